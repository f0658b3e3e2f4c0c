// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/picture on a report that is written here, and on ones it must refuse.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const folder = mkdtempSync(join(tmpdir(), 'picture-'));
after(() => rmSync(folder, { recursive: true }));
const out = join(folder, 'out.svg');

const kPlaces = [[2, 47.4012499, 8.5436971], [11, 47.3978072, 8.5437099, 60], [15, 47.3977, 8.5456]];
const flown = (name, values, more = {}) => ({ name, title: name, unit: 'm', group: '', kind: 'truth', time: 0, values, ...more });
function report(change = (document) => document) {
  const document = change({
    format: 'apm-flight', version: 1, kind: 'simulated', title: 'a flight',
    plan: { home: { lat_deg: 47.3977, lon_deg: 8.5456 },
      items: kPlaces.map(([index, lat_deg, lon_deg, radius_m]) => ({ index, name: '', text: '', lat_deg, lon_deg, radius_m })) },
    times: [[0, 10, 20]],
    series: [flown('lat_deg', [47.3977, 47.4012, 47.3978]), flown('lon_deg', [8.5456, 8.5437, 8.5437]),
      flown('height_m', [0, 60, 60]), flown('planned_height_m', [null, 60, 60], { kind: '' })],
    events: [{ time_s: 12, kind: 'item', text: 'flies item 2' }], bands: [{ kind: 'mode', name: 'AUTO', from_s: 4, to_s: 20 }],
  });
  return `<script type="application/json" id="flight">${JSON.stringify(document)}</script>`;
}
const summary = { completed: true, mission: 'first_flight.waypoints', firmware: 'a<b.elf', board: 'apm2',
  wind_mps: 0, wind_from_deg: 0, gusts: false, seed: 1, flight_time_s: 335.06, cpu_load: 0.304 };

function draw(page, figures) {
  rmSync(out, { force: true });
  writeFileSync(join(folder, 'report.html'), page);
  writeFileSync(join(folder, 'summary.json'), JSON.stringify(figures));
  return spawnSync(join(root, 'toolchain/picture'), ['-o', out, folder], { encoding: 'utf8' });
}

test('the picture has title, figures, the mission by name, and both charts', () => {
  assert.equal(draw(report(), summary).status, 0);
  const svg = readFileSync(out, 'utf8');
  for (const part of ['mission completed', 'a&#60;b.elf on apm2', '>335 s<', '>30 %<', '>take-off to 45 m<',
    '>loiter, 2 turns at 60 m<', '>2</text>', '>11 loiter</text>', '>15 land</text>', 'width="600" height="803"'])
    assert.ok(svg.includes(part), part);
  assert.doesNotMatch(svg, /undefined|NaN/);
  assert.doesNotMatch(svg, /touch-down/, 'a figure that the summary has not');
});

test('it needs nothing from elsewhere', () => {
  assert.equal(draw(report(), summary).status, 0);
  for (const svg of [out, join(root, 'docs/first_flight.svg')])
    assert.doesNotMatch(readFileSync(svg, 'utf8'), /<script|<image|href=|url\(|@import|@font-face|\son\w+=/, svg);
});

for (const [what, page, figures, said] of [
  ['a flight that failed', report(), { ...summary, completed: false, reason: 'crashed' }, 'crashed'],
  ['a page without a document', '<p>a page</p>', summary, 'no flight document'],
  ['a report without a track', report((document) => ({ ...document, series: [] })), summary, 'no ground track'],
  ['another mission', report().replace('"index":2', '"index":99'), summary, 'item 99'],
  ['a mission that is not there', report(), { ...summary, mission: 'none' }, 'ENOENT'],
]) {
  test(`${what} is refused in one line, and nothing is written`, () => {
    const { status, stderr } = draw(page, figures);
    assert.equal(status, 1);
    assert.match(stderr, /^picture: .*\n$/);
    assert.ok(stderr.includes(said), stderr);
    assert.ok(!existsSync(out));
  });
}

test('wrong words are status 2', () => {
  for (const words of [['--nothing'], ['a', 'b'], ['-o']])
    assert.equal(spawnSync(join(root, 'toolchain/picture'), words).status, 2, words.join(' '));
});
