// SPDX-License-Identifier: GPL-3.0-or-later
// A log as far as its gaps are concerned: the records' formats are in the log itself (docs/log.md).
const kHead = 0xa395, kFormat = 128, kFormatLength = 89, kFormatFields = 'BBnNZ';
const kSizes = { b: 1, B: 1, M: 1, h: 2, H: 2, c: 2, C: 2, i: 4, I: 4, e: 4, E: 4, L: 4, f: 4, d: 8, q: 8, Q: 8, n: 4, N: 16, Z: 64, a: 64 };

const textAt = (bytes, at, size) => bytes.toString('latin1', at, at + size).replace(/\0.*/s, '');

function formatIn(bytes, at) {
  const fields = textAt(bytes, at + 9, 16), labels = textAt(bytes, at + 25, 64).split(',');
  const offsets = {};
  let offset = 3;
  for (const [i, letter] of [...fields].entries()) {
    offsets[labels[i]] = offset;
    offset += kSizes[letter] ?? NaN;
  }
  return { name: textAt(bytes, at + 5, 4), length: bytes[at + 4], whole: offset === bytes[at + 4], offsets };
}

// { records, bad_at, times_s (of records of `timed`), dropped }. bad_at: the first byte that is none
// of a record, or undefined; a last record that is cut off is no fault.
export function readLog(bytes, timed = 'ATT') {
  const formats = new Map([[kFormat, { name: 'FMT', length: kFormatLength, whole: [...kFormatFields].length === 5, offsets: {} }]]);
  const log = { records: 0, times_s: [], dropped: 0 };
  for (let at = 0; at + 3 <= bytes.length;) {
    const format = bytes.readUInt16BE(at) === kHead ? formats.get(bytes[at + 2]) : undefined;
    if (!format?.whole) return { ...log, bad_at: at };
    if (at + format.length > bytes.length) break;
    if (format.name === 'FMT') formats.set(bytes[at + 3], formatIn(bytes, at));
    if (format.name === timed) log.times_s.push(Number(bytes.readBigUInt64LE(at + format.offsets.TimeUS)) * 1e-6);
    if (format.name === 'PM' && format.offsets.LogDrop !== undefined) log.dropped = Math.max(log.dropped, bytes.readUInt16LE(at + format.offsets.LogDrop));
    ++log.records;
    at += format.length;
  }
  return log;
}

export const longestGap_s = (times_s) => times_s.slice(1).reduce((most, time_s, i) => Math.max(most, time_s - times_s[i]), 0);
