// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/same: where two files differ first, what becomes of a flight, and what a user is
// answered. The flights themselves take minutes to build and are not flown here.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { firstDifference, flattened, compared } from '../../../../toolchain/same_tool/compare.mjs';
import { kFlights } from '../../../../toolchain/same_tool/flights.mjs';
import { readOptions, verdictOf } from '../../../../toolchain/same_tool/main.mjs';
import { commandLong, frame, framesIn, heartbeat, modeOf } from '../../../../toolchain/same_tool/mavlink.mjs';
import { chosenSlot } from '../../../../toolchain/same_tool/versions.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
const difference = (path, before, after) => firstDifference(path, Buffer.from(before), Buffer.from(after));

for (const [what, before, after, words] of [
  ['the same', 'a,b\n1,2\n', 'a,b\n1,2\n', null],
  ['a value', 'time_s,b\n0.10,2\n0.20,3\n', 'time_s,b\n0.10,2\n0.20,4\n', 'line 3 at 0.20 s, b: 3 and 4'],
  ['the first of several', 'a,b\n1,2\n5,6\n', 'a,b\n9,8\n7,6\n', 'line 2, a: 1 and 9'],
  ['an empty value', 'a,b\n1,\n', 'a,b\n1,2\n', 'line 2, b: nothing and 2'],
  ['a value more', 'a,b\n1,2\n', 'a,b\n1,2,3\n', 'line 2: 2 columns and 3'],
  ['a longer file', 'a,b\n1,2\n', 'a,b\n1,2\n3,4\n', 'line 3: nothing and 3,4'],
  ['a shorter file', 'a,b\n1,2', 'a,b', 'line 2: 1,2 and no line'],
  ['a longer one without a last end of line', 'a,b', 'a,b\n1,2', 'line 2: no line and 1,2'],
]) test(`flight.csv: ${what}`, () => assert.equal(difference('flight.csv', before, after), words));

test('a byte of a memory is named by its place with both values', () => {
  const ours = Buffer.alloc(1200, 0xff), theirs = Buffer.from(ours);
  theirs[530] = 0x0a;

  assert.equal(firstDifference('eeprom.bin', ours, theirs), 'byte 530: 0xff and 0x0a');
  assert.equal(firstDifference('first/log.bin', ours, theirs), 'page 1, byte 2: 0xff and 0x0a');
  assert.equal(firstDifference('log.bin', ours, ours.subarray(0, 5)), 'page 0, byte 5: 0xff and nothing');
});

const text = (words) => frame({ id: 253, extra: 83, payload: [5, ...Buffer.from(words.padEnd(50, '\0'))] }, 0);

test('a message is named by its number, a text by its words', () => {
  const beat = frame(heartbeat(), 0), other = Buffer.from(beat);
  other[6] ^= 1;

  assert.equal(difference('telemetry.bin', Buffer.concat([beat, text('armed')]), Buffer.concat([beat, text('ready')])),
    'message 2: "armed" and "ready"');
  assert.equal(difference('usb.bin', Buffer.concat([beat, beat]), Buffer.concat([beat, other])),
    'message 2 (id 0), byte 6: 0x00 and 0x01');
  assert.equal(difference('usb.bin', beat, Buffer.concat([beat, beat])), 'message 1 (id 0), byte 17: nothing and 0xfe');
});

test('frames are cut out of a stream, and an unfinished one is left', () => {
  const stream = Buffer.concat([frame(heartbeat(), 3), frame(commandLong(400, [1]), 4)]);
  const { frames, taken } = framesIn(stream.subarray(0, stream.length - 1));

  assert.deepEqual([frames.length, taken], [1, 17]);
  assert.deepEqual(modeOf(frames[0]), { mode: 0, armed: false });
});

// Against another way to compute it, bit by bit.
test('a frame carries the checksum of X.25 over what follows its first byte', () => {
  const bytes = frame({ id: 0, extra: 0x39, payload: [...Buffer.from('5678')] }, 0x32);
  let crc = 0xffff;
  for (const byte of [...bytes.subarray(1, -2), 0x39]) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >> 1) ^ 0x8408 : crc >> 1;
  }
  assert.equal(bytes.readUInt16LE(bytes.length - 2), crc);
});

const side = (files, failure = null) => ({ failure,
  files: new Map(Object.entries(files).map(([name, words]) => [name, Buffer.from(words)])) });

test('a flight is the same only when all of its files are', () => {
  const one = { 'flight.csv': 'a\n1\n', 'log.bin': 'xy' };

  assert.equal(compared(side(one), side(one)).verdict, 'same');
  assert.deepEqual(compared(side(one), side({ ...one, 'log.bin': 'xz' })),
    { verdict: 'different', words: 'log.bin page 0, byte 1: 0x79 and 0x7a' });
  assert.equal(compared(side(one), side({ 'flight.csv': 'a\n1\n' })).verdict, 'different');
});

