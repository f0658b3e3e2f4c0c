// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { longestGap_s, readLog } from '../../../../toolchain/bench_tool/log_file.mjs';

function format(type, length, name, fields, labels) {
  const bytes = Buffer.alloc(89);
  bytes.set([0xa3, 0x95, 128, type, length]);
  bytes.write(name, 5);
  bytes.write(fields, 9);
  bytes.write(labels, 25);
  return bytes;
}
const att = (time_us) => {
  const bytes = Buffer.alloc(13);
  bytes.set([0xa3, 0x95, 1]);
  bytes.writeBigUInt64LE(BigInt(time_us), 3);
  return bytes;
};
const kAtt = format(1, 13, 'ATT', 'Qh', 'TimeUS,Roll');
const logOf = (...records) => readLog(Buffer.concat(records));

test('records, their times, and the longest gap', () => {
  const log = logOf(format(128, 89, 'FMT', 'BBnNZ', 'Type,Length,Name,Format,Columns'), kAtt, att(100_000), att(200_000), att(700_000));
  assert.equal(log.bad_at, undefined);
  assert.equal(log.records, 5);
  assert.ok(Math.abs(longestGap_s(log.times_s) - 0.5) < 1e-9);
});

test('a byte that is none of a record is found, and a type without a format', () => {
  assert.equal(logOf(kAtt, att(1), Buffer.from([1, 2, 3])).bad_at, 89 + 13);
  assert.equal(logOf(att(1)).bad_at, 0);
  assert.equal(logOf(format(1, 12, 'ATT', 'Qh', 'TimeUS,Roll'), att(1)).bad_at, 89, 'a format whose length is wrong');
});

test('a last record that is cut off is no fault', () => assert.equal(logOf(kAtt, att(1).subarray(0, 9)).bad_at, undefined));
