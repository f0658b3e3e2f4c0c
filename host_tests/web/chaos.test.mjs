// SPDX-License-Identifier: GPL-3.0-or-later
// The page of flights of chaos in a browser. CHAOS names the program, SHOTS where screenshots go.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { assertAccessible, launch, open } from '../support/browser.mjs';
import { embedded } from '../support/flight_document.mjs';

const kScreens = 3, kHeight = 900, kWidth = 1400, kFlights = 80;
const { CHAOS, SHOTS } = process.env;
let folder, browser, file, campaign, said;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'chaos-'));
  said = spawnSync(CHAOS, ['--flights', `${kFlights}`, '--seed', '300', '--jobs', '2', '--out', folder], { encoding: 'utf8' }).stdout;
  file = join(folder, 'campaign.html');
  campaign = embedded(file, 'campaign');
  mkdirSync(SHOTS, { recursive: true });
  browser = await launch();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

async function shown(options, path = file) {
  const page = await open(browser, `file://${path}`, { width: kWidth, height: kHeight, ...options });
  await page.locator('#tiles').waitFor();
  await page.waitForTimeout(200);
  return page;
}
const rowsOf = (page, name) => page.getByRole('region', { name, exact: true }).locator('tbody tr');

// The document of these flights with one in which an invariant was violated.
function withViolation() {
  const changed = structuredClone(campaign), [flight] = changed.flights;
  Object.assign(flight, { violations: [{ time_s: 41.3, name: 'mission_jump', numbers: 'item 3 after 1' }],
    scenario: `mission_jump_${flight.seed}.scenario`, replay: `toolchain/chaos --replay build/chaos/mission_jump_${flight.seed}.scenario` });
  Object.assign(changed, { violated: 1, violations: [{ name: 'mission_jump', flights: 1 }], verdict: { good: false, text: 'of 80 flights 1 violated an invariant' } });
  const path = join(folder, 'violated.html');
  writeFileSync(path, readFileSync(file, 'utf8').replace(/(id="campaign">)[^]*?(<\/script>)/, (_, begin, end) => begin + JSON.stringify(changed) + end));
  return { path, flight };
}

test('campaign.json is the document that the page shows, with every flight', () => {
  assert.deepEqual(JSON.parse(readFileSync(join(folder, 'campaign.json'), 'utf8')), campaign);
  assert.deepEqual([campaign.kind, campaign.flown, campaign.flights.length], ['chaos', kFlights, kFlights]);
  const [, airborne, crashed, promised] = /flights, (\d+) airborne, (\d+) crashed, (\d+) that must not/.exec(said).map(Number);
  assert.deepEqual([campaign.airborne, campaign.crashed, campaign.must_survive], [airborne, crashed, promised]);
  assert.equal(campaign.flights.filter((flight) => flight.crashed).length, crashed);
});

test('what was drawn is there as often as the terminal says', async () => {
  const page = await shown();
  const times = Object.fromEntries([...said.matchAll(/^ +(\d+) {2}(.+)$/gm)].map(([, number, name]) => [name, Number(number)]));
  const rows = await rowsOf(page, 'What was drawn').all();
  assert.ok(rows.length > 20, `${rows.length} kinds of events`);
  for (const row of rows) {
    const [name, number] = await row.locator('td').allTextContents();
    assert.equal(Number(number.replaceAll(',', '')), times[name], name);
  }
  assert.equal(await rowsOf(page, 'Airplanes').count(), new Set(campaign.flights.map(({ airplane }) => airplane)).size);
  assert.deepEqual([page.faults, page.requests.length], [[], 1]);
  await page.context().close();
});

test('crashes that were allowed are listed, each with the command that flies it again', async () => {
  const page = await shown();
  const allowed = campaign.flights.filter(({ crashed, must_survive }) => crashed && !must_survive);
  const rows = rowsOf(page, 'Crashes that were allowed');
  assert.ok(allowed.length > 0, 'a page without a crash shows nothing of them');
  assert.equal(await rows.count(), allowed.length);
  assert.deepEqual(await rows.locator('code').allTextContents(), allowed.map(({ seed }) => `toolchain/chaos --seed ${seed} --flights 1`));
  await page.context().close();
});

test('a violation is named with what it was and the scenario that shows it', async () => {
  const { path, flight } = withViolation();
  const page = await shown({}, path);
  const row = rowsOf(page, 'Violations').first();
  assert.match(await row.textContent(), new RegExp(`^mission_jump141.3item 3 after 1${flight.seed}`));
  assert.equal(await row.locator('code').textContent(), flight.replay);
  assert.match(await page.locator('#verdict').getAttribute('class'), /bad/);
  await assertAccessible(page);
  await page.context().close();
});

test('it is at most three screens high', async () => {
  const page = await shown();
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  assert.ok(height <= kScreens * kHeight, `${height} pixels`);
  await page.screenshot({ path: join(SHOTS, 'chaos.png'), fullPage: true });
  await page.context().close();
});

for (const [name, options] of [['chaos_dark', { dark: true }], ['chaos_phone', { width: 390, height: 844 }], ['chaos_light', {}]]) {
  test(`${name}: axe finds nothing, and nothing is wider than the screen`, async () => {
    const page = await shown(options);
    await page.screenshot({ path: join(SHOTS, `${name}.png`), fullPage: true });
    await assertAccessible(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.context().close();
  });
}
