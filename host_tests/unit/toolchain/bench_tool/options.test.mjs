// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { kLastStep, readOptions, stepsOf, usage } from '../../../../toolchain/bench_tool/options.mjs';
import { addressOf } from '../../../../toolchain/bench_tool/port.mjs';
import { kSteps } from '../../../../toolchain/bench_tool/steps/table.mjs';

const read = (line) => readOptions(line.split(' '), '2026-01-02');

test('steps and ranges', () => {
  assert.deepEqual(stepsOf('3'), [3]);
  assert.deepEqual(stepsOf('7,1,4-6,5'), [1, 4, 5, 6, 7]);
  for (const text of ['', '0', '17', '3-', '5-4', 'a', '1,,2', '-3', '1.5']) assert.throws(() => stepsOf(text), /expected steps/, text);
});

test('a line, and what is wrong with one', () => {
  const options = read('/dev/ttyACM0 --board apm2 --step 1,3');
  assert.deepEqual([options.port, options.board, options.name, options.steps], ['/dev/ttyACM0', 'apm2', '2026-01-02', [1, 3]]);
  for (const [line, why] of [['--board apm2', /which port/], ['/dev/a', /which board/], ['/dev/a --board apm3', /no board apm3/], ['/dev/a b --board apm1', /one port/],
    ['/dev/a --board', /wants a value/], ['/dev/a --board apm1 --fast', /no option/], ['/dev/a --board apm1 --name ../x', /--name takes/],
    ['/dev/a --board apm1 --name ..', /--name takes/], ['/dev/a --board constructor', /no board/]])
    assert.throws(() => read(line), why, line);
});

test('ports', () => {
  assert.deepEqual(addressOf('/dev/ttyUSB0:57600'), { kind: 'serial', path: '/dev/ttyUSB0', baud: 57600 });
  assert.deepEqual(addressOf('/dev/ttyACM0'), { kind: 'serial', path: '/dev/ttyACM0', baud: 115200 });
  assert.deepEqual(addressOf('tcp:localhost:5761'), { kind: 'tcp', host: 'localhost', port: 5761 });
  for (const text of ['ttyACM0', '/dev/a:1200', 'tcp:host', 'tcp:host:0', 'tcp:host:70000', 'udp:host:1', '/dev/a:b']) assert.throws(() => addressOf(text), /expected|1 to 65535|one of/, text);
});

test('the protocol: sixteen steps in order, each part with its name, limit, and what to do', () => {
  assert.deepEqual(kSteps.map(({ number }) => number), Array.from({ length: kLastStep }, (_, i) => i + 1));
  const parts = kSteps.flatMap((step) => step.parts.map((part) => ({ step, part })));
  assert.equal(new Set(parts.map(({ part }) => part.id)).size, parts.length);
  for (const { step, part } of parts) {
    assert.ok(part.id.startsWith(`${step.number}.`), part.id);
    assert.ok(part.limit.text && part.limit.why && part.title && (part.failed ?? step.failed) && step.tools, part.id);
    assert.equal(typeof part.measure, 'function');
  }
  assert.ok(usage.split('\n').every((line) => line.length <= 100));
});
