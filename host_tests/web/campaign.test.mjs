// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a campaign in a browser. CAMPAIGN names the program, SHOTS where screenshots go.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { assertAccessible, launch, open } from '../support/browser.mjs';
import { embedded } from '../support/flight_document.mjs';

const kScreens = 3;
const { CAMPAIGN, SHOTS } = process.env;
let folder, browser, file, campaign;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'campaign-'));
  execFileSync(CAMPAIGN, ['--airplane', 'foam_trainer', '--airplane', 'flying_wing', '--seeds', '3', '--jobs', '2', '--out', folder], { stdio: 'ignore' });
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
  const page = await open(browser, `file://${file}`, options);
  await page.locator('#scatter').waitFor();
  await page.waitForTimeout(200);
  return page;
};

test('it draws every goal that flights have figures for, and says how many keep it', async () => {
  const page = await shown();
  assert.equal(await page.locator('#subtitle').textContent().then((text) => text.split(' · ')[0]), '24 flights');
  for (const { figure, calm, windy } of campaign.goals) {
    const known = campaign.flights.filter(({ figures }) => figures[figure] !== undefined);
    const share = known.filter((flight) => flight.figures[figure] <= (flight.calm ? calm : windy)).length / known.length;
    const said = await page.locator(`[data-figure="${figure}"] b`).textContent();
    assert.ok(Math.abs(parseFloat(said) - share * 100) < 0.11, `${figure}: ${said}, ${share}`);
  }
  assert.deepEqual([page.faults, page.requests.length], [[], 1]);
  await page.context().close();
});

test('it is at most three screens high', async () => {
  const page = await shown();
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  assert.ok(height <= kScreens * 800, `${height} pixels`);
  await page.screenshot({ path: join(SHOTS, 'campaign.png'), fullPage: true });
  await page.context().close();
});

test('the worst ten are in order, each with the command that flies it again', async () => {
  const page = await shown();
  const rows = page.getByRole('region', { name: 'The worst flights' }).locator('tbody tr');
  assert.equal(await rows.count(), 10);
  const times = (await rows.locator('td:nth-child(6)').allTextContents()).map(Number);
  assert.deepEqual(times, [...times].sort((a, b) => b - a));
  const commands = campaign.flights.map(({ command }) => command);
  for (const command of await rows.locator('code').allTextContents()) assert.ok(commands.includes(command), command);
  await page.context().close();
});

test('a mission and a figure can be chosen', async () => {
  const page = await shown();
  await page.getByLabel('Mission', { exact: true }).selectOption('box_600');
  const said = await page.locator('[data-figure="crosstrack_rms_m"] b').textContent();
  assert.match(said, /within/);
  assert.equal(await page.getByRole('region', { name: 'Spread of a figure' }).locator('tbody tr').count(), 4, 'two airplanes in two winds');
  await page.getByLabel('Figure', { exact: true }).selectOption('landed_distance_m');
  const worst = Math.max(...campaign.flights.filter(({ mission }) => mission === 'box_600').map(({ figures }) => figures.landed_distance_m));
  assert.ok((await page.getByRole('region', { name: 'Spread of a figure' }).textContent()).includes(worst.toFixed(2)));
  await page.context().close();
});

for (const [name, options] of [['campaign_dark', { dark: true }], ['campaign_phone', { width: 390, height: 844 }], ['campaign_light', {}]]) {
  test(`${name}: axe finds nothing, and nothing is wider than the screen`, async () => {
    const page = await shown(options);
    await page.screenshot({ path: join(SHOTS, `${name}.png`) });
    await assertAccessible(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.context().close();
  });
}
