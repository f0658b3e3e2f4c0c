// SPDX-License-Identifier: GPL-3.0-or-later
// Over a link that loses or flips 1 % of the bytes, doubles 0.5 % and stalls for two seconds, the
// parameters and a mission of 170 items still arrive, whole and right.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { makeNoisy } from './noisy_line.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const rates = [57_600, 115_200];  // of line 0, the telemetry, and line 1, USB

// As MAVProxy: the list, and after a second of silence what is missing, ten at a time.
async function fetchParameters(vehicle, line) {
  const values = new Map();
  let count, asked_ms = -Infinity, heard_ms = vehicle.now_ms;
  const take = () => {
    line.inbox = line.inbox.filter(({ name, data }) => {
      if (name !== 'PARAM_VALUE') return true;
      count = data.paramCount;
      if (data.paramIndex < count) values.set(data.paramIndex, `${data.paramId} ${data.paramValue}`);
      heard_ms = vehicle.now_ms;
      return false;
    });
  };
  const ask = () => {
    asked_ms = vehicle.now_ms;
    if (count === undefined) return line.send('PARAM_REQUEST_LIST');
    const missing = Array.from({ length: count }, (_, i) => i).filter((i) => !values.has(i));
    for (const paramIndex of missing.slice(0, 10)) line.send('PARAM_REQUEST_READ', { paramIndex, paramId: '' });
  };
  const until_ms = vehicle.now_ms + 120_000;
  while (vehicle.now_ms < until_ms) {
    take();
    if (values.size === count) return [...values].sort(([a], [b]) => a - b).map(([, value]) => value);
    if (vehicle.now_ms - Math.max(heard_ms, asked_ms) >= 1000 || asked_ms < 0) ask();
    await vehicle.wait(20);
  }
  assert.fail(`${values.size} of ${count} parameters in two minutes`);
}

const mission = Array.from({ length: 170 }, (_, seq) => ({ seq, frame: 3, command: 16, param1: 0,
  param2: 0, param3: 0, param4: 0, x: 473_977_000 + 137 * seq, y: 85_456_000 - 291 * seq,
  z: 100 + (seq % 40), current: 0, autocontinue: 1, missionType: 0 }));

// One try: the count until it is asked for items, then whatever it asks for. The MAV_MISSION_RESULT,
// or undefined when it has fallen silent.
async function upload(vehicle, line) {
  line.inbox.length = 0;
  let began = false, said_ms = -Infinity, heard_ms = vehicle.now_ms;
  while (vehicle.now_ms - heard_ms < 10_000) {
    if (!began && vehicle.now_ms - said_ms >= 1000) {
      line.send('MISSION_COUNT', { count: mission.length, missionType: 0 });
      said_ms = vehicle.now_ms;
    }
    await vehicle.wait(20);
    for (const { name, data } of line.inbox.splice(0)) {
      if (name === 'MISSION_ACK') return data.type;
      if (name !== 'MISSION_REQUEST_INT' && name !== 'MISSION_REQUEST') continue;
      began = true;
      heard_ms = vehicle.now_ms;
      line.send('MISSION_ITEM_INT', mission[data.seq]);
    }
  }
  return undefined;
}

async function download(vehicle, line) {
  line.send('MISSION_REQUEST_LIST', { missionType: 0 });
  vehicle.line = line;
  const { count } = await vehicle.expect('MISSION_COUNT');
  const items = [];
  for (let seq = 0; seq < count; ++seq) {
    line.send('MISSION_REQUEST_INT', { seq, missionType: 0 });
    items.push(await vehicle.expect('MISSION_ITEM_INT', { where: (data) => data.seq === seq }));
  }
  return items;
}

const report = (what, vehicle, began_ms, { up, down }) =>
  console.log(`${what} in ${((vehicle.now_ms - began_ms) / 1000).toFixed(1)} s; up ${JSON.stringify(up.counts)}, ` +
    `down ${JSON.stringify(down.counts)}`);

// The emulated minutes of the chip are counted: it has the slower line.
for (const [number, rate] of (process.env.FLY_BOARD === 'elf' ? rates.slice(0, 1) : rates).entries()) {
  test(`all parameters come over a bad link at ${rate} baud`, withVehicle({}, async (vehicle) => {
    const line = vehicle.lines[number], clean = vehicle.lines[1 - number];
    await vehicle.wait(1000);
    const truth = await fetchParameters(vehicle, clean);
    line.version = 2;
    makeNoisy(vehicle, line, 10 + number);
    const began_ms = vehicle.now_ms;

    const values = await fetchParameters(vehicle, line);

    report(`${values.length} parameters`, vehicle, began_ms, line);
    const steady = (all) => all.filter((value) => !value.startsWith('COMPASS_DEC '));  // learnt from the GPS
    assert.deepEqual(steady(values), steady(truth));
    assert.ok(line.down.counts.lost > 0 && line.down.counts.flipped > 0 && line.down.counts.doubled > 0);
  }));

  test(`a mission of 170 items goes up over a bad link at ${rate} baud`, withVehicle({}, async (vehicle) => {
    const line = vehicle.lines[number], clean = vehicle.lines[1 - number];
    line.version = clean.version = 2;
    makeNoisy(vehicle, line, 20 + number);
    const began_ms = vehicle.now_ms;
    let result, tries = 0;

    while (result !== 0 && tries < 8) {  // as the pilot would: again
      ++tries;
      result = await upload(vehicle, line);
    }

    report(`170 items at the ${tries}. try`, vehicle, began_ms, line);
    assert.equal(result, 0);
    assert.ok(line.up.counts.stalls > 0);
    const items = await download(vehicle, clean);
    assert.equal(items.length, mission.length);
    for (const { seq, x, y, z, command } of items.slice(1))
      assert.deepEqual({ x, y, z, command }, { x: mission[seq].x, y: mission[seq].y, z: mission[seq].z, command: 16 });
  }));
}
