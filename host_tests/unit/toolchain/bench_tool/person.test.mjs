// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { NotDone, NotFitted, NotMeasured, Stopped } from '../../../../toolchain/bench_tool/errors.mjs';
import { fromFile, numberOf, Person } from '../../../../toolchain/bench_tool/person.mjs';

const typing = (...lines) => new Person(() => Promise.resolve(lines.shift()), () => {});
const volts = { unit: 'V', low: 0, high: 20 };

test('numbers with point or comma, with their unit or without', () => {
  assert.equal(numberOf('5,01 V', 'V'), 5.01);
  assert.equal(numberOf('-3', 'us'), -3);
  for (const text of ['', '5 A', 'five', '1e3', '5.', '0x10', '1 2', 'NaN', 'Infinity']) assert.equal(numberOf(text, 'V'), undefined, text);
});

test('a reading is asked for until it is a plausible number', async () => {
  assert.equal(await typing('', 'x', '50', '5 V').number('id', '', volts), 5);
});

test('words end a part or the session', async () => {
  for (const [word, kind, message] of [['skip no meter', NotDone, 'no meter'], ['none', NotFitted, /none/], ['fail it smokes', NotMeasured, 'it smokes'],
    ['quit', Stopped, /stopped/], [undefined, Stopped, /stopped/]])
    await assert.rejects(typing(word).number('id', '', volts), (error) => error instanceof kind && (message.test?.(error.message) ?? error.message === message));
});

test('a remark is kept and the question stays', async () => {
  const person = typing('remark loose plug', '5');
  assert.equal(await person.number('id', '', volts), 5);
  assert.deepEqual(person.remarks, ['loose plug']);
});

test('only the very words confirm', async () => {
  for (const text of ['', 'y', 'yes', 'run', 'Run the motor', 'run the motor!', 'none']) assert.equal(await typing(text).confirms('id', '', 'run the motor'), false, text);
  assert.equal(await typing(' run the motor ').confirms('id', '', 'run the motor'), true);
});

test('fuses are bytes', async () => {
  assert.equal(await typing('D8').byte('id', ''), '0xD8');
  assert.equal(await typing('zz', '0x1ff', '0xfd').byte('id', ''), '0xFD');
});

test('a file of answers: unknown questions, and answers that cannot be used, are refused', async () => {
  const path = join(mkdtempSync(join(tmpdir(), 'bench-answers-')), 'a.json');
  const output = { write: () => {} };
  writeFileSync(path, '{"a": "soon", "b": 5}');
  const person = fromFile(path, output);
  assert.equal(await person.number('b', '', volts), 5);
  await assert.rejects(person.number('a', '', volts), /no number in V/);
  await assert.rejects(async () => person.action('c', ''), /has no answer to c/);
  for (const text of ['', '[]', 'null', '3']) {
    writeFileSync(path, text);
    assert.throws(() => fromFile(path, output), /cannot be used|no object/);
  }
  assert.throws(() => fromFile('/none/a.json', output), /ENOENT/);
});
