// SPDX-License-Identifier: GPL-3.0-or-later
// In which order the functions lie in flash. A call that reaches its target within 4 KiB takes 2 bytes
// (RCALL, RJMP), any other 4 and a cycle more (CALL, JMP; AVR instruction set manual). A pointer to a
// function has 16 bits: beyond 128 KiB it needs a trampoline, a jump of 4 bytes near the vectors.
//
// Simulated annealing: sections are moved at random, and at first a move that makes the image larger
// is often kept too. The random numbers are the same each time, so the same sections give the same
// order.
const kBackwards = -4096, kForwards = 4094;  // the reach of RCALL and RJMP from the next instruction
const kShortCallBytes = 2;
const kPointerReach = 0x20000;
const kFarCallCosts = 2, kTrampolineCosts = 4;  // bytes
const kHopeless = 2;                            // times that: not even worked out for all sections
const kHottest = 6, kColdest = 0.4;             // bytes: a move that costs so many is kept by 1 in e

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
      const away = at[calls[i + 1]] - at[calls[i]] + calls[i + 2];
      if (away < 0 || away > kForwards - kBackwards) far++;
    }
    return far;
  }

  // What one section by itself costs more when it lies at an address, and all others where they are.
  ownCost(section, address) {
    const { at, calls } = this;
    const before = at[section];
    let more = 0;
    for (const i of this.callsOf[section]) {
      const away = at[calls[i + 1]] - at[calls[i]] + calls[i + 2];
      const moved = away + (calls[i + 1] === section ? address - before : before - address);
      more += (moved < 0 || moved > kForwards - kBackwards) - (away < 0 || away > kForwards - kBackwards);
    }
    const trampoline = this.isPointedAt[section] * ((address >= kPointerReach) - (before >= kPointerReach));
    return kFarCallCosts * more + kTrampolineCosts * trampoline;
  }

  trampolines() {
    return this.pointedAt.filter((i) => this.at[i] >= kPointerReach).length;
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
    if (count === 1 && layout.ownCost(order[from], layout.at[order[to]]) > kHopeless * heat) continue;
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
