// SPDX-License-Identifier: GPL-3.0-or-later
// The stack tool on small programs whose need is known: written in assembler, or counted from
// what avr-gcc is documented to push.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { stackBound } from '../../../../toolchain/image/stack_bound.mjs';

const folder = mkdtempSync(join(tmpdir(), 'stack_bound-'));
const kMain = 3;  // the start-up code's call of main

function compile(source, ...options) {
  const path = join(folder, 'program');
  writeFileSync(`${path}.cpp`, `#include <avr/interrupt.h>\n#include <avr/io.h>\n#include <avr/pgmspace.h>
    #define ASM __attribute__((naked, noinline, used)) void
    #define PLAIN __attribute__((noinline, noclone)) \n${source}`);
  execFileSync('avr-g++', ['-mmcu=atmega2560', '-std=gnu++14', '-Os', ...options,
    '-o', `${path}.elf`, `${path}.cpp`]);
  return `${path}.elf`;
}
const bound = (source, ...options) => stackBound(compile(source, '-Wl,--emit-relocs', ...options));
const chain = (result) => result.main.chain.map((link) => link.function).slice(1);

test('pushes, calls and their return addresses add up along the deepest chain', () => {
  const result = bound(`
    extern "C" ASM leaf() { asm("push r16\\n push r17\\n pop r17\\n pop r16\\n ret"); }
    extern "C" ASM shallow() { asm("ret"); }
    extern "C" ASM middle() { asm("push r2\\n call shallow\\n call leaf\\n pop r2\\n ret"); }
    __attribute__((naked)) int main() { asm("call shallow\\n call middle\\n rjmp .-2"); }`);

  assert.equal(result.bytes, kMain + 3 + 1 + 3 + 2);
  assert.deepEqual(chain(result), ['main', 'middle', 'leaf']);
});

test('a jump at the end of a function needs no return address of its own', () => {
  const result = bound(`
    extern "C" ASM leaf() { asm("push r16\\n pop r16\\n ret"); }
    extern "C" ASM middle() { asm("push r2\\n pop r2\\n jmp leaf"); }
    __attribute__((naked)) int main() { asm("call middle\\n rjmp .-2"); }`);

  assert.equal(result.bytes, kMain + 3 + 1);
});

test('a function that ends by jumping to another one does not share its frame', () => {
  const framed = (name, size, end) => `extern "C" ASM ${name}() {
    asm("ldi r26, ${size}\\n ldi r27, 0\\n ldi r30, pm_lo8(1f)\\n ldi r31, pm_hi8(1f)\\n jmp __room\\n"
        "1: adiw r28, ${size}\\n out 0x3e, r29\\n out 0x3d, r28\\n ${end}"); }`;
  const result = bound(`
    extern "C" ASM __room() {  // as the compiler's own helper
      asm("in r28, 0x3d\\n in r29, 0x3e\\n sub r28, r26\\n sbc r29, r27\\n out 0x3e, r29\\n out 0x3d, r28\\n ijmp"); }
    ${framed('second', 5, 'ret')}
    ${framed('first', 16, 'jmp second')}
    __attribute__((naked)) int main() { asm("call first\\n rjmp .-2"); }`);

  assert.equal(result.bytes, kMain + 3 + 16);
});

test('room made by moving the stack pointer counts', () => {
  const frame = (size) => bound(`
    PLAIN void work() { volatile uint8_t frame[${size}]; frame[0] = 1; frame[${size} - 1] = 2; }
    __attribute__((naked)) int main() { work(); for (;;) {} }`).bytes;
  const saved = 2;  // Y

  assert.equal(frame(40), kMain + 3 + saved + 40);
  assert.equal(frame(300), kMain + 3 + saved + 300);
});

test('room made by pushes and by calls of the next instruction counts', () => {
  for (const size of [1, 2, 3, 4, 5]) {
    const result = bound(`
      PLAIN void work() { volatile uint8_t frame[${size}]; for (auto& byte : frame) byte = 1; }
      __attribute__((naked)) int main() { work(); for (;;) {} }`);
    assert.equal(result.bytes, kMain + 3 + 2 + size, `${size} bytes`);
  }
});

