// SPDX-License-Identifier: GPL-3.0-or-later
// The deepest the stack of an image can ever get, from its code alone.
//   node toolchain/image/stack_bound.mjs FILE.elf [--json] [--indirect]
// The program's deepest chain of calls, and on top of it the deepest interrupt (once: interrupts
// run with interrupts off; those that switch them on are added all together). Recursion fails.
//
// Calls through pointers are followed to where the pointer comes from: back through arithmetic,
// arguments and all callers' arguments, and members of structs, to the tables in flash and the
// initialised words in RAM that name functions. An index that is not known means every row; the
// size of a row is known where the code multiplies by it or steps through the table. A pointer
// that cannot be followed, such as one stored while the program runs, is counted as unresolved
// and taken to mean every function whose address is taken anywhere.
// Needs the relocations in the file: link with -Wl,--emit-relocs.
import { execFileSync } from 'node:child_process';

import { decode } from './decode.mjs';
import { readElf } from './elf.mjs';
import { Routine } from './routine.mjs';
import { isNumber, isUnknown, keyOf, number, pair, plus, sum } from './value.mjs';

const kVectorBytes = 4, kVectors = 57;
const kWordOfData = 4, kWordOfCode = 5;                // R_AVR_16, R_AVR_16_PM
const kCodeAddresses = new Set([12, 13, 15, 16, 24, 25]);  // LDI of a code address, either half
const kReturnAddress = 3;
const kTrampolineBytes = 4, kPointerReach = 0x1ffff;
const kRam = 0x800000;  // where the ELF file puts it

// From the linker's names to those in the source, without arguments.
function readableNames(raw) {
  try {
    const text = execFileSync('avr-c++filt', { input: raw.join('\n'), encoding: 'utf8' });
    const nice = text.trimEnd().split('\n').map((name) => name.replaceAll('(anonymous namespace)::', '').replace(/\((unsigned )?\w+\)(?=\d)/g, '').replace(/\(.*/, ''));
    return new Map(raw.map((name, i) => [name, nice[i]]));
  } catch {
    return new Map(raw.map((name) => [name, name]));
  }
}

class Image {
  constructor(elf) {
    this.text = elf.text;
    this.elf = elf;
    const inText = elf.symbols.filter((symbol) => symbol.section === '.text' && symbol.type !== 'section' && symbol.type !== 'file');
    this.functions = new Map();
    for (const symbol of inText) {
      if (symbol.type === 'function' || !this.functions.has(symbol.value)) this.functions.set(symbol.value, symbol);
    }
    const symbols = [...this.functions.values()];
    const names = readableNames(symbols.map((symbol) => symbol.name));
    for (const symbol of symbols) symbol.name = names.get(symbol.name);
    this.ours = new Set([...this.functions.values()].filter(({ type, name }) => type === 'function' && !name.startsWith('__')).map(({ value }) => value));
    this.starts = [...this.functions.keys()].sort((a, b) => a - b);
    this.objects = elf.symbols.filter((symbol) => symbol.type === 'object' && symbol.size > 0);
    this.words = new Map(elf.relocations.filter((r) => r.type === kWordOfCode).map((r) => [r.at, r.target]));
    const isAddress = (r) => r.type === kWordOfCode || r.type === kWordOfData;
    this.addresses = new Map(elf.relocations.filter(isAddress).map((r) => [r.at, r]));
    this.trampolines = this.findTrampolines();
  }

  // Whether a function that is no helper of the compiler's begins there.
  isOurs(address) { return this.ours.has(address); }

  // A pointer has 16 bits and reaches the first 128 KiB; for functions above, the linker makes it
  // point to a jump to them.
  findTrampolines() {
    const begin = this.elf.symbol('__trampolines_start')?.value ?? 0, end = this.elf.symbol('__trampolines_end')?.value ?? 0;
    const found = new Map();
    for (let at = begin; at < end; at += kTrampolineBytes) found.set(decode(this.text, at).to, at);
    return found;
  }
  pointerTo(target) { return (target > kPointerReach ? this.trampolines.get(target) ?? target : target) / 2; }

  startOf(address) {
    let low = 0, high = this.starts.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.starts[middle] <= address) low = middle + 1;
      else high = middle;
    }
    return this.starts[low - 1] ?? 0;
  }
  name(address) { return this.functions.get(this.startOf(address))?.name ?? `0x${address.toString(16)}`; }
  isFunction(address) { return this.functions.get(address)?.type === 'function'; }
  objectAt(address) { return this.objects.find((o) => address >= o.value && address < o.value + o.size); }

  // Targets of the switch whose table begins at this word, as long as they lie in its function.
  jumpTable(word, at) {
    const home = this.startOf(at), targets = [];
    for (let entry = 2 * word; this.startOf(this.words.get(entry) ?? -1) === home; entry += 2) {
      targets.push(this.words.get(entry));
    }
    return targets;
  }

  // The words in memory that a pointer to this place may mean, as far as they are addresses;
  // undefined: not known.
  wordsAt(space, { off, stride }) {
    const base = space === 'ram' ? kRam + off : off;
    const valueOf = (r) => number(r.type === kWordOfCode ? this.pointerTo(r.target) : r.target);
    if (stride === 0) {
      const r = this.addresses.get(base);
      return r ? [valueOf(r)] : space === 'flash' ? [] : undefined;
    }
    const object = this.objectAt(base);
    if (!object) return undefined;
    const found = [];
    for (let at = base - stride * Math.floor((base - object.value) / stride); at < object.value + object.size; at += stride) {
      const r = this.addresses.get(at);
      if (r) found.push(valueOf(r));
    }
    return found.length > 0 ? found : undefined;
  }

  // Every function whose address is taken; a jump of the vector table does not count.
  taken() {
    const found = new Set();
    for (const r of this.elf.relocations) {
      if ((r.type === kWordOfCode || kCodeAddresses.has(r.type)) && this.isFunction(r.target)) found.add(r.target);
    }
    return found;
  }
}

