// SPDX-License-Identifier: GPL-3.0-or-later
// What a register pair is known to hold: root + off + i * stride, i any whole number.
//   root 'abs'          a number; with stride 1 and off 0 any number at all
//   root 'sp'           the stack pointer at the routine's entry
//   root {arg}          what the caller had in that pair
//   root {space, at}    the word in 'flash' or 'ram' at the value `at`

const gcd = (a, b) => (b === 0 ? Math.abs(a) : gcd(b, a % b));
const rootKey = (root) => (typeof root === 'string' ? root : root.arg !== undefined ? `arg${root.arg}` : `${root.space}(${keyOf(root.at)})`);
export const keyOf = (value) => (value.key ??= `${rootKey(value.root)}+${value.off}~${value.stride}`);

const word = (off) => off & 0xffff;
const make = (root, off, stride) => ({ root, off: root === 'abs' ? word(off) : off, stride });
export const number = (off) => make('abs', off, 0);
export const unknown = make('abs', 0, 1);
export const multiple = (of) => (of === 0 ? number(0) : make('abs', 0, of));
export const stackPointer = (depth) => make('sp', -depth, 0);
export const argument = (register) => make({ arg: register }, 0, 0);
export const wordAt = (space, at) => make({ space, at }, 0, 0);

export const isNumber = (value) => value.root === 'abs' && value.stride === 0;
export const isStack = (value) => value.root === 'sp';
export const isUnknown = (value) => value.root === 'abs' && value.stride === 1 && value.off === 0;

export const plus = (value, off) => (isUnknown(value) && off === 0 ? value : make(value.root, value.off + off, value.stride));
export function sum(a, b) {
  if (a.root !== 'abs' && b.root !== 'abs') return unknown;
  const [based, free] = a.root === 'abs' ? [b, a] : [a, b];
  // A number from 0x8000 on is one below 0 when it is added to an address that is not a number.
  const off = based.root === 'abs' || free.off < 0x8000 ? free.off : free.off - 0x10000;
  return make(based.root, based.off + off, gcd(a.stride, b.stride));
}
export const twice = (value) => (value.root === 'abs' ? make('abs', 2 * value.off, 2 * value.stride) : unknown);

// Either of the two, where paths meet.
export function either(a, b) {
  if (keyOf(a) === keyOf(b)) return a;
  if (rootKey(a.root) !== rootKey(b.root)) return unknown;
  return make(a.root, a.off, gcd(gcd(a.stride, b.stride), a.off - b.off));
}

// A register holds one half of such a value (and may be known itself, as c), or a byte of memory,
// or (null) anything.
export const half = (value, which) => (isUnknown(value) ? null : { value, which });
export const byteAt = (space, at) => ({ space, at });
export const constantByte = (c) => ({ value: number(c & 0xff), which: 0 });

export const byteOf = (byte) => {
  if (byte?.c !== undefined) return byte.c;
  if (!byte?.value || !isNumber(byte.value)) return undefined;
  return byte.which === 0 ? byte.value.off & 0xff : byte.value.off >> 8;
};
export function pair(low, high) {
  const lowByte = byteOf(low), highByte = byteOf(high);
  if (lowByte !== undefined && highByte !== undefined) return number(highByte << 8 | lowByte);
  if (low?.value && high?.value && low.which === 0 && high.which === 1 && keyOf(low.value) === keyOf(high.value)) return low.value;
  if (low?.space && low.space === high?.space && keyOf(plus(low.at, 1)) === keyOf(high.at)) return wordAt(low.space, low.at);
  return unknown;
}
export const byteKey = (byte) => {
  if (!byte) return '';
  if (byte.c !== undefined) return `#${byte.c} ${keyOf(byte.value)}`;
  const c = byteOf(byte);
  if (c !== undefined) return `#${c}`;
  return byte.value ? `${keyOf(byte.value)}.${byte.which}` : `${byte.space}[${keyOf(byte.at)}]`;
};
const isSameByte = (a, b) => byteKey(a) === byteKey(b) || (byteOf(a) !== undefined && byteOf(a) === byteOf(b));

// The same for a whole pair, whose halves may be constants that only together are an address.
export function eitherPair([lowA, highA], [lowB, highB]) {
  if (!isSameByte(lowA, lowB)) {
    const both = either(pair(lowA, highA), pair(lowB, highB));
    const high = byteOf(highA) === byteOf(highB) ? byteOf(highA) : undefined;
    if (!isUnknown(both)) return [half(both, 0), high === undefined ? half(both, 1) : { value: both, which: 1, c: high }];
  }
  return [eitherByte(lowA, lowB), eitherByte(highA, highB)];
}
export function eitherByte(a, b) {
  if (a === b || byteKey(a) === byteKey(b)) return a;
  if (isSameByte(a, b)) return constantByte(byteOf(a));
  if (a?.value && b?.value && a.which === b.which) return half(either(a.value, b.value), a.which);
  if (a?.space && a.space === b?.space) {
    const at = either(a.at, b.at);
    return isUnknown(at) ? null : byteAt(a.space, at);
  }
  return null;
}

// What a callee says in terms of its arguments, in terms of the caller's pairs.
export function inCaller(byte, args) {
  if (!byte) return null;
  if (byte.space) {
    const at = valueInCaller(byte.at, args);
    return isUnknown(at) || isStack(at) ? null : byteAt(byte.space, at);
  }
  return half(valueInCaller(byte.value, args), byte.which);
}
function valueInCaller(value, args) {
  if (value.root === 'abs') return value;
  if (value.root === 'sp') return unknown;
  const index = make('abs', 0, value.stride);
  if (value.root.arg !== undefined) return sum(plus(args.get(value.root.arg) ?? unknown, value.off), index);
  const at = valueInCaller(value.root.at, args);
  return isUnknown(at) || isStack(at) ? unknown : make({ space: value.root.space, at }, value.off, value.stride);
}
