// SPDX-License-Identifier: GPL-3.0-or-later
// A fence: loaded, read back, shown, and flown against.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertSame, beside, distance_m, download, fence, flies, kCircleIn, kCircleOut, kExclusion, kFence, said,
  setParameter, takeOff, upload, zones } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kGuided = 15, kAuto = 10, kEnable = 207, kGeofence = 0x100000;
const square = fence(300);

test('goes up and comes down the same', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  assert.equal(await upload(vehicle, square, kFence), 0);
  assertSame(await download(vehicle, kFence), square);
  vehicle.send('MISSION_CLEAR_ALL', { missionType: kFence });
  assert.equal((await vehicle.expect('MISSION_ACK', { within_ms: 3000 })).type, 0);
  assert.equal((await download(vehicle, kFence)).length, 0);
}));

test('of all kinds of zones goes up and comes down the same', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  const all = zones({ command: kCircleIn, param1: 1500, ...beside(20, 30) },
    { command: kCircleOut, param1: 87.5, ...beside(-400, 0) });
  assert.equal(await upload(vehicle, all, kFence), 0);
  assertSame(await download(vehicle, kFence), all);
}));

test('what it does not fly is refused, with the reason', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  assert.equal(await upload(vehicle, square, kFence), 0);
  const mixed = square.map((item, i) => ({ ...item, command: i === 3 ? kExclusion : item.command }));
  assert.equal(await upload(vehicle, mixed, kFence), 6);
  await said(vehicle, /Item 3 refused: corners or radius/);
  const tooLarge = zones({ command: kCircleIn, param1: 10_001, ...beside(0, 0) });
  assert.equal(await upload(vehicle, tooLarge, kFence), 6);
  await said(vehicle, /Item 7 refused: corners or radius/);
  const waypoint = square.map((item, i) => ({ ...item, command: i === 1 ? 16 : item.command }));
  assert.equal(await upload(vehicle, waypoint, kFence), 3);
  await said(vehicle, /Item 1 refused: no part of a fence/);
  vehicle.send('MISSION_COUNT', { count: 21, missionType: kFence });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 4);
  assertSame(await download(vehicle, kFence), square);
}));

test('does not go up by the messages of before the mission protocol: a text says so', withVehicle({}, async (vehicle) => {
  for (const [name, fields] of [['FENCE_POINT', { idx: 0, count: 6, lat: 47, lng: 8 }], ['FENCE_FETCH_POINT', { idx: 0 }],
    ['RALLY_POINT', { idx: 0, count: 1 }], ['RALLY_FETCH_POINT', { idx: 0 }]]) {
    vehicle.send(name, fields);
    await said(vehicle, /Fence and rally: only as mission items/);
  }
  assert.equal(await setParameter(vehicle, 'FENCE_TOTAL', 6), 0);
  await said(vehicle, /Parameter is read-only/);
}));

test('turns the airplane back from a zone', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  const centre = beside(500, 0), radius_m = 120, wayBack = beside(80, 60);
  assert.equal(await upload(vehicle, zones({ command: kCircleOut, param1: radius_m, ...centre }), kFence), 0);
  assert.equal(await setParameter(vehicle, 'FENCE_ACTION', 1), 1);
  await takeOff(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 6, reqMessageRate: 5, startStop: 1 });
  assert.equal(await vehicle.command(kEnable, [1]), 0);

  vehicle.send('MISSION_ITEM_INT', { command: 16, frame: 6, current: 2, ...centre, z: 60 });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 0);
  await said(vehicle, /Fence breach: outside/, 40_000);
  vehicle.forget();
  const entered = await vehicle.expect('GLOBAL_POSITION_INT');
  const beyond_m = distance_m(centre, entered) - radius_m;
  assert.ok(beyond_m < 0 && beyond_m > -40, `turned back ${beyond_m} m from the edge`);
  await flies(vehicle, 60, (place) => distance_m(wayBack, place) < 90);
}));

test('turns the airplane back', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  const wayBack = beside(80, 60);
  assert.equal(await upload(vehicle, fence(250, wayBack), kFence), 0);
  assert.equal(await setParameter(vehicle, 'FENCE_ACTION', 1), 1);
  await takeOff(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 6, reqMessageRate: 5, startStop: 1 });
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 2, reqMessageRate: 2, startStop: 1 });
  assert.equal(await vehicle.command(kEnable, [1]), 0);

  // a place outside, which it must not get to
  const outside = beside(900, 0);
  vehicle.send('MISSION_ITEM_INT', { command: 16, frame: 6, current: 2, ...outside, z: 60 });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 0);
  await said(vehicle, /Fence breach: outside/, 40_000);
  vehicle.forget();
  const status = await vehicle.expect('FENCE_STATUS', { where: ({ breachStatus }) => breachStatus === 1 });
  assert.equal(status.breachCount, 1);
  assert.equal(status.breachType, 3);
  const health = await vehicle.expect('SYS_STATUS');
  assert.ok(health.onboardControlSensorsEnabled & kGeofence);
  assert.ok(!(health.onboardControlSensorsHealth & kGeofence));
  const mode = await vehicle.expect('HEARTBEAT', { within_ms: 1500 });
  assert.equal(mode.customMode, kGuided);
  await flies(vehicle, 60, (place) => distance_m(wayBack, place) < 90);
  await vehicle.expect('FENCE_STATUS', { where: ({ breachStatus }) => breachStatus === 0 });

  // the pilot may choose again; AUTO's waypoints are inside or not, the fence is off now
  assert.equal(await vehicle.command(kEnable, [0]), 0);
  assert.equal(await vehicle.command(176, [1, kAuto]), 0);
}));
