// SPDX-License-Identifier: GPL-3.0-or-later
// The linker script with which an image is linked again, its functions in the order that makes its
// calls short (placement.mjs):
//   node toolchain/image/link_script.mjs LINKED.elf LINKED.map SCRIPT.ld
// LINKED is the same image, linked with --emit-relocs by the linker's own script, of which SCRIPT
// is a copy with the functions' sections named one by one. A section that SCRIPT does not name, or
// names in vain, does no harm.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';

import { readElf } from './elf.mjs';
import { placed } from './placement.mjs';

const kSteps = 4_500_000;
const kCall = 18, kShortCall = 3;                        // R_AVR_CALL, R_AVR_13_PCREL
const kPointers = new Set([5, 24, 25]);                  // R_AVR_16_PM, R_AVR_LO8_LDI_GS, R_AVR_HI8_LDI_GS
const kRest = '    *(.text)\n';
const kSection = /^ (\.\S+)\s+0x([0-9a-f]+)\s+0x([0-9a-f]+) (\S+)$/;

// The linker's map has a line for each section of each file; a long name stands on a line before.
function readMap(path) {
  const text = readFileSync(path, 'utf8').replace(/^( \.\S+)\n\s+/gm, '$1 ');
  const map = text.slice(text.indexOf('Linker script and memory map'));
  const sections = [];
  for (const line of map.split('\n')) {
    const [, name, address, size, file] = kSection.exec(line) ?? [];
    if (name && Number.parseInt(size, 16) > 0) {
      sections.push({ name, file, address: Number.parseInt(address, 16), size: Number.parseInt(size, 16) });
    }
  }
  return sections;
}

// The section that an address is in, by its index.
function finder(sections) {
  const starts = sections.map(({ address }) => address);
  return (address) => {
    let low = 0, high = starts.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (starts[middle] <= address) low = middle + 1;
      else high = middle;
    }
    const i = low - 1;
    return i >= 0 && address < starts[i] + sections[i].size ? i : undefined;
  };
}

function callsBetween(relocations, sections, sectionAt) {
  const calls = [];
  for (const { at, type, target } of relocations) {
    if (type !== kCall && type !== kShortCall) continue;
    const from = sectionAt(at), to = sectionAt(target);
    if (from === undefined || to === undefined || from === to) continue;
    calls.push({ from, fromAt: at - sections[from].address, to, toAt: target - sections[to].address });
  }
  return calls;
}

// The linker's pattern for a section. In libraries many have the same name; otherwise the name is
// enough, and the file may be a temporary one of link-time optimisation.
function pattern({ name, file }, sections) {
  if (sections.filter((other) => other.name === name).length === 1) return `*(${name})`;
  const [, archive, member] = /([^/]+\.a)\((.+)\)$/.exec(file) ?? [];
  return archive ? `*${archive}:${member}(${name})` : `*${file.split('/').at(-1)}(${name})`;
}

function script(patterns) {
  const verbose = execFileSync('avr-ld', ['-m', 'avr6', '--verbose'], { encoding: 'utf8' });
  const whole = verbose.split(/^=+$/m)[1];
  if (!whole?.includes(kRest)) throw new Error('the script of avr-ld has no line *(.text)');
  return whole.replace(kRest, patterns.map((line) => `    ${line}\n`).join('') + kRest);
}

// What placed() is to know, of an image and its linker's map.
function sectionsOf(elf, mapPath) {
  const sections = readMap(mapPath).filter(({ address }) => address < elf.text.length).sort((a, b) => a.address - b.address);
  const sectionAt = finder(sections);
  for (const section of sections) section.isMoved = section.name.startsWith('.text.');
  for (const { type, target } of elf.relocations) {
    const i = kPointers.has(type) ? sectionAt(target) : undefined;
    if (i !== undefined) sections[i].isPointedAt = true;
  }
  return { sections, calls: callsBetween(elf.relocations, sections, sectionAt) };
}

function run([elfPath, mapPath, out]) {
  if (!out) throw new Error('usage: link_script.mjs LINKED.elf LINKED.map SCRIPT.ld');
  const { sections, calls } = sectionsOf(readElf(elfPath), mapPath);
  if (!sections.some(({ isMoved }) => isMoved) || calls.length === 0) throw new Error(`${elfPath} has no calls between sections .text.*: link it with --emit-relocs`);
  const { order, farCalls, trampolines } = placed(sections, calls, kSteps);
  writeFileSync(out, script(order.map((i) => pattern(sections[i], sections))));
  console.log(`${order.length} functions placed: ${farCalls} of ${calls.length} calls are long, ${trampolines} trampolines`);
}

try {
  run(process.argv.slice(2));
} catch (error) {
  console.error(`link_script: ${error.message}`);
  process.exitCode = 1;
}
