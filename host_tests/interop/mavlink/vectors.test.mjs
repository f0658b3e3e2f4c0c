// SPDX-License-Identifier: GPL-3.0-or-later
// Every message, as npm node-mavlink writes it with arbitrary contents, through our parser and
// writer and back. MAVLINK_REPEAT names the program made of repeat.cpp.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { messages, nodeMavlink } from '../../support/node_mavlink.mjs';

const repeat = process.env.MAVLINK_REPEAT;
const list = JSON.parse(readFileSync(
  new URL('../../../toolchain/mavlink/messages.json', import.meta.url), 'utf8')).messages;
const v1 = new nodeMavlink.MavLinkProtocolV1(255, 190);
const v2 = new nodeMavlink.MavLinkProtocolV2(255, 190);

let state = 1;
const random = (below) => {
  state = (Math.imul(state, 1103515245) + 12345) >>> 0;
  return (state >>> 8) % below;
};

const values = {
  char: () => String.fromCharCode(1 + random(127)),
  int8_t: () => random(256) - 128,
  uint8_t: () => random(256),
  uint8_t_mavlink_version: () => 3,
  int16_t: () => random(65536) - 32768,
  uint16_t: () => random(65536),
  int32_t: () => random(1 << 24) * 256 - 2147483648,
  uint32_t: () => random(1 << 24) * 256 + random(256),
  int64_t: () => BigInt(random(1 << 24)) - 8388608n,
  uint64_t: () => (BigInt(random(1 << 24)) << 40n) + 1n,
  float: () => Math.fround(random(1 << 24) / 1024 - 8192),
};

function filled(type, zeros) {
  const message = new type();
  for (const field of type.FIELDS) {
    const kind = field.type.replace('[]', '');
    const value = zeros ? () => (kind.endsWith('64_t') ? 0n : kind === 'char' ? '\0' : 0) : values[kind];
    const all = Array.from({ length: field.length || 1 }, value);
    message[field.name] = kind === 'char' && field.length ? all.join('') : field.length ? all : all[0];
  }
  return message;
}

function throughOurs(framing, frames) {
  const run = spawnSync(repeat, [framing], { input: Buffer.concat(frames), maxBuffer: 1 << 24 });
  assert.equal(run.status, 0);
  assert.equal(run.stderr.toString().trim(), '0', 'frames whose checksum we found wrong');
  return run.stdout;
}

const contents = list.flatMap((name) =>
  [1, 2, 3, 4].map(() => filled(messages[name], false)));

test('the program under test is named', () => assert.ok(repeat));

test('MAVLink 2 frames come out as they went in, byte for byte', () => {
  const frames = contents.map((message, i) => v2.serialize(message, i & 255));
  assert.deepEqual(throughOurs('2', frames), Buffer.concat(frames));
});

test('MAVLink 1 frames come out as they went in, but for extension bytes', () => {
  const short = contents.filter(({ constructor: type }) => type.MSG_ID < 256);
  const frames = short.map((message, i) => v1.serialize(message, i & 255));
  const ours = throughOurs('1', frames);
  let at = 0;
  for (const [i, { constructor: type }] of short.entries()) {
    const length = ours[at + 1];
    const extended = type.FIELDS.some((field) => field.extension);
    assert.equal(length < frames[i][1], extended, type.MSG_NAME);
    assert.deepEqual(ours.subarray(at + 2, at + 6 + length), frames[i].subarray(2, 6 + length));
    if (!extended) assert.deepEqual(ours.subarray(at, at + length + 8), frames[i]);
    at += length + 8;
  }
  assert.equal(at, ours.length);
});

test('what comes in MAVLink 1 and goes out in MAVLink 2 is the same message', () => {
  const short = contents.filter(({ constructor: type }) => type.MSG_ID < 256);
  const frames = short.map((message, i) => v1.serialize(message, i & 255));
  const expected = short.map((message, i) => v2.serialize(message, i & 255));
  assert.deepEqual(throughOurs('2', frames), Buffer.concat(expected));
});

test('signed frames are read like any others', () => {
  const message = filled(messages.COMMAND_LONG, false);
  const signing = new nodeMavlink.MavLinkProtocolV2(255, 190, nodeMavlink.MavLinkProtocolV2.IFLAG_SIGNED);
  const signed = signing.sign(signing.serialize(message, 7), 1,
    nodeMavlink.MavLinkPacketSignature.key('secret'), 1.6e12);
  assert.deepEqual(throughOurs('2', [signed, signed]),
    Buffer.concat([v2.serialize(message, 7), v2.serialize(message, 7)]));
});

test('a payload of zeros alone, which node-mavlink does not send at all, is read', () => {
  for (const name of list) {
    const ours = throughOurs('2', [v2.serialize(filled(messages[name], true), 9)]);
    assert.equal(ours[1], 1, name);
    assert.equal(ours[10], 0, name);
  }
});
