// SPDX-License-Identifier: GPL-3.0-or-later
// An image that the parameter tool has made, on the board: it boots with the values of the file; and
// what a ground station then sets is in the file that the tool makes of the EEPROM. FLY and
// PARAM_TOOL name the programs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { withVehicle } from '../support/vehicle.mjs';

const tool = (...words) => execFileSync(process.env.PARAM_TOOL, words,
  { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });

test('the board boots with the values of a file, and the tool reads back what it holds', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'param-tool-'));
  const [file, image] = [join(folder, 'plane.param'), join(folder, 'plane.bin')];
  try {
    writeFileSync(file, '#NOTE: a plane\r\nWP_RADIUS,42\r\nTECS_TIME_CONST 3.25\n');
    tool('compile', file, '-o', image);
    await withVehicle({ options: ['--eeprom', image] }, async (vehicle) => {
      for (const [paramId, value] of [['WP_RADIUS', 42], ['TECS_TIME_CONST', 3.25]]) {
        vehicle.send('PARAM_REQUEST_READ', { paramId, paramIndex: -1 });
        assert.equal((await vehicle.expect('PARAM_VALUE')).paramValue, value);
      }
      await vehicle.wait(1000);  // the store is busy reading the mission at first
      vehicle.send('PARAM_SET', { paramId: 'THR_MAX', paramValue: 80, paramType: 2 });
      assert.equal((await vehicle.expect('PARAM_VALUE', { within_ms: 3000 })).paramValue, 80);
      await vehicle.wait(2000);
    })();
    assert.deepEqual(tool('decode', image, '--changed').trim().split('\n').sort(),
      ['TECS_TIME_CONST,3.25', 'THR_MAX,80', 'WP_RADIUS,42']);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
