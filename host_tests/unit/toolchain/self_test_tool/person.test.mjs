// SPDX-License-Identifier: GPL-3.0-or-later
// Before the board is touched anybody may leave; afterwards nothing ends the program before its time.
import assert from 'node:assert/strict';
import { EventEmitter } from 'node:events';
import { PassThrough } from 'node:stream';
import { test } from 'node:test';

import { Refusal } from '../../../../toolchain/flash_tool/refusal.mjs';
import { waitForEnter, watchStops } from '../../../../toolchain/self_test_tool/person.mjs';

test('Enter goes on, the end of the input does not', async () => {
  for (const [typed, confirmed] of [['\n', true], ['', false]]) {
    const input = new PassThrough(), output = new PassThrough();
    input.end(typed);
    const waiting = waitForEnter(input, output);
    if (confirmed) await waiting;
    else await assert.rejects(waiting, (error) => error instanceof Refusal && /not confirmed; nothing was written/.test(error.message));
    assert.match(output.read().toString(), /Enter when it is so/);
  }
});

for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'])
  test(`${signal} stops the test, and again only says to wait`, () => {
    const signals = new EventEmitter(), said = [];
    const state = watchStops({ signals, outputs: [], say: (line) => said.push(line) });
    assert.equal(state.stopped, false);
    assert.equal(signals.emit(signal), true);
    assert.deepEqual([state.stopped, said], [true, []]);
    signals.emit(signal);
    assert.match(said.join(), /wait: the board gets its firmware back/);
    state.release();
    assert.equal(signals.emit(signal), false);
  });

test('an output that goes away stops the test and does not end the program until released', () => {
  const outputs = [new EventEmitter(), new EventEmitter()];
  let ended = 0;
  outputs[0].on('error', () => { ++ended; });
  for (const output of outputs) {
    const state = watchStops({ signals: new EventEmitter(), outputs, say: () => {} });
    output.emit('error', new Error('EPIPE'));  // would throw where nobody listens
    assert.deepEqual([state.stopped, ended], [true, 0]);
    state.release();
  }
  outputs[0].emit('error', new Error('EPIPE'));
  assert.equal(ended, 1);
});
