// SPDX-License-Identifier: GPL-3.0-or-later
// The order of functions in flash: on layouts whose best one is known, and on a program that is
// linked, placed and linked again.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { readElf } from '../../../../toolchain/image/elf.mjs';
import { placed } from '../../../../toolchain/image/placement.mjs';

const kTool = fileURLToPath(new URL('../../../../toolchain/image/link_script.mjs', import.meta.url));
const kSteps = 20_000;

// Sections of so many bytes, one behind the other from `begin` on.
function row(begin, sizes, more = () => ({})) {
  let address = begin;
  return sizes.map((size, i) => {
    const section = { address, size, isMoved: true, isPointedAt: false, ...more(i) };
    address += size;
    return section;
  });
}
const call = (from, to, fromAt = 0) => ({ from, fromAt, to, toAt: 0 });
const inOrder = (count) => [...Array(count).keys()];

test('a caller and what it calls are brought together', () => {
  const sections = row(0x4000, [100, 6000, 6000, 100]);
  const { order, farCalls } = placed(sections, [call(0, 3), call(0, 3, 50)], kSteps);

  assert.equal(farCalls, 0);
  assert.equal(Math.abs(order.indexOf(0) - order.indexOf(3)), 1);
});

test('every section is placed once', () => {
  const sizes = inOrder(40).map((i) => 100 + 37 * i);
  const calls = inOrder(40).map((i) => call(i, (i * 7 + 3) % 40));
  const { order } = placed(row(0, sizes), calls, kSteps);

  assert.deepEqual([...order].sort((a, b) => a - b), inOrder(40));
});

test('the same sections give the same order', () => {
  const sizes = inOrder(40).map((i) => 100 + 137 * i);
  const calls = inOrder(80).map((i) => call(i % 40, (i * 11 + 5) % 40));

  assert.deepEqual(placed(row(0, sizes), calls, kSteps), placed(row(0, sizes), calls, kSteps));
});

test('what the moves have saved one by one is what the order saves as a whole', () => {
  const pointed = (i) => ({ isPointedAt: i % 3 === 0 });
  const sections = row(0x1c000, inOrder(60).map((i) => 100 + 73 * i), pointed);
  const calls = inOrder(240).map((i) => call(i % 60, (i * 17 + 7) % 60, i % 90)).filter(({ from, to }) => from !== to);
  const [before, after] = [0, kSteps].map((steps) => placed(sections, calls, steps));
  const cost = ({ farCalls, trampolines }) => 2 * farCalls + 4 * trampolines;

  assert.ok(after.saved > 0);
  assert.equal(after.saved, cost(before) - cost(after));
});

test('what is not moved stays, and callers come near it', () => {
  const vectors = { address: 0, size: 200, isMoved: false, isPointedAt: false };
  const { order, farCalls } = placed([vectors, ...row(200, [5000, 5000, 80])], [call(0, 3)], kSteps);

  assert.equal(farCalls, 0);
  assert.equal(order[0], 3);
});

test('the reach of a short call is 4096 bytes back and 4094 on, from behind it', () => {
  const isMoved = (i) => ({ isMoved: i === 1 });
  const farCalls = (gap, from, to, fromAt, toAt) =>
    placed(row(0, [100, 10, gap, 100], isMoved), [{ from, fromAt, to, toAt }], 0).farCalls;

  assert.equal(farCalls(4000, 0, 3, 16, 16 + 2 + 4094 - 4110), 0);
  assert.equal(farCalls(4000, 0, 3, 16, 16 + 2 + 4094 - 4110 + 2), 1);
  assert.equal(farCalls(4000, 3, 0, 0, 4110 + 2 - 4096), 0);
  assert.equal(farCalls(4000, 3, 0, 0, 4110 + 2 - 4096 - 2), 1);
});

test('functions that are pointed at come into the lower 128 KiB', () => {
  const sections = row(0, [0x12000, 0x12000, 500, 500], (i) => ({ isPointedAt: i >= 2 }));
  const before = placed(sections, [call(0, 1)], 0), after = placed(sections, [call(0, 1)], kSteps);

  assert.equal(before.trampolines, 2);
  assert.equal(after.trampolines, 0);
});

// Four callers of one function, each behind 8 KiB that none of them calls.
const kProgram = `
  #include <avr/io.h>
  #define FAR(n) \\
    extern "C" __attribute__((naked, noinline, used)) void filler##n() { asm(".fill 4096, 2, 0\\n ret"); } \\
    extern "C" __attribute__((naked, noinline, used)) void caller##n() { asm("call leaf\\n call leaf\\n ret"); }
  extern "C" __attribute__((naked, noinline, used)) void leaf() { asm("ret"); }
  FAR(1) FAR(2) FAR(3) FAR(4)
  int main() { asm("call caller1\\n call caller2\\n call caller3\\n call caller4"
                   "\\n call filler1\\n call filler2\\n call filler3\\n call filler4"); }`;

function link(folder, name, ...options) {
  const path = join(folder, name);
  execFileSync('avr-g++', ['-mmcu=atmega2560', '-Os', '-mrelax', '-ffunction-sections', '-Wl,--emit-relocs',
    `-Wl,-Map=${path}.map`, ...options, '-x', 'c++', '-', '-o', `${path}.elf`], { input: kProgram });
  return readElf(`${path}.elf`);
}
const place = (...args) => spawnSync('node', [kTool, ...args], { encoding: 'utf8' });

test('an image that is linked again by the script has the same functions and short calls', () => {
  const folder = mkdtempSync(join(tmpdir(), 'placement-'));
  const before = link(folder, 'before');
  const { stdout, status } = place(join(folder, 'before.elf'), join(folder, 'before.map'), join(folder, 'placed.ld'));
  const after = link(folder, 'after', '-T', join(folder, 'placed.ld'));

  assert.equal(status, 0);
  assert.match(stdout, /^\d+ functions placed: \d+ of \d+ calls are long, 0 trampolines$/m);
  // of eight calls of leaf two were short, of main's eight one
  assert.ok(before.text.length - after.text.length >= 16, `${before.text.length} to ${after.text.length} bytes`);
  const functions = ({ symbols }) => symbols.filter(({ type }) => type === 'function').map(({ name }) => name).sort();
  assert.deepEqual(functions(after), functions(before));
});

test('an image without calls that can be placed is refused', () => {
  const folder = mkdtempSync(join(tmpdir(), 'placement-'));
  execFileSync('avr-g++', ['-mmcu=atmega2560', `-Wl,-Map=${join(folder, 'p.map')}`, '-x', 'c++', '-', '-o', join(folder, 'p.elf')],
    { input: 'int main() {}' });
  const { stderr, status } = place(join(folder, 'p.elf'), join(folder, 'p.map'), join(folder, 'placed.ld'));

  assert.equal(status, 1);
  assert.match(stderr, /link_script: .*link it with --emit-relocs/);
  assert.throws(() => readFileSync(join(folder, 'placed.ld')));
});
