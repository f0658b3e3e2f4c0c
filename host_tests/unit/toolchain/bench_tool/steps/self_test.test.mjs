// SPDX-License-Identifier: GPL-3.0-or-later
// Step 16: a row of the form for each group of the self-test's parts, of a report as toolchain/self_test leaves it.
import assert from 'node:assert/strict';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { NotDone, NotMeasured } from '../../../../../toolchain/bench_tool/errors.mjs';
import { verdictOn } from '../../../../../toolchain/bench_tool/limits.mjs';
import { selfTest } from '../../../../../toolchain/bench_tool/steps/self_test.mjs';
import { writeFigures } from '../../../../../toolchain/self_test_tool/figures_file.mjs';
import { verdicts } from '../../../../../toolchain/self_test_tool/parts.mjs';
import { Report } from '../../../../../toolchain/self_test_tool/report.mjs';
import { kBegin, kEnd, kLines } from '../../self_test_tool/good_report.mjs';

const good = [...kBegin, ...kLines, ...kEnd];

function reportOf(lines) {
  const report = new Report();
  for (const [i, line] of lines.entries()) report.take(Buffer.from(`${line}\n`), i * 100);
  return report;
}

const outcomeOf = async ({ id, limit, measure }, b) => {
  try {
    return verdictOn(limit, await measure({ ...b, id }));
  } catch (error) {
    return error;
  }
};

// Of each part by its name { verdict, value }, or the error, with a board whose self-test says `lines`; null: the
// tool leaves no report.
async function measured(lines, { board = 'apm2', status = 0, canReset = true } = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'step-16-')), calls = [];
  const port = { canReset, address: { path: '/dev/ttyACM0' }, pause: () => calls.push('pause'), resume: async () => { calls.push('resume'); } };
  const tool = (path, kind, file) => {
    calls.push(`${path} ${kind}`);
    if (lines) {
      const report = reportOf(lines);
      writeFigures(file, { report, results: verdicts(report), passed: status === 0 });
    }
    return status;
  };
  const b = { board: { port }, options: { board, folder, selfTest: tool }, person: { action: async () => {} }, print: () => {}, found: {} };
  const rows = {};
  for (const part of selfTest.parts) rows[part.id] = await outcomeOf(part, b);
  return { calls, ...rows };
}

test('a good board passes each row; the port is free while the tool has it', async () => {
  const { calls, ...rows } = await measured(good);
  assert.deepEqual(calls, ['pause', '/dev/ttyACM0 apm2', 'resume']);
  assert.deepEqual(Object.values(rows).map(({ verdict }) => verdict), Array(11).fill('pass'));
  assert.equal(rows['16.pwm_of_outputs_1_to_8'].value, 'pulses off what was asked -1.0 us to 1.0 us; period 19999.0 us to 20001.0 us');
  assert.equal(rows['16.supply'].value, '4.99 V to 5.00 V');
});

test('a row shows the worst of its parts, and names the output', async () => {
  const rows = await measured(good.map((line) => (line.startsWith('pulse 5 asked 900') ? 'pulse 5 asked 900 least 880 most 901' : line)), { status: 1 });
  assert.deepEqual(rows['16.pwm_of_outputs_1_to_8'], { verdict: 'fail',
    value: 'pulses off what was asked -20.0 us to 1.0 us; period 19999.0 us to 20001.0 us; output 5: pulses off what was asked' });
  assert.equal(rows['16.eeprom'].verdict, 'pass');
});

test('a part that is not in the report fails its row', async () => {
  const rows = await measured(good.filter((line) => !line.startsWith('period 3')), { status: 1 });
  assert.equal(rows['16.pwm_of_outputs_1_to_8'].verdict, 'fail');
  assert.match(rows['16.pwm_of_outputs_1_to_8'].value, /period not in the report; output 3: period/);
});

test('a line that is not understood fails the run, another board\'s report counts for nothing', async () => {
  assert.deepEqual((await measured([...kBegin, '~~', ...kLines, ...kEnd], { status: 1 }))['16.run'], { verdict: 'fail', value: 'not understood: ~~' });
  const other = await measured(good, { board: 'apm1', status: 1 });
  assert.deepEqual(other['16.run'], { verdict: 'fail', value: 'the report of an APM 2' });
  assert.ok(other['16.supply'] instanceof NotDone);
});

test('a tool that ends early fails the run, and the other rows are not done', async () => {
  for (const [status, message] of [[2, /ended with status 2/], [1, /did not come to its end/]]) {
    const { calls, ...rows } = await measured(null, { status });
    assert.ok(rows['16.run'] instanceof NotMeasured);
    assert.match(rows['16.run'].message, message);
    assert.ok(rows['16.ram'] instanceof NotDone);
    assert.equal(calls.at(-1), 'resume');
  }
});

test('over TCP the step is not done', async () => {
  const { calls, ...rows } = await measured(good, { canReset: false });
  assert.deepEqual(calls, []);
  assert.ok(Object.values(rows).every((row) => row instanceof NotDone));
});
