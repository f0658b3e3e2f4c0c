// SPDX-License-Identifier: GPL-3.0-or-later
// A flight of a campaign flown again by its command line, on the image: thrown, parameters set by
// wire, elevons. FLY names the program, MINUTES a file for the emulated minutes.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { appendFileSync, mkdirSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test from 'node:test';

const { FLY, MINUTES } = process.env;
const seconds = 45;

function flown(...kind) {
  const out = mkdtempSync(join(tmpdir(), 'replay-'));
  const words = ['--airplane', 'flying_wing', '--wind', '7,320', '--gusts', '--seed', '3',
    '--time-limit', `${seconds}`, '--out', out];
  const { stdout, stderr } = spawnSync(FLY, [...kind, ...words]);
  const said = `${stdout}${stderr}`;
  assert.match(said, /not completed: time limit reached after item 2/);
  const rows = readFileSync(join(out, 'flight.csv'), 'utf8').trim().split('\n');
  const names = rows[0].split(',');
  const column = (name) => rows.slice(1).map((row) => Number(row.split(',')[names.indexOf(name)]));
  return { summary: JSON.parse(readFileSync(join(out, 'summary.json'))), column };
}

test('a thrown wing flies on the image as it does natively', () => {
  const native = flown('--native');
  const image = flown();
  mkdirSync(dirname(MINUTES), { recursive: true });
  appendFileSync(MINUTES, `${seconds / 60}\n`);
  for (const { summary, column } of [native, image]) {
    assert.deepEqual(summary.items_reached, [1]);
    const right = column('servo1_us');
    const left = column('servo2_us');
    const apart = right.map((us, i) => Math.abs(us - left[i]));
    assert.ok(Math.max(...apart) > 100, 'the elevons never went apart');
    assert.ok(Math.max(...column('height_m')) > 40);
  }
  const speeds = [native, image].map(({ column }) => column('equivalent_airspeed_mps').at(-1));
  assert.ok(Math.abs(speeds[0] - speeds[1]) < 2, `${speeds}`);
});
