// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a program smaller after the compiler: instructions that occur again and again stand once,
// behind a call. A run that ends with a call or a return costs three cycles more, others ten.
//   outline.mjs IN.s OUT.s PACES.txt
import { readFileSync, writeFileSync } from 'node:fs';

import { readCode } from './code.mjs';
import { shortenCalls } from './near.mjs';
import { saveInPlace } from './saves.mjs';
import { shareRepeats } from './search.mjs';

// One that goes on in another lies before it, when no other does, and needs no jump.
function chains(fragments) {
  const byName = new Map(fragments.map((fragment) => [fragment.name, fragment]));
  const nextOf = ({ body }) => byName.get(/^jmp (__fragment_\d+)$/.exec(body[body.length - 1].text)?.[1]);
  const behind = new Map();
  for (const fragment of fragments) {
    const next = nextOf(fragment);
    if (next && ![...behind.values()].includes(next)) behind.set(fragment, next);
  }
  const followers = new Set(behind.values());
  return fragments.filter((fragment) => !followers.has(fragment)).map((first) => {
    const chain = [];
    for (let fragment = first; fragment; fragment = behind.get(fragment)) chain.push(fragment);
    return chain;
  });
}

function linesOf(chain) {
  const code = chain.flatMap(({ name, body }, i) => [
    `\t.type\t${name}, @function`, `${name}:`,
    ...(i + 1 < chain.length ? body.slice(0, -1) : body).map(({ text }) => `\t${text}`),
    `\t.size\t${name}, .-${name}`,
  ]);
  return [`\t.pushsection\t.text.${chain[0].name},"ax",@progbits`, ...code, '\t.popsection'];
}

// What stands in a line that began a run, or '' where one was cut out; then the fragments near
// the functions that use them.
export function outline(text, paceOf) {
  const lines = saveInPlace(text.split('\n'), paceOf.saves ?? (() => false));
  const before = readCode(lines, paceOf);
  const { steps, fragments } = shareRepeats(before);
  for (const step of before) if (step) lines[step.line] = '';
  for (const { line, text: now } of steps) lines[line] = `\t${now}`;
  const near = new Map();
  for (const chain of chains(fragments)) {
    const home = chain[0].home;
    near.set(home, [...(near.get(home) ?? []), ...linesOf(chain)]);
  }
  const whole = lines.filter((line) => line !== '').flatMap((line) => {
    const of = /^\t\.size\t([\w$.]+), \.-/.exec(line)?.[1];
    return near.has(of) ? [line, ...near.get(of)] : [line];
  });
  return `${shortenCalls(whole, paceOf).join('\n')}\n`;
}

// A::b as the linker writes it, with whatever is in it (Itanium C++ ABI, 5.1).
function pattern(name) {
  const parts = name.split('::').map((part) => `${part.length}${part}`);
  return `^_ZZ?N?K?${parts.join('(12_GLOBAL__N_1)?')}|^${name}`;
}

// One name a line, of functions or what they are in: nothing moves of what stays, of what hurries
// only what costs a jump; what saves keeps its registers without help.
export function pacesIn(text) {
  const rows = text.split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split(' '));
  const any = (pace) => new RegExp(rows.filter((row) => row[0] === pace).map((row) => pattern(row[1])).join('|') || '$^');
  const stays = any('stays'), hurries = any('hurries'), saves = any('saves');
  const paceOf = (name) => (stays.test(name) ? 'stays' : hurries.test(name) ? 'hurries' : '');
  return Object.assign(paceOf, { saves: (name) => saves.test(name) });
}

if (process.argv[1]?.endsWith('outline.mjs')) {
  const [from, to, paces] = process.argv.slice(2);
  writeFileSync(to, outline(readFileSync(from, 'utf8'), pacesIn(readFileSync(paces, 'utf8'))));
}
