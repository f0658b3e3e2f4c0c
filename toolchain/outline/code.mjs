// SPDX-License-Identifier: GPL-3.0-or-later
// Reads avr-gcc's assembly as a row of steps: instructions that may move to another place, and
// between them what may not (undefined).
const kTwoWords = new Set(['call', 'jmp', 'lds', 'sts']);
const kSkips = new Set(['cpse', 'sbrc', 'sbrs', 'sbic', 'sbis']);
const kTakesCarry = new Set(['adc', 'sbc', 'sbci', 'cpc', 'ror', 'rol']);
// What reads or writes memory, a register or flags, and nothing of where it stands.
const kMovable = new Set(['adc', 'add', 'adiw', 'and', 'andi', 'asr', 'bld', 'bst', 'clr', 'clt', 'com',
  'cp', 'cpc', 'cpi', 'dec', 'eor', 'inc', 'ld', 'ldd', 'ldi', 'lds', 'lsl', 'lsr', 'mov', 'movw', 'mul', 'muls',
  'mulsu', 'neg', 'or', 'ori', 'rol', 'ror', 'sbc', 'sbci', 'sbiw', 'set', 'st', 'std', 'sts', 'sub', 'subi',
  'swap', 'tst', 'call', 'jmp', 'ret', 'pop']);
// The stack pointer, interrupts' state, the chip's registers, some of which count cycles between
// two accesses, and places that are named only within their function.
const kFixed = /__SP_|__SREG__|__tablejump2__|\.L|\b\d+[bf]\b|^(lds \w+,|sts )\d/;

export const kCallBytes = 3.5;  // two, or four where the linker cannot shorten it
export const bytesOfStep = (text) => (kTwoWords.has(/^\w+/.exec(text)[0]) ? 4 : 2);

// A row of { text, bytes, ends: 'call', 'leave' or '', carry, line, inside, pace, isEnd }, undefined
// where nothing may be taken along. What takes back registers, isEnd, does so only on leaving. `paceOf(name)` of a function: 'stays', 'hurries' or ''.
export function readCode(lines, paceOf) {
  const steps = [];
  let inside = '', label = '', blockFrom = 0, pace = 'stays', isSkipped = false, isByHand = false;
  const gap = () => steps.push(undefined);
  const mayMove = (name, text) => (isByHand ? name === 'lpm' : kMovable.has(name)) && pace !== 'stays' && !isSkipped && !kFixed.test(text);
  const begin = (name) => {
    gap();
    [label, blockFrom] = [name, steps.length];
    if (/^[A-Za-z_]/.test(name)) [inside, pace] = [name, paceOf(name)];
  };
  const read = (text, line) => {
    const [name, operands = ''] = text.split(' ');
    if (name.startsWith('br') && [label, `${label}b`].includes(operands)) steps.fill(undefined, blockFrom);  // a short loop stays
    if (!mayMove(name, text)) {
      gap();
    } else {
      const ends = name === 'call' ? 'call' : name === 'jmp' || name === 'ret' ? 'leave' : '';
      steps.push({ text, bytes: bytesOfStep(name), ends, carry: kTakesCarry.has(name), line, inside, pace, isEnd: name === 'pop' });
      if (ends === 'leave') gap();
    }
    isSkipped = kSkips.has(name);
  };
  lines.forEach((line, at) => {
    const text = line.trim().replace(/\s+/g, ' ').replace(/, /g, ',');
    const name = /^([\w$.]+):/.exec(text)?.[1];
    if (text.includes('#APP') || text.includes('#NOAPP')) {
      isByHand = text.includes('#APP');
    } else if (name) {
      begin(name);
    } else if (/^[a-z]/.test(text)) {
      read(text, at);
    } else if (/^\.(section|text|data)/.test(text)) {
      gap();
    }
  });
  return steps;
}
