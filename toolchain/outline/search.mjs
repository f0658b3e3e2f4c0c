// SPDX-License-Identifier: GPL-3.0-or-later
// Finds runs of steps that occur again and again, and has each of them once, as a fragment.
import { kCallBytes } from './code.mjs';

const kLongest = 60;      // steps of one fragment
const kReturnBytes = 2;
const kShortest = 6;      // bytes, of what comes back: a call and a return take ten cycles
const kWorth = 0.3;       // of the best in a round, what is still taken in it

const bytesOf = (steps) => steps.reduce((sum, step) => sum + step.bytes, 0);

// What `times` runs of these steps gain when they stand once.
function gain(steps, times) {
  const bytes = bytesOf(steps);
  const { ends } = steps[steps.length - 1];
  if (bytes < kShortest && !ends) return 0;
  if (ends !== 'leave' && steps.some((step) => step.isEnd)) return 0;
  const body = bytes + (ends ? 0 : kReturnBytes);
  return times * (bytes - kCallBytes) - body;
}

// A sum's lower and upper bytes stay together: what a carry goes through is not torn apart.
const mayBeCut = (steps, from, to) => !steps[from].carry && !steps[to]?.carry;

// Calls with every run of two or more steps that occurs more than once: (length, positions).
// Runs of one more step are sought among those that occur again; one that ends, ends.
function everyRepeat(steps, ids, found) {
  let groups = [steps.map((_, at) => at).filter((at) => steps[at])];
  const isOver = (at) => !steps[at] || steps[at - 1]?.ends;
  for (let length = 1; length <= kLongest && groups.length > 0; length++) {
    const longer = [];
    for (const group of groups) {
      const byNext = new Map();
      for (const at of group) {
        const last = at + length - 1;
        if (!steps[last] || (length > 1 && isOver(last))) continue;
        if (!byNext.has(ids[last])) byNext.set(ids[last], []);
        byNext.get(ids[last]).push(at);
      }
      for (const positions of byNext.values()) {
        if (positions.length < 2) continue;
        longer.push(positions);
        if (length > 1) found(length, positions);
      }
    }
    groups = longer;
  }
}

// A fragment leaves for another by a jump alone, so that no more than one is called at a time;
// what hurries has no time for a return.
const kMayEnd = { '': ['', 'call', 'leave'], hurries: ['call', 'leave'], fragment: ['leave'] };
const mayLeave = (steps, from, last) => kMayEnd[steps[from].pace].includes(steps[last].ends);

// The positions whose runs overlap neither each other nor what is taken, and may be cut out.
function apart(steps, length, positions, taken) {
  const kept = [];
  let free = 0;
  for (const at of positions) {
    const end = at + length;
    if (at < free || !mayBeCut(steps, at, end) || !mayLeave(steps, at, end - 1) || taken?.subarray(at, end).includes(1)) continue;
    kept.push(at);
    free = end;
  }
  return kept;
}

function candidates(steps, ids) {
  const all = [];
  everyRepeat(steps, ids, (length, positions) => {
    const most = gain(steps.slice(positions[0], positions[0] + length), positions.length);
    if (most <= 0) return;
    const kept = apart(steps, length, positions);
    const worth = kept.length > 1 ? gain(steps.slice(kept[0], kept[0] + length), kept.length) : 0;
    if (worth > 0) all.push({ length, positions, worth });
  });
  return all.sort((a, b) => b.worth - a.worth || b.length - a.length || a.positions[0] - b.positions[0]);
}

// The steps of a fragment: it goes back, or goes on where its last step called.
function bodyOf(steps, home) {
  const body = steps.map(({ text, bytes, ends, carry, isEnd }) => ({ text, bytes, ends, carry, isEnd, inside: home, pace: 'fragment' }));
  const last = body[body.length - 1];
  if (last.ends === 'call') Object.assign(last, { text: last.text.replace('call', 'jmp'), ends: 'leave' });
  if (last.ends === '') body.push({ text: 'ret', bytes: kReturnBytes, ends: 'leave', carry: false, inside: home, pace: 'fragment' });
  return body;
}

// Takes the best repeats, as long as they are worth it beside the best of all; returns the steps
// that remain, with those of the new fragments behind them.
function round(steps, fragments) {
  const numbers = new Map();
  const number = (text) => numbers.get(text) ?? numbers.set(text, numbers.size).size - 1;
  const ranked = candidates(steps, steps.map((step) => (step ? number(step.text) : -1)));
  const taken = new Uint8Array(steps.length);
  const calls = new Map();
  const least = Math.max(1, (ranked[0]?.worth ?? 0) * kWorth);
  for (const { length, positions, worth } of ranked) {
    if (worth < least) break;
    const kept = apart(steps, length, positions, taken);
    if (kept.length < 2) continue;
    const run = steps.slice(kept[0], kept[0] + length);
    if (gain(run, kept.length) < Math.max(least, worth / 2)) continue;
    const home = steps[kept[kept.length >> 1]].inside;
    const name = `__fragment_${fragments.length}`;
    fragments.push({ name, home, body: bodyOf(run, home) });
    for (const at of kept) {
      taken.fill(1, at, at + length);
      calls.set(at, { name, length });
    }
  }
  return calls;
}

// Puts the calls in the place of the runs.
function replaced(steps, calls) {
  const left = [];
  for (let at = 0; at < steps.length; at++) {
    const call = calls.get(at);
    if (!call) {
      left.push(steps[at]);
      continue;
    }
    const run = steps.slice(at, at + call.length);
    const leaves = run[run.length - 1].ends === 'leave';
    left.push({ ...run[0], text: `${leaves ? 'jmp' : 'call'} ${call.name}`, bytes: kCallBytes, ends: leaves ? 'leave' : 'call', carry: false, isEnd: false });
    at += call.length - 1;
  }
  return left;
}

// The steps that are left, and the fragments { name, home, body }: the function it is to lie near.
export function shareRepeats(steps) {
  const fragments = [];
  let code = steps;
  for (;;) {
    const known = fragments.length;
    const calls = round(code, fragments);
    if (calls.size === 0) break;
    code = replaced(code, calls);
    for (const { name, body } of fragments.slice(known)) code.push(undefined, ...body.map((step) => ({ ...step, of: name })), undefined);
  }
  const bodies = new Map(fragments.map(({ name }) => [name, []]));
  for (const step of code) if (step?.pace === 'fragment') bodies.get(step.of).push(step);
  return { steps: code.filter((step) => step && step.pace !== 'fragment'), fragments: fragments.map(({ name, home }) => ({ name, home, body: bodies.get(name) })) };
}
