// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { Vehicle, withVehicle } from './vehicle.mjs';

const set = (vehicle, paramId, paramValue) =>
  vehicle.send('PARAM_SET', { paramId, paramValue, paramType: 9 });

async function read(vehicle, paramId) {
  vehicle.send('PARAM_REQUEST_READ', { paramId, paramIndex: -1 });
  return (await vehicle.expect('PARAM_VALUE', { where: (data) => data.paramId === paramId }))
    .paramValue;
}

for (const version of [1, 2])
  test(`gives the whole list, in order, near the speed of the wire, MAVLink ${version}`,
    withVehicle({}, async (vehicle) => {
      await vehicle.wait(1000);
      vehicle.line.version = version;
      vehicle.send('PARAM_REQUEST_LIST');
      const first = await vehicle.expect('PARAM_VALUE');
      const values = [first];
      const began_ms = vehicle.now_ms;
      while (values.length < first.paramCount) values.push(await vehicle.expect('PARAM_VALUE'));
      const took_ms = vehicle.now_ms - began_ms;

      assert.deepEqual(values.map(({ paramIndex }) => paramIndex), values.map((_, i) => i));
      assert.equal(new Set(values.map(({ paramId }) => paramId)).size, values.length);
      assert.ok(values.some(({ paramId, paramValue }) => paramId === 'SYSID_MYGCS' && paramValue === 255));
      const wire_ms = values.length * (version === 1 ? 33 : 37) * 10 / 57.6;
      assert.ok(took_ms <= wire_ms * 1.4 + 100, `${took_ms} ms, the wire alone ${wire_ms} ms`);
    }));

test('sets a parameter and answers with what it now is', withVehicle({}, async (vehicle) => {
  set(vehicle, 'TRIM_ARSPD_CM', 1350);
  assert.equal((await vehicle.expect('PARAM_VALUE')).paramValue, 1350);
  assert.equal(await read(vehicle, 'TRIM_ARSPD_CM'), 1350);
}));

test('refuses a value out of range aloud, and keeps the old one', withVehicle({}, async (vehicle) => {
  const before = await read(vehicle, 'TRIM_ARSPD_CM');
  for (const value of [-1e9, NaN]) {
    set(vehicle, 'TRIM_ARSPD_CM', value);
    assert.equal((await vehicle.expect('PARAM_VALUE')).paramValue, before);
    await vehicle.expect('STATUSTEXT', { where: ({ text }) => /refused/.test(text) });
  }
}));

test('a value that was set is there after the next power-on', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'eeprom-'));
  const options = ['--eeprom', join(folder, 'eeprom.bin')];
  try {
    const first = await Vehicle.start({ options });
    await first.boot();
    set(first, 'WP_RADIUS', 42);
    await first.expect('PARAM_VALUE');
    await first.wait(3000);  // the store is busy reading the mission at first
    await first.stop();
    const second = await Vehicle.start({ options });
    await second.boot();
    assert.equal(await read(second, 'WP_RADIUS'), 42);
    await second.stop();
  } finally {
    rmSync(folder, { recursive: true });
  }
});
