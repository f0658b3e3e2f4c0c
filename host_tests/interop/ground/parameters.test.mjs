// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { withVehicle } from '../../support/vehicle.mjs';

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

for (const version of [1, 2])
  test(`reads one parameter by name and the same by index, MAVLink ${version}`,
    withVehicle({}, async (vehicle) => {
      vehicle.line.version = version;
      vehicle.send('PARAM_REQUEST_READ', { paramId: 'BATT_CAPACITY', paramIndex: -1 });
      const byName = await vehicle.expect('PARAM_VALUE');
      assert.equal(byName.paramId, 'BATT_CAPACITY');
      assert.equal(byName.paramType, 6);  // a whole number of 32 bits, as a float
      assert.equal(byName.paramValue, 3300);
      vehicle.send('PARAM_REQUEST_READ', { paramId: '', paramIndex: byName.paramIndex });
      assert.deepEqual(await vehicle.expect('PARAM_VALUE'), byName);
    }));

test('does not invent a parameter', withVehicle({}, async (vehicle) => {
  vehicle.send('PARAM_REQUEST_READ', { paramId: 'NO_SUCH_NAME', paramIndex: -1 });
  vehicle.send('PARAM_REQUEST_READ', { paramId: '', paramIndex: 9999 });
  assert.equal(await vehicle.next('PARAM_VALUE'), undefined);
  set(vehicle, 'NO_SUCH_NAME', 1);
  await vehicle.expect('STATUSTEXT', { where: ({ text }) => /No such parameter/.test(text) });
  assert.equal(await vehicle.next('PARAM_VALUE'), undefined);
}));

test('gives the whole list on both links at once', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  vehicle.forget();
  for (const line of vehicle.lines) line.send('PARAM_REQUEST_LIST');
  await vehicle.wait(5000);
  for (const line of vehicle.lines) {
    const values = line.inbox.filter(({ name }) => name === 'PARAM_VALUE').map(({ data }) => data);
    assert.ok(values.length > 100, `${values.length} values`);
    assert.equal(values.length, values[0].paramCount);
    assert.deepEqual(values.map(({ paramIndex }) => paramIndex), values.map((_, i) => i));
    assert.ok(line.inbox.filter(({ name }) => name === 'HEARTBEAT').length >= 4);
  }
}));

test('sends a new value on the other link too', withVehicle({}, async (vehicle) => {
  set(vehicle, 'WP_RADIUS', 42);
  await vehicle.expect('PARAM_VALUE');
  const heard = vehicle.lines[1].inbox.filter(({ name }) => name === 'PARAM_VALUE');
  assert.equal(heard.length, 1);
  assert.equal(heard[0].data.paramId, 'WP_RADIUS');
  assert.equal(heard[0].data.paramValue, 42);
}));

test('shows the declination of the place it is at', withVehicle({}, async (vehicle) => {
  assert.equal(await read(vehicle, 'COMPASS_DEC'), 0);
  await vehicle.expect('GPS_RAW_INT', { within_ms: 20000, where: ({ fixType }) => fixType >= 3 });
  await vehicle.wait(1500);
  const declination_deg = await read(vehicle, 'COMPASS_DEC') * 180 / Math.PI;
  assert.ok(Math.abs(declination_deg - 3.8) < 0.5, `${declination_deg}`);  // Zurich, 2027
}));

// Powers on with what the EEPROM holds since the last time.
async function withEeprom(...flights) {
  const folder = mkdtempSync(join(tmpdir(), 'eeprom-'));
  const options = ['--eeprom', join(folder, 'eeprom.bin')];
  try {
    for (const flight of flights) await withVehicle({ options }, flight)();
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function setAndStore(vehicle) {
  await vehicle.wait(1000);  // the store is busy reading the mission at first
  for (const [name, value] of [['WP_RADIUS', 42], ['TECS_TIME_CONST', 3.5], ['RC2_REV', -1]]) {
    set(vehicle, name, value);
    assert.equal((await vehicle.expect('PARAM_VALUE', { within_ms: 3000 })).paramValue, value);
  }
}
const everyByteWritten_ms = 3000;

test('values that were set are there after the next power-on', () => withEeprom(
  async (vehicle) => {
    await setAndStore(vehicle);
    await vehicle.wait(everyByteWritten_ms);
  },
  async (vehicle) => {
    assert.equal(await read(vehicle, 'WP_RADIUS'), 42);
    assert.equal(await read(vehicle, 'TECS_TIME_CONST'), 3.5);
    assert.equal(await read(vehicle, 'RC2_REV'), -1);
  }));

// Mission Planner's "Reset to Default", QGroundControl's "Reset all to firmware's defaults".
for (const [name, reset] of [
  ['FORMAT_VERSION 0', async (vehicle) => {
    set(vehicle, 'FORMAT_VERSION', 0);
    await vehicle.expect('PARAM_VALUE', { where: ({ paramValue }) => paramValue === 0 });
  }],
  ['PREFLIGHT_STORAGE', async (vehicle) => {
    assert.equal(await vehicle.command(245, [2, -1]), 0);
  }],
])
  test(`all parameters are the defaults again after ${name} and a restart`, () => withEeprom(
    async (vehicle) => {
      await setAndStore(vehicle);
      await reset(vehicle);
      assert.equal(await read(vehicle, 'WP_RADIUS'), 42);
      await vehicle.wait(everyByteWritten_ms);
    },
    async (vehicle) => {
      assert.equal(await read(vehicle, 'WP_RADIUS'), 30);
      await vehicle.expect('STATUSTEXT',
        { within_ms: 5000, where: ({ text }) => /are the defaults/.test(text) });
      await vehicle.wait(everyByteWritten_ms);
    },
    async (vehicle) => {
      assert.equal(await read(vehicle, 'WP_RADIUS'), 30);
      assert.equal(await read(vehicle, 'RC2_REV'), 1);
      assert.equal(await read(vehicle, 'FORMAT_VERSION'), 1);
    }));

test('a value that was set stands after a restart by command', withVehicle({}, async (vehicle) => {
  await setAndStore(vehicle);
  assert.equal(await vehicle.command(246, [1]), 0);
  await vehicle.expect('STATUSTEXT',  // of a start
    { within_ms: 10000, where: ({ text }) => /airplane/.test(text) });
  assert.equal(await read(vehicle, 'WP_RADIUS'), 42);
  assert.equal(await read(vehicle, 'TECS_TIME_CONST'), 3.5);
}));
