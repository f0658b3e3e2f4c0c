// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withVehicle } from '../../support/vehicle.mjs';

const streams = {
  1: ['RAW_IMU', 'SCALED_PRESSURE'],
  2: ['SYS_STATUS', 'GPS_RAW_INT', 'NAV_CONTROLLER_OUTPUT', 'MISSION_CURRENT'],
  3: ['SERVO_OUTPUT_RAW', 'RC_CHANNELS_RAW', 'RC_CHANNELS'],
  6: ['GLOBAL_POSITION_INT'],
  10: ['ATTITUDE'],
  11: ['VFR_HUD'],
  12: ['AHRS', 'WIND'],
};
// with some of them, but once a second
const slow = {
  2: ['POWER_STATUS', 'EXTENDED_SYS_STATE'],
  12: ['HWSTATUS', 'SYSTEM_TIME', 'VIBRATION', 'EKF_STATUS_REPORT'],
};

const request = (vehicle, stream, rate) => vehicle.send('REQUEST_DATA_STREAM',
  { reqStreamId: stream, reqMessageRate: rate, startStop: rate > 0 ? 1 : 0 });

async function counted(vehicle, time_ms) {
  await vehicle.wait(300);
  vehicle.forget();
  await vehicle.wait(time_ms);
  const counts = {};
  for (const { name } of vehicle.line.inbox) counts[name] = (counts[name] ?? 0) + 1;
  vehicle.forget();
  return counts;
}

test('each stream comes at the rate it was asked for', withVehicle({}, async (vehicle) => {
  request(vehicle, 0, 0);
  for (const [stream, names] of Object.entries(streams)) {
    for (const rate of [2, 10]) {
      request(vehicle, +stream, rate);
      const counts = await counted(vehicle, 2000);
      for (const name of names)
        assert.ok(Math.abs(counts[name] - 2 * rate) <= 1, `${name}: ${counts[name]} in 2 s`);
      for (const name of slow[stream] ?? []) assert.equal(counts[name], 2, name);
    }
    request(vehicle, +stream, 0);
    const counts = await counted(vehicle, 1000);
    for (const name of [...names, ...slow[stream] ?? []]) assert.equal(counts[name], undefined, name);
  }
}));

// What changes slowly.
test('comes slowly what is shown as numbers alone', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  request(vehicle, 0, 0);
  for (const rate of [2, 10, 0]) {
    request(vehicle, 12, rate);
    const counts = await counted(vehicle, 3000);
    for (const name of ['VIBRATION', 'EKF_STATUS_REPORT'])
      assert.equal(counts[name] ?? 0, rate > 0 ? 3 : 0, `${name} in 3 s`);
  }
}));

for (const version of [1, 2])
  test(`all streams at 10 Hz are 10 Hz on a line of 57,600 baud, MAVLink ${version}`,
    withVehicle({}, async (vehicle) => {
      vehicle.line.version = version;
      request(vehicle, 0, 10);
      const counts = await counted(vehicle, 5000);
      for (const names of Object.values(streams))
        for (const name of names)
          assert.ok(Math.abs(counts[name] - 50) <= 1, `${name}: ${counts[name]} in 5 s`);
      assert.ok(Math.abs(counts.HEARTBEAT - 5) <= 1);
    }));

test('one message can have an interval of its own', withVehicle({}, async (vehicle) => {
  request(vehicle, 0, 0);
  assert.equal(await vehicle.command(511, [30, 50_000]), 0);
  const counts = await counted(vehicle, 2000);
  assert.ok(Math.abs(counts.ATTITUDE - 40) <= 1, `${counts.ATTITUDE} in 2 s`);
  assert.equal(await vehicle.command(510, [30]), 0);
  assert.equal((await vehicle.expect('MESSAGE_INTERVAL')).intervalUs, 50_000);
}));
