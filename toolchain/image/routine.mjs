// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the code from one entry along every path and counts the bytes on the stack: pushes, pops,
// calls, and frames that are made by moving the stack pointer. For that, and to see where a
// pointer to a function comes from, it stores what is known of every register and of the bytes in
// the routine's own frame. Assumed of compiled code: a call gives back the stack pointer, the
// call-saved registers and, of the frame, what it does not fill itself.
import { decode } from './decode.mjs';
import {
  argument, byteAt, byteKey, byteOf, constantByte, eitherByte, eitherPair, half, inCaller, isNumber, isStack, isUnknown, multiple, number,
  pair, plus, stackPointer, sum, twice, unknown,
} from './value.mjs';

const kSpl = 0x3d, kSph = 0x3e, kRamEnd = 0x21ff;
const kStartUp = new Set(['__do_copy_data', '__do_clear_bss']);  // makes RAM what the ELF file says
const kReturnAddress = 3;  // bytes, on a chip with more than 128 KiB
const kMaxVisits = 60;    // of one instruction with a growing stack
const kCallClobbered = [0, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 30, 31];
const kResults = [18, 19, 20, 21, 22, 23, 24, 25];
const kArguments = [8, 10, 12, 14, 16, 18, 20, 22, 24];  // pairs (avr-gcc's calling convention)

const pairOf = (registers, d) => pair(registers[d], registers[d + 1]);
function setPair(registers, d, value) {
  registers[d] = half(value, 0);
  registers[d + 1] = half(value, 1);
}
const argumentsOf = (registers) => new Map(kArguments.map((d) => [d, pairOf(registers, d)]));

// image: { text, name(address), jumpTable(word, at) }
// After follow(): depth in bytes, returns (whether it ever does), enables (interrupts), calls
// [{at, to, depth, args, slots}], indirect [{at, depth, z, args, slots}]; slots: bytes of its frame.
// And stored: the RAM addresses it writes to.
export class Routine {
  constructor(image, entry) {
    this.image = image;
    this.entry = entry;
    this.depth = 0;
    this.returns = false;
    this.enables = false;
    this.calls = new Map();
    this.indirect = new Map();
    this.stored = new Set();
    this.filled = new Map();
  }

  fail(at, text) {
    throw new Error(`${this.image.name(at)} at 0x${at.toString(16)}: ${text}`);
  }

  // `callee(address)`: its routine; one that never returns ends the path.
  follow(callee) {
    this.callee = callee;
    this.states = new Map();
    this.visits = new Map();
    this.open = [];
    const registers = new Array(32).fill(null);
    for (const d of kArguments) setPair(registers, d, argument(d));
    registers[1] = constantByte(0);
    this.enter(this.entry, { depth: 0, registers, slots: new Map() });
    while (this.open.length > 0) {
      const at = this.open.pop();
      const { depth, registers: known, slots } = this.states.get(at);
      this.step(at, { depth, registers: [...known], slots });
    }
    this.states = this.visits = undefined;
    if (this.returnsUnknown) this.result = undefined;
    this.finished = true;
  }

  enter(at, state) {
    const old = this.states.get(at);
    if (!old) {
      this.states.set(at, state);
      this.open.push(at);
      return;
    }
    const depth = Math.max(old.depth, state.depth);
    const registers = [eitherByte(old.registers[0], state.registers[0]), eitherByte(old.registers[1], state.registers[1])];
    for (let d = 2; d < 32; d += 2) registers.push(...eitherPair(old.registers.slice(d, d + 2), state.registers.slice(d, d + 2)));
    const slots = this.mergeSlots(old.slots, state.slots);
    const isSame = depth === old.depth && slots === old.slots &&
      registers.every((byte, i) => byteKey(byte) === byteKey(old.registers[i]));
    if (isSame) return;
    this.visits.set(at, (this.visits.get(at) ?? 0) + 1);
    if (depth > old.depth && this.visits.get(at) > kMaxVisits) this.fail(at, 'the stack grows in a loop');
    this.states.set(at, { depth, registers, slots });
    this.open.push(at);
  }
  mergeSlots(a, b) {
    if (a === b) return a;
    let changed = false;
    const merged = new Map();
    for (const [slot, byte] of a) {
      const both = b.has(slot) ? eitherByte(byte, b.get(slot)) : null;
      if (both) merged.set(slot, both);
      if (byteKey(both) !== byteKey(byte)) changed = true;
    }
    return changed ? merged : a;
  }

