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

const map = `<svg class="chart" viewBox="0 0 620 830" role="img" aria-label="north of home, m over east of home, m">
<text x="1" y="2" class="name">2</text><text x="3" y="4" class="name">11</text><text x="5" y="6" class="name">15 land</text>
</svg>`;
const altitude = '<svg class="chart" viewBox="0 0 960 260" aria-label="altitude above home, m over time"></svg>';
const summary = { completed: true, mission: 'first_flight.waypoints', firmware: 'a<b.elf', board: 'apm2',
  wind_mps: 0, wind_from_deg: 0, gusts: false, seed: 1, flight_time_s: 335.06, cpu_load: 0.304 };

function draw(page, figures) {
  rmSync(out, { force: true });
  writeFileSync(join(folder, 'report.html'), page);
  writeFileSync(join(folder, 'summary.json'), JSON.stringify(figures));
  return spawnSync(join(root, 'toolchain/picture'), ['-o', out, folder], { encoding: 'utf8' });
}

test('the picture has title, figures, the mission by name, and both charts', () => {
  assert.equal(draw(`<p>${map}</p>${altitude}`, summary).status, 0);
  const svg = readFileSync(out, 'utf8');
  for (const part of ['mission completed', 'a&#60;b.elf on apm2', '>335 s<', '>30 %<', '>take-off to 45 m<',
    '>loiter, 2 turns at 60 m<', '>2</text>', '>11 loiter</text>', '>15 land</text>', 'width="600" height="803"'])
    assert.ok(svg.includes(part), part);
  assert.doesNotMatch(svg, /undefined|NaN/);
  assert.doesNotMatch(svg, /touch-down/, 'a figure that the summary has not');
});

test('it needs nothing from elsewhere', () => {
  assert.equal(draw(map + altitude, summary).status, 0);
  for (const svg of [out, join(root, 'docs/first_flight.svg')])
    assert.doesNotMatch(readFileSync(svg, 'utf8'), /<script|<image|href=|url\(|@import|@font-face|\son\w+=/, svg);
});

for (const [what, page, figures, said] of [
  ['a flight that failed', map + altitude, { ...summary, completed: false, reason: 'crashed' }, 'crashed'],
  ['a report without a map', altitude, summary, 'no ground track'],
  ['another mission', map.replace('>2<', '>99<') + altitude, summary, 'item 99'],
  ['a mission that is not there', map + altitude, { ...summary, mission: 'none' }, 'ENOENT'],
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
