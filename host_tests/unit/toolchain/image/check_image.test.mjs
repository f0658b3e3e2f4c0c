// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { checkImage } from '../../../../toolchain/image/check_image.mjs';

const folder = mkdtempSync(join(tmpdir(), 'check_image-'));
const plenty = { flash: 250000, ram_static: 4000, stack: 1000, ram_static_and_stack: 5000 };

function compile(source) {
  const path = join(folder, 'program');
  writeFileSync(`${path}.cpp`, `#include <avr/io.h>\n#include <avr/pgmspace.h>\n${source}`);
  execFileSync('avr-g++', ['-mmcu=atmega2560', '-Os', '-Wl,--emit-relocs', '-o', `${path}.elf`, `${path}.cpp`]);
  return `${path}.elf`;
}
const plain = 'char ram[100]; int main() { for (;;) ram[PINA % 100] = 1; }';

test('an image within its budgets has a line for each memory and no fault', () => {
  const { lines, faults } = checkImage(compile(plain), plenty);

  assert.deepEqual(faults, []);
  assert.deepEqual(lines.map((line) => line.slice(0, 11).trim()), ['flash', 'ram', 'stack', 'ram + stack']);
  assert.match(lines[1], /ram +100 of +4000/);
});

test('each memory past its budget is a fault that says by how much', () => {
  const { faults } = checkImage(compile(plain), { flash: 100, ram_static: 90, stack: 1, ram_static_and_stack: 91 });

  assert.equal(faults.length, 4);
  assert.match(faults[1], /ram: 100 bytes are 10 past the budget of 90/);
});

test('a global object with a constructor is a fault', () => {
  const { faults } = checkImage(compile(
    'struct A { volatile char x; A() : x(PINA) {} } a; int main() { for (;;) {} }'), plenty);

  assert.match(faults.join('\n'), /constructed at start-up/);
});

test('three exclamation marks are a fault on a board whose loader may have a monitor', () => {
  const path = compile('volatile char ram[] = "never!!!"; int main() { for (;;) PORTA = ram[PINA]; }');

  assert.match(checkImage(path, { ...plenty, loader_monitor: true }).faults.join('\n'), /'!!!' at 0x/);
  assert.deepEqual(checkImage(path, plenty).faults, []);
  assert.deepEqual(checkImage(compile(plain), { ...plenty, loader_monitor: true }).faults, []);
});

test('tables past 64 KiB are a fault', () => {
  const { faults } = checkImage(compile(
    `const char a[32700] PROGMEM = {1}; const char b[32700] PROGMEM = {1}; const char c[300] PROGMEM = {1};
     int main() { for (;;) PORTA = pgm_read_byte(&a[PINA]) + pgm_read_byte(&b[PINA]) + pgm_read_byte(&c[PINA]); }`), plenty);

  assert.match(faults.join('\n'), /past 64 KiB/);
});

test('an image that reaches the bootloader is a fault', () => {
  const blocks = [...Array(8).keys()].map((i) => `const char a${i}[32000] PROGMEM = {1};`).join('\n');
  const uses = [...Array(8).keys()].map((i) => `pgm_read_byte(&a${i}[PINA])`).join(' + ');
  const { faults } = checkImage(compile(`${blocks} int main() { for (;;) PORTA = ${uses}; }`), plenty);

  assert.match(faults.join('\n'), /bootloader/);
});

// The same image as another compiler's.
function byAnotherCompiler(path) {
  const bytes = readFileSync(path);
  bytes.write('9', bytes.indexOf('GCC: (GNU) 5.4.0') + 'GCC: (GNU) '.length);
  writeFileSync(path, bytes);
  return path;
}

test('the budgets of an image by another compiler are notes, what cannot run stays a fault', () => {
  const tight = { flash: 100, ram_static: 90, stack: 1, ram_static_and_stack: 91 };
  const { faults, notes } = checkImage(byAnotherCompiler(compile(plain)), tight);

  assert.deepEqual(faults, []);
  assert.match(notes[0], /compiled by GCC: \(GNU\) 9.4.0; the budgets are of GCC: \(GNU\) 5.4.0/);
  assert.equal(notes.length, 5);
});

test('a stack that cannot be followed is a fault', () => {
  const { faults } = checkImage(compile(
    '__attribute__((noinline)) int down(int x) { const int y = PINA; return x > 3 ? y + down(x - y) * down(x - 2) : y; } '
    + 'int main() { for (;;) PORTA = down(PINA); }'), plenty);

  assert.match(faults.join('\n'), /stack: recursion: down/);
});
