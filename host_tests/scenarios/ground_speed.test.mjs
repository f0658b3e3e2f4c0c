// SPDX-License-Identifier: GPL-3.0-or-later
// MIN_GNDSPD_CM in a wind nearly as fast as the airplane: into it that is the speed over ground, but
// for the seconds that the throttle takes behind a turn. FLY names the program.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

const kFrom_deg = 320, kInto_deg = 20;
const kLeast_mps = 5, kSlack_mps = 0.5, kSlackBehindTurns_mps = 2;
const kAuto = 10, kFastest_mps = 22;

const folder = mkdtempSync(join(tmpdir(), 'ground-speed-'));
after(() => rmSync(folder, { recursive: true }));

const fromWind_deg = (yaw_deg) => Math.abs(((yaw_deg - kFrom_deg + 540) % 360) - 180);

// Into the wind, on the legs that are flown and have been captured.
function flown(name, least_cms) {
  const out = join(folder, name), parameters = join(folder, `${name}.param`);
  writeFileSync(parameters, `MIN_GNDSPD_CM,${least_cms}\n`);
  const { status, stdout } = spawnSync(process.env.FLY, ['--native', '--wind', `11,${kFrom_deg}`, '--param', parameters, '--out', out],
    { encoding: 'utf8' });
  assert.equal(status, 0, stdout);
  const [head, ...rows] = readFileSync(join(out, 'flight.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  const at = (row, column) => Number(row[head.indexOf(column)]);
  return rows.filter((row) => at(row, 'mode') === kAuto && at(row, 'leg_captured') === 1
    && fromWind_deg(at(row, 'yaw_deg')) < kInto_deg)
    .map((row) => ({ ground_mps: at(row, 'ground_speed_mps'), air_mps: at(row, 'equivalent_airspeed_mps') }));
}
const slowest = (rows) => Math.min(...rows.map(({ ground_mps }) => ground_mps));
const median = (rows) => rows.map(({ ground_mps }) => ground_mps).sort((a, b) => a - b)[rows.length >> 1];

test('into the wind it flies as fast as the least ground speed needs', () => {
  const without = flown('without', 0), held = flown('held', 100 * kLeast_mps);
  assert.ok(slowest(without) < kLeast_mps / 2, `${slowest(without)} m/s without it: the wind is no trial`);
  assert.ok(Math.abs(median(held) - kLeast_mps) < kSlack_mps, `${median(held)} m/s over ground`);
  assert.ok(slowest(held) > kLeast_mps - kSlackBehindTurns_mps, `${slowest(held)} m/s at the slowest`);
  assert.ok(Math.max(...held.map(({ air_mps }) => air_mps)) < kFastest_mps);
});
