// SPDX-License-Identifier: GPL-3.0-or-later
// How long the functions of the firmware and its libraries are, from the first line of the
// declaration to the closing brace, and how many lines of source each folder has. Fails when the
// functions are longer than the limits allow.
//   node toolchain/check/lengths.mjs
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

import { codeOf } from '../mutate_tool/code.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');

export const kLimits = { median: 5, p90: 15, max: 60 };
const kMeasured = ['firmware', 'libraries'];
const kCounted = ['firmware', 'libraries', 'hal_avr', 'simulator', 'toolchain', 'host_tests', 'docs'];
const kSource = /\.(hpp|cpp|S|mjs|cmake|sh|md)$|^[a-z_]+$/;

export function closingBrace(text, open) {
  let depth = 0;
  for (let at = open; at < text.length; ++at) {
    if (text[at] === '{') ++depth;
    if (text[at] === '}' && --depth === 0) return at;
  }
  return text.length - 1;
}

const kHoldsFunctions = /\b(?:namespace|class|struct|union|extern)\b[^()]*$/;
const kIsFunction = /\)\s*(?:const|noexcept|override|final|volatile|&|->[^;{}]*|:[^:][^;]*|\s)*$/;
const endsMemberInitialiser = (text, close) => /^\s*[,{]/.test(text.slice(close + 1, close + 200));

// { line, length } of each function with a body. A lambda or local class belongs to the function
// around it.
export function functionsIn(source) {
  const text = codeOf(source);
  const found = [];
  const lineOf = (at) => text.slice(0, at).split('\n').length;
  let begin = 0;  // of the present declaration
  for (let at = 0; at < text.length; ++at) {
    if (text[at] === ';' || text[at] === '}') begin = at + 1;
    if (text[at] !== '{') continue;
    const head = text.slice(begin, at).replace(/\b(?:public|private|protected)\s*:/g, '');
    if (kHoldsFunctions.test(head.replace(/\balignas\s*\([^)]*\)|__attribute__\s*\(\(.*?\)\)/g, ''))) {
      begin = at + 1;
      continue;
    }
    const close = closingBrace(text, at);
    if (kIsFunction.test(head) && !/=\s*$/.test(head)) {
      if (!endsMemberInitialiser(text, close)) {
        const first = lineOf(begin + /^(?:\s|\b(?:public|private|protected)\s*:)*/.exec(text.slice(begin))[0].length);
        found.push({ line: first, length: lineOf(close) - first + 1 });
        begin = close + 1;
      }
    }
    at = close;
  }
  return found;
}

export function figuresOf(lengths) {
  const sorted = [...lengths].sort((a, b) => a - b);
  const at = (share) => sorted[Math.max(0, Math.ceil(share * sorted.length) - 1)];
  return { count: sorted.length, median: at(0.5), p90: at(0.9), max: at(1) };
}

export const exceeded = (figures) => Object.keys(kLimits).filter((name) => figures[name] > kLimits[name]);

function* files(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory() && entry.name !== 'node_modules') yield* files(path);
    else if (entry.isFile() && kSource.test(entry.name)) yield path;
  }
}

const functionsOf = (folder) => [...files(join(root, folder))].filter((path) => /\.[hc]pp$/.test(path))
  .flatMap((path) => functionsIn(readFileSync(path, 'utf8')).map((each) => ({ ...each, path: relative(root, path) })));

// Prints the figures of these functions and returns them.
function show(name, functions) {
  const figures = figuresOf(functions.map(({ length }) => length));
  const { path, line } = functions.reduce((longest, each) => (each.length > longest.length ? each : longest));
  console.log(`${name}: ${figures.count} functions; median ${figures.median} lines, 90 % at most ${figures.p90}, ` +
    `longest ${figures.max} (${path}:${line})`);
  return figures;
}

function main() {
  const functions = new Map(kMeasured.map((folder) => [folder, functionsOf(folder)]));
  for (const [folder, each] of functions) show(folder, each);
  const figures = show('together', [...functions.values()].flat());
  for (const folder of kCounted) {
    const paths = [...files(join(root, folder))];
    const lines = paths.reduce((sum, path) => sum + readFileSync(path, 'utf8').split('\n').length - 1, 0);
    console.log(`${folder}: ${lines} lines in ${paths.length} files`);
  }
  for (const name of exceeded(figures)) {
    console.log(`together: ${name} is ${figures[name]} lines, its limit ${kLimits[name]}`);
    process.exitCode = 1;
  }
}

if (process.argv[1]?.endsWith('lengths.mjs')) main();
