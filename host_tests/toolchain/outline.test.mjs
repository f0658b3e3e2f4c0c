// SPDX-License-Identifier: GPL-3.0-or-later
// What stands once instead of often, and what stays where it is.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { pacesIn, outline } from '../../toolchain/outline/outline.mjs';

const kNone = () => '';
const kFour = ['ldd r18,Z+8', 'ldd r19,Z+9', 'ldd r20,Z+10', 'ldd r21,Z+11'];
const code = (name, ...steps) => [`\t.section\t.text.${name},"ax",@progbits`, `${name}:`, ...steps.map((step) => (step.endsWith(':') ? step : `\t${step}`)),
  `\t.size\t${name}, .-${name}`];
const functions = (count, steps) => Array.from({ length: count }, (_, i) => code(`f${i}`, ...steps(i))).flat().join('\n');
// { f0: [...], __fragment_0: [...] }
function bodies(text) {
  const found = {};
  let name;
  for (const line of text.split('\n')) {
    name = /^([A-Za-z_]\w*):/.exec(line)?.[1] ?? name;
    if (/^\t[a-z]/.test(line)) (found[name] ??= []).push(line.trim());
  }
  return found;
}
const outlined = (text, paceOf = kNone) => bodies(outline(text, paceOf));

test('a run that occurs again stands once and goes back', () => {
  const all = outlined(functions(4, (i) => [`ldi r24,${i}`, ...kFour, `ldi r25,${i}`, 'rjmp .L9']));

  assert.deepEqual(all.__fragment_0, [...kFour, 'ret']);
  assert.deepEqual(all.f2, ['ldi r24,2', 'call __fragment_0', 'ldi r25,2', 'rjmp .L9']);
});

test('a run that ends with a call goes on there by a jump', () => {
  const all = outlined(functions(5, (i) => [`ldi r24,${i}`, 'movw r18,r22', 'movw r20,r24', 'call __mulsf3', `ldi r25,${i}`, 'rjmp .L9']));

  assert.deepEqual(all.__fragment_0, ['movw r18,r22', 'movw r20,r24', 'jmp __mulsf3']);
  assert.deepEqual(all.f0.slice(1, 2), ['call __fragment_0']);
});

test('an end that occurs again is jumped to', () => {
  const all = outlined(functions(4, (i) => [`ldi r24,${i}`, ...kFour, 'ret']));

  assert.deepEqual(all.f3, ['ldi r24,3', 'jmp __fragment_0']);
});

test('what uses the stack pointer, jumps, or is skipped stays', () => {
  for (const fixed of ['push r18', 'in r28,__SP_L__', 'out __SREG__,r0', 'rcall .', 'breq .L1', 'cli', 'ldi r30,lo8(gs(1f))', 'jmp __tablejump2__']) {
    const all = outlined(functions(6, (i) => [`ldi r24,${i}`, 'ldd r18,Z+8', fixed, 'ldd r19,Z+9', 'rjmp .L9']));
    assert.equal(all.__fragment_0, undefined, fixed);
  }
  const all = outlined(functions(6, (i) => [`ldi r24,${i}`, 'sbrc r24,7', ...kFour, 'rjmp .L9']));
  assert.deepEqual(all.f0.slice(1, 3), ['sbrc r24,7', kFour[0]]);
});

test('what a carry goes through is not torn apart', () => {
  const all = outlined(functions(6, (i) => [`ldi r24,${i}`, 'ldd r18,Z+8', 'ldd r19,Z+9', 'add r18,r22', `adc r19,r${i}`, 'rjmp .L9']));

  assert.ok(all.f0.includes('add r18,r22'), all.f0.join());
});

test('a loop over a few instructions stays', () => {
  const all = outlined(functions(6, () => ['ldi r24,9', '0:', 'ld r0,Z+', 'st X+,r0', 'dec r24', 'brne 0b', 'rjmp .L9']));

  assert.ok(all.f0.includes('ld r0,Z+'), all.f0.join());
});

test('no fragment calls another, so that one return address is enough', () => {
  const all = outlined(functions(30, (i) => [`ldi r24,${i}`, ...(i % 3 ? ['mov r2,r3', 'mov r4,r5'] : []), ...kFour, ...(i % 2 ? ['mov r6,r7', 'mov r8,r9'] : []),
    `ldi r25,${i}`, 'rjmp .L9']));
  const fragments = Object.entries(all).filter(([name]) => name.startsWith('__fragment_'));

  assert.ok(fragments.length > 1);
  for (const [name, body] of fragments) assert.ok(!body.some((step) => step.startsWith('call __fragment')), name);
});

test('what is named keeps its pace, with all that is in it', () => {
  const paceOf = pacesIn('# why\nstays main\nhurries geo\nstays firmware::runMode\n');

  for (const name of ['main', '_ZN3geo6offsetERKNS_8PositionES2_', '_ZNK3geo5Place4moveEv.constprop.3', '_ZN8firmware7runModeEv', '_ZN8firmware12_GLOBAL__N_17runModeEv'])
    assert.equal(paceOf(name), name.includes('3geo') ? 'hurries' : 'stays', name);
  for (const name of ['_ZN8firmware13runModeSwitchEv', '_ZN4geos6offsetEv', '_ZN8firmware3runEv']) assert.equal(paceOf(name), '', name);
  const repeated = (i) => [`ldi r24,${i}`, ...kFour, 'rjmp .L9'];
  const all = outlined(functions(6, repeated), (name) => (name === 'f2' ? 'stays' : ''));
  assert.deepEqual(all.f2, repeated(2));
});

