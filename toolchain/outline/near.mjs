// SPDX-License-Identifier: GPL-3.0-or-later
// A call within 4 KiB takes two bytes, a farther one four. Several calls of one far place go by a
// jump near them, two cycles longer. The linker shortens them; here addresses are guessed, and
// a wrong guess costs bytes only.
import { bytesOfStep } from './code.mjs';

const kReach = 3900;      // bytes; 4096 but for what is guessed wrong
const kRounds = 3;        // until calls that became short have moved the others together
const kFewest = 3;        // calls for a jump of four bytes

// Calls and jumps by name { line, at, to, far }, ends of functions { line, at }, begins by name.
function measure(lines, paceOf, isFar) {
  const sites = [], ends = [], begins = new Map();
  let at = 0, isKept = true, isCode = false;
  lines.forEach((line, number) => {
    const text = line.trim();
    const name = /^([A-Za-z_][\w$.]*):/.exec(text)?.[1];
    if (/^\.(section|pushsection|text|data)/.test(text)) isCode = /^\.text|\.text/.test(text);
    if (!isCode) return;
    if (name) {
      begins.set(name, at);
      isKept = paceOf(name) === 'stays';
    } else if (/^\.size/.test(text)) {
      ends.push({ line: number, at });
    } else if (/^[a-z]/.test(text)) {
      const [, step, to] = /^(call|jmp)\s+([A-Za-z_].*)$/.exec(text) ?? [];
      const isSite = step && !isKept && !to.startsWith('__tablejump2__');
      if (isSite) sites.push({ line: number, at, step, to: to.replace(/\s/g, '') });
      at += isSite && !isFar(number) ? 2 : bytesOfStep(text);
    }
  });
  return { sites, ends, begins };
}

// The places for one target's jumps, each with the calls it serves.
function served(sites, ends) {
  const found = [];
  for (let i = 0, end = 0; i < sites.length;) {
    while (end + 1 < ends.length && ends[end + 1].at <= sites[i].at + kReach) end++;
    const near = sites.slice(i).filter(({ at }) => Math.abs(at - ends[end].at) <= kReach);
    if (near.length >= kFewest) found.push({ line: ends[end].line, sites: near });
    i += Math.max(near.length, 1);
  }
  return found;
}

export function shortenCalls(lines, paceOf) {
  let far = new Set(), measured = measure(lines, paceOf, () => true);
  for (let round = 0; round < kRounds; round++) {
    const isNear = ({ at, to }) => Math.abs(measured.begins.get(to) - at) <= kReach;
    far = new Set(measured.sites.filter((site) => !isNear(site)).map(({ line }) => line));
    measured = measure(lines, paceOf, (line) => far.has(line));
  }
  const byTarget = new Map();
  for (const site of measured.sites) if (far.has(site.line)) byTarget.set(site.to, [...(byTarget.get(site.to) ?? []), site]);
  const changed = [...lines], jumps = new Map();
  let count = 0;
  for (const [to, sites] of byTarget) {
    for (const place of served(sites, measured.ends)) {
      const name = `__fragment_to_${count++}`;
      for (const { line, step } of place.sites) changed[line] = `\t${step} ${name}`;
      jumps.set(place.line, [...(jumps.get(place.line) ?? []), `\t.pushsection\t.text.${name},"ax",@progbits`, `\t.type\t${name}, @function`,
        `${name}:`, `\tjmp ${to}`, `\t.size\t${name}, .-${name}`, '\t.popsection']);
    }
  }
  return changed.flatMap((line, i) => [line, ...(jumps.get(i) ?? [])]);
}
