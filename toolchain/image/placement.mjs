// SPDX-License-Identifier: GPL-3.0-or-later
// In which order the functions lie in flash. A call that reaches its target within 4 KiB takes 2 bytes
// (RCALL, RJMP), any other 4 and a cycle more (CALL, JMP; AVR instruction set manual). A pointer to a
// function has 16 bits: beyond 128 KiB it needs a trampoline, a jump of 4 bytes near the vectors.
//
// Simulated annealing: sections are moved at random, and at first a move that makes the image larger
// is often kept too. The random numbers are the same each time, so the same sections give the same
// order.
const kBackwards = -4096, kForwards = 4094;  // the reach of RCALL and RJMP from the next instruction
const kReach = kForwards - kBackwards;       // from the farthest back; what is less wraps round to far more
const kShortCallBytes = 2;
const kPointerReach = 0x20000;
const kFarCallCosts = 2, kTrampolineCosts = 4;  // bytes
const kHopeless = 2;                            // times that: not even worked out for what makes way
const kHottest = 4, kColdest = 0.2;             // bytes: a move that costs so many is kept by 1 in e

// xorshift32: Marsaglia, Xorshift RNGs, 2003
function randomNumbers() {
  let state = 0x2545f491;
  return (below) => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) % below;
  };
}

// Where the sections lie, and what that costs. Flat arrays: it is asked some million times.
class Layout {
  constructor(sections, calls) {
    this.size = Int32Array.from(sections, ({ size }) => size);
    this.at = Int32Array.from(sections, ({ address }) => address);
    this.by = new Int32Array(sections.length);  // how far a move that is tried brings each
    this.isPointedAt = Int8Array.from(sections, ({ isPointedAt }) => (isPointedAt ? 1 : 0));
    this.calls = Int32Array.from(calls.flatMap(({ from, fromAt, to, toAt }) =>
      [from, to, toAt - fromAt - kShortCallBytes - kBackwards]));
    // Each call as both its ends see it: { the other section, what is to be added to the way there so
    // that 0 to kReach are within reach }. Those of a section lie from endsOf[section] to the next.
    const ends = sections.map(() => []);
    for (let i = 0; i < this.calls.length; i += 3) {
      const [from, to, reach] = this.calls.subarray(i, i + 3);
      ends[from].push(to, reach);
      ends[to].push(from, kReach - reach);
    }
    this.ends = Int32Array.from(ends.flat());
    this.endsOf = new Int32Array(sections.length + 1);
    ends.forEach((list, i) => { this.endsOf[i + 1] = this.endsOf[i] + list.length; });
    this.begin = sections.find(({ isMoved }) => isMoved).address;
    this.place(Int32Array.from(sections.flatMap(({ isMoved }, i) => (isMoved ? [i] : []))));
  }

  place(order) {
    this.order = order;
    let next = this.begin;
    for (const section of order) {
      this.at[section] = next;
      next += this.size[section];
    }
  }

  farCalls() {
    const { at, calls } = this;
    let far = 0;
    for (let i = 0; i < calls.length; i += 3) {
      if (at[calls[i + 1]] - at[calls[i]] + calls[i + 2] >>> 0 > kReach) far++;
    }
    return far;
  }

  trampolines() {
    return this.order.filter((section) => this.isPointedAt[section] && this.at[section] >= kPointerReach).length;
  }

  // What the order costs more when the sections [first, last) of it are moved by `by`.
  costMore(first, last) {
    const { order, at, by, ends } = this;
    let twiceFar = 0, trampolines = 0;  // a call between two that are moved is seen from both ends
    for (let k = first; k < last; k++) {
      const section = order[k], own = at[section], ownBy = by[section];
      for (let i = this.endsOf[section]; i < this.endsOf[section + 1]; i += 2) {
        const other = ends[i], more = by[other] - ownBy;
        if (more === 0) continue;
        const away = at[other] - own + ends[i + 1];
        const far = (away + more >>> 0 > kReach) - (away >>> 0 > kReach);
        twiceFar += by[other] === 0 ? 2 * far : far;
      }
      if (this.isPointedAt[section]) trampolines += (own + ownBy >= kPointerReach) - (own >= kPointerReach);
    }
    return kFarCallCosts * twiceFar / 2 + kTrampolineCosts * trampolines;
  }

