// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { taskRows } from '../../../../toolchain/schedule/task_rows.mjs';

const table = (...rows) => `#define TASKS(TASK) \\\n${rows.join(' \\\n')}\nnothing of it\n`;

test('every row is numbered in the order of the table', () => {
  const rows = taskRows(table('    /* run (us) */', '    TASK(fast, runA,  1,  0,  250)', '    TASK(slow,runB,10,3,1500)'));

  assert.deepEqual(rows, [{ number: 0, name: 'runA', tier: 'fast', period: 1, phase: 0, budget_us: 250 },
    { number: 1, name: 'runB', tier: 'slow', period: 10, phase: 3, budget_us: 1500 }]);
});

test('a row that cannot be read is not left out silently', () => {
  assert.throws(() => taskRows(table('    TASK(fast, runA, 1, 0, 250)', '    TASK(slow, runB, kPeriod, 0, 9)')),
    /of 2 rows only 1/);
});

test('a row without a tier is not understood', () => {
  assert.throws(() => taskRows(table('    TASK(fast, runA, 1, 0, 250)', '    TASK(runB, 10, 0, 9)')), /of 2 rows only 1/);
});

test('the schedule of the firmware can be read', () => {
  const source = readFileSync(new URL('../../../../firmware/app/tasks.cpp', import.meta.url), 'utf8');

  assert.ok(taskRows(source).length > 10);
});
