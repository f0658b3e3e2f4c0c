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
const kHopeless = 2;                            // times that: not even worked out for all sections
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

// Works out what an order costs. Flat arrays: it is asked some hundred thousand times.
class Layout {
  constructor(sections, calls) {
    this.size = Int32Array.from(sections, ({ size }) => size);
    this.at = Int32Array.from(sections, ({ address }) => address);
    this.begin = sections.find(({ isMoved }) => isMoved).address;
    this.isPointedAt = Int8Array.from(sections, ({ isPointedAt }) => (isPointedAt ? 1 : 0));
    this.pointedAt = sections.flatMap(({ isMoved, isPointedAt }, i) => (isMoved && isPointedAt ? [i] : []));
    this.calls = Int32Array.from(calls.flatMap(({ from, fromAt, to, toAt }) =>
      [from, to, toAt - fromAt - kShortCallBytes - kBackwards]));
    this.callsOf = sections.map(() => []);  // where a section's own begin in `calls`
    calls.forEach(({ from, to }, i) => {
      this.callsOf[from].push(3 * i);
      this.callsOf[to].push(3 * i);
    });
  }

  place(order) {
    let next = this.begin;
    for (let i = 0; i < order.length; i++) {
      this.at[order[i]] = next;
      next += this.size[order[i]];
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

  // What sections that lie side by side cost more when the first lies at an address, and all others
  // where they are.
  ownCost(order, { from, count }, address) {
    const { at, calls } = this;
    const by = address - at[order[from]];
    const first = at[order[from]], last = at[order[from + count - 1]];
    let more = 0, trampolines = 0;
    for (let k = from; k < from + count; k++) {
      const section = order[k];
      trampolines += this.isPointedAt[section] * ((at[section] + by >= kPointerReach) - (at[section] >= kPointerReach));
      for (const i of this.callsOf[section]) {
        const isFrom = calls[i] === section;
        const other = at[isFrom ? calls[i + 1] : calls[i]];
        if (other >= first && other <= last) continue;
        const away = at[calls[i + 1]] - at[calls[i]] + calls[i + 2];
        const moved = away + (isFrom ? -by : by);
        more += (moved >>> 0 > kReach) - (away >>> 0 > kReach);
      }
    }
    return kFarCallCosts * more + kTrampolineCosts * trampolines;
  }

  trampolines() {
    let needed = 0;
    for (const i of this.pointedAt) if (this.at[i] >= kPointerReach) needed++;
    return needed;
  }

  cost(order) {
    this.place(order);
    return kFarCallCosts * this.farCalls() + kTrampolineCosts * this.trampolines();
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
  const count = 1 + random([1, 1, 8, 60][random(4)]);
  if (count >= order.length) return null;
  return { from: random(order.length - count + 1), to: random(order.length - count + 1), count };
}

// sections: { address, size, isMoved, isPointedAt }, by their present addresses; the first that is
// moved begins where those that are moved will lie.
// calls: { from, fromAt, to, toAt }: indices of sections, and bytes from their beginnings.
// Returns the indices of what is moved in its new order, and what is left to pay for.
export function placed(sections, calls, steps) {
  const order = Int32Array.from(sections.flatMap(({ isMoved }, i) => (isMoved ? [i] : [])));
  const layout = new Layout(sections, calls);
  const random = randomNumbers();
  let cost = layout.cost(order), best = cost, bestOrder = order.slice();
  for (let step = 0; step < steps; step++) {
    const drawn = random(2) === 0 ? moveTogether(order, calls, random) : moveAnywhere(order, random);
    if (!drawn) continue;
    const heat = kHottest * (kColdest / kHottest) ** (step / steps);
    // most moves bring a section away from what it calls: that is seen at less cost than all of it
    const { from, to, count } = drawn;
    if (layout.ownCost(order, drawn, layout.at[order[to]]) > kHopeless * heat) continue;
    move(order, drawn);
    const more = layout.cost(order) - cost;
    if (more > 0 && random(1e9) >= 1e9 * Math.exp(-more / heat)) {
      move(order, { from: to, to: from, count });
      layout.place(order);
      continue;
    }
    cost += more;
    if (cost < best) {
      best = cost;
      bestOrder = order.slice();
    }
  }
  layout.place(bestOrder);
  return { order: [...bestOrder], farCalls: layout.farCalls(), trampolines: layout.trampolines() };
}
