// SPDX-License-Identifier: GPL-3.0-or-later
// Signed frames by node-mavlink: a key over USB, then the radio obeys what is signed with it, once,
// and all that the vehicle sends is signed with it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { messages, nodeMavlink } from '../../support/node_mavlink.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const { MavLinkPacketSignature, MavLinkProtocolV2 } = nodeMavlink;
const kKey = MavLinkPacketSignature.key('what only the two of us know');
const kBudgets = new URL('../../../toolchain/image/budgets.json', import.meta.url);
const kBegins_ms = Date.UTC(2026, 0, 1), kLink = 1;
const signer = new MavLinkProtocolV2(255, 190, MavLinkProtocolV2.IFLAG_SIGNED);
const since2015 = (time_ms) => BigInt(time_ms - MavLinkProtocolV2.SIGNATURE_START_TIME) * 100n;

const write = (line, bytes) => {
  line.written += bytes.length;
  line.socket.write(bytes);
};

let sequence = 0;
function signed(name, fields, { time_ms, key = kKey, link = kLink }) {
  const message = Object.assign(new messages[name](), { targetSystem: 1, targetComponent: 1 }, fields);
  return signer.sign(signer.serialize(message, sequence++ & 255), link, key, time_ms);
}

async function setKey(vehicle, key) {
  const usb = vehicle.lines[1];
  assert.equal(await vehicle.order('usb in'), 'ok');
  await vehicle.wait(200);
  usb.version = 2;
  usb.send('SETUP_SIGNING', { secretKey: [...key], initialTimestamp: since2015(kBegins_ms) });
  await vehicle.wait(1000);
}

const read = { paramId: 'SYSID_THISMAV', paramIndex: -1 };
async function answered(vehicle, bytes) {
  vehicle.forget();
  write(vehicle.line, bytes);
  return (await vehicle.next('PARAM_VALUE', { within_ms: 500 })) !== undefined;
}

test('the radio obeys what is signed with the key, once', withVehicle({}, async (vehicle) => {
  await setKey(vehicle, kKey);
  vehicle.line.version = 2;
  vehicle.forget();
  vehicle.send('PARAM_REQUEST_READ', read);
  assert.equal(await vehicle.next('PARAM_VALUE', { within_ms: 500 }), undefined, 'unsigned');

  const first = signed('PARAM_REQUEST_READ', read, { time_ms: kBegins_ms + 1000 });
  assert.ok(await answered(vehicle, first));
  assert.ok(!await answered(vehicle, first), 'heard twice');
  const strange = MavLinkPacketSignature.key('another');
  assert.ok(!await answered(vehicle, signed('PARAM_REQUEST_READ', read, { time_ms: kBegins_ms + 2000, key: strange })));
  assert.ok(await answered(vehicle, signed('PARAM_REQUEST_READ', read, { time_ms: kBegins_ms + 2000 })));

  const usb = vehicle.lines[1];
  usb.inbox.length = 0;
  usb.send('PARAM_REQUEST_READ', read);
  await vehicle.wait(500);
  assert.ok(usb.inbox.some(({ name }) => name === 'PARAM_VALUE'), 'USB needs no signature');
}));

test('a list of all parameters comes by signed requests at 20 a second', withVehicle({}, async (vehicle) => {
  await setKey(vehicle, kKey);
  vehicle.line.version = 2;
  vehicle.forget();
  let heard = 0;
  for (let i = 0; i < 100; ++i) {
    write(vehicle.line, signed('PARAM_REQUEST_READ', { paramId: '', paramIndex: i }, { time_ms: kBegins_ms + 1000 + 50 * i }));
    await vehicle.wait(50);
  }
  await vehicle.wait(200);
  heard = vehicle.line.inbox.filter(({ name }) => name === 'PARAM_VALUE').length;
  assert.equal(heard, 100);
}));

test('a key of zeros ends it', withVehicle({}, async (vehicle) => {
  await setKey(vehicle, kKey);
  await setKey(vehicle, Buffer.alloc(32));
  vehicle.line.version = 2;
  vehicle.forget();
  vehicle.send('PARAM_REQUEST_READ', read);
  await vehicle.expect('PARAM_VALUE');
}));

const isRight = ({ signature }, key = kKey) => signature?.matches(key) === true;