  step(at, state) {
    if (at + 1 >= this.image.text.length) this.fail(this.entry, `runs out of the code to 0x${at.toString(16)}`);
    const code = decode(this.image.text, at);
    const next = at + 2 * code.words;
    const { registers } = state;
    const on = (to = next, depth = state.depth) => {
      if (to < 0) this.fail(this.entry, `runs out of the code to ${to}`);
      this.depth = Math.max(this.depth, depth);
      this.enter(to, { depth, registers, slots: state.slots });
    };
    switch (code.kind) {
      case 'push': return on(next, state.depth + 1);
      case 'pop':
        registers[code.d] = null;
        return on(next, state.depth - 1);
      case 'in': {
        const which = code.io === kSpl ? 0 : code.io === kSph ? 1 : undefined;
        registers[code.d] = which === undefined ? null : half(stackPointer(state.depth), which);
        return on();
      }
      case 'out': return on(next, this.moved(at, code, state));
      case 'jump':
        if (code.to === 0) return undefined;  // begins the program anew, with an empty stack
        if (this.isTailCall(code.to, state)) return this.call(at, code.to, next, state, () => this.ret(at, state), 0);
        return this.jump(at, code.to, registers, on);
      case 'branch': on(); return on(code.to);
      case 'skip': on(); return on(next + 2 * decode(this.image.text, next).words);
      case 'call': return this.call(at, code.to, next, state, on);
      case 'icall':
        this.indirect.set(at, { at, depth: state.depth + kReturnAddress, z: pairOf(registers, 30), args: argumentsOf(registers), slots: state.slots });
        this.clobber(registers);
        return on();
      case 'ijmp': {
        const z = pairOf(registers, 30);
        if (isNumber(z)) return on(2 * z.off);
        this.returnsUnknown = true;
        this.indirect.set(at, { at, depth: state.depth, z, args: argumentsOf(registers), slots: state.slots });
        this.returns = true;
        return undefined;
      }
      case 'ret': case 'reti': return this.ret(at, state);
      case 'sei': this.enables = true; return on();
      case 'load': {
        const behind = this.copyLoop(at, code, state);
        if (behind) return on(behind);
        this.load(code, state);
        return on();
      }
      case 'store': {
        const behind = this.fillLoop(at, code, state);
        if (behind) return on(behind);
        this.store(at, code, state);
        return on();
      }
      default:
        this.compute(at, code, registers);
        return on();
    }
  }

  ret(at, { depth, registers }) {
    if (depth > 0) this.fail(at, `returns with ${depth} bytes on the stack`);
    this.returns = true;
    this.result = this.result ? this.result.map((byte, i) => eitherByte(byte, registers[i])) : registers;
  }

  // A jump to where another function of ours begins, with nothing left on the stack. Followed as a
  // part of this one, its saved registers and frame would be mixed up with this one's.
  isTailCall(to, { depth }) {
    return depth === 0 && to !== this.entry && this.image.isOurs(to);
  }

  clobber(registers) {
    for (const i of kCallClobbered) registers[i] = null;
    registers[1] = constantByte(0);
  }

  // New depth after OUT SPL or OUT SPH; the pair is taken over with its low half, which avr-gcc
  // writes last; the start-up code's constants count as soon as they are there.
  moved(at, code, { depth, registers }) {
    if (code.io !== kSpl && code.io !== kSph) return depth;
    const value = pairOf(registers, code.io === kSpl ? code.r : code.r - 1);
    if (isStack(value) && value.stride === 0) return code.io === kSpl ? -value.off : depth;
    if (!isNumber(value)) this.fail(at, 'the stack pointer is set to something unknown');
    return kRamEnd - value.off;
  }

