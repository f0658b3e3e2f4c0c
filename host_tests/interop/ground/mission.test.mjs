// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { withVehicle } from '../../support/vehicle.mjs';

const file = new URL('../../../simulator/missions/first_flight.waypoints', import.meta.url);
const plan = readFileSync(file, 'utf8').trim().split(/\r?\n/).slice(1).map((line) => {
  const [seq, , frame, command, param1, param2, param3, param4, x, y, z] = line.split(/\s+/).map(Number);
  return { seq, frame, command, param1, param2, param3, param4,
    x: Math.round(x * 1e7), y: Math.round(y * 1e7), z, current: 0, autocontinue: 1 };
});

async function upload(vehicle, items, { degrees = false, lose = new Set() } = {}) {
  vehicle.send('MISSION_COUNT', { count: items.length });
  for (;;) {
    const answer = await vehicle.next(['MISSION_REQUEST_INT', 'MISSION_REQUEST', 'MISSION_ACK'],
      { within_ms: 5000 });
    assert.ok(answer, 'the vehicle has stopped asking');
    if (answer.name === 'MISSION_ACK') return answer.data.type;
    assert.equal(answer.data.targetSystem, 255);
    assert.equal(answer.data.targetComponent, 190);
    if (lose.delete(answer.data.seq)) continue;
    const item = items[answer.data.seq];
    if (degrees) vehicle.send('MISSION_ITEM', { ...item, x: item.x * 1e-7, y: item.y * 1e-7 });
    else vehicle.send('MISSION_ITEM_INT', item);
  }
}

async function download(vehicle, request = 'MISSION_REQUEST_INT', reply = 'MISSION_ITEM_INT') {
  vehicle.send('MISSION_REQUEST_LIST');
  const { count } = await vehicle.expect('MISSION_COUNT');
  const items = [];
  for (let seq = 0; seq < count; ++seq) {
    vehicle.send(request, { seq });
    items.push(await vehicle.expect(reply, { where: (data) => data.seq === seq }));
  }
  vehicle.send('MISSION_ACK', { type: 0 });
  return items;
}

// Item 0 is home, which the vehicle keeps for itself.
function assertSame(items, wanted = plan) {
  assert.equal(items.length, wanted.length);
  for (const [seq, item] of items.entries()) {
    if (seq === 0) continue;
    assert.equal(item.command, wanted[seq].command, `command of item ${seq}`);
    assert.equal(item.x, wanted[seq].x, `x of item ${seq}`);
    assert.equal(item.y, wanted[seq].y, `y of item ${seq}`);
    assert.ok(Math.abs(item.z - wanted[seq].z) < 0.01, `z of item ${seq}`);
  }
}

for (const version of [1, 2])
  test(`goes up and comes down again, MAVLink ${version}`, withVehicle({}, async (vehicle) => {
    vehicle.line.version = version;
    assert.equal(await upload(vehicle, plan), 0);
    assertSame(await download(vehicle));
  }));

test('goes up and down as MISSION_ITEM in whole degrees', withVehicle({}, async (vehicle) => {
  assert.equal(await upload(vehicle, plan, { degrees: true }), 0);
  const items = await download(vehicle, 'MISSION_REQUEST', 'MISSION_ITEM');
  assert.deepEqual(items.map(({ command }) => command).slice(1),
    plan.map(({ command }) => command).slice(1));
  for (const item of items.slice(1))
    if (plan[item.seq].x !== 0) assert.ok(Math.abs(item.x - plan[item.seq].x * 1e-7) < 1e-5);
}));

test('items that are lost on the way are asked for again', withVehicle({}, async (vehicle) => {
  assert.equal(await upload(vehicle, plan, { lose: new Set([0, 4, plan.length - 1]) }), 0);
  assertSame(await download(vehicle));
}));

test('an upload that is left alone ends with the truth; the old mission stays',
  withVehicle({}, async (vehicle) => {
    assert.equal(await upload(vehicle, plan), 0);
    vehicle.send('MISSION_COUNT', { count: 9 });
    vehicle.send('MISSION_ITEM_INT', { ...plan[0], seq: 0 });
    const ack = await vehicle.expect('MISSION_ACK', { within_ms: 15_000 });
    assert.equal(ack.type, 15);
    assertSame(await download(vehicle));
  }));

test('a command the vehicle cannot carry out is refused; the old mission stays',
  withVehicle({}, async (vehicle) => {
    assert.equal(await upload(vehicle, plan), 0);
    const bad = plan.slice(0, 4).map((item) => ({ ...item }));
    bad[2].command = 31_000;
    assert.notEqual(await upload(vehicle, bad), 0);
    assertSame(await download(vehicle));
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
