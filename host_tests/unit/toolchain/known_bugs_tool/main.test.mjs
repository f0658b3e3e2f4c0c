// SPDX-License-Identifier: GPL-3.0-or-later
// What a user is answered; the flights take minutes and are not flown here.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { kBugs } from '../../../../toolchain/known_bugs_tool/bugs.mjs';
import { readOptions } from '../../../../toolchain/known_bugs_tool/main.mjs';

const program = join(dirname(fileURLToPath(import.meta.url)), '../../../../toolchain/known_bugs_tool/main.mjs');

test('options are read', () => {
  assert.deepEqual(readOptions([]), { names: [], flights: 10_000, seed: 1, jobs: 1, list: false });
  assert.deepEqual(readOptions(['S4', '--flights', '50', 'S1', '--seed', '7', '--jobs', '2']),
    { names: ['S4', 'S1'], flights: 50, seed: 7, jobs: 2, list: false });
});

for (const [words, why] of [[['S99'], /no bug S99/], [['--what'], /no option --what/],
  [['--flights'], /--flights needs a number from 1 on, not nothing/], [['--seed', '0'], /--seed needs .* not 0/]])
  test(`${words.join(' ')} is wrong`, () => assert.throws(() => readOptions(words), why));

test('--list prints every bug, and wrong usage is one line and status 2', () => {
  const list = spawnSync(process.execPath, [program, '--list'], { encoding: 'utf8' });
  assert.equal(list.status, 0);
  assert.deepEqual(list.stdout.trim().split('\n').map((line) => line.slice(0, 2)), kBugs.map(({ name }) => name));
  const wrong = spawnSync(process.execPath, [program, 'S99'], { encoding: 'utf8' });
  assert.equal(wrong.status, 2);
  assert.match(wrong.stderr, /^known_bugs: .*\n$/);
});
