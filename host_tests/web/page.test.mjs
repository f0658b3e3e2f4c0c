// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a flight in a browser: a report, a log's report, a log that is dropped, a live flight.
// FLY and LOG_TOOL name the programs, PAGES the folder of the pages, SHOTS where screenshots go.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { assertAccessible, busiest, eventually, launch, open } from '../support/browser.mjs';
import { embedded } from '../support/flight_document.mjs';
import { liveServer } from '../support/live_server.mjs';

const kMax_bytes = 1_500_000, kMax_ms = 500, kMaxFrame_ms = 16;
const { FLY, LOG_TOOL, PAGES, SHOTS } = process.env;
let folder, browser, report, log, logReport;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'page-'));
  const image = join(folder, 'flash.bin');
  execFileSync(FLY, ['--native', '--wind', '5,320', '--gusts', '--fault', 'gps:lost@120-140', '--dataflash', image,
    '--out', join(folder, 'flight')], { stdio: 'ignore' });
  report = join(folder, 'flight/report.html');
  log = join(folder, 'log.bin');
  logReport = join(folder, 'log.html');
  execFileSync(LOG_TOOL, ['extract', image, '-o', log]);
  execFileSync(LOG_TOOL, ['report', log, '-o', logReport]);
  mkdirSync(SHOTS, { recursive: true });
  browser = await launch();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

const file = (path) => `file://${path}`;
const shot = (page, name) => page.screenshot({ path: join(SHOTS, `${name}.png`) });
const cursor_s = (page) => page.evaluate(() => Number(document.querySelector('#timeline input').value));
const plot = (page, group) => page.locator(`.u-over[data-group="${group}"]`);
const ready = (page) => plot(page, 'height').waitFor();
const spanLabels = (page, group) => page.locator(`section[data-group="${group}"]`).evaluate((box) => box.querySelector('canvas').toDataURL().length);