export class Analysis {
  constructor(elf) {
    this.image = new Image(elf);
    this.routines = new Map();
    this.underWay = [];
    this.bounds = new Map();
    this.callers = new Map();
    this.stored = new Set();
    this.sites = new Map();  // of calls through pointers: {at, in, from, targets, isResolved}
  }

  // The account of one function; the calls it makes are only listed.
  routine(address) {
    const known = this.routines.get(address);
    if (known) return known;
    const routine = new Routine(this.image, address);
    this.routines.set(address, routine);
    routine.follow((to) => this.routine(to));
    for (const call of routine.calls.values()) this.addCaller(call.to, call, address);
    for (const at of routine.stored) this.stored.add(at);
    return routine;
  }
  addCaller(to, site, from) {
    if (!this.callers.has(to)) this.callers.set(to, new Map());
    this.callers.get(to).set(`${from} ${site.at}`, { from, args: site.args, slots: site.slots });
  }

  // Finds all code that can run from the roots. What a pointer can mean grows with every caller
  // that is found, so the search is repeated until nothing new comes.
  explore(roots) {
    for (const root of roots) this.routine(root);
    this.settle();
    for (const site of this.sites.values()) {
      if (site.targets.length === 0) site.isResolved = false;
    }
    this.settle();
  }
  settle() {
    for (let before = -1, now = 0; now !== before;) {
      before = now;
      for (const [address, routine] of [...this.routines]) {
        for (const site of routine.indirect.values()) this.resolve(address, site);
      }
      now = this.routines.size + [...this.sites.values()].reduce((all, site) => all + site.targets.length, 0);
    }
  }
  resolve(address, site) {
    const key = `${address} ${site.at}`;
    if (!this.sites.has(key)) this.sites.set(key, { at: site.at, in: address, from: keyOf(site.z), targets: [], isResolved: true });
    const known = this.sites.get(key);
    const meant = known.isResolved ? this.meanings(site.z, address, new Set()) : undefined;
    known.isResolved = meant !== undefined && meant.every((value) => !value.slots && isNumber(value));
    known.targets = known.isResolved ? [...new Set(meant.map((value) => 2 * value.off))] : [...this.image.taken()];
    for (const target of known.targets) {
      this.routine(target);
      this.addCaller(target, site, address);
    }
  }

  // What a value in this function can be: numbers, or places in the frame of a caller
  // {slots, from, off}; undefined: not known.
  meanings(value, address, asked) {
    if (isUnknown(value) || value.root === 'sp') return undefined;
    if (value.root === 'abs') return [value];
    const key = `${address} ${keyOf(value)}`;
    if (asked.has(key)) return [];
    asked.add(key);
    const found = value.root.arg === undefined ? this.inMemory(value.root, address, asked) : this.inCallers(value.root.arg, address, asked);
    const index = { root: 'abs', off: 0, stride: value.stride };
    return found?.map((each) => (each.slots ? { ...each, off: each.off + value.off } : sum(plus(each, value.off), index)));
  }
  inCallers(register, address, asked) {
    const found = [];
    for (const { from, args, slots } of this.callers.get(address)?.values() ?? []) {
      const given = args.get(register);
      const meant = given.root === 'sp' && given.stride === 0 ? [{ slots, from, off: given.off }] : this.meanings(given, from, asked);
      if (!meant) return undefined;
      found.push(...meant);
    }
    return found;
  }
  inMemory({ space, at }, address, asked) {
    const found = [];
    for (const place of this.meanings(at, address, asked) ?? [undefined]) {
      const words = place && this.wordsAt(space, place, asked);
      if (!words) return undefined;
      found.push(...words);
    }
    return found;
  }
  wordsAt(space, place, asked) {
    if (place.slots) return this.meanings(pair(place.slots.get(place.off), place.slots.get(place.off + 1)), place.from, asked);
    return space === 'ram' && this.stored.has(place.off) ? undefined : this.image.wordsAt(space, place);
  }

