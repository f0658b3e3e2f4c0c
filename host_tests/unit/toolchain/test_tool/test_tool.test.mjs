// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/test: which trees and targets the chosen tests need, the table of the slowest, reused
// results, and the progress of builds.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { Progress, timeLeft } from '../../../../toolchain/build_tool/progress.mjs';
import { folderOf } from '../../../../toolchain/build_tool/trees.mjs';
import { readOptions, requestsFor } from '../../../../toolchain/test_tool/main.mjs';
import { Slowest } from '../../../../toolchain/test_tool/slowest.mjs';

const tools = join(dirname(fileURLToPath(import.meta.url)), '../../../../toolchain');
const needing = (...files) => ({ properties: [{ name: 'REQUIRED_FILES', value: files }] });

test('what the chosen tests need is built in its tree, once, and nothing else', () => {
  const fly = join(folderOf('host'), 'fly'), image = join(folderOf('avr'), 'apm2/firmware.elf');

  assert.deepEqual(requestsFor([needing(fly, image), needing(fly), {}, needing('/elsewhere/x')]),
    [{ tree: 'avr', targets: ['apm2/firmware.elf'] }, { tree: 'host', targets: ['fly'] }]);
});

test('quick is a label, and what ctest knows is handed on', () => {
  const { quick, long, ctest } = readOptions(['quick', '-R', 'geo']);

  assert.deepEqual([quick, long, ctest], [true, false, ['-L', '^quick$', '-C', 'quick', '-R', 'geo']]);
});

test('long has ctest take the tests of that configuration, too', () => {
  assert.deepEqual(readOptions(['--long', '-R', 'bench']).ctest, ['-C', 'long', '-R', 'bench']);
});

test('the slowest tests stand before the summary, which stays last', () => {
  const slowest = new Slowest();
  const shown = [' 1/2 Test #9: a.b ......   Passed    0.52 sec', ' 2/2 Test #10: c ...***Failed   12.00 sec',
    '', '50% tests passed, 1 tests failed out of 2'].flatMap((line) => slowest.withSummary(line));

  assert.equal(shown[3], 'The slowest of 2 tests, which took 13 s together:');
  assert.deepEqual(shown.slice(4, 6), ['    12.0 s  c', '     0.5 s  a.b']);
  assert.equal(shown.at(-1), '50% tests passed, 1 tests failed out of 2');
});

test('a build says how many steps are done of all, and about how long the others take', () => {
  let now = 0;
  const lines = [];
  const out = { isTTY: false, write: (text) => lines.push(text) };
  const progress = new Progress(new Map([['host', 100], ['avr', 20]]), { out, now: () => now });
  now = 100;
  progress.update('host', 1, 2);  // the search for new files
  now = 31_000;
  progress.update('host', 30, 100);
  now = 32_000;
  progress.update('host', 31, 100);
  progress.end();

  assert.deepEqual(lines, ['building: 30/120, about 2 min left\n', 'built: 120 steps in 32 s\n']);
  assert.equal(timeLeft(1000, 50, 100), 'less than a minute');
});

// A command that counts how often it ran.
function counted(folder, status = 0) {
  const input = join(folder, 'input'), runs = join(folder, 'runs'), stamp = join(folder, 'stamp');
  writeFileSync(input, 'one');
  writeFileSync(runs, '');
  const run = (reuse) => spawnSync(process.execPath, [join(tools, 'test_tool/reuse.mjs'), stamp, input, '--',
    '/bin/sh', '-c', `printf x >>${runs}; exit ${status}`],
    { env: { PATH: process.env.PATH, ...(reuse ? { REUSE_RESULTS: '1' } : {}) }, encoding: 'utf8' });
  return { run, input, runs: () => readFileSync(runs, 'utf8').length };
}

function inFolder(work) {
  const folder = mkdtempSync(join(tmpdir(), 'reuse-'));
  try {
    work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a test that passed is not run again until what it depends on changes', () => inFolder((folder) => {
  const { run, input, runs } = counted(folder);
  run(true);
  const again = run(true);
  assert.deepEqual([again.status, runs()], [0, 1]);
  assert.match(again.stdout, /nothing it depends on has changed/);
  run(false);
  assert.equal(runs(), 2, 'without REUSE_RESULTS it always runs');
  writeFileSync(input, 'two');
  run(true);
  assert.equal(runs(), 3);
}));

test('a test that failed runs again, and its status is passed on', () => inFolder((folder) => {
  const { run, runs } = counted(folder, 3);
  assert.deepEqual([run(true).status, run(true).status, runs()], [3, 3, 2]);
}));