test('the library\'s shared prologue and epilogue are seen through', () => {
  const source = `
    volatile uint8_t in;
    extern "C" ASM leaf() { asm("ret"); }
    PLAIN uint32_t work(uint32_t a, uint32_t b, uint32_t c) {
      volatile uint8_t frame[20];
      frame[3] = in;
      leaf();
      frame[7] = in;
      leaf();
      return a + b * c + frame[3] + frame[7];
    }
    __attribute__((naked)) int main() { in = static_cast<uint8_t>(work(1, 2, 3)); for (;;) {} }`;
  const inline = bound(source), shared = bound(source, '-mcall-prologues', '-mrelax');

  const call = 3, saved = 14;  // r4..r15 or as many for three 32-bit numbers, and Y
  assert.ok(inline.bytes >= kMain + 3 + saved + 20 + call);
  assert.equal(shared.bytes, inline.bytes);
});

test('a call through a table goes to its deepest function and to no other table\'s', () => {
  const result = bound(`
    extern "C" {
    ASM small() { asm("push r2\\n pop r2\\n ret"); }
    ASM large() { asm("push r2\\n push r3\\n push r4\\n pop r4\\n pop r3\\n pop r2\\n ret"); }
    ASM huge() { asm("push r2\\n push r2\\n push r2\\n push r2\\n push r2\\n push r2\\n push r2\\n push r2\\n"
                     "pop r2\\n pop r2\\n pop r2\\n pop r2\\n pop r2\\n pop r2\\n pop r2\\n pop r2\\n ret"); }
    }
    struct Row { uint8_t id; void (*run)(); };
    const Row kRows[] PROGMEM = {{1, small}, {2, large}};
    const Row kOther[] PROGMEM = {{1, huge}};
    volatile uint8_t i;
    volatile uint16_t sink;
    __attribute__((OS_main)) int main() {
      for (;;) reinterpret_cast<void (*)()>(pgm_read_word(&kRows[i].run))();
    }
    __attribute__((used)) void* other() { return const_cast<Row*>(&kOther[i]); }`);

  assert.equal(result.bytes, kMain + 3 + 3);
  assert.deepEqual(chain(result), ['main', 'large']);
  assert.equal(result.unresolved, 0);
});

test('a table is found through the pointer in RAM that leads to it', () => {
  const result = bound(`
    extern "C" ASM large() { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n ret"); }
    typedef void (*Run)();
    const Run kRows[] PROGMEM = {large};
    const Run* volatile table = kRows;
    __attribute__((OS_main)) int main() { for (;;) reinterpret_cast<Run>(pgm_read_word(table))(); }`);

  assert.equal(result.bytes, kMain + 3 + 2);
  assert.equal(result.unresolved, 0);
});

test('a row copied from flash into a frame and handed on still leads to its table', () => {
  const result = bound(`
    #include <string.h>
    extern "C" ASM large() { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n ret"); }
    extern "C" ASM huge() { asm("push r2\\n push r3\\n push r4\\n pop r4\\n pop r3\\n pop r2\\n ret"); }
    struct Row { void (*run)(); void (*other)(); uint8_t a, b, c; };
    const Row kRows[] PROGMEM = {{large, huge, 1, 2, 3}, {large, huge, 1, 2, 3}, {large, huge, 4, 5, 6}};
    PLAIN void run(const Row& row) { row.run(); PORTA = row.a; }
    __attribute__((OS_main)) int main() {
      for (uint8_t i = 0;; i = PINA % 3) {
        Row row;
        memcpy_P(&row, &kRows[i], sizeof row);
        run(row);
      }
    }`);

  assert.equal(result.unresolved, 0);
  assert.deepEqual(result.indirect[0].targets, ['large']);
});

test('a function given as an argument is looked for in the callers', () => {
  const result = bound(`
    extern "C" ASM asked() { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n ret"); }
    extern "C" ASM hand() { asm("movw r30, r24\\n eicall\\n ret"); }
    extern "C" ASM other() { asm("ldi r24, pm_lo8(asked)\\n ldi r25, pm_hi8(asked)\\n call hand\\n ret"); }
    __attribute__((naked)) int main() { asm("call other\\n rjmp .-2"); }`);

  assert.equal(result.bytes, kMain + 3 + 3 + 3 + 2);
  assert.equal(result.unresolved, 0);
});

test('a pointer that nobody explains is counted and gets the deepest of all', () => {
  const result = bound(`
    extern "C" ASM deep() { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n ret"); }
    void (*volatile held)();
    ISR(INT0_vect) { held = deep; }
    __attribute__((OS_main)) int main() { for (;;) held(); }`);

  assert.equal(result.unresolved, 1);
  assert.equal(result.main.bytes, kMain + 3 + 2);
});