  // Bytes below this function's own return address, with the chain of calls that needs them.
  bound(address) {
    const known = this.bounds.get(address);
    if (known) return known;
    const again = this.underWay.indexOf(address);
    if (again >= 0) {
      const cycle = [...this.underWay.slice(again), address].map((each) => this.image.name(each));
      throw new Error(`recursion: ${cycle.join(' > ')}`);
    }
    this.underWay.push(address);
    const routine = this.routine(address);
    let best = { bytes: routine.depth, chain: [{ address, bytes: routine.depth }], enables: routine.enables };
    let enables = routine.enables;
    const reach = (to, depth) => {
      const below = this.bound(to);
      enables ||= below.enables;
      if (depth + below.bytes <= best.bytes) return;
      best = { bytes: depth + below.bytes, chain: [{ address, bytes: depth }, ...below.chain] };
    };
    for (const call of routine.calls.values()) reach(call.to, call.depth);
    for (const site of routine.indirect.values()) {
      for (const target of this.sites.get(`${address} ${site.at}`).targets) reach(target, site.depth);
    }
    this.underWay.pop();
    best.enables = enables;
    this.bounds.set(address, best);
    return best;
  }

  handlers() {
    const all = [];
    const restart = this.image.elf.symbol('__bad_interrupt')?.value;  // begins the program anew
    for (let vector = 1; vector < kVectors; vector++) {
      const address = this.routineJump(vector);
      if (address !== undefined && address !== restart) all.push({ vector, address });
    }
    return all;
  }
  interrupts() {
    return this.handlers().map(({ vector, address }) => {
      const { bytes, chain, enables } = this.bound(address);
      return { vector, bytes: bytes + kReturnAddress, chain, enables };
    });
  }
  // The vector table's entry: jmp, or after relaxation rjmp and a nop.
  routineJump(vector) {
    const at = vector * kVectorBytes, word = this.image.text.readUInt16LE(at);
    if ((word & 0xfe0e) === 0x940c) return 2 * this.image.text.readUInt16LE(at + 2) + ((word & 1) << 17);
    if ((word & 0xf000) === 0xc000) return at + 2 + 2 * ((word << 20) >> 20);
    return undefined;
  }
}

// { bytes, main: {bytes, chain}, interrupts: {bytes, vectors}, indirect, unresolved, recursion? }
export function stackBound(path) {
  const elf = readElf(path);
  if (elf.relocations.length === 0) throw new Error(`${path} has no relocations: link with -Wl,--emit-relocs`);
  const analysis = new Analysis(elf);
  analysis.explore([0, ...analysis.handlers().map((each) => each.address)]);
  const main = analysis.bound(0);
  const interrupts = analysis.interrupts();
  const name = (address) => analysis.image.name(address);
  const chainOf = (chain) => chain.map((link) => ({ function: name(link.address), bytes: link.bytes }));
  const quiet = interrupts.filter((each) => !each.enables).map((each) => each.bytes);
  const nested = interrupts.filter((each) => each.enables).map((each) => each.bytes);
  const above = Math.max(0, ...quiet) + nested.reduce((total, bytes) => total + bytes, 0);
  return {
    bytes: main.bytes + above,
    main: { bytes: main.bytes, chain: chainOf(main.chain) },
    interrupts: {
      bytes: above,
      nested: nested.length,
      vectors: interrupts.map((each) => ({ vector: each.vector, bytes: each.bytes, enables: each.enables, chain: chainOf(each.chain) })),
    },
    indirect: [...analysis.sites.values()].map((site) => ({
      at: site.at, in: name(site.in), from: site.from, resolved: site.isResolved, targets: site.targets.map(name),
    })),
    unresolved: [...analysis.sites.values()].filter((site) => !site.isResolved).length,
  };
}

export function describe(bound) {
  const chain = bound.main.chain.map((link) => link.function).join(' > ');
  const worst = bound.interrupts.vectors.reduce((a, b) => (b.bytes > a.bytes ? b : a), { bytes: 0, vector: 0 });
  const nested = bound.interrupts.nested > 0 ? `, ${bound.interrupts.nested} of them nested` : '';
  const unresolved = bound.unresolved > 0 ? `, ${bound.unresolved} calls through pointers unresolved` : '';
  return `${bound.bytes} = ${bound.main.bytes} (${chain}) + ${bound.interrupts.bytes} of interrupts ` +
    `(deepest: vector ${worst.vector}${nested})${unresolved}`;
}

function run(options) {
  const path = options.find((option) => !option.startsWith('--'));
  if (!path) throw new Error('usage: stack_bound.mjs FILE.elf [--json] [--indirect]');
  const bound = stackBound(path);
  if (options.includes('--json')) return console.log(JSON.stringify(bound, null, 2));
  console.log(`stack  ${describe(bound)}`);
  if (!options.includes('--indirect')) return undefined;
  for (const site of bound.indirect) {
    console.log(`  0x${site.at.toString(16)} in ${site.in}, ${site.resolved ? site.from : 'unresolved'}: ${site.targets.join(', ')}`);
  }
  return undefined;
}

if (process.argv[1]?.endsWith('stack_bound.mjs')) {
  try {
    run(process.argv.slice(2));
  } catch (error) {
    console.error(`stack_bound: ${error.message}`);
    process.exitCode = 1;
  }
}
