// SPDX-License-Identifier: GPL-3.0-or-later
// What a part must come to, and the verdict on what came.
export const kPass = 'pass', kFail = 'fail', kNotDone = 'not done', kNotFitted = 'not fitted';

const shown = (value, digits) => value.toFixed(digits).replace(/^-(0(\.0*)?)$/, '$1');

// `low` to `high`, both allowed; either may be left out. `why`: where the limit comes from.
export function within({ low = -Infinity, high = Infinity, unit, digits = 1, why }) {
  const ends = low === -Infinity ? `at most ${high}` : high === Infinity ? `at least ${low}`
    : low === high ? `${low}` : low === -high ? `±${high}` : `${Number(low.toFixed(2))} to ${Number(high.toFixed(2))}`;
  return {
    text: `${ends} ${unit}`.trim(), why,
    has: (value) => Number.isFinite(value) && value >= low && value <= high,
    show: (value) => (Number.isFinite(value) ? `${shown(value, digits)} ${unit}`.trim() : 'no number'),
  };
}

// A text that must be this one, whatever its case.
export const equals = (wanted, why) => ({
  text: wanted, why, has: (value) => value.toLowerCase() === wanted.toLowerCase(), show: (value) => value,
});

// Something that is so, or is not: the measurement gives { ok, note }.
export const holds = (what, why) => ({ text: what, why, has: (ok) => ok === true, show: (ok) => (ok ? 'yes' : 'no') });

// Of what was measured: a value, or { value, ok, note }, where `ok` false fails it whatever the value.
export function verdictOn(limit, measured) {
  const { value, ok = true, note = '' } = typeof measured === 'object' ? { value: measured.ok, ...measured } : { value: measured };
  return { verdict: ok && limit.has(value) ? kPass : kFail,
    value: [typeof value === 'boolean' && note ? '' : limit.show(value), note].filter(Boolean).join('; ') };
}

// Of a step: one failed part fails it; it passes when every part has, but for what is not fitted.
export function verdictOfStep(parts, count) {
  if (parts.some(({ verdict }) => verdict === kFail)) return kFail;
  const done = parts.filter(({ verdict }) => verdict === kPass || verdict === kNotFitted);
  if (done.length < count || !parts.some(({ verdict }) => verdict === kPass)) return kNotDone;
  return kPass;
}