  // of the sections [first, last) of the order
  bytes(first, last) {
    const end = this.order[last - 1];
    return last > first ? this.at[end] + this.size[end] - this.at[this.order[first]] : 0;
  }

  shift(first, last, by) {
    for (let k = first; k < last; k++) this.by[this.order[k]] = by;
  }

  // Makes a move, unless isKept() refuses what it costs more. Returns what the order then costs more.
  // Most moves bring a section away from what it calls: that is seen without what makes way for it.
  tryMove({ from, to, count }, hopeless, isKept) {
    const end = from + count;
    const [first, last] = to < from ? [to, from] : [end, to + count];  // what makes way
    const away = this.bytes(first, last);
    this.shift(from, end, to < from ? -away : away);
    let more = this.costMore(from, end);
    const isHopeless = more > hopeless, low = Math.min(from, to), high = Math.max(from, to) + count;
    let isMade = false;
    if (!isHopeless) {
      const way = this.bytes(from, end);
      this.shift(first, last, to < from ? way : -way);
      more = this.costMore(low, high);
      isMade = isKept(more);
    }
    if (isMade) for (let k = low; k < high; k++) this.at[this.order[k]] += this.by[this.order[k]];
    this.shift(isHopeless ? from : low, isHopeless ? end : high, 0);
    if (isMade) move(this.order, { from, to, count });
    return isMade ? more : 0;
  }
}

// Takes `count` sections out of the order and puts them back so that the first has the index `to`.
function move(order, { from, to, count }) {
  const taken = order.slice(from, from + count);
  if (to < from) order.copyWithin(to + count, to, from);
  else order.copyWithin(from, from + count, to + count);
  order.set(taken, to);
}

// One section to where another is that calls it or is called by it.
function moveTogether(order, calls, random) {
  const call = calls[random(calls.length)];
  const [moved, other] = random(2) === 0 ? [call.from, call.to] : [call.to, call.from];
  const from = order.indexOf(moved), near = order.indexOf(other);
  if (from < 0 || near < 0) return null;
  return { from, to: Math.min(Math.max(near + random(21) - 10, 0), order.length - 1), count: 1 };
}

// One section or some that lie side by side, to anywhere.
function moveAnywhere(order, random) {
  const count = 1 + random([1, 4, 16, 60][random(4)]);
  if (count >= order.length) return null;
  return { from: random(order.length - count + 1), to: random(order.length - count + 1), count };
}

// sections: { address, size, isMoved, isPointedAt }, by their present addresses; the first that is
// moved begins where those that are moved will lie.
// calls: { from, fromAt, to, toAt }: indices of sections, and bytes from their beginnings.
// Returns the indices of what is moved in its new order, what is left to pay for, and the bytes that
// the moves have saved by what each changed.
export function placed(sections, calls, steps) {
  const layout = new Layout(sections, calls);
  const random = randomNumbers();
  let cost = 0, best = 0, bestOrder = layout.order.slice();
  for (let step = 0; step < steps; step++) {
    const drawn = random(4) !== 0 ? moveTogether(layout.order, calls, random) : moveAnywhere(layout.order, random);
    if (!drawn) continue;
    const heat = kHottest * (kColdest / kHottest) ** (step / steps);
    cost += layout.tryMove(drawn, kHopeless * heat, (more) => more <= 0 || random(1e9) < 1e9 * Math.exp(-more / heat));
    if (cost < best) {
      best = cost;
      bestOrder = layout.order.slice();
    }
  }
  layout.place(bestOrder);
  return { order: [...bestOrder], farCalls: layout.farCalls(), trampolines: layout.trampolines(), saved: -best };
}
