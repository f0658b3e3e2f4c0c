// SPDX-License-Identifier: GPL-3.0-or-later
// An independent reader of ArduPilot's self-describing logs, as strict as a reader can be: every
// byte belongs to a record, and every record to a format before it.
import assert from 'node:assert/strict';

const read = {
  b: [1, (view, at) => view.getInt8(at)],
  B: [1, (view, at) => view.getUint8(at)],
  M: [1, (view, at) => view.getUint8(at)],
  h: [2, (view, at) => view.getInt16(at, true)],
  H: [2, (view, at) => view.getUint16(at, true)],
  c: [2, (view, at) => view.getInt16(at, true) / 100],
  C: [2, (view, at) => view.getUint16(at, true) / 100],
  i: [4, (view, at) => view.getInt32(at, true)],
  I: [4, (view, at) => view.getUint32(at, true)],
  e: [4, (view, at) => view.getInt32(at, true) / 100],
  E: [4, (view, at) => view.getUint32(at, true) / 100],
  L: [4, (view, at) => view.getInt32(at, true) * 1e-7],
  f: [4, (view, at) => view.getFloat32(at, true)],
  d: [8, (view, at) => view.getFloat64(at, true)],
  q: [8, (view, at) => Number(view.getBigInt64(at, true))],
  Q: [8, (view, at) => Number(view.getBigUint64(at, true))],
  n: [4, text(4)],
  N: [16, text(16)],
  Z: [64, text(64)],
};

function text(size) {
  return (view, at) => {
    let letters = '';
    for (let i = 0; i < size && view.getUint8(at + i) !== 0; ++i) letters += String.fromCharCode(view.getUint8(at + i));
    return letters;
  };
}

// The records in their order: {name, ...fields}.
export function readLog(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const formats = new Map([[128, { name: 'FMT', length: 89, fields: 'BBnNZ', labels: ['Type', 'Length', 'Name', 'Format', 'Columns'] }]]);
  const records = [];
  for (let at = 0; at < bytes.length;) {
    assert.equal(view.getUint16(at), 0xa395, `no record begins at byte ${at}`);
    const format = formats.get(bytes[at + 2]);
    assert.ok(format, `type ${bytes[at + 2]} at byte ${at} has no format`);
    assert.ok(at + format.length <= bytes.length, `${format.name} at byte ${at} is cut off`);
    const record = { name: format.name };
    let field = at + 3;
    for (const [i, letter] of [...format.fields].entries()) {
      const [size, value] = read[letter];
      record[format.labels[i]] = value(view, field);
      field += size;
    }
    assert.equal(field - at, format.length, `${format.name} has another length than its fields`);
    if (format.name === 'FMT') {
      const labels = record.Columns.split(',');
      assert.equal(labels.length, record.Format.length, record.Name);
      formats.set(record.Type, { name: record.Name, length: record.Length, fields: record.Format, labels });
    }
    records.push(record);
    at += format.length;
  }
  return records;
}

export const named = (records, name) => records.filter((record) => record.name === name);
