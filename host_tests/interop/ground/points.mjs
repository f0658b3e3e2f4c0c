// SPDX-License-Identifier: GPL-3.0-or-later
// Missions, fences and rally points as ground stations send and ask for them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

export const kFence = 1, kRally = 2;
export const kReturnPoint = 5000, kCorner = 5001, kExclusion = 5002, kCircleIn = 5003, kCircleOut = 5004, kRallyPoint = 5100;

const file = new URL('../../../simulator/missions/first_flight.waypoints', import.meta.url);
export const wholePlan = readFileSync(file, 'utf8').trim().split(/\r?\n/).slice(1).map((line) => {
  const [seq, , frame, command, param1, param2, param3, param4, x, y, z] = line.split(/\s+/).map(Number);
  return { seq, frame, command, param1, param2, param3, param4,
    x: Math.round(x * 1e7), y: Math.round(y * 1e7), z, current: 0, autocontinue: 1, missionType: 0 };
});
export const plan = wholePlan.slice(0, 3);
export const home = plan[0];
const metresPerE7 = 0.011132;
const shrink = Math.cos(home.x * 1e-7 * Math.PI / 180);
export const beside = (north_m, east_m) => ({
  x: home.x + Math.round(north_m / metresPerE7),
  y: home.y + Math.round(east_m / metresPerE7 / shrink),
});
export const distance_m = (place, { lat, lon }) =>
  Math.hypot((place.x - lat) * metresPerE7, (place.y - lon) * metresPerE7 * shrink);

const items = (missionType, rows) => rows.map((row, seq) => ({ seq, frame: 3, current: 0,
  autocontinue: 1, param1: 0, param2: 0, param3: 0, param4: 0, z: 0, missionType, ...row }));

const square = (half_m) => [[-1, -1], [-1, 1], [1, 1], [1, -1]].map(([north, east]) =>
  ({ command: kCorner, param1: 4, ...beside(north * half_m, east * half_m) }));
// A square about home and a return point.
export const fence = (half_m, wayBack = beside(0, 0)) => items(kFence, [
  { command: kReturnPoint, ...wayBack }, ...square(half_m)]);
// A square to stay in, a triangle to stay out of, circles of both kinds: { command, param1, x, y }.
export const zones = (...circles) => items(kFence, [
  ...square(1000),
  ...[[600, 600], [600, 700], [700, 600]].map((place) => ({ command: kExclusion, param1: 3, ...beside(...place) })),
  ...circles, { command: kReturnPoint, ...beside(80, 60) }]);
export const rally = (...places) => items(kRally, places.map(([north_m, east_m, z]) =>
  ({ command: kRallyPoint, ...beside(north_m, east_m), z })));

// The result. `degrees`: as MISSION_ITEM; the requests for what is in `lose` go unanswered once.
export async function upload(vehicle, list, missionType = 0, { degrees = false, lose = new Set() } = {}) {
  vehicle.send('MISSION_COUNT', { count: list.length, missionType });
  for (;;) {
    const answer = await vehicle.next(['MISSION_REQUEST_INT', 'MISSION_REQUEST', 'MISSION_ACK'],
      { within_ms: 5000 });
    assert.ok(answer, 'the vehicle has stopped asking');
    if (vehicle.line.version === 2) assert.equal(answer.data.missionType, missionType);
    if (answer.name === 'MISSION_ACK') return answer.data.type;
    assert.deepEqual([answer.data.targetSystem, answer.data.targetComponent], [255, 190]);
    if (lose.delete(answer.data.seq)) continue;
    const item = list[answer.data.seq];
    if (degrees) vehicle.send('MISSION_ITEM', { ...item, x: item.x * 1e-7, y: item.y * 1e-7 });
    else vehicle.send('MISSION_ITEM_INT', item);
  }
}

export async function download(vehicle, missionType = 0, request = 'MISSION_REQUEST_INT', reply = 'MISSION_ITEM_INT') {
  vehicle.send('MISSION_REQUEST_LIST', { missionType });
  const { count } = await vehicle.expect('MISSION_COUNT');
  const list = [];
  for (let seq = 0; seq < count; ++seq) {
    vehicle.send(request, { seq, missionType });
    list.push(await vehicle.expect(reply, { where: (data) => data.seq === seq }));
  }
  vehicle.send('MISSION_ACK', { type: 0, missionType });
  return list;
}

// Item 0 of a mission is home, which the vehicle keeps for itself.
export function assertSame(list, wanted) {
  assert.equal(list.length, wanted.length);
  for (const [seq, item] of list.entries()) {
    if (seq === 0 && item.missionType === 0) continue;
    for (const field of ['command', 'frame', 'x', 'y', 'z', 'param1', 'missionType'])
      assert.equal(item[field], wanted[seq][field], `${field} of item ${seq}`);
  }
}

export async function setParameter(vehicle, paramId, paramValue) {
  vehicle.send('PARAM_SET', { paramId, paramValue, paramType: 9 });
  const answer = await vehicle.expect('PARAM_VALUE',
    { within_ms: 3000, where: (data) => data.paramId === paramId });
  return answer.paramValue;
}

export const said = (vehicle, pattern, within_ms = 2000) =>
  vehicle.expect('STATUSTEXT', { within_ms, where: ({ text }) => pattern.test(text) });

// Until `where` holds of where it says it is.
export async function flies(vehicle, within_s, where) {
  vehicle.forget();
  return vehicle.expect('GLOBAL_POSITION_INT', { within_ms: within_s * 1000, where });
}

export async function armWhenReady(vehicle) {
  let result = 4;
  for (let tries = 0; tries < 60 && result !== 0; ++tries) {
    await vehicle.wait(1000);
    result = await vehicle.command(400, [1]);
  }
  assert.equal(result, 0, 'never ready in a minute');
}

export async function takeOff(vehicle) {
  assert.equal(await upload(vehicle, plan), 0);
  await armWhenReady(vehicle);
  assert.equal(await vehicle.command(300), 0);
  await flies(vehicle, 40, ({ relativeAlt }) => relativeAlt > 35_000);
}
