// SPDX-License-Identifier: GPL-3.0-or-later
// The files that are to be written: how far they reach, whether they are whole, whether they fit.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';

import { kBootloader, kEepromSize } from './boards.mjs';
import { Refusal } from './refusal.mjs';

const kData = 0, kEnd = 1, kSegment = 2, kLinear = 4;
const hex = (number) => `0x${number.toString(16)}`;

function bytesOfLine(line, place) {
  if (!/^:([0-9a-fA-F]{2}){5,}$/.test(line)) throw new Refusal(`${place}: no line of Intel hex`);
  const bytes = Buffer.from(line.slice(1), 'hex');
  if (bytes.length !== bytes[0] + 5) throw new Refusal(`${place}: the length is wrong`);
  if (bytes.reduce((sum, byte) => sum + byte, 0) % 256 !== 0)
    throw new Refusal(`${place}: the checksum is wrong`);
  return bytes;
}

// Where the contents of an Intel hex file begin and end, and how many bytes there are.
export function reachOfHex(text, name) {
  let base = 0, begin = Infinity, end = 0, bytes = 0;
  const lines = text.trimEnd().split(/\r?\n/);
  for (const [index, line] of lines.entries()) {
    const record = bytesOfLine(line, `${name}:${index + 1}`);
    const type = record[3];
    if (type === kEnd) return { begin, end, bytes };
    if (type === kSegment) base = record.readUInt16BE(4) * 16;
    if (type === kLinear) base = record.readUInt16BE(4) * 65536;
    if (type !== kData || record[0] === 0) continue;
    const at = base + record.readUInt16BE(1);
    begin = Math.min(begin, at);
    end = Math.max(end, at + record[0]);
    bytes += record[0];
  }
  throw new Refusal(`${name}: the file ends without its end record, a part of it is missing`);
}

function read(path) {
  try {
    return readFileSync(path);
  } catch (error) {
    throw new Refusal(error.code === 'ENOENT' ? `there is no file ${path}`
                                              : `${path} cannot be read: ${error.code}`);
  }
}

export function checkImage(path) {
  const reach = reachOfHex(read(path).toString('latin1'), basename(path));
  if (reach.bytes === 0) throw new Refusal(`${path} is empty`);
  if (reach.end > kBootloader)
    throw new Refusal(`${path} does not fit: it ends at ${hex(reach.end)}, ` +
                      `${reach.end - kBootloader} bytes inside the bootloader at ${hex(kBootloader)}`);
  if (reach.begin !== 0)
    throw new Refusal(`${path} is no image of the firmware: it begins at ${hex(reach.begin)}`);
  return reach;
}

// avrdude's letter for the file's form is part of the answer.
export function checkEeprom(path) {
  const raw = path.endsWith('.bin');
  if (!raw && !/\.(eep|hex)$/.test(path))
    throw new Refusal(`${path}: an EEPROM image ends in .eep or .hex (Intel hex) or .bin (raw)`);
  const contents = read(path);
  const reach = raw ? { end: contents.length, bytes: contents.length }
                    : reachOfHex(contents.toString('latin1'), basename(path));
  if (reach.bytes === 0) throw new Refusal(`${path} is empty`);
  if (reach.end > kEepromSize)
    throw new Refusal(`${path} does not fit: it ends at byte ${reach.end} of ${kEepromSize}`);
  return { ...reach, form: raw ? 'r' : 'i' };
}
