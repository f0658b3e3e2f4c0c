// SPDX-License-Identifier: GPL-3.0-or-later
// Both lines full from the first byte to the last, with noise or with questions: the control loop
// keeps its time, heartbeats keep theirs, and the next question is answered.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { messages, nodeMavlink } from '../../support/node_mavlink.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const bytesPerStep = [115, 230];  // in 20 ms at 57,600 and 115,200 baud, 8N1
const protocol = new nodeMavlink.MavLinkProtocolV2(255, 190);

let state = 1;
const random = (below) => {
  state = (Math.imul(state, 1103515245) + 12345) >>> 0;
  return (state >>> 8) % below;
};

function write(line, bytes) {
  line.written += bytes.length;
  line.socket.write(bytes);
}

async function status(vehicle) {
  vehicle.forget();
  for (let tries = 0; tries < 5; ++tries) {
    vehicle.send('COMMAND_LONG', { command: 512, _param1: 1, confirmation: 0 });
    const found = await vehicle.next('SYS_STATUS', { within_ms: 500 });
    if (found) return found.data;
  }
  return assert.fail('no SYS_STATUS');
}

// `next(line)` gives the bytes a line is filled with; each line's queue never runs dry.
async function flood(vehicle, time_ms, next) {
  const queues = vehicle.lines.map(() => Buffer.alloc(0));
  const beats = [0, 0];
  let written = 0;
  for (let ms = 0; ms < time_ms; ms += 20) {
    for (const [i, line] of vehicle.lines.entries()) {
      while (queues[i].length < bytesPerStep[i]) queues[i] = Buffer.concat([queues[i], next(i)]);
      write(line, queues[i].subarray(0, bytesPerStep[i]));
      written += bytesPerStep[i];
      queues[i] = queues[i].subarray(bytesPerStep[i]);
    }
    await vehicle.advance(20);
    for (const [i, line] of vehicle.lines.entries())
      beats[i] += line.inbox.splice(0).filter(({ name }) => name === 'HEARTBEAT').length;
  }
  for (const [i, line] of vehicle.lines.entries()) write(line, queues[i]);
  return { beats, written };
}

// What ends a flood: whatever the last bytes promised is known to be false, and the air is clear.
async function settle(vehicle) {
  for (const line of vehicle.lines) for (let i = 0; i < 4; ++i) line.send('HEARTBEAT', { type: 6, autopilot: 8, mavlinkVersion: 3 });
  await vehicle.wait(1000);
}

async function check(vehicle, time_ms, next) {
  const before = await status(vehicle);
  const { beats, written } = await flood(vehicle, time_ms, next);
  await settle(vehicle);
  const after = await status(vehicle);
  console.log(`${written} bytes in ${time_ms / 1000} s, ${after.errorsComm} of them taken for bad frames, ` +
    `${after.errorsCount1} lost in the receive buffer, load ${after.load / 10} %, longest frame ${after.errorsCount3} us`);
  assert.equal(after.errorsCount2, before.errorsCount2, 'frames were late');
  for (const count of beats) assert.ok(count >= time_ms / 1000 - 2, `${count} heartbeats`);
  vehicle.forget();
  vehicle.send('PING', { timeUsec: 1n, seq: 77, targetSystem: 0, targetComponent: 0 });
  assert.equal((await vehicle.expect('PING')).seq, 77);
  return { written };
}

test('half a megabyte of noise makes no frame late and nothing happens', withVehicle({}, async (vehicle) => {
  await vehicle.wait(2000);
  const noise = () => Buffer.from(Array.from({ length: 256 }, () => random(256)));
  const { written } = await check(vehicle, 29_100, noise);
  assert.ok(written >= 500_000, `${written}`);
}));

// OpenFileRO, ReadFile and BurstReadFile
function fileRequest() {
  const payload = Buffer.alloc(251);
  payload[3] = [4, 5, 15][random(3)];
  payload[4] = payload[3] === 4 ? 16 : 80;
  payload.writeUInt32LE(payload[3] === 4 ? 0 : random(3000), 8);
  payload.write('@PARAM/param.pck', 12, 'latin1');
  return [...payload];
}

const questions = [
  ['PARAM_REQUEST_READ', () => ({ paramIndex: random(150), paramId: '' })],
  ['PARAM_REQUEST_LIST', () => ({})],
  ['PARAM_SET', () => ({ paramId: 'TRIM_ARSPD_CM', paramValue: 1000 + random(500), paramType: 9 })],
  ['MISSION_REQUEST_LIST', () => ({})],
  ['MISSION_REQUEST_INT', () => ({ seq: random(200) })],
  ['MISSION_SET_CURRENT', () => ({ seq: random(200) })],
  ['COMMAND_LONG', () => ({ command: [410, 512, 510, 520, 31_000][random(5)], _param1: random(300) })],
  ['REQUEST_DATA_STREAM', () => ({ reqStreamId: 0, reqMessageRate: 50, startStop: 1 })],
  ['LOG_REQUEST_DATA', () => ({ id: random(10), ofs: 0, count: 90 })],
  ['FILE_TRANSFER_PROTOCOL', () => ({ targetNetwork: 0, payload: fileRequest() })],
  ['RC_CHANNELS_OVERRIDE', () => ({ chan1Raw: 1400 + random(200) })],
  ['MANUAL_CONTROL', () => ({ target: 1, y: random(2000) - 1000, x: 32_767, z: 32_767, r: 32_767 })],
  ['PING', () => ({ timeUsec: 1n, seq: 1, targetSystem: 0, targetComponent: 0 })],
  ['TIMESYNC', () => ({ ts1: 5n })],
];

function question() {
  const [name, fields] = questions[random(questions.length)];
  const message = Object.assign(new messages[name](), { targetSystem: 1, targetComponent: 1 }, fields());
  return protocol.serialize(message, random(256));
}

test('a ground station that never stops asking makes no frame late', withVehicle({}, async (vehicle) => {
  await vehicle.wait(2000);
  await check(vehicle, 20_000, question);
}));
