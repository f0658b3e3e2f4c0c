// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of an AVR ELF file that say what is in flash and RAM: sections, symbols, and, when
// it was linked with --emit-relocs, which words are addresses of what.
import { readFileSync } from 'node:fs';

const kSymbolTable = 2, kRelocations = 4;
const kTypes = ['none', 'object', 'function', 'section', 'file'];

const cString = (bytes, at) => bytes.toString('latin1', at, bytes.indexOf(0, at));

function readSections(file) {
  const table = file.readUInt32LE(32), size = file.readUInt16LE(46), count = file.readUInt16LE(48);
  const sections = [];
  for (let i = 0; i < count; i++) {
    const at = table + i * size;
    const [name, type, flags, address, offset, length, link, info] =
      [0, 4, 8, 12, 16, 20, 24, 28].map((field) => file.readUInt32LE(at + field));
    const bytes = type === 8 ? Buffer.alloc(0) : file.subarray(offset, offset + length);
    sections.push({ nameAt: name, type, flags, address, length, link, info, bytes });
  }
  const names = sections[file.readUInt16LE(50)].bytes;
  for (const section of sections) section.name = cString(names, section.nameAt);
  return sections;
}

function readSymbols(sections) {
  const table = sections.find((section) => section.type === kSymbolTable);
  if (!table) return [];
  const names = sections[table.link].bytes, symbols = [];
  for (let at = 0; at < table.length; at += 16) {
    const section = table.bytes.readUInt16LE(at + 14);
    symbols.push({
      name: cString(names, table.bytes.readUInt32LE(at)),
      value: table.bytes.readUInt32LE(at + 4),
      size: table.bytes.readUInt32LE(at + 8),
      type: kTypes[table.bytes[at + 12] & 15] ?? 'other',
      section: sections[section]?.name ?? '',
    });
  }
  return symbols;
}

function readRelocations(sections, symbols) {
  const all = [];
  for (const section of sections) {
    const of = sections[section.info];
    if (section.type !== kRelocations || !(of.flags & 2)) continue;
    for (let at = 0; at < section.length; at += 12) {
      const info = section.bytes.readUInt32LE(at + 4);
      all.push({
        at: section.bytes.readUInt32LE(at),
        type: info & 0xff,
        target: symbols[info >>> 8].value + section.bytes.readInt32LE(at + 8),
      });
    }
  }
  return all.sort((a, b) => a.at - b.at);
}

// Addresses in .data and .bss are the ELF's own, from 0x800000 on.
export function readElf(path) {
  const file = readFileSync(path);
  if (file.length < 52 || file.readUInt32BE(0) !== 0x7f454c46) throw new Error(`${path} is no ELF file`);
  if (file.readUInt16LE(18) !== 83) throw new Error(`${path} is not for an AVR`);
  const sections = readSections(file);
  const symbols = readSymbols(sections);
  const length = (name) => sections.find((section) => section.name === name)?.length ?? 0;
  const bytesOf = (name) => sections.find((section) => section.name === name)?.bytes ?? Buffer.alloc(0);
  return {
    path, sections, symbols, length,
    relocations: readRelocations(sections, symbols),
    text: bytesOf('.text'),
    data: bytesOf('.data'),
    compiler: cString(sections.find((section) => section.name === '.comment')?.bytes ?? Buffer.of(0), 0),
    symbol: (name) => symbols.find((symbol) => symbol.name === name),
  };
}