// What the page's own thread has taken of the processor since: other programs do not count.
async function processorTime(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  const now_ms = async () => (await session.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value * 1000;
  const begun_ms = await now_ms();
  return async () => await now_ms() - begun_ms;
}

// How much slower than the computer on which the limits hold this one is now: computers differ by a
// factor of two, and others may be using the core's caches. A fixed piece of work is the measure.
const kReference_ms = 180;
async function referenceRatio() {
  const page = await open(browser, 'about:blank');
  const spent = await processorTime(page);
  await page.evaluate(() => {
    const rows = [];
    for (let i = 0; i < 150_000; ++i) rows.push({ place: i * 7919 % 100_003, text: String(i) });
    rows.sort((a, b) => a.place - b.place);
    return JSON.parse(JSON.stringify(rows)).length;
  });
  const reference_ms = await spent();
  await page.context().close();
  console.log(`reference: ${reference_ms.toFixed(0)} ms`);
  return Math.max(1, reference_ms / kReference_ms);
}

async function opened(path, options) {
  const page = await open(browser, file(path), options);
  await (options?.width < 900 ? page.locator('#play') : plot(page, 'height')).waitFor();
  return page;
}

async function openingTime_ms() {
  const page = await open(browser, 'about:blank');
  const spent = await processorTime(page);
  page.requests.length = 0;
  await page.goto(file(report));
  await page.waitForFunction(() => performance.getEntriesByName('shown').length > 0);
  const shown_ms = await page.evaluate(() => performance.getEntriesByName('shown')[0].startTime), spent_ms = await spent();
  console.log(`report: ${statSync(report).size} bytes, shown after ${shown_ms.toFixed(0)} ms, of the processor's ${spent_ms.toFixed(0)} ms`);
  assert.deepEqual([page.faults, page.requests], [[], [file(report)]]);
  await page.context().close();
  return spent_ms;
}

test('a report is small, opens at once, and loads nothing', async () => {
  assert.ok(statSync(report).size <= kMax_bytes, `${statSync(report).size} bytes`);
  let least_ms = Infinity;
  for (let opening = 0; opening < 5 && least_ms > kMax_ms; ++opening)
    least_ms = Math.min(least_ms, await openingTime_ms() / await referenceRatio());
  assert.ok(least_ms <= kMax_ms, `${least_ms} ms`);
});

test('the pointer over one plot moves the cursor in all of them, and the airplane', async () => {
  const page = await opened(report);
  const place = () => page.locator('.airplane').evaluate((element) => element.style.transform);
  const lines = () => page.locator('.cursor-line').evaluateAll((all) => [...new Set(all.map((line) => line.style.transform))]);
  const [at_s, at] = [await cursor_s(page), await place()];
  const box = await plot(page, 'height').boundingBox();
  await page.mouse.move(box.x + box.width * 0.8, box.y + 20);
  assert.ok(await cursor_s(page) > at_s + 60, 'four fifths of the flight');
  assert.notEqual(await place(), at);
  assert.equal((await lines()).length, 1, 'in every plot at the same time');
  await page.context().close();
});

test('a span that is drawn with the pointer is shown by all plots; a double click shows the whole', async () => {
  const page = await opened(report);
  const whole = page.locator('#whole'), before_zoom = await spanLabels(page, 'speed');
  assert.ok(await whole.isDisabled());
  const box = await plot(page, 'height').boundingBox();
  await page.mouse.move(box.x + 100, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + 220, box.y + 24, { steps: 4 });
  await page.mouse.up();
  assert.ok(await whole.isEnabled());
  assert.ok(await eventually(page, async () => await spanLabels(page, 'speed') !== before_zoom));
  await plot(page, 'height').dblclick();
  assert.ok(await whole.isDisabled());
  await page.context().close();
});

test('it plays, faster when asked, and stops', async () => {
  const page = await opened(report);
  await page.waitForTimeout(600);  // the attitude is there
  await page.selectOption('#rate', '10');
  await page.click('#play');
  const [thread, drawing] = [await processorTime(page), await busiest(browser)];
  const { frames, real_s, played_s } = await page.evaluate(() => new Promise((resolve) => {
    const cursor = () => Number(document.querySelector('#timeline input').value);
    let begun_ms, begun_s, count = 0;
    const next = (now_ms) => {
      if (begun_ms === undefined) [begun_ms, begun_s] = [now_ms, cursor()];
      else ++count;
      if (now_ms - begun_ms < 2000) requestAnimationFrame(next);
      else resolve({ frames: count, real_s: (now_ms - begun_ms) / 1000, played_s: cursor() - begun_s });
    };
    requestAnimationFrame(next);
  }));
  const [page_ms, drawn_ms] = [await thread() / frames, await drawing() / frames];
  await page.click('#play');
  console.log(`playing: ${(frames / real_s).toFixed(1)} frames/s; of the processor, each took ${page_ms.toFixed(1)} ms of the page's thread and ${drawn_ms.toFixed(1)} ms of the busiest process`);
  assert.ok(played_s > 8 * real_s && played_s < 12 * real_s, `${played_s} s in ${real_s} s`);
  assert.ok(Math.max(page_ms, drawn_ms) <= kMaxFrame_ms * await referenceRatio(), `${page_ms} ms and ${drawn_ms} ms a frame`);
  const stopped_s = await cursor_s(page);
  await page.waitForTimeout(150);
  assert.equal(await cursor_s(page), stopped_s);
  await page.context().close();
});

test('a text that is clicked moves the cursor to its time', async () => {
  const page = await opened(report);
  await page.getByRole('button', { name: 'GPS lost: dead reckoning' }).click();
  const said = embedded(report).events.find(({ text }) => text.startsWith('GPS lost'));
  assert.ok(Math.abs(await cursor_s(page) - said.time_s) < 0.11);
  assert.equal(await page.locator('#message-list .now').textContent().then((text) => text.includes('GPS lost')), true);
  await page.context().close();
});

test('series are switched, groups chosen, and a plot is a table when that is wanted', async () => {
  const page = await opened(report);
  const box = page.locator('section[data-group="height"]');
  const truth = box.getByRole('button', { name: 'height truth' });
  const drawn = await spanLabels(page, 'height');
  await truth.click();
  assert.equal(await truth.getAttribute('aria-pressed'), 'false');
  assert.notEqual(await spanLabels(page, 'height'), drawn);
  await page.locator('#groups [data-group="battery"]').click();
  await plot(page, 'battery').waitFor();
  await box.getByRole('button', { name: 'Height as a table' }).click();
  assert.equal(await box.locator('tbody tr').count(), 61);
  await page.context().close();
});

test('every group of series that the flight has can be drawn', async () => {
  const page = await opened(report);
  const groups = [...new Set(embedded(report).series.map(({ group }) => group))].filter((group) => group !== '');
  for (const group of ['height', 'speed', 'roll', 'pitch', 'heading', 'climb', 'controls', 'servos', 'energy', 'battery', 'wind', 'gps', 'vibration', 'rc', 'cpu'])
    assert.ok(groups.includes(group), group);
  for (const group of groups) {
    const button = page.locator(`#groups [data-group="${group}"]`);
    if (await button.getAttribute('aria-pressed') === 'false') await button.click();
    await page.locator(`section[data-group="${group}"]`).scrollIntoViewIfNeeded();
    await plot(page, group).waitFor();
  }
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('deviations have goals, and the command that flies it again is there', async () => {
  const page = await opened(report);
  await page.getByRole('tab', { name: 'Deviations' }).click();
  const row = page.getByRole('row', { name: /^Touch-down from landing point/ });
  assert.match(await row.textContent(), /≤ 20m✓ met/);
  await page.getByRole('tab', { name: 'Provenance' }).click();
  assert.equal(await page.locator('.command code').textContent(),
    `toolchain/fly --native --wind 5,320 --gusts --fault gps:lost@120-140 --dataflash ${join(folder, 'flash.bin')}`);
  assert.match(await page.locator('#pane-provenance').textContent(), /foam_trainer/);
  await page.context().close();
});

test('the keys do what the buttons do', async () => {
  const page = await opened(report);
  await page.keyboard.press('Home');
  assert.ok(await cursor_s(page) < 0.2);
  await page.keyboard.press('Shift+ArrowRight');
  assert.ok(Math.abs(await cursor_s(page) - 10.1) < 0.2);
  const from_s = await cursor_s(page);
  await page.keyboard.press(' ');
  while (await cursor_s(page) < from_s + 0.1) await page.waitForTimeout(50);
  await page.keyboard.press(' ');
  const stopped_s = await cursor_s(page);
  await page.waitForTimeout(200);
  assert.equal(await cursor_s(page), stopped_s);
  await page.keyboard.press('+');
  assert.ok(await page.locator('#whole').isEnabled());
  await page.keyboard.press('0');
  assert.ok(await page.locator('#whole').isDisabled());
  await page.context().close();
});

for (const [name, options] of [['report', {}], ['report_dark', { dark: true }], ['report_phone', { width: 390, height: 844 }]]) {
  test(`${name}: axe finds nothing, and nothing is wider than the screen`, async () => {
    const page = await opened(report, options);
    await page.waitForTimeout(700);
    await shot(page, name);
    for (const tab of await page.getByRole('tab').all()) {
      await tab.click();
      await assertAccessible(page);
    }
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.context().close();
  });
}

test('nothing on the map covers anything else, however wide the page is', async () => {
  const parts = ['#map-tools', '#map-legend', '#wind', '.leaflet-control-zoom', '.leaflet-control-scale'];
  const page = await opened(report);
  await page.getByRole('button', { name: 'GPS lost: dead reckoning' }).click();
  for (const width of [390, 640, 901, 960, 1040, 1200, 1600]) {
    await page.setViewportSize({ width, height: 800 });
    let covered = [];
    await eventually(page, async () => {
      const boxes = await Promise.all(parts.map((part) => page.locator(part).boundingBox()));
      covered = boxes.flatMap((a, i) => boxes.slice(i + 1)
        .flatMap((b, j) => (a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y ? [] : [`${parts[i]} and ${parts[i + 1 + j]}`])));
      return covered.length === 0;
    });
    assert.deepEqual(covered, [], `at ${width} pixels`);
  }
  const [airplane, names] = await page.evaluate(() => ['.airplane', '.place'].map((what) =>
    Number(globalThis.getComputedStyle(document.querySelector(what).closest('.leaflet-pane')).zIndex)));
  assert.ok(airplane > names, 'the airplane is above the names of items');
  await page.context().close();
});

test('the airplane that is drawn is the one that flew', async () => {
  const wing = join(folder, 'wing');
  spawnSync(FLY, ['--native', '--airplane', 'flying_wing', '--time-limit', '60', '--out', wing]);  // it ends on its way
  for (const [path, shape] of [[report, 'with a tail'], [join(wing, 'report.html'), 'flying wing']]) {
    const page = await opened(path);
    await page.locator(`#attitude[data-shape="${shape}"]`).waitFor();
    await page.waitForTimeout(300);
    if (shape === 'flying wing') await page.locator('#attitude-box').screenshot({ path: join(SHOTS, 'wing.png') });
    await page.context().close();
  }
});

test('the report of a log shows the same flight', async () => {
  assert.ok(statSync(logReport).size <= kMax_bytes);
  const page = await opened(logReport);
  assert.equal(await page.locator('#subtitle').textContent(), 'log.bin · ArduPilotMega autopilot V0.1 (Plane)');
  assert.equal(await page.locator('#verdict').textContent(), 'flown and disarmed');
  await page.getByRole('button', { name: 'in the air' }).click();
  await assertAccessible(page);
  await page.waitForTimeout(500);
  await shot(page, 'log');
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

async function drop(page, path, name) {
  const bytes = readFileSync(path).toString('base64');
  const transfer = await page.evaluateHandle(([text, as]) => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], as));
    return data;
  }, [bytes, name]);
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer });
}