test('a switch through a jump table is followed', () => {
  const cases = [...Array(12).keys()].map((i) => `case ${i}: ${i === 7 ? 'deep();' : `PORTA = ${i * 7 % 5};`} break;`);
  const result = bound(`
    extern "C" ASM deep() { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n ret"); }
    PLAIN void choose(uint8_t i) { switch (i) { ${cases.join(' ')} } }
    __attribute__((OS_main)) int main() { for (;;) choose(PINA); }`, '-fno-tree-switch-conversion');

  assert.equal(result.main.chain.at(-1).function, 'deep');
});

// The library's routines have parts without a name, which the linker may put there.
test('a jump to what lies behind the jump through tables is no jump through one', () => {
  const result = bound(`
    extern "C" ASM __tablejump2__() { asm("eijmp\\n push r16\\n pop r16\\n ret"); }
    extern "C" ASM library() { asm("jmp __tablejump2__ + 2"); }
    __attribute__((naked)) int main() { asm("call library\\n rjmp .-2"); }`);

  assert.equal(result.bytes, kMain + 3 + 1);
});

test('the deepest interrupt is added once, return address and all', () => {
  const result = bound(`
    ISR(INT0_vect, ISR_NAKED) { asm("push r2\\n pop r2\\n reti"); }
    ISR(INT1_vect, ISR_NAKED) { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n reti"); }
    __attribute__((naked)) int main() { asm("rjmp .-2"); }`);

  assert.equal(result.interrupts.bytes, 3 + 2);
  assert.equal(result.bytes, kMain + 3 + 2);
  assert.equal(result.interrupts.nested, 0);
});

test('an interrupt that lets others in is added to the deepest of them', () => {
  const result = bound(`
    ISR(INT0_vect, ISR_NAKED) { asm("sei\\n push r2\\n pop r2\\n reti"); }
    ISR(INT1_vect, ISR_NAKED) { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n reti"); }
    __attribute__((naked)) int main() { asm("rjmp .-2"); }`);

  assert.equal(result.interrupts.bytes, 3 + 1 + 3 + 2);
  assert.equal(result.interrupts.nested, 1);
});

test('recursion fails and shows the cycle', () => {
  const program = `
    extern "C" { void second();
    ASM first() { asm("call second\\n ret"); }
    ASM second() { asm("call first\\n ret"); } }
    __attribute__((naked)) int main() { asm("call first\\n rjmp .-2"); }`;

  assert.throws(() => bound(program), /recursion: first > second > first/);
});

test('recursion through a table fails too', () => {
  const program = `
    typedef void (*Run)();
    PLAIN void again();
    extern const Run kRows[1] PROGMEM;
    volatile uint8_t i;
    PLAIN void again() { reinterpret_cast<Run>(pgm_read_word(&kRows[i]))(); PORTA = 1; }
    const Run kRows[1] PROGMEM = {again};
    __attribute__((OS_main)) int main() { again(); for (;;) {} }`;

  assert.throws(() => bound(program), /recursion: again > again/);
});

test('a table reaches functions above 128 KiB by way of the linker\'s trampolines', () => {
  const result = bound(`
    typedef void (*Run)();
    extern "C" __attribute__((section(".text.far"))) ASM farAway() { asm("push r2\\n push r3\\n pop r3\\n pop r2\\n ret\\n"); }
    const Run kRows[] PROGMEM = {farAway};
    extern "C" ASM filler() { asm(".fill 0x10000, 2, 0x9508"); }
    volatile uint8_t i;
    __attribute__((OS_main)) int main() {
      reinterpret_cast<Run>(pgm_read_word(&kRows[i]))();
      for (;;) {}
    }`);

  assert.ok(result.indirect[0].resolved);
  assert.equal(result.bytes, kMain + 3 + 2);
});

test('a stack that grows in a loop fails', () => {
  assert.throws(() => bound(`
    __attribute__((naked)) int main() { asm("1: push r2\\n rjmp 1b"); }`), /grows in a loop/);
});

test('nothing is counted behind a call that never returns', () => {
  const result = bound(`
    extern "C" ASM never() { asm("rjmp .-2"); }
    extern "C" ASM last() { asm("call never\\n push r2\\n push r2\\n push r2\\n push r2\\n ret"); }
    __attribute__((naked)) int main() { asm("call last\\n rjmp .-2"); }`);

  assert.equal(result.bytes, kMain + 3 + 3);
});

test('a file without relocations is refused', () => {
  const path = compile('int main() { for (;;) {} }');

  assert.throws(() => stackBound(path), /no relocations/);
});
