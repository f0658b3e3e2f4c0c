// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { equals, holds, kFail, kNotDone, kNotFitted, kPass, verdictOfStep, verdictOn, within } from '../../../../toolchain/bench_tool/limits.mjs';

const volts = within({ low: 4.85, high: 5.15, unit: 'V', digits: 2, why: '' });

test('both ends of a range are allowed, nothing beyond them, and no number is a failure', () => {
  for (const [value, verdict] of [[4.85, kPass], [5.15, kPass], [4.84, kFail], [5.16, kFail], [NaN, kFail], [Infinity, kFail], [undefined, kFail]])
    assert.equal(verdictOn(volts, value).verdict, verdict, String(value));
  assert.equal(verdictOn(volts, 5).value, '5.00 V');
  assert.equal(verdictOn(volts, NaN).value, 'no number');
});

test('limits are written as a person reads them', () => {
  assert.equal(volts.text, '4.85 to 5.15 V');
  assert.equal(within({ high: 0, unit: 'frames' }).text, 'at most 0 frames');
  assert.equal(within({ low: 3, unit: 'V' }).text, 'at least 3 V');
  assert.equal(within({ low: -5, high: 5, unit: '%' }).text, '±5 %');
  assert.equal(within({ low: 5, high: 5, unit: 'logs' }).text, '5 logs');
});

test('what else was measured can fail a good value, and is shown', () => {
  assert.deepEqual(verdictOn(volts, { value: 5, ok: false, note: 'ripple' }), { verdict: kFail, value: '5.00 V; ripple' });
  assert.deepEqual(verdictOn(holds('yes', ''), { ok: true, note: 'seen' }), { verdict: kPass, value: 'seen' });
  assert.equal(verdictOn(holds('yes', ''), { ok: false }).verdict, kFail);
  assert.equal(verdictOn(holds('yes', ''), { note: 'nobody looked' }).verdict, kFail);
  assert.equal(verdictOn(equals('0xFF', ''), '0xff').verdict, kPass);
  assert.equal(verdictOn(equals('0xFF', ''), '0xFE').verdict, kFail);
});

test('a step passes when all its parts have, and fails by one', () => {
  const of = (...verdicts) => verdicts.map((verdict) => ({ verdict }));
  assert.equal(verdictOfStep(of(kPass, kPass), 2), kPass);
  assert.equal(verdictOfStep(of(kPass, kNotFitted), 2), kPass);
  assert.equal(verdictOfStep(of(kNotFitted, kNotFitted), 2), kNotDone, 'nothing was measured');
  assert.equal(verdictOfStep(of(kPass), 2), kNotDone, 'interrupted');
  assert.equal(verdictOfStep(of(kPass, kNotDone), 2), kNotDone);
  assert.equal(verdictOfStep(of(kNotDone, kFail), 3), kFail);
});
