// SPDX-License-Identifier: GPL-3.0-or-later
// What the self-test's report means: a whole one passes, and each part that is wrong or missing fails alone.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { kParts, verdicts } from '../../../../toolchain/self_test_tool/parts.mjs';
import { Report } from '../../../../toolchain/self_test_tool/report.mjs';
import { kBegin, kEnd, kLines } from './good_report.mjs';

function reportOf(lines, gap_ms = 700) {
  const report = new Report();
  let now_ms = 0;
  for (const line of lines) {
    report.take(Buffer.from(`${line}\r\n`), now_ms);
    now_ms += line === 'watchdog waits' ? gap_ms : 1;
  }
  return report;
}
const not_passed = (lines, gap_ms) => verdicts(reportOf(lines, gap_ms))
  .filter(({ verdict }) => verdict !== 'pass').map(({ title, verdict }) => `${title}: ${verdict}`);
const good = [...kBegin, ...kLines, ...kEnd];
const changed = (from, to) => {
  const lines = good.map((line) => line.replace(from, to));
  assert.notDeepEqual(lines, good, `${from} is in the report`);
  return lines;
};

test('a good board passes every part, in whatever pieces the report comes', () => {
  const report = reportOf(good);
  assert.deepEqual(not_passed(good), []);
  assert.deepEqual([report.board, report.ended, report.unknown], ['APM 2', true, []]);
  const pieces = new Report();
  for (const byte of Buffer.from(good.join('\n') + '\n')) pieces.take(Buffer.from([byte]), 0);
  assert.deepEqual(pieces.figures, new Map([...report.figures, ['restart', { s: 0 }]]));
});

for (const [from, to, title, verdict = 'fail'] of [
  ['least 4987', 'least 4290', 'supply'], ['most 5004', 'most 5710', 'supply'],
  ['us 53.5', 'us 150.5', 'held up by interrupts'],
  ['samples 2000', 'samples 1949', 'inertial sensor: samples in 10 s'],
  ['inertial samples 2000 bad 0', 'inertial samples 2000 bad 1', 'inertial sensor: bad reads and restarts'],
  ['samples 2000 bad 0 restarts 0', 'samples 2000 bad 0 restarts 1', 'inertial sensor: bad reads and restarts'],
  ['readings 800', 'readings 149', 'barometer: readings in 10 s'],
  ['readings 800 bad 0', 'readings 800 bad 3', 'barometer: bad reads and restarts'],
  ['right 100', 'right 99', 'compass: answers of 100'],
  ['pulse 3 asked 900 least 899.0', 'pulse 3 asked 900 least 897.5', 'output 3: pulses off what was asked'],
  ['pulse 8 asked 1000 least 1000.0 most 1001.0', 'pulse 8 asked 1000 least 0.0 most 0.0', 'output 8: pulses off what was asked'],
  ['period 5 least 19999.0', 'period 5 least 19899.5', 'output 5: period'],
  ['cells 8 bad 0', 'cells 8 bad 1', 'EEPROM: bad cells'],
  ['cells 8', 'cells 0', 'EEPROM: cells tried'],
  ['bytes 528 bad 0', 'bytes 528 bad 7', 'DataFlash: bad bytes'],
  ['pages 8192', 'pages 0', 'DataFlash: pages'],
  ['ram bytes 6336 bad 0', 'ram bytes 6336 bad 1', 'RAM: bad bytes'],
  ['ram bytes 6336', 'ram bytes 1999', 'RAM: bytes tried'],
  [/^compass .*/, 'heading 90', 'compass: answers of 100', 'missing'],
  [/^pulse 2 asked 800 .*/, 'noise 1', 'output 2: pulses off what was asked', 'missing'],
]) test(`"${from}" as "${to}": ${verdict}`, () => assert.deepEqual(not_passed(changed(from, to)), [`${title}: ${verdict}`]));

test('a restart that takes too long fails, one that the watchdog has not made is none', () => {
  assert.deepEqual(not_passed(good, 1600), ['silent over a restart by the watchdog: fail']);
  assert.equal(not_passed(changed('started by watchdog', 'started by external')).length, kParts.length, 'it begins anew');
});

test('a board that is reset in the middle begins anew', () => {
  const half = kLines.slice(0, 5).map((line) => line.replace('bad 0', 'bad 9'));
  assert.deepEqual(not_passed([...kBegin, ...half, ...good]), []);
});

test('a garbled line is kept, and is no figure', () => {
  const report = reportOf([...kBegin, 'compass asked 1~0 right 100', 'end of what', ...kLines.slice(5), ...kEnd]);
  assert.deepEqual(report.unknown, ['compass asked 1~0 right 100', 'end of what']);
  const strange = ['c\x1b\x7fmpass asked 100 right 100', 'restart s 0', 'heading 90'];
  assert.deepEqual(reportOf(strange).unknown, ['c??mpass asked 100 right 100', ...strange.slice(1)]);
  assert.deepEqual([...reportOf(strange).figures], []);
});

test('a line that a reset tears ends where the report begins anew', () => {
  const torn = ['noise', ...kLines.slice(0, 5).map((line) => line.replace('bad 0', 'bad 9')), `inertial sam${kBegin[0]}`];
  const lines = [...kBegin, ...torn, ...good.slice(1)];
  assert.deepEqual(reportOf(lines).unknown, []);
  assert.deepEqual(not_passed(lines), []);
  assert.equal(reportOf(lines).begins, 3);
  assert.deepEqual(not_passed(good.map((line, i) => (i > kBegin.length && line === kBegin[0] ? `\0\xff${line}` : line))), [],
    'noise of the watchdog\'s reset');
});