test('a flight that failed, or left nothing, is not the same', () => {
  const one = { 'flight.csv': 'a\n1\n' };

  assert.deepEqual(compared(side(one), side(one, 'crashed at 3 s')),
    { verdict: 'failed', words: 'after: crashed at 3 s' });
  assert.equal(compared(side(one, 'crashed'), side(one, 'crashed')).verdict, 'failed');
  assert.equal(compared(side({}), side({})).verdict, 'failed');
  const log = { 'log.bin': 'x' };
  assert.equal(compared(side(log), side(log), { texts_may_differ: true }).verdict, 'failed');
});

test('where texts may differ the path is compared all the same, and the verdict says so', () => {
  const before = side({ 'flight.csv': 'a\n1\n', 'log.bin': 'x', 'summary.txt': 'x', 'telemetry.bin': 'x' });
  const after = side({ 'flight.csv': 'a\n1\n', 'log.bin': 'y', 'summary.txt': 'y', 'telemetry.bin': 'y' });
  const options = { texts_may_differ: true };

  assert.deepEqual(compared(before, after, options), { verdict: 'same', words: 'flight.csv' });
  assert.equal(compared(before, side({ 'flight.csv': 'a\n2\n' }), options).verdict, 'different');
  assert.match(verdictOf([{ verdict: 'same' }], options), /only flight\.csv was compared/);
});

test('the verdict counts what is different and what failed', () => {
  assert.equal(verdictOf([{ verdict: 'same' }, { verdict: 'same' }], {}), 'the same: 2 of 2 flights');
  assert.equal(verdictOf([{ verdict: 'same' }, { verdict: 'failed' }, { verdict: 'different' }], {}),
    'different: 2 of 3 flights, 1 of them failed');
});

test('of a summary everything counts but how fast the computer was', () => {
  const lines = (speedup, words) => flattened({ speedup, completed: true, texts: [{ time_s: 1, text: words }] });

  assert.equal(lines(700, 'armed'), lines(600, 'armed'));
  assert.notEqual(lines(700, 'armed'), lines(700, 'ready'));
});

test('a version that is built is taken again, otherwise the checkout longest not used', () => {
  const slots = [['a', 'x', 5], ['b', 'y', 3], ['c', 'z', 4]].map(([path, tree, used]) => ({ path, tree, used }));

  assert.equal(chosenSlot(slots, 'x', []).path, 'a');
  assert.equal(chosenSlot(slots, 'w', []).path, 'b');
  assert.equal(chosenSlot(slots, 'w', ['b']).path, 'c');
  assert.equal(chosenSlot(slots, 'y', ['b']).path, 'c');
});

test('ten flights, each with a name of its own', () => {
  assert.equal(new Set(kFlights.map(({ name }) => name)).size, 10);
});

test('options', () => {
  assert.deepEqual(readOptions(['a']), { before: 'a', after: 'HEAD', worktree: false, texts_may_differ: false });
  assert.deepEqual(readOptions(['--expect-text', 'a', 'b']),
    { before: 'a', after: 'b', worktree: false, texts_may_differ: true });
});

test('of two runs in one folder the second is refused while the first goes on, and not for ever', () => {
  const folder = mkdtempSync(join(tmpdir(), 'alone-'));
  const script = `import('${join(root, 'toolchain/shared/checkout.mjs')}').then(({ beAlone }) => beAlone('${folder}'))`;
  const second = () => spawnSync(process.execPath, ['-e', script], { encoding: 'utf8' });

  writeFileSync(join(folder, 'lock'), `${process.pid}\n`);
  assert.match(second().stderr, new RegExp(`process ${process.pid} works in`));
  rmSync(join(folder, 'lock'));
  assert.equal(second().status, 0);
  assert.equal(second().status, 0, 'the lock of one that has ended');
  rmSync(folder, { recursive: true });
});

const run = (...words) => spawnSync(process.execPath, [join(root, 'toolchain/same_tool/main.mjs'), ...words],
  { encoding: 'utf8', cwd: root });

// The sources alone, as toolchain/fresh has them, are no repository.
const hasHistory = spawnSync('git', ['-C', root, 'rev-parse', '--verify', 'HEAD']).status === 0;

for (const [what, words, expected, options = {}] of [
  ['no commit', [], 'which commit'],
  ['an option that is none', ['HEAD', '--fast'], 'no option --fast'],
  ['three commits', ['a', 'b', 'c'], 'not also c'],
  ['a commit and the working tree', ['a', 'b', '--worktree'], 'not both'],
  ['a commit that is none', ['no-such-commit'], 'no commit no-such-commit', { skip: !hasHistory }],
]) {
  test(`${what}: one line and exit status 2`, options, () => {
    const { status, stdout, stderr } = run(...words);
    assert.equal(status, 2);
    assert.equal(stdout, '');
    assert.match(stderr, /^same: .*\n$/);
    assert.ok(stderr.includes(expected), stderr);
  });
}
