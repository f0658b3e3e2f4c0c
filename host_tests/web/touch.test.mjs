// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers on the page of a flight, by Chromium's touch emulation, on the screen of a phone.
// FLY names the program, SHOTS where screenshots go.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { launch, open } from '../support/browser.mjs';

const kPhone = { width: 390, height: 844, touch: true };
const kMaxTaps = 10, kClick_ms = 2000;
const { FLY, SHOTS } = process.env;
let folder, browser, report;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'touch-'));
  execFileSync(FLY, ['--native', '--out', join(folder, 'flight')], { stdio: 'ignore' });
  report = join(folder, 'flight/report.html');
  mkdirSync(SHOTS, { recursive: true });
  browser = await launch();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

const cursor_s = (page) => page.evaluate(() => Number(document.querySelector('#timeline input').value));
// A page with its plot of heights in view, and a hand: down, move and up take the places of all fingers.
async function touched() {
  const page = await open(browser, `file://${report}`, kPhone);
  const over = page.locator('.u-over[data-group="height"]');
  await page.locator('section[data-group="height"]').scrollIntoViewIfNeeded();
  await over.waitFor();
  await over.evaluate((element) => element.scrollIntoView({ block: 'center' }));
  await page.waitForTimeout(100);
  const box = await over.boundingBox();
  const session = await page.context().newCDPSession(page);
  const send = (type, places) => session.send('Input.dispatchTouchEvent', {
    type, touchPoints: places.map(([x, y], id) => ({ x: box.x + x * box.width, y: box.y + y * box.height, id })) });
  const hand = { down: (...places) => send('touchStart', places), move: (...places) => send('touchMove', places), up: () => send('touchEnd', []) };
  return { page, hand, over, box };
}
const whole = (page) => page.locator('#whole').isDisabled();
async function dragged(hand, from, to, steps = 6) {
  await hand.down(from);
  for (let i = 1; i <= steps; ++i) await hand.move([from[0] + (to[0] - from[0]) * i / steps, from[1] + (to[1] - from[1]) * i / steps]);
}
// The span that the height's plot shows, by the cursor's place on it.
async function shownAt(page, over, part) {
  const box = await over.boundingBox();
  // What is read before the click that Chromium makes of a tap is where the cursor was. On a busy machine
  // it takes a tap for a long press, of which it makes none: then a person taps again.
  await over.evaluate((element) => { globalThis.clicked = false; element.addEventListener('click', () => { globalThis.clicked = true; }, { once: true }); });
  for (let taps = 0; !await page.evaluate(() => globalThis.clicked); ++taps) {
    assert.ok(taps < kMaxTaps, 'no click came of the taps');
    await page.touchscreen.tap(box.x + part * box.width, box.y + box.height / 2);
    await page.waitForFunction(() => globalThis.clicked, null, { timeout: kClick_ms }).catch(() => {});
  }
  return cursor_s(page);
}

test('a tap on a plot puts the cursor there', async () => {
  const { page, over } = await touched();
  const [early, late] = [await shownAt(page, over, 0.2), await shownAt(page, over, 0.9)];
  assert.ok(late > early + 100, `${early} s, ${late} s`);
  assert.ok(await whole(page));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('a finger that is drawn along a plot shows that span, in all of them', async () => {
  const { page, hand, over } = await touched();
  const [from_s, to_s] = [await shownAt(page, over, 0.3), await shownAt(page, over, 0.7)];
  await dragged(hand, [0.3, 0.5], [0.7, 0.5]);
  assert.ok(await page.locator('.u-select').first().evaluate((element) => element.clientWidth > 50), 'the span is seen while it is drawn');
  await page.screenshot({ path: join(SHOTS, 'touch.png') });
  await hand.up();
  assert.equal(await whole(page), false);
  const [first_s, last_s] = [await shownAt(page, over, 0.02), await shownAt(page, over, 0.98)];
  assert.ok(Math.abs(first_s - from_s) < 6 && Math.abs(last_s - to_s) < 6, `${first_s} to ${last_s} s, not ${from_s} to ${to_s}`);
  await page.context().close();
});

test('two fingers pinch the span: apart in, together out, and what is under them stays', async () => {
  const { page, hand, over } = await touched();
  const [a_s, b_s] = [await shownAt(page, over, 0.4), await shownAt(page, over, 0.6)];
  await hand.down([0.4, 0.5], [0.6, 0.5]);
  for (let i = 1; i <= 8; ++i) await hand.move([0.4 - 0.03 * i, 0.5], [0.6 + 0.03 * i, 0.5]);
  await hand.up();
  assert.equal(await whole(page), false);
  const [now_a, now_b] = [await shownAt(page, over, 0.16), await shownAt(page, over, 0.84)];
  assert.ok(Math.abs(now_a - a_s) < 6 && Math.abs(now_b - b_s) < 6, `${a_s} and ${b_s} s became ${now_a} and ${now_b}`);
  assert.ok(await page.evaluate(() => globalThis.visualViewport.scale === 1), 'the page itself is not zoomed');
  for (let turn = 0; turn < 2; ++turn) {
    await hand.down([0.05, 0.5], [0.95, 0.5]);
    for (let i = 1; i <= 8; ++i) await hand.move([0.05 + 0.05 * i, 0.5], [0.95 - 0.05 * i, 0.5]);
    await hand.up();
  }
  assert.ok(await whole(page), 'together again it is the whole flight');
  await page.context().close();
});

test('the bar that plays stays at the end of the screen, wherever the page is scrolled to', async () => {
  const { page } = await touched();
  for (const to of [0, 600, 1e6]) {
    await page.evaluate((y) => globalThis.scrollTo(0, y), to);
    const { y, height } = await page.locator('#playback').boundingBox();
    assert.ok(Math.abs(y + height - kPhone.height) < 1, `it ends at ${y + height} of ${kPhone.height}, scrolled to ${to}`);
  }
  await page.context().close();
});

test('a finger that goes up the page scrolls it and zooms nothing', async () => {
  const { page, hand } = await touched();
  const before_px = await page.evaluate(() => globalThis.scrollY);
  await dragged(hand, [0.5, 0.5], [0.52, -1.5], 12);
  await hand.up();
  await page.waitForTimeout(300);
  assert.notEqual(await page.evaluate(() => globalThis.scrollY), before_px);
  assert.ok(await whole(page));
  await page.context().close();
});