  jump(at, to, registers, on) {
    const through = this.image.name(to) === '__tablejump2__' && this.image.startOf(to) === to;
    if (!through || this.image.name(at) === '__tablejump2__') return on(to);
    const table = pairOf(registers, 30);
    if (table.root !== 'abs' || isUnknown(table)) this.fail(at, 'jumps through a table that is not known');
    const targets = this.image.jumpTable(table.off, at);
    if (targets.length === 0) this.fail(at, 'jumps through an empty table');
    for (const target of targets) on(target);
    return undefined;
  }

  call(at, to, next, state, on, pushed = kReturnAddress) {
    if (to === next) return on(next, state.depth + kReturnAddress);  // avr-gcc's short way to make room
    const depth = state.depth + pushed;
    const args = argumentsOf(state.registers);
    this.calls.set(at, { at, to, depth, args, slots: state.slots });
    if (this.image.name(to) === 'memcpy_P') this.copyFromFlash(state);
    this.depth = Math.max(this.depth, depth);
    this.clobber(state.registers);
    const callee = this.callee(to);
    for (const { arg, off, byte } of callee.filled.values()) this.write(state, plus(args.get(arg), off), [inCaller(byte, args)]);
    if (callee.result) for (const i of kResults) state.registers[i] = inCaller(callee.result[i], args);
    if (callee.returns || !callee.finished) on();
    return undefined;
  }

  // Where a load or store goes; moves its pointer.
  address(code, registers) {
    if (code.address !== undefined) return number(code.address);
    const pointer = pairOf(registers, code.pointer);
    const at = plus(pointer, (code.displacement ?? 0) - (code.before ?? 0));
    if (code.before || code.after) setPair(registers, code.pointer, plus(pointer, (code.after ?? 0) - (code.before ?? 0)));
    return at;
  }
  load(code, state) {
    const at = this.address(code, state.registers);
    state.registers[code.d] = this.byteOf(code.space, at, state);
  }
  byteOf(space, at, state) {
    if (isStack(at)) return at.stride === 0 ? state.slots.get(at.off) ?? null : null;
    return isUnknown(at) ? null : byteAt(space, at);
  }
  store(at, code, state) {
    const to = this.address(code, state.registers);
    if (!kStartUp.has(this.image.name(at))) this.write(state, to, [state.registers[code.d]]);
  }
  // Bytes into the frame (to an unknown place in it: all that was known is lost), or to where an
  // argument points: a struct of the caller's that this routine fills.
  write(state, at, bytes) {
    if (isStack(at)) {
      state.slots = new Map(at.stride === 0 ? state.slots : []);
      if (at.stride === 0) bytes.forEach((byte, i) => state.slots.set(at.off + i, byte));
    } else if (at.root.arg !== undefined && at.stride === 0) {
      bytes.forEach((byte, i) => this.fill(at.root.arg, at.off + i, byte));
    } else if (isNumber(at)) {
      bytes.forEach((_, i) => this.stored.add(at.off + i));
    }
  }
  fill(arg, off, byte) {
    const key = `${arg} ${off}`, old = this.filled.get(key);
    this.filled.set(key, { arg, off, byte: old ? eitherByte(old.byte, byte) : byte });
  }
  // memcpy_P(to, from, size)
  copyFromFlash(state) {
    const [to, from, size] = [24, 22, 20].map((d) => pairOf(state.registers, d));
    const count = isNumber(size) ? size.off : 0;
    const bytes = Array.from({ length: count }, (_, i) => this.byteOf('flash', plus(from, i), state));
    if (count > 0 || isStack(to)) this.write(state, count > 0 ? to : { ...to, stride: 1 }, bytes);
  }
  // avr-gcc's clearing of a struct: st X+,rS  dec rN  brne. Returns where it ends.
  fillLoop(at, code, state) {
    const [count, back] = [2, 4].map((by) => decode(this.image.text, at + by));
    if (code.after !== 1 || count.kind !== 'dec' || back.to !== at) return undefined;
    const size = byteOf(state.registers[count.d]);
    if (!size) return undefined;
    const to = pairOf(state.registers, code.pointer);
    this.write(state, to, new Array(size).fill(state.registers[code.d]));
    setPair(state.registers, code.pointer, plus(to, size));
    state.registers[count.d] = constantByte(0);
    return at + 6;
  }
  // avr-gcc's copy of a struct: ld r0,Z+  st X+,r0  dec rN  brne. Returns where it ends.
  copyLoop(at, code, state) {
    if (code.d !== 0 || code.after !== 1) return undefined;
    const [store, count, back] = [2, 4, 6].map((by) => decode(this.image.text, at + by));
    if (store.kind !== 'store' || store.d !== 0 || store.after !== 1 || count.kind !== 'dec' || back.to !== at) return undefined;
    const size = byteOf(state.registers[count.d]);
    const from = pairOf(state.registers, code.pointer), to = pairOf(state.registers, store.pointer);
    if (!size) return undefined;
    this.write(state, to, Array.from({ length: size }, (_, i) => this.byteOf(code.space, plus(from, i), state)));
    setPair(state.registers, code.pointer, plus(from, size));
    setPair(state.registers, store.pointer, plus(to, size));
    state.registers[0] = null;
    state.registers[count.d] = constantByte(0);
    return at + 8;
  }

