// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a program smaller after the compiler: instructions that occur again and again stand once,
// behind a call. A run that ends with a call or a return costs three cycles more, others ten.
//   outline.mjs IN.s OUT.s HURRIED.txt     what HURRIED.txt names stays as it is
import { readFileSync, writeFileSync } from 'node:fs';

import { readCode } from './code.mjs';
import { shortenCalls } from './near.mjs';
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
export function outline(text, isHurried) {
  const lines = text.split('\n');
  const before = readCode(lines, isHurried);
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
  return shortenCalls(whole, isHurried).join('\n');
}

// A::b as the linker writes it, with whatever is in it (Itanium C++ ABI, 5.1).
function pattern(name) {
  const parts = name.split('::').map((part) => `${part.length}${part}`);
  return `^_ZZ?N?K?${parts.join('(12_GLOBAL__N_1)?')}|^${name}`;
}

// One name a line; whether a function is one of them or in one of them.
export function hurriedIn(text) {
  const names = text.split('\n').filter((line) => line && !line.startsWith('#'));
  const any = new RegExp(names.map(pattern).join('|'));
  return (name) => any.test(name);
}

if (process.argv[1]?.endsWith('outline.mjs')) {
  const [from, to, hurried] = process.argv.slice(2);
  writeFileSync(to, outline(readFileSync(from, 'utf8'), hurriedIn(readFileSync(hurried, 'utf8'))));
}