test('a log that is dropped onto the page is read there', async () => {
  const page = await open(browser, file(join(PAGES, 'page.html')));
  await drop(page, log, 'dropped.bin');
  await ready(page);
  assert.equal(await page.locator('#subtitle').textContent(), 'dropped.bin · ArduPilotMega autopilot V0.1 (Plane)');
  assert.equal(await page.locator('#message-list li').count(), embedded(logReport).events.length);
  assert.deepEqual([page.faults, page.requests.length], [[], 1]);
  await drop(page, report, 'report.bin');
  await page.getByText('this is no log').waitFor();
  await page.context().close();
});

test('a log may be dropped onto a report, and takes its place', async () => {
  const page = await opened(report);
  await drop(page, log, 'another.bin');
  await page.getByText('another.bin ·').waitFor();
  await ready(page);
  assert.equal(await page.locator('[role=tab]').first().textContent(), 'Plots');
  assert.equal(await page.locator('#play').count(), 1);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('a live flight is drawn as it comes, and does what it is asked', async () => {
  const text = readFileSync(join(PAGES, 'page.html'), 'utf8').replace('content="document"', 'content="live"');
  const server = await liveServer(text, embedded(report));
  const page = await open(browser, server.url);
  await ready(page);
  await page.getByText('disarmed · FBWA').waitFor();
  await page.click('#arm');
  await page.getByText('armed · FBWA · item 2').waitFor();
  await page.getByLabel('mode', { exact: true }).selectOption('AUTO');
  await page.getByText('armed · AUTO').waitFor();
  await page.click('#goto');
  await page.locator('#map').click({ position: { x: 150, y: 250 } });
  await page.getByText('done: goto').waitFor();
  await page.getByRole('button', { name: '5×', exact: true }).click();
  await page.getByLabel('inject a fault').selectOption('gps:lost');
  await page.getByRole('button', { name: 'set wind' }).click();
  await page.getByText('done: wind').waitFor();
  await page.waitForFunction(() => Number(document.querySelector('#timeline input').max) > 70);
  assert.ok(await cursor_s(page) > 65, 'the cursor stays at the newest sample');
  await page.waitForFunction(() => document.querySelectorAll('#message-list li').length >= 3);
  await page.click('#pause');
  await page.getByText('paused').first().waitFor();
  await page.waitForTimeout(400);
  await shot(page, 'live');
  await assertAccessible(page);
  assert.deepEqual(server.commands.map((command) => command.do), ['arm', 'mode', 'goto', 'speed', 'fault', 'wind', 'pause']);
  const { lat_deg, lon_deg, altitude_m } = server.commands[2];
  assert.ok(Math.abs(lat_deg - 47.4) < 0.05 && Math.abs(lon_deg - 8.54) < 0.05 && altitude_m === 60);
  assert.deepEqual(server.commands[4], { do: 'fault', name: 'gps:lost', on: true });
  assert.deepEqual(page.faults, []);
  await page.context().close();
  server.close();
});

test('the keyboard flies as sticks while that is switched on', async () => {
  const text = readFileSync(join(PAGES, 'page.html'), 'utf8').replace('content="document"', 'content="live"');
  const server = await liveServer(text, embedded(report));
  const page = await open(browser, server.url);
  await ready(page);
  await page.keyboard.press('ArrowRight');
  await page.click('#sticks');
  await page.keyboard.down('ArrowRight');
  await page.keyboard.down('w');
  await page.waitForTimeout(300);
  await page.keyboard.up('w');
  await page.keyboard.up('ArrowRight');
  const sticks = () => server.commands.filter((command) => command.do === 'sticks');
  assert.ok(await eventually(page, async () => sticks().at(-1)?.roll === 0 && sticks().at(-1).throttle > 0), JSON.stringify(sticks()));
  assert.ok(sticks().some(({ roll }) => roll > 0), JSON.stringify(sticks()));
  await page.context().close();
  server.close();
});
