// SPDX-License-Identifier: GPL-3.0-or-later
// What "fly to here" of a ground station does: one flight, from the runway into GUIDED and around
// in it, by every message that ground stations use for it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { beside, distance_m, flies, home, takeOff } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kGuided = 15, kAuto = 10;
const kGlobalInt = 5, kRelativeInt = 6, kTerrainInt = 11;
const kReposition = 192, kChangeAltitude = 186, kChangeSpeed = 178, kSetHome = 179,
  kChangeHeading = 43_002;
const kRadius_m = 60;

async function commandInt(vehicle, command, frame, { x, y }, z, params = []) {
  const fields = { command, frame, _param5: x, _param6: y, _param7: z };
  for (let i = 0; i < 4; ++i) fields[`_param${i + 1}`] = params[i] ?? 0;
  vehicle.send('COMMAND_INT', fields);
  return (await vehicle.expect('COMMAND_ACK', { where: (data) => data.command === command })).result;
}

async function inMode(vehicle, mode) {
  vehicle.forget();
  const heartbeat = await vehicle.expect('HEARTBEAT', { within_ms: 1200 });
  assert.equal(heartbeat.customMode, mode);
}

const truth = async (vehicle) => JSON.parse(await vehicle.order('state'));

test('fly guided', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  await takeOff(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 6, reqMessageRate: 5, startStop: 1 });

  // MAVProxy's and Mission Planner's way: an item that is none
  const first = beside(200, -250);
  vehicle.send('MISSION_ITEM_INT', { command: 16, frame: kRelativeInt, current: 2, ...first, z: 60 });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 0);
  await inMode(vehicle, kGuided);
  await flies(vehicle, 45, (at) => distance_m(first, at) < kRadius_m + 15);

  // somewhere that cannot be flown to changes nothing
  assert.equal(await commandInt(vehicle, kReposition, kTerrainInt, first, 60, [-1, 1]), 9);
  assert.equal(await commandInt(vehicle, kReposition, kRelativeInt, { x: 950_000_000, y: 0 }, 60,
    [-1, 1]), 2);
  vehicle.send('MISSION_ITEM_INT', { command: 16, frame: 1, current: 2, ...first, z: 60 });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 2);

  // QGroundControl's way, above sea level, slower, around a smaller circle the other way
  const second = beside(200, -50);
  assert.equal(await vehicle.command(kChangeSpeed, [0, 12, -1]), 0);
  assert.equal(await vehicle.command(kChangeSpeed, [0, 60, -1]), 2);
  assert.equal(await commandInt(vehicle, kReposition, kGlobalInt, second, home.z + 70,
    [-1, 1, 50, 1]), 0);
  await flies(vehicle, 40, (at) => distance_m(second, at) < 65);
  await vehicle.wait(12_000);
  for (let look = 0; look < 3; ++look) {
    await vehicle.wait(2000);
    const at = await flies(vehicle, 1, () => true);
    assert.ok(Math.abs(distance_m(second, at) - 50) < 8, `${distance_m(second, at)} m from the middle`);
    assert.ok(Math.abs(at.relativeAlt / 1000 - 70) < 3, `${at.relativeAlt} mm high`);
    const now = await truth(vehicle);
    assert.ok(Math.abs(now.airspeed_mps - 12) < 1.5, `${now.airspeed_mps} m/s`);
    assert.ok(now.roll_rad < -0.1, 'turns left');
  }

  // a new home moves the numbers, not the airplane
  const before = await truth(vehicle);
  assert.equal(await commandInt(vehicle, kSetHome, kGlobalInt, second, home.z + 30), 0);
  await vehicle.wait(6000);
  const after = await truth(vehicle);
  assert.ok(Math.abs(after.altitude_m - before.altitude_m) < 2,
    `${before.altitude_m} m became ${after.altitude_m} m`);
  const at = await flies(vehicle, 1, () => true);
  assert.ok(Math.abs(at.relativeAlt / 1000 - 40) < 3, `${at.relativeAlt} mm above the new home`);

  // the height alone: MAVProxy's changealt, and the older way
  assert.equal(await vehicle.command(kChangeAltitude, [60, 3]), 0);
  await flies(vehicle, 25, ({ relativeAlt }) => relativeAlt > 57_000);
  vehicle.send('MISSION_ITEM_INT', { command: 16, frame: kRelativeInt, current: 3, x: 0, y: 0, z: 45 });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 0);
  const lower = await flies(vehicle, 25, ({ relativeAlt }) => relativeAlt < 48_000);
  assert.ok(distance_m(second, lower) < 65, 'left its place');

  // straight on along a course, at that height
  for (const course_deg of [90, 300]) {
    assert.equal(await vehicle.command(kChangeHeading, [0, course_deg, 0]), 0);
    await vehicle.wait(12_000);
    const { vx, vy, relativeAlt } = await flies(vehicle, 1, () => true);
    const off_deg = Math.atan2(vy, vx) * 180 / Math.PI - course_deg;
    assert.ok(Math.abs(off_deg - 360 * Math.round(off_deg / 360)) < 3, `${off_deg} degrees off ${course_deg}`);
    assert.ok(Math.abs(relativeAlt / 1000 - 45) < 3, `${relativeAlt} mm high`);
  }
  assert.equal(await vehicle.command(kChangeHeading, [1, 90, 0]), 2, 'not of the nose');

  // on the ground alone
  assert.equal(await vehicle.command(241, [1]), 2);
  assert.equal(await vehicle.command(246, [1]), 1);
  await inMode(vehicle, kGuided);
  assert.equal(await vehicle.command(176, [1, kAuto]), 0);
  await inMode(vehicle, kAuto);
}));
