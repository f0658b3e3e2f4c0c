// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { frameOf, Splitter } from '../../../../toolchain/bench_tool/mavlink.mjs';

const beat = (sequence) => frameOf('HEARTBEAT', { type: 6, autopilot: 8, mavlinkVersion: 3 }, sequence);
const names = (messages) => messages.map(({ name, header }) => `${name} ${header.seq}`);

test('frames in pieces and with a bootloader\'s noise between them', () => {
  const bytes = Buffer.concat([Buffer.from([0xfe, 3, 0x1b, 0xfd]), beat(1), Buffer.from([0xfe, 9, 2]), beat(2), Buffer.from('!!!'), beat(3)]);
  for (const size of [1, 2, 7, 1000]) {
    const splitter = new Splitter(), heard = [];
    for (let at = 0; at < bytes.length; at += size) heard.push(...splitter.take(bytes.subarray(at, at + size)));
    heard.push(...splitter.take(Buffer.alloc(300)));  // what a false beginning has promised
    assert.deepEqual(names(heard), ['HEARTBEAT 1', 'HEARTBEAT 2', 'HEARTBEAT 3'], `${size} bytes at once`);
  }
});

test('a frame with a wrong checksum is none', () => {
  const bad = beat(1);
  bad[8] ^= 1;
  assert.deepEqual(names(new Splitter().take(Buffer.concat([bad, beat(2), Buffer.alloc(20)]))), ['HEARTBEAT 2']);
});
