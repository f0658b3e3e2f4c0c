// SPDX-License-Identifier: GPL-3.0-or-later
// Without fixes the mission is flown on by nose, air and wind, and no loop swings by that: each
// aileron turns the nose a little before it turns the course. FLY names the program.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { flown } from '../support/flown.mjs';

const kLost_s = 50, kBack_s = 75;
const kMiddle_us = 1500, kFar_us = 150;  // of 400 to either side
const kMaxSwings = 6;  // two turns, each begun and ended, and a gust

const folder = mkdtempSync(join(tmpdir(), 'dead-reckoning-'));
after(() => rmSync(folder, { recursive: true }));

// How often the pulse goes from far out on one side to far out on the other.
function swings(pulses_us) {
  let side = 0, count = 0;
  for (const pulse_us of pulses_us) {
    const off_us = pulse_us - kMiddle_us;
    if (Math.abs(off_us) < kFar_us || Math.sign(off_us) === side) continue;
    if (side !== 0) ++count;
    side = Math.sign(off_us);
  }
  return count;
}

for (const airplane of ['foam_trainer', 'trainer_6kg', 'flying_wing'])
  for (const wind of ['0,0', '5,320'])
    test(`the ailerons of the ${airplane} do not swing without fixes, wind ${wind}`, () => {
      const rows = flown(join(folder, `${airplane}${wind}`), ['--airplane', airplane, '--wind', wind,
        '--fault', `gps:lost@${kLost_s}-${kBack_s}`]);
      const between = rows.filter(({ time_s }) => time_s > kLost_s && time_s < kBack_s);
      const found = swings(between.map(({ servo1_us }) => servo1_us));
      assert.ok(between.length > 200 && found <= kMaxSwings, `${found} times`);
    });
