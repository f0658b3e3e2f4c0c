// SPDX-License-Identifier: GPL-3.0-or-later
// That a failing check on the chip fails, and that a program which does not come to its end does.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';

const run = (name, seconds) => spawnSync(process.env.RUN_ON_CHIP,
  [join(process.env.ON_CHIP_PROGRAMS, `on_chip_${name}.elf`), seconds], { encoding: 'utf8' });

test('every failing check is reported with its line and values, and the program fails', () => {
  const { status, stdout } = run('failing', '5');

  assert.equal(status, 1);
  const reported = [...stdout.matchAll(/failing_test\.cpp:\d+: (\w+)\(/g)].map(([, check]) => check);
  assert.deepEqual(reported, ['EQ', 'NE', 'LT', 'LE', 'GT', 'GE', 'TRUE', 'FALSE', 'NEAR', 'FLOAT_EQ', 'EQ', 'EQ',
                          'ADD_FAILURE', 'EQ', 'EQ', 'LT', 'NEAR', 'EQ']);
  assert.match(stdout, /left: one, right: two in words: 7/);
  assert.match(stdout, /left: 65535, right: -1/);
  assert.match(stdout, /OK  \] Passing\.among_failures/);
  assert.match(stdout, /^6 tests, 5 failed, 0 left out$/m);
  assert.doesNotMatch(stdout, /never reached/);
});

test('a program that does not come to its end fails', () => {
  const { status, stdout } = run('stopping', '0.5');

  assert.equal(status, 1);
  assert.match(stdout, /Stopping\.stops_in_the_middle_of_a_test/);
  assert.match(stdout, /without an end/);
});

test('a test that is to be left out and does not exist is a failure', () => {
  const { status, stdout } = run('stale', '5');

  assert.equal(status, 1);
  assert.match(stdout, /there is no test Gone\.long_ago/);
});
