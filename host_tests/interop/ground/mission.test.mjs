// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertSame, download, upload, wholePlan as plan } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

for (const version of [1, 2])
  test(`goes up and comes down again, MAVLink ${version}`, withVehicle({}, async (vehicle) => {
    vehicle.line.version = version;
    assert.equal(await upload(vehicle, plan), 0);
    assertSame(await download(vehicle), plan);
  }));

test('goes up and down as MISSION_ITEM in whole degrees', withVehicle({}, async (vehicle) => {
  assert.equal(await upload(vehicle, plan, 0, { degrees: true }), 0);
  const items = await download(vehicle, 0, 'MISSION_REQUEST', 'MISSION_ITEM');
  assert.deepEqual(items.map(({ command }) => command).slice(1),
    plan.map(({ command }) => command).slice(1));
  for (const item of items.slice(1))
    if (plan[item.seq].x !== 0) assert.ok(Math.abs(item.x - plan[item.seq].x * 1e-7) < 1e-5);
}));

test('items that are lost on the way are asked for again', withVehicle({}, async (vehicle) => {
  assert.equal(await upload(vehicle, plan, 0, { lose: new Set([0, 4, plan.length - 1]) }), 0);
  assertSame(await download(vehicle), plan);
}));

test('an upload that is left alone ends with the truth; the old mission stays',
  withVehicle({}, async (vehicle) => {
    assert.equal(await upload(vehicle, plan), 0);
    vehicle.send('MISSION_COUNT', { count: 9 });
    vehicle.send('MISSION_ITEM_INT', { ...plan[0], seq: 0 });
    const ack = await vehicle.expect('MISSION_ACK', { within_ms: 15_000 });
    assert.equal(ack.type, 15);
    assertSame(await download(vehicle), plan);
  }));

test('a command the vehicle cannot carry out is refused; the old mission stays',
  withVehicle({}, async (vehicle) => {
    assert.equal(await upload(vehicle, plan), 0);
    const bad = plan.slice(0, 4).map((item) => ({ ...item }));
    bad[2].command = 31_000;
    assert.notEqual(await upload(vehicle, bad), 0);
    assertSame(await download(vehicle), plan);
  }));

test('is cleared', withVehicle({}, async (vehicle) => {
  assert.equal(await upload(vehicle, plan), 0);
  vehicle.send('MISSION_CLEAR_ALL');
  assert.equal((await vehicle.expect('MISSION_ACK', { within_ms: 3000 })).type, 0);
  vehicle.send('MISSION_REQUEST_LIST');
  const { count } = await vehicle.expect('MISSION_COUNT');
  assert.ok(count <= 1, `${count} items left`);
}));

test('the current item is set by message and by command', withVehicle({}, async (vehicle) => {
  assert.equal(await upload(vehicle, plan), 0);
  vehicle.send('MISSION_SET_CURRENT', { seq: 4 });
  await vehicle.expect('MISSION_CURRENT', { where: ({ seq }) => seq === 4 });
  assert.equal(await vehicle.command(224, [2]), 0);
  await vehicle.expect('MISSION_CURRENT', { where: ({ seq }) => seq === 2 });
  assert.notEqual(await vehicle.command(224, [99]), 0);
}));
