// SPDX-License-Identifier: GPL-3.0-or-later
// docs/architecture.md against the sources: its schedule is kTasks, and it names every room, every
// library and every writer of the shared state.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import * as state from '../../../toolchain/state/document.mjs';
import { constant, frameLoads, hyperPeriod, schedule, written } from '../../../toolchain/schedule/document.mjs';

const read = (path) => readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8');
const document = read('docs/architecture.md');
const tasks = read('firmware/app/tasks.cpp');
const scheduler = read('libraries/scheduler/scheduler.hpp');

// The first cells of the table's rows in the section, with what stands in backticks in them.
function firstCells(heading) {
  const section = document.split(/^##+ /m).find((text) => text.startsWith(`${heading}\n`));
  assert.ok(section, `there is no section ${heading}`);
  return section.split('\n').filter((line) => line.startsWith('| `'))
    .flatMap((line) => [...line.split('|')[1].matchAll(/`(\w+)`/g)].map(([, name]) => name));
}

test('the schedule is the one of kTasks', () => {
  assert.equal(document, written(document, schedule(tasks, scheduler)), 'node toolchain/schedule/document.mjs writes it');
});

test('a row that changes, comes or goes is noticed', () => {
  const now = schedule(tasks, scheduler);
  assert.notEqual(schedule(tasks.replace(/(runLog,\s+2,\s+0,\s+)\d+/, '$1999'), scheduler), now);
  assert.notEqual(schedule(tasks.replace(/(runLog,\s+)2/, '$14'), scheduler), now);
  assert.notEqual(schedule(tasks.replace(/slow,(\s+runLog,)/, 'medium,$1'), scheduler), now);
  assert.throws(() => schedule(tasks.replace(' runLog,', ' runLogs,'), scheduler), /no remark for runLogs/);
  assert.throws(() => schedule(tasks.replace(/TASK\(\w+,\s+runLog,.*\)/, ''), scheduler), /explains runLog/);
});

test('a frame is as full as the rows that are due in it', () => {
  const rows = [{ period: 1, phase: 0, budget_us: 10 }, { period: 2, phase: 1, budget_us: 5 },
    { period: 4, phase: 3, budget_us: 1 }];
  assert.deepEqual(frameLoads(rows, 4), [10, 15, 10, 16]);
});

test('the schedule repeats itself after the least common multiple of the periods', () => {
  assert.equal(hyperPeriod([1, 4, 10, 8].map((period) => ({ period }))), 40);
});

test('a constant is read, and one that is missing is noticed', () => {
  assert.equal(constant('constexpr int8_t kA = 5;\nconstexpr uint8_t kB = 3, kC = 7;  // frames', 'kB'), 3);
  assert.throws(() => constant('kA = 5;', 'kB'), /kB cannot be read/);
});

test('a document without a place for a table is refused', () => {
  assert.throws(() => written('# A page\n', ''), /no place/);
  assert.throws(() => state.written('# A page\n', ''), /no place/);
});

test('rooms and libraries are those that the layering check knows, in its order', () => {
  const layering = read('toolchain/check/layering.mjs');
  const rooms = [.../const rooms = \[([^]*?)\]/.exec(layering)[1].matchAll(/'(\w+)'/g)].map(([, name]) => name);
  const libraries = [.../const libraries = \{\n([^]*?)\n\};/.exec(layering)[1].matchAll(/^ {2}(\w+):/gm)]
    .map(([, name]) => name);
  assert.ok(rooms.length > 10 && libraries.length > 10);
  assert.deepEqual(firstCells('The rooms of firmware/'), rooms);
  assert.deepEqual(firstCells('Libraries'), libraries);
});

test('the table of writers is that of the sources', () => {
  const now = state.table(read('firmware/state/vehicle.hpp'), state.publishers());
  assert.equal(document, state.written(document, now), 'node toolchain/state/document.mjs writes it');
});

test('a section is read by its name, or by its fields where it is part of the vehicle itself', () => {
  const source = 'struct OneState {\n    int a;  // b;\n};\nstruct TwoState {\n    Mode mode;\n    bool x : 1, y : 1;\n'
    + '    uint16_t s[hal::kServos];\n};\nstruct Vehicle : TwoState {\n    OneState one;\n};\n'
    + '& section(Vehicle*)\n& section(OneState*)\n& section(TwoState*)\n';
  assert.deepEqual(state.sections(source),
    [{ struct: 'OneState', reads: ['one'] }, { struct: 'TwoState', reads: ['mode', 'x', 'y', 's'] }]);
});
