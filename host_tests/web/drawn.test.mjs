// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a campaign in drawn worlds in a browser. CAMPAIGN names the program, SHOTS where screenshots go.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { assertAccessible, launch, open } from '../support/browser.mjs';
import { embedded } from '../support/flight_document.mjs';

const kScreens = 3, kHeight = 900, kWidth = 1400;
const { CAMPAIGN, SHOTS } = process.env;
let folder, browser, file, campaign, said;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'drawn-'));
  said = spawnSync(CAMPAIGN, ['--drawn', '77-88', '--jobs', '2', '--out', folder], { encoding: 'utf8' }).stdout;
  file = join(folder, 'campaign.html');
  campaign = embedded(file, 'campaign');
  mkdirSync(SHOTS, { recursive: true });
  browser = await launch();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

const shown = async (options) => {
  const page = await open(browser, `file://${file}`, { width: kWidth, height: kHeight, ...options });
  await page.locator('#scatter').waitFor();
  await page.waitForTimeout(200);
  return page;
};
const rowsOf = (page, name) => page.getByRole('region', { name }).locator('tbody tr');

test('campaign.json is the document that the page shows', () => {
  assert.deepEqual(JSON.parse(readFileSync(join(folder, 'campaign.json'), 'utf8')), campaign);
  assert.equal(campaign.flights.length, 12);
});

test('every limit is in the table and in a distribution, with the share that the terminal shows', async () => {
  const page = await shown();
  const shares = Object.fromEntries([...said.matchAll(/^(\S.*?), \S+ +[\d.]+ +(\d+)% /gm)].map(([, name, share]) => [name, Number(share)]));
  for (const { figure, name } of campaign.goals) {
    const share = parseFloat(await page.locator(`[data-figure="${figure}"] b`).textContent());
    assert.ok(Math.abs(share - shares[name]) <= 1, `${name}: ${share} %, ${shares[name]} %`);
  }
  assert.equal(await rowsOf(page, 'Limits').count(), campaign.goals.length);
  assert.match(await rowsOf(page, 'Limits').first().textContent(), /^Touch-down from the point, m30\.00/);
  assert.match(await page.locator('h2').first().textContent(), new RegExp(`every limit met by ${campaign.met_all} of 12`));
  assert.match(said, new RegExp(`every limit is met by ${campaign.met_all} of 12`));
  assert.deepEqual([page.faults, page.requests.length], [[], 1]);
  await page.context().close();
});

test('it is at most three screens high', async () => {
  const page = await shown();
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  assert.ok(height <= kScreens * kHeight, `${height} pixels`);
  await page.screenshot({ path: join(SHOTS, 'drawn.png'), fullPage: true });
  await page.context().close();
});

test('the worst are in order, each with its command and a report that exists', async () => {
  const page = await shown();
  const rows = rowsOf(page, 'The worst flights');
  const missing = campaign.flights.filter(({ completed, met_all }) => completed && !met_all);
  assert.equal(await rows.count(), Math.min(10, missing.length));
  const times = (await rows.locator('td:nth-child(5)').allTextContents()).map(Number);
  assert.deepEqual(times, [...times].sort((a, b) => b - a));
  for (const row of await rows.all()) {
    const seed = await row.locator('td').first().textContent();
    assert.equal(await row.locator('code').textContent(), `toolchain/campaign --drawn ${seed}-${seed}`);
    assert.ok(existsSync(join(folder, await row.locator('a').getAttribute('href'))), seed);
  }
  await page.context().close();
});

test('every failed flight is named with its reason', async () => {
  const page = await shown();
  const failed = campaign.flights.filter(({ completed }) => !completed);
  const rows = await rowsOf(page, 'Failed flights').all();
  const named = await Promise.all(rows.map(async (row) => (await row.locator('td').nth(2).textContent()).split(', ').map(Number)));
  assert.ok(failed.length > 0, 'a page without a failed flight shows nothing of them');
  assert.deepEqual(named.flat().sort((a, b) => a - b), failed.map(({ seed }) => seed));
  for (const { seed, failure } of failed) {
    const reason = await rows[named.findIndex((seeds) => seeds.includes(seed))].locator('td').first().textContent();
    const begins = failure.replace(/^drawn: /, '').split(/[\d;]/)[0];
    assert.ok(reason.startsWith(begins), `${reason}: ${failure}`);
  }
  await page.context().close();
});

test('what it depends on can be asked of each figure', async () => {
  const page = await shown();
  const place = page.getByRole('region', { name: 'What it depends on' });
  const before_ = await place.textContent();
  await page.getByLabel('Share of').selectOption({ label: 'Airspeed RMS' });
  assert.notEqual(await place.textContent(), before_);
  assert.ok(await place.locator('tbody tr').count() >= 10);
  await page.context().close();
});

for (const [name, options] of [['drawn_dark', { dark: true }], ['drawn_phone', { width: 390, height: 844 }], ['drawn_light', {}]]) {
  test(`${name}: axe finds nothing, and nothing is wider than the screen`, async () => {
    const page = await shown(options);
    await page.screenshot({ path: join(SHOTS, `${name}.png`), fullPage: true });
    await assertAccessible(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.context().close();
  });
}