test('all that is sent is signed with the key, on both links, and no time comes twice', withVehicle({}, async (vehicle) => {
  await setKey(vehicle, kKey);
  vehicle.line.version = 2;
  vehicle.forget();
  write(vehicle.line, signed('REQUEST_DATA_STREAM', { reqStreamId: 0, reqMessageRate: 4, startStop: 1 }, { time_ms: kBegins_ms + 1000 }));
  vehicle.lines[1].send('REQUEST_DATA_STREAM', { targetSystem: 1, targetComponent: 1, reqStreamId: 0, reqMessageRate: 4, startStop: 1 });
  await vehicle.wait(5000);
  for (const { inbox } of vehicle.lines) {
    assert.ok(inbox.length > 200, `${inbox.length} frames`);
    assert.deepEqual(inbox.filter((frame) => !isRight(frame)).map(({ name }) => name), []);
    assert.ok(!isRight(inbox[0], MavLinkPacketSignature.key('another')));
    const times = inbox.map(({ signature }) => signature.timestamp);
    assert.ok(times.every((time, i) => i === 0 || time > times[i - 1]), 'they rise');
    const numbers = inbox.map(({ header }) => header.seq);
    assert.ok(numbers.every((number, i) => i === 0 || number === (numbers[i - 1] + 1 & 255)), 'none is lost');
  }
}));

test('a signed download of all parameters is whole', withVehicle({}, async (vehicle) => {
  await setKey(vehicle, kKey);
  vehicle.line.version = 2;
  vehicle.forget();
  write(vehicle.line, signed('PARAM_REQUEST_LIST', {}, { time_ms: kBegins_ms + 1000 }));
  await vehicle.wait(15_000);
  const heard = vehicle.line.inbox.filter(({ name }) => name === 'PARAM_VALUE');
  assert.ok(heard.every((frame) => isRight(frame)));
  assert.equal(new Set(heard.map(({ data }) => data.paramIndex)).size, heard[0].data.paramCount);
}));

// Signatures are made and checked in what the frames leave: no frame is late by them, as in every flight, and no
// message waits. { load_pct, frames }: of the processor's time, on both links together in a second.
async function measured(vehicle, seconds, each) {
  const load = async () => Number(await vehicle.order('load')) * vehicle.now_ms;
  const [began_ms, before] = [vehicle.now_ms, await load()];
  vehicle.forget();
  for (let i = 0; i < 10 * seconds; ++i) {
    each(i);
    await vehicle.wait(100);
  }
  return { load_pct: 100 * (await load() - before) / (vehicle.now_ms - began_ms),
    frames: vehicle.lines.reduce((sum, { inbox }) => sum + inbox.length, 0) / seconds };
}

test('with signatures both ways on both links as much comes as without, in the budget\'s share of the processor',
  { skip: process.env.FLY_BOARD === 'elf' ? false : 'cycles are those of the image' }, withVehicle({}, async (vehicle) => {
    const budget_pct = JSON.parse(readFileSync(kBudgets, 'utf8')).signing_both_links_percent;
    assert.equal(await vehicle.order('usb in'), 'ok');
    await vehicle.wait(6000);
    for (const line of vehicle.lines) {
      line.version = 2;
      line.send('REQUEST_DATA_STREAM', { reqStreamId: 0, reqMessageRate: 4, startStop: 1 });
    }
    await vehicle.wait(5000);
    const asks = { paramId: '', paramIndex: 3 };
    const plain = await measured(vehicle, 10, () => vehicle.send('PARAM_REQUEST_READ', asks));
    await setKey(vehicle, kKey);
    const both = await measured(vehicle, 10, (i) =>
      write(vehicle.line, signed('PARAM_REQUEST_READ', asks, { time_ms: kBegins_ms + 1000 + 100 * i })));
    console.log(`processor without ${plain.load_pct.toFixed(1)} %, with ${both.load_pct.toFixed(1)} %; ${both.frames} frames a second`);
    assert.ok(Math.abs(both.frames - plain.frames) <= 1, `${both.frames} frames a second, ${plain.frames} without`);
    assert.ok(both.load_pct <= budget_pct, `${both.load_pct} % of the processor`);
    assert.ok(both.load_pct > plain.load_pct + 10, 'the signatures are made');
  }));

test('a vehicle that has started again goes on with later times', withVehicle({}, async (vehicle) => {
  await setKey(vehicle, kKey);
  vehicle.line.version = 2;
  await vehicle.wait(3000);
  const { signature: { timestamp: before } } = await vehicle.next('HEARTBEAT');
  const reboot = { command: 246, confirmation: 0, _param1: 1 };
  write(vehicle.line, signed('COMMAND_LONG', reboot, { time_ms: kBegins_ms + 2000 }));
  await vehicle.wait(4000);
  vehicle.forget();
  const heartbeat = await vehicle.next('HEARTBEAT', { within_ms: 3000 });
  assert.ok(isRight(heartbeat), 'signed from the first one on');
  assert.ok(heartbeat.signature.timestamp > before);
}));
