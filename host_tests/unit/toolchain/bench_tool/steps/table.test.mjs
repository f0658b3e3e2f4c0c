// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { kSteps, stepsOn } from '../../../../../toolchain/bench_tool/steps/table.mjs';

const partsOn = (board) => stepsOn(board).flatMap(({ parts }) => parts);
const partOn = (board, id) => partsOn(board).find((part) => part.id === id);

test('both boards have the same steps, and parts in the same order but for those of one board', () => {
  const ids = (board) => partsOn(board).filter(({ only }) => !only).map(({ id }) => id);

  assert.deepEqual(stepsOn('apm1').map(({ number }) => number), kSteps.map(({ number }) => number));
  assert.deepEqual(ids('apm1'), ids('apm2'));
});

test('an APM 1 has its own limits, titles and advice, an APM 2 none of them', () => {
  assert.equal(partOn('apm1', '10.lift').limit.text, '0.5 to 1.5 m');
  assert.equal(partOn('apm2', '10.lift').limit.text, '0.8 to 1.2 m');
  assert.equal(partOn('apm1', '2.reboot').title, 'silent over a restart by command');
  assert.equal(partOn('apm2', '2.reboot').title, 'silent over a restart by the watchdog');
  assert.match(stepsOn('apm1')[10].note, /channel 8/);
  assert.equal(stepsOn('apm2')[10].note, undefined);
});

test('nothing that an APM 1 shows is about parts that only an APM 2 has', () => {
  const shown = stepsOn('apm1').flatMap((step) => [step, ...step.parts])
    .map(({ title, tools, note, failed, limit }) => [title, tools, note, failed, limit?.text, limit?.why].join(' '));

  for (const text of shown) assert.doesNotMatch(text, /APM 2|MPU-?6000|MS5611|jumper|factory's wiring/);
});

test('each timer of the servo outputs has an output whose rate is measured', () => {
  const timers = { apm1: [[1, 2], [3, 4], [5, 6], [7, 8]], apm2: [[1, 2], [3, 4, 5], [6, 7, 8]] };  // docs/boards.md

  for (const [board, groups] of Object.entries(timers))
    for (const outputs of groups) assert.ok(outputs.some((output) => partOn(board, `11.rate_${output}`)), `${board} ${outputs}`);
});
