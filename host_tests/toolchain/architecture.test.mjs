// SPDX-License-Identifier: GPL-3.0-or-later
// docs/architecture.md against the sources: its schedule is kTasks, and it names every room, every
// library and every part of the vehicle's state.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { frameLoads, schedule, written } from '../../toolchain/document_tasks.mjs';

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
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

// The members of struct Vehicle: a section by the name behind its brace, then what is beside them.
export function members(source) {
  const body = /struct Vehicle \{\n([^]*?)\n\};/.exec(source)[1].replace(/\/\/.*$/gm, '');
  const sections = [...body.matchAll(/^    \} (\w+);/gm)].map(([, name]) => name);
  const beside = body.replace(/^    struct \{[^]*?^    \} \w+;/gm, '').split(';')
    .map((line) => line.replace(/\[.*?\]|: 1/g, '').trim()).filter(Boolean)
    .flatMap((line) => line.replace(/^[\w:]+\s/, '').split(',').map((part) => part.trim().split(/\s+/).pop()));
  return [...sections, ...beside];
}

test('the schedule is the one of kTasks', () => {
  assert.equal(document, written(document, schedule(tasks, scheduler)), 'node toolchain/document_tasks.mjs writes it');
});

test('a row that changes, comes or goes is noticed', () => {
  const now = schedule(tasks, scheduler);
  assert.notEqual(schedule(tasks.replace(/(\{ runLog,\s+2,\s+0,\s+)\d+/, '$1999'), scheduler), now);
  assert.notEqual(schedule(tasks.replace(/(\{ runLog,\s+)2/, '$14'), scheduler), now);
  assert.throws(() => schedule(tasks.replace('{ runLog,', '{ runLogs,'), scheduler), /no remark for runLogs/);
  assert.throws(() => schedule(tasks.replace(/\{ runLog,.*\n/, '\n'), scheduler), /explains runLog/);
});

test('a frame is as full as the rows that are due in it', () => {
  const rows = [{ period: 1, phase: 0, budget_us: 10 }, { period: 2, phase: 1, budget_us: 5 },
    { period: 4, phase: 3, budget_us: 1 }];
  assert.deepEqual(frameLoads(rows, 4), [10, 15, 10, 16]);
});

test('a document without a place for the schedule is refused', () => {
  assert.throws(() => written('# A page\n', ''), /no place/);
});

test('rooms and libraries are those that the layering check knows, in its order', () => {
  const layering = read('toolchain/check_layering.mjs');
  const rooms = [.../const rooms = \[([^]*?)\]/.exec(layering)[1].matchAll(/'(\w+)'/g)].map(([, name]) => name);
  const libraries = [.../const libraries = \{\n([^]*?)\n\};/.exec(layering)[1].matchAll(/^ {2}(\w+):/gm)]
    .map(([, name]) => name);
  assert.ok(rooms.length > 10 && libraries.length > 10);
  assert.deepEqual(firstCells('The rooms of firmware/'), rooms);
  assert.deepEqual(firstCells('Libraries'), libraries);
});

test('every part of the vehicle has its writer, and no other', () => {
  assert.deepEqual(firstCells('Who writes which state').sort(), members(read('firmware/state/vehicle.hpp')).sort());
});

test('the members of a struct are found', () => {
  const source = 'struct Vehicle {\n    struct {\n        int a;  // b;\n    } one;\n    Mode mode;\n'
    + '    bool x : 1, y : 1;\n    core::Angle p,\n        q;\n    uint16_t s[hal::kServos];\n};\n';
  assert.deepEqual(members(source), ['one', 'mode', 'x', 'y', 'p', 'q', 's']);
});
