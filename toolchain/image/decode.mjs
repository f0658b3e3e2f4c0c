// SPDX-License-Identifier: GPL-3.0-or-later
// AVR machine code, as far as control flow, the stack and the contents of registers go (AVR
// Instruction Set Manual). Addresses are bytes.

const signed = (value, bits) => (value << (32 - bits)) >> (32 - bits);

// kind: what it does; words: its length; d, r: registers; k: constant; to: target;
// writes: registers whose value is lost.
export function decode(text, at) {
  const w = text.readUInt16LE(at);
  const next = at + 2;
  const d5 = (w >> 4) & 31, r5 = (w & 15) | ((w >> 5) & 16), d4 = 16 + ((w >> 4) & 15);
  const k8 = ((w >> 4) & 0xf0) | (w & 15);
  const io = ((w >> 5) & 0x30) | (w & 15);
  const one = (kind, more) => ({ kind, words: 1, at, writes: [], ...more });
  const write = (...registers) => one('other', { writes: registers });
  const far = () => (((w >> 3) & 0x3e) | (w & 1)) * 0x20000 + 2 * text.readUInt16LE(next);

  switch (w >> 12) {
    case 0x0:
      if ((w & 0xff00) === 0x0100) return one('movw', { d: (d5 & 15) * 2, r: (w & 15) * 2 });
      if ((w & 0xfe00) === 0x0200) return write(0, 1);  // multiplications
      if ((w & 0xfc00) === 0x0800) return one('sbc', { d: d5, r: r5 });
      if ((w & 0xfc00) === 0x0c00) return one('add', { d: d5, r: r5 });
      return one('other');
    case 0x1:
      if ((w & 0xfc00) === 0x1000) return one('skip');
      if ((w & 0xfc00) === 0x1800) return one('sub', { d: d5, r: r5 });
      if ((w & 0xfc00) === 0x1c00) return one('adc', { d: d5, r: r5 });
      return one('other');
    case 0x2:
      if ((w & 0xfc00) === 0x2400 && d5 === r5) return one('ldi', { d: d5, k: 0 });
      if ((w & 0xfc00) === 0x2c00) return one('mov', { d: d5, r: r5 });
      return write(d5);
    case 0x3: return one('other');
    case 0x4: return one('sbci', { d: d4, k: k8 });
    case 0x5: return one('subi', { d: d4, k: k8 });
    case 0x6: case 0x7: return write(d4);
    case 0x8: case 0xa: {
      const access = { pointer: w & 8 ? 28 : 30, displacement: (w & 7) | ((w >> 7) & 0x18) | ((w >> 8) & 0x20), d: d5 };
      return w & 0x200 ? one('store', access) : one('load', { ...access, space: 'ram', writes: [d5] });
    }
    case 0x9: return decodeNine(w, { one, write, far, d5, r5, text, next });
    case 0xb: return w & 0x800 ? one('out', { io, r: d5 }) : one('in', { io, d: d5 });
    case 0xc: return one('jump', { to: next + 2 * signed(w & 0xfff, 12) });
    case 0xd: return one('call', { to: next + 2 * signed(w & 0xfff, 12) });
    case 0xe: return one('ldi', { d: d4, k: k8 });
    default:
      if ((w & 0x0800) === 0) return one('branch', { to: next + 2 * signed((w >> 3) & 0x7f, 7) });
      if ((w & 0x0e00) === 0x0800) return write(d5);  // bld
      return (w & 0x0c00) === 0x0c00 ? one('skip') : one('other');
  }
}

// Last four bits of loads and stores: the pointer, what it is moved by before and after.
const kPointers = {
  1: [30, 0, 1], 2: [30, 1, 0], 4: [30, 0, 0], 5: [30, 0, 1], 6: [30, 0, 0], 7: [30, 0, 1],
  9: [28, 0, 1], 10: [28, 1, 0], 12: [26, 0, 0], 13: [26, 0, 1], 14: [26, 1, 0],
};

function decodeNine(w, { one, write, far, d5, r5, text, next }) {
  const low = w & 15;
  if ((w & 0xfc00) === 0x9000) {
    const isStore = (w & 0x200) !== 0;
    if (low === 15) return isStore ? one('push') : one('pop', { d: d5, writes: [d5] });
    const kind = isStore ? 'store' : 'load';
    if (low === 0) return { ...one(kind, { address: text.readUInt16LE(next), d: d5, space: 'ram', writes: isStore ? [] : [d5] }), words: 2 };
    const [pointer, before, after] = kPointers[low] ?? [30, 0, 0];
    const space = low >= 4 && low <= 7 ? 'flash' : 'ram';
    return one(kind, { pointer, before, after, displacement: 0, d: d5, space, writes: isStore ? [] : [d5] });
  }
  if ((w & 0xfe0e) === 0x940c) return { ...one('jump', { to: far() }), words: 2 };
  if ((w & 0xfe0e) === 0x940e) return { ...one('call', { to: far() }), words: 2 };
  const whole = {
    0x9409: 'ijmp', 0x9419: 'ijmp', 0x9509: 'icall', 0x9519: 'icall',
    0x9508: 'ret', 0x9518: 'reti', 0x9478: 'sei',
  }[w];
  if (whole) return one(whole);
  if ((w & 0xff0f) === 0x9508) {  // lpm and elpm to r0, or sleep, wdr, break, spm
    const access = { pointer: 30, before: 0, after: 0, displacement: 0, d: 0, space: 'flash', writes: [0] };
    return (w & 0xef) === 0xc8 ? one('load', access) : one('other');
  }
  if ((w & 0xfe00) === 0x9400) {
    if (low === 3 || low === 10) return one(low === 3 ? 'inc' : 'dec', { d: d5, writes: [d5] });
    return low === 8 || low === 0xb ? one('other') : write(d5);
  }
  if ((w & 0xfe00) === 0x9600) {
    const k = ((w >> 2) & 0x30) | low, d = 24 + ((w >> 3) & 6);
    return one(w & 0x100 ? 'sbiw' : 'adiw', { d, k });
  }
  if ((w & 0xfd00) === 0x9900) return one('skip');
  if ((w & 0xfc00) === 0x9c00) return one('mul', { d: d5, r: r5, writes: [0, 1] });
  return one('other');  // cbi, sbi
}
