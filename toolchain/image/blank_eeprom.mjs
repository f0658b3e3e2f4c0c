// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the image of an erased EEPROM as Intel hex: flashed, it brings every default back.
//   node toolchain/image/blank_eeprom.mjs FILE.eep
import { writeFileSync } from 'node:fs';

const size = 4096;
const perLine = 32;

const record = (address, type, bytes) => {
  const fields = [bytes.length, address >> 8, address & 0xff, type, ...bytes];
  const sum = fields.reduce((total, byte) => total + byte, 0);
  return [...fields, -sum & 0xff].map((byte) => byte.toString(16).padStart(2, '0')).join('');
};

const lines = [];
for (let address = 0; address < size; address += perLine)
  lines.push(record(address, 0, new Array(perLine).fill(0xff)));
lines.push(record(0, 1, []));
writeFileSync(process.argv[2], lines.map((line) => `:${line.toUpperCase()}\n`).join(''));
