// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a self-test: whatever happens, the board gets its firmware back.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Refusal } from '../../../../toolchain/flash_tool/refusal.mjs';
import { readOptions } from '../../../../toolchain/self_test_tool/options.mjs';
import { selfTest, table } from '../../../../toolchain/self_test_tool/run.mjs';
import { kBegin, kEnd, kLines } from './good_report.mjs';

const good = [...kBegin, ...kLines, ...kEnd];

// A board that says `lines`; `failing` is the program that cannot be written.
function rig({ lines = good, failing = [], flashes = true, stop_ms = Infinity, again }) {
  const done = [], printed = [];
  const rest = [...lines];
  let now_ms = 0, listener;
  const clock = { now_ms: () => now_ms, stopped: () => now_ms > stop_ms,
    sleep: async (time_ms) => {
      now_ms += time_ms;
      if (again && rest.length === 0) rest.push(...again);
      if (rest.length > 0) listener(Buffer.from(`${rest.shift()}\n`));
    } };
  const device = { flashes, command: 'toolchain/flash /dev/ttyACM0 --board apm2',
    flash: async (program) => {
      done.push(program);
      if (failing.includes(program)) throw new Refusal('no bootloader answers', 1);
    },
    open: async () => {
      done.push('open');
      return { onBytes: (to) => { listener = to; }, close: () => done.push('close') };
    } };
  return { done, printed, run: (board = 'apm2') => selfTest({ board, device, clock, print: (line) => printed.push(line) }) };
}

test('the self-test is written, read, and the firmware written back', async () => {
  const { done, run } = rig({});
  const { passed, results, report } = await run();
  assert.equal(passed, true);
  assert.deepEqual(done, ['self_test', 'open', 'close', 'firmware']);
  assert.equal(table(results, report).length, results.length);
});

test('over TCP nothing is written', async () => {
  const { done, run } = rig({ flashes: false });
  assert.equal((await run()).passed, true);
  assert.deepEqual(done, ['open', 'close']);
});

test('a part that fails, a line that is not understood or another board: not passed, with what to do', async () => {
  const bad = await rig({ lines: good.map((line) => line.replace('right 100', 'right 0')) }).run();
  assert.equal(bad.passed, false);
  assert.match(table(bad.results, bad.report).join('\n'), /fail +compass: answers of 100 +0 .*\n +No compass/);
  const garbled = await rig({ lines: [...kBegin, '~~', ...kLines, ...kEnd] }).run();
  assert.equal(garbled.passed, false);
  assert.match(table(garbled.results, garbled.report).join('\n'), /not understood: ~~/);
  const other = rig({});
  assert.equal((await other.run('apm1')).passed, false);
  assert.match(other.printed.join('\n'), /that of an APM 2, not of an APM 1/);
});

for (const [what, options, message] of [
  ['a board that says nothing', { lines: [] }, /nothing came at all/],
  ['a report that stops', { lines: good.slice(0, 5) }, /its last line was "inertial|its last line was "barometer|its last line was "interrupted/],
  ['Ctrl-C', { stop_ms: 300 }, /interrupted/],
  ['a board that begins again and again', { lines: [], again: kBegin }, /no end within 180 s; the board began \d{3,} times: something resets it/],
  ['a board that repeats a line', { lines: kBegin, again: kLines.slice(0, 1) }, /no end within 180 s; its last line was "supply/],
  ['another program on the board', { lines: [], again: ['\xfe\x09', '~'] }, /no end within 180 s; what comes is no report/],
  ['a self-test that cannot be written', { failing: ['self_test'] }, /no bootloader answers/],
]) test(`${what}: an error, and the firmware is written back`, async () => {
  const { done, run } = rig(options);
  await assert.rejects(run, (error) => error instanceof Refusal && error.status === 1 && message.test(error.message));
  assert.equal(done.at(-1), 'firmware');
});

test('firmware that cannot be written back is said loudly, with the command that writes it', async () => {
  const { printed, run } = rig({ failing: ['firmware'] });
  await assert.rejects(run, /^Error: the firmware could not be written back/);
  assert.match(printed.join('\n'), /DOES NOT HAVE ITS FIRMWARE: no bootloader answers\nWrite it with: toolchain\/flash/);
  await assert.rejects(rig({ lines: [], failing: ['firmware'] }).run, /nothing came at all; and the firmware could not be written back/);
});

test('a report without its beginning is of no board', async () => {
  const { printed, run } = rig({ lines: [...kLines, 'end'], flashes: false });
  assert.equal((await run()).passed, false);
  assert.match(printed.join('\n'), /^The beginning of the report is missing/);
});

test('the command line', () => {
  assert.deepEqual(readOptions(['tcp:127.0.0.1:5761', '--board', 'apm1', '--yes']).address, { kind: 'tcp', host: '127.0.0.1', port: 5761 });
  for (const words of [[], ['/dev/ttyACM0'], ['/dev/ttyACM0', '--board', 'apm3'], ['COM3', '--board', 'apm1'],
    ['/dev/ttyACM0', '--board'], ['/dev/ttyACM0', '/dev/ttyACM1', '--board', 'apm1'], ['/dev/ttyACM0', '--fast']])
    assert.throws(() => readOptions(words), (error) => error instanceof Refusal && error.status === 2, words.join(' '));
});
