// SPDX-License-Identifier: GPL-3.0-or-later
// Two ground stations at once, one on each line: one changes a list, the other is informed that it
// cannot, and gets its turn afterwards.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertSame, download, fence, kFence, kRally, plan, rally, upload } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kDenied = 14, kCancelled = 15;
const points = rally([-150, 200, 55.5], [400, 900, 80]);

async function at(vehicle, line, talk) {
  const own = vehicle.line;
  vehicle.line = vehicle.lines[line];
  vehicle.line.version = 2;
  try {
    return await talk();
  } finally {
    vehicle.line = own;
  }
}
const one = (vehicle, talk) => at(vehicle, 0, talk);
const other = (vehicle, talk) => at(vehicle, 1, talk);
const ack = async (vehicle, within_ms = 3000) => (await vehicle.expect('MISSION_ACK', { within_ms })).type;

test('whose upload is open keeps it; the other is denied every list', withVehicle({}, async (vehicle) => {
  const square = fence(300);
  await one(vehicle, async () => {
    vehicle.send('MISSION_COUNT', { count: square.length, missionType: kFence });
    await vehicle.expect('MISSION_REQUEST_INT', { within_ms: 3000 });
  });
  await other(vehicle, async () => {
    for (const missionType of [0, kFence, kRally]) {
      vehicle.send('MISSION_COUNT', { count: 2, missionType });
      assert.equal(await ack(vehicle), kDenied);
      vehicle.send('MISSION_CLEAR_ALL', { missionType });
      assert.equal(await ack(vehicle), kDenied);
    }
    vehicle.send('MISSION_ITEM_INT', square[0]);
    assert.equal(await ack(vehicle), kDenied);
    assert.equal((await download(vehicle, kFence)).length, 0);  // looking is free
  });
  await one(vehicle, async () => {
    for (const item of square) {
      vehicle.send('MISSION_ITEM_INT', item);
      await vehicle.wait(40);
    }
    assert.equal(await ack(vehicle), 0);
  });
  await other(vehicle, async () => {
    assert.equal(await upload(vehicle, points, kRally), 0);
    assertSame(await download(vehicle, kRally), points);
    assertSame(await download(vehicle, kFence), square);
  });
}));

test('who is gone gives way after the time-out', withVehicle({}, async (vehicle) => {
  await one(vehicle, async () => {
    vehicle.send('MISSION_COUNT', { count: plan.length });
    await vehicle.expect('MISSION_REQUEST_INT', { within_ms: 3000 });
  });
  await other(vehicle, async () => {
    vehicle.send('MISSION_COUNT', { count: points.length, missionType: kRally });
    assert.equal(await ack(vehicle), kDenied);
  });
  await one(vehicle, async () => assert.equal(await ack(vehicle, 15_000), kCancelled));
  await other(vehicle, async () => assert.equal(await upload(vehicle, points, kRally), 0));
}));