  // Sixteen-bit sums come as two instructions in a row; the first computes, the second is seen.
  compute(at, code, registers) {
    const second = decode(this.image.text, at + 2);
    const carries = (kinds) => kinds.includes(second.kind) && second.d === code.d + 1;
    switch (code.kind) {
      case 'ldi': registers[code.d] = constantByte(code.k); break;
      case 'mov': registers[code.d] = registers[code.r]; break;
      case 'movw':
        registers[code.d] = registers[code.r];
        registers[code.d + 1] = registers[code.r + 1];
        break;
      case 'inc': {
        const c = byteOf(registers[code.d]);
        registers[code.d] = c === undefined ? null : constantByte(c + 1);
        break;
      }
      case 'adiw': setPair(registers, code.d, plus(pairOf(registers, code.d), code.k)); break;
      case 'sbiw': setPair(registers, code.d, plus(pairOf(registers, code.d), -code.k)); break;
      case 'mul': this.multiply(code, registers); break;
      case 'subi': case 'sub':
        if (carries(['sbci', 'sbc'])) this.subtractPair(code, second, registers);
        else this.subtractByte(code, registers);
        break;
      case 'add':
        if (carries(['adc'])) this.addPair(code, second, registers);
        else registers[code.d] = null;
        break;
      case 'sbci': case 'sbc': case 'adc':
        if (!this.isSecond(at, code)) registers[code.d] = null;
        break;
      default:
        for (const i of code.writes) registers[i] = null;
    }
  }
  isSecond(at, code) {
    const first = at >= 2 ? decode(this.image.text, at - 2) : code;
    const kinds = code.kind === 'adc' ? ['add'] : ['sub', 'subi'];
    return kinds.includes(first.kind) && first.d + 1 === code.d;
  }
  multiply(code, registers) {
    const factor = byteOf(registers[code.d]) ?? byteOf(registers[code.r]);
    setPair(registers, 0, factor === undefined ? unknown : multiple(factor));
  }
  subtractByte(code, registers) {
    const a = byteOf(registers[code.d]), b = code.kind === 'subi' ? code.k : byteOf(registers[code.r]);
    registers[code.d] = a === undefined || b === undefined ? null : constantByte(a - b);
  }
  subtractPair(code, second, registers) {
    const low = code.kind === 'subi' ? code.k : byteOf(registers[code.r]);
    const high = second.kind === 'sbci' ? second.k : byteOf(registers[second.r]);
    const isKnown = low !== undefined && high !== undefined;
    const amount = isKnown ? ((high << 8 | low) << 16) >> 16 : 0;
    setPair(registers, code.d, isKnown ? plus(pairOf(registers, code.d), -amount) : unknown);
  }
  addPair(code, second, registers) {
    const a = pairOf(registers, code.d);
    const isDouble = code.d === code.r && second.d === second.r;
    const b = pair(registers[code.r], registers[second.r]);
    setPair(registers, code.d, isDouble ? twice(a) : sum(a, b));
  }
}
