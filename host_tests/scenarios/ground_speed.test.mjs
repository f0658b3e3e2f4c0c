// SPDX-License-Identifier: GPL-3.0-or-later
// MIN_GNDSPD_CM in a wind nearly as fast as the airplane: into it that is the speed over ground, but
// for the seconds that the throttle takes behind a turn. FLY names the program.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { flown } from '../support/flown.mjs';

const kFrom_deg = 320, kInto_deg = 20;
const kLeast_mps = 5, kSlack_mps = 0.5, kSlackBehindTurns_mps = 2;
const kAuto = 10, kFastest_mps = 22;

const folder = mkdtempSync(join(tmpdir(), 'ground-speed-'));
after(() => rmSync(folder, { recursive: true }));

const fromWind_deg = (yaw_deg) => Math.abs(((yaw_deg - kFrom_deg + 540) % 360) - 180);

// Into the wind, on the legs that are flown and have been captured.
function intoTheWind(name, least_cms) {
  const parameters = join(folder, `${name}.param`);
  writeFileSync(parameters, `MIN_GNDSPD_CM,${least_cms}\n`);
  return flown(join(folder, name), ['--wind', `11,${kFrom_deg}`, '--param', parameters])
    .filter((row) => row.mode === kAuto && row.leg_captured === 1 && fromWind_deg(row.yaw_deg) < kInto_deg);
}
const speeds_mps = (rows) => rows.map((row) => row.ground_speed_mps).sort((a, b) => a - b);
const slowest = (rows) => speeds_mps(rows)[0];
const median = (rows) => speeds_mps(rows)[rows.length >> 1];

test('into the wind it flies as fast as the least ground speed needs', () => {
  const without = intoTheWind('without', 0), held = intoTheWind('held', 100 * kLeast_mps);
  assert.ok(slowest(without) < kLeast_mps / 2, `${slowest(without)} m/s without it: the wind is no trial`);
  assert.ok(Math.abs(median(held) - kLeast_mps) < kSlack_mps, `${median(held)} m/s over ground`);
  assert.ok(slowest(held) > kLeast_mps - kSlackBehindTurns_mps, `${slowest(held)} m/s at the slowest`);
  assert.ok(Math.max(...held.map((row) => row.equivalent_airspeed_mps)) < kFastest_mps);
});
