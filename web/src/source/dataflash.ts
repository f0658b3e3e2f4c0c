// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilot's self-describing logs: records, each of a type whose format a record FMT gives.

export interface Format { name: string; fields: string; labels: string[]; length: number }
export type Fields = Record<string, number | string>;
export interface LogRecord { name: string; fields: Fields }

const kHead = [0xa3, 0x95], kHeadBytes = 3, kFormat = 128;

type Reader = readonly [size: number, read: (bytes: DataView, at: number) => number | string];

const text = (size: number): Reader => [size, (bytes, at) => {
  let letters = '';
  for (let i = 0; i < size; ++i) {
    const code = bytes.getUint8(at + i);
    if (code === 0) break;
    letters += code < 32 || code > 126 ? '?' : String.fromCharCode(code);
  }
  return letters;
}];

const kReaders: Record<string, Reader> = {
  b: [1, (bytes, at) => bytes.getInt8(at)], B: [1, (bytes, at) => bytes.getUint8(at)], M: [1, (bytes, at) => bytes.getUint8(at)],
  h: [2, (bytes, at) => bytes.getInt16(at, true)], H: [2, (bytes, at) => bytes.getUint16(at, true)],
  i: [4, (bytes, at) => bytes.getInt32(at, true)], I: [4, (bytes, at) => bytes.getUint32(at, true)],
  q: [8, (bytes, at) => Number(bytes.getBigInt64(at, true))], Q: [8, (bytes, at) => Number(bytes.getBigUint64(at, true))],
  c: [2, (bytes, at) => bytes.getInt16(at, true) * 0.01], C: [2, (bytes, at) => bytes.getUint16(at, true) * 0.01],
  e: [4, (bytes, at) => bytes.getInt32(at, true) * 0.01], E: [4, (bytes, at) => bytes.getUint32(at, true) * 0.01],
  L: [4, (bytes, at) => bytes.getInt32(at, true) * 1e-7],
  f: [4, (bytes, at) => bytes.getFloat32(at, true)], d: [8, (bytes, at) => bytes.getFloat64(at, true)],
  n: text(4), N: text(16), Z: text(64), a: [64, () => NaN],
};

function lengthOf(fields: string): number {
  let length = kHeadBytes;
  for (const letter of fields) {
    if (!kReaders[letter]) return 0;
    length += kReaders[letter][0];
  }
  return length;
}

export class NoLog extends Error {}

export class DataflashLog {
  readonly records: LogRecord[] = [];
  private readonly formats = new Map<number, Format>([
    [kFormat, { name: 'FMT', fields: 'BBnNZ', labels: ['Type', 'Length', 'Name', 'Format', 'Columns'], length: 89 }],
  ]);

  // What is no record is passed over. Throws NoLog where the first is no format.
  constructor(buffer: ArrayBuffer) {
    const bytes = new DataView(buffer);
    const isHead = (at: number): boolean =>
      at + kHeadBytes <= bytes.byteLength && bytes.getUint8(at) === kHead[0] && bytes.getUint8(at + 1) === kHead[1];
    if (!isHead(0) || bytes.getUint8(2) !== kFormat)
      throw new NoLog('this is no log: it does not begin with a format. Of an image of the DataFlash, toolchain/log extract makes one.');
    for (let at = 0; at < bytes.byteLength;) {
      const format = isHead(at) ? this.formats.get(bytes.getUint8(at + 2)) : undefined;
      if (!format || at + format.length > bytes.byteLength) {
        ++at;
        continue;
      }
      this.records.push(this.read(bytes, at, format));
      at += format.length;
    }
  }
  private read(bytes: DataView, start: number, format: Format): LogRecord {
    const fields: Fields = {};
    let at = start + kHeadBytes;
    for (let i = 0; i < format.fields.length; ++i) {
      const [size, read] = kReaders[format.fields[i]];
      fields[format.labels[i]] = read(bytes, at);
      at += size;
    }
    if (format.name === 'FMT') this.learn(fields);
    return { name: format.name, fields };
  }
  // A format that is repeated changes nothing.
  private learn({ Type, Length, Name, Format, Columns }: Fields): void {
    const format = { name: String(Name), fields: String(Format), labels: String(Columns).split(','), length: Number(Length) };
    if (lengthOf(format.fields) !== format.length || format.labels.length !== format.fields.length) return;
    if (!/^[A-Za-z0-9_]+$/.test(format.name) || this.formats.has(Number(Type))) return;
    this.formats.set(Number(Type), format);
  }
  named(name: string): Fields[] { return this.records.filter((record) => record.name === name).map(({ fields }) => fields); }
}
