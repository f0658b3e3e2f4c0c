// SPDX-License-Identifier: GPL-3.0-or-later
// Rally points: loaded, read back, and returned to.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertSame, beside, distance_m, download, flies, kRally, rally, said, setParameter,
  takeOff, upload } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kRtl = 11;
const points = rally([-150, 200, 55.5], [400, 900, 80], [-500, -700, 45]);

test('go up and come down the same', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  assert.equal(await upload(vehicle, points, kRally), 0);
  assertSame(await download(vehicle, kRally), points);
  vehicle.send('MISSION_COUNT', { count: 11, missionType: kRally });
  assert.equal((await vehicle.expect('MISSION_ACK')).type, 4);
  vehicle.send('MISSION_CLEAR_ALL', { missionType: 255 });
  assert.equal((await vehicle.expect('MISSION_ACK', { within_ms: 3000 })).type, 0);
  assert.equal((await download(vehicle, kRally)).length, 0);
}));

test('RTL flies to the nearest', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  assert.equal(await upload(vehicle, points, kRally), 0);
  assert.equal(await setParameter(vehicle, 'RALLY_LIMIT_KM', 2), 2);
  await takeOff(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 6, reqMessageRate: 5, startStop: 1 });
  assert.equal(await vehicle.command(176, [1, kRtl]), 0);
  await said(vehicle, /Going to rally point 0/);
  await flies(vehicle, 90, (place) => Math.abs(distance_m(beside(-150, 200), place) - 60) < 15 &&
    Math.abs(place.relativeAlt - 55_500) < 5000);
}));