test('what hurries goes to a fragment only to go on from there', () => {
  const all = outlined(functions(6, (i) => [`ldi r24,${i}`, ...kFour, `ldi r25,${i}`, 'movw r18,r22', 'movw r20,r24', 'call __mulsf3', 'rjmp .L9']), () => 'hurries');

  assert.deepEqual(all.f1.slice(1, 5), kFour);
  assert.deepEqual(all.__fragment_0, ['movw r18,r22', 'movw r20,r24', 'jmp __mulsf3']);
});

test('registers are taken back from the stack only by an end that is jumped to', () => {
  const ends = outlined(functions(4, (i) => [`ldi r24,${i}`, 'pop r29', 'pop r28', 'pop r17', 'ret']));
  assert.deepEqual(ends.f1, ['ldi r24,1', 'jmp __fragment_0']);
  assert.deepEqual(ends.__fragment_0, ['pop r29', 'pop r28', 'pop r17', 'ret']);

  const amid = outlined(functions(6, (i) => [`ldi r24,${i}`, ...kFour.slice(0, 3), 'pop r24', 'pop r25', `ldi r26,${i}`, 'rjmp .L9']));
  assert.deepEqual(amid.f1.slice(2, 4), ['pop r24', 'pop r25']);
});

test('several far calls of one place go by a jump near them', () => {
  const filler = (name, words) => code(name, ...Array.from({ length: words }, (_, i) => `cpi r24,${name}${i}`)).join('\n');
  const callers = (name) => code(name, 'ldi r24,1', 'call __mulsf3', 'ldi r24,2', 'call __mulsf3', 'ldi r24,3', 'call __mulsf3', 'rjmp .L9').join('\n');
  const lone = code('lone', 'call __mulsf3', 'rjmp .L9').join('\n');
  const all = outlined([callers('f0'), filler('x', 4000), callers('f1'), filler('y', 4000), lone].join('\n'));

  const jumps = Object.entries(all).filter(([name]) => name.startsWith('__fragment_to_'));
  assert.deepEqual(jumps.map(([, body]) => body), [['jmp __mulsf3'], ['jmp __mulsf3']]);
  assert.equal(all.f0[1], `call ${jumps[0][0]}`);
  assert.equal(all.f1[1], `call ${jumps[1][0]}`);
  assert.equal(all.lone[0], 'call __mulsf3');
});

test('a call that reaches by itself stays', () => {
  const all = outlined([code('f0', 'ldi r24,1', 'call f1', 'ldi r24,2', 'call f1', 'ldi r24,3', 'call f1', 'rjmp .L9'), code('f1', 'inc r24', 'ret')].flat().join('\n'));

  assert.equal(all.f0[1], 'call f1');
});

test('the chip\'s registers are not moved away from each other', () => {
  const all = outlined(functions(6, (i) => [`ldi r24,${i}`, 'sts 96,r18', 'sts 96,r19', 'rjmp .L9']));

  assert.deepEqual(all.f1.slice(1, 3), ['sts 96,r18', 'sts 96,r19']);
});

// What a function with three registers to keep and `frame` bytes on the stack looks like.
const called = (frame, ends, ...body) => ['\t.section\t.text.f,"ax",@progbits', 'f:', `\tldi r26,lo8(${frame})`, '\tldi r27,0', '\tldi r30,lo8(gs(1f))', '\tldi r31,hi8(gs(1f))',
  '\tjmp __prologue_saves__+((18 - 3) * 2)', '1:', ...body.map((step) => `\t${step}`), ...ends.map((step) => `\t${step}`), '\tldi r30, lo8(3)', '\tjmp __epilogue_restores__ + ((18 - 3) * 2)', '\t.size\tf, .-f'].join('\n');
const savingPace = (text) => outlined(text, pacesIn('stays f\nsaves f\n')).f;

test('what saves keeps its registers itself, and Y only where it uses it', () => {
  assert.deepEqual(savingPace(called(0, ['in r28,__SP_L__', 'in r29,__SP_H__'], 'mov r17,r24', 'call g')),
    ['push r17', 'mov r17,r24', 'call g', 'pop r17', 'ret']);
  assert.deepEqual(savingPace(called(0, ['in r28,__SP_L__', 'in r29,__SP_H__'], 'mov r28,r24', 'call g')),
    ['push r17', 'push r28', 'push r29', 'mov r28,r24', 'call g', 'pop r29', 'pop r28', 'pop r17', 'ret']);
});

test('what saves makes its frame and takes it away with interrupts off in between', () => {
  const set = ['in __tmp_reg__,__SREG__', 'cli', 'out __SP_H__,r29', 'out __SREG__,__tmp_reg__', 'out __SP_L__,r28'];

  assert.deepEqual(savingPace(called(12, ['adiw r28,12'], 'std Y+1,r24')),
    ['push r17', 'push r28', 'push r29', 'in r28,__SP_L__', 'in r29,__SP_H__', 'sbiw r28,12', ...set, 'std Y+1,r24', 'adiw r28,12', ...set, 'pop r29', 'pop r28', 'pop r17', 'ret']);
});

test('a frame of another form is left to the library', () => {
  for (const text of [called(64, ['adiw r28,63', 'adiw r28,1'], 'nop'), called(0, [], 'nop'), called(12, ['adiw r28,11'], 'nop')])
    assert.ok(savingPace(text).some((step) => step.startsWith('jmp __prologue_saves__')), text);
});
