// SPDX-License-Identifier: GPL-3.0-or-later
// The mutations of a C++ text: each a small mistake as people make them, on one line. Operators are
// recognised by the blanks that clang-format puts around them, which templates and references have
// not.
import { closing, codeOf } from './code.mjs';

const kOperators = {
  '<': ['<=', '>='], '<=': ['<', '>'], '>': ['>=', '<='], '>=': ['>', '<'], '==': ['!='], '!=': ['=='],
  '&&': ['||'], '||': ['&&'], '+': ['-'], '-': ['+'], '+=': ['-='], '-=': ['+='],
};
const kBinary = /(?<=[^\s(,] )(<=|>=|==|!=|&&|\|\||\+=|-=|<|>|\+|-)(?=\s)/g;
const kNegative = /(?<=[(,=?:{[<>+*/&|] ?|\breturn )-(?=[\w.(])/g;
const kSteps = /\+\+|--/g;
const kNot = /!(?=[\w(!])/g;
const kBooleans = /\b(?:true|false)\b/g;
const kNumber = /(?<![\w.'])(?:0[xX][0-9a-fA-F']+|(?:\d[\d']*\.?[\d']*|\.\d+)(?:[eE][-+]?\d+)?)([a-zA-Z]*)(?![\w.'])/g;
const kIf = /\bif \(/g;
const kLeaves = /^\s*(?:return|continue|break)\b/;
const kDeclares = /[^=!<>+*/&|-]=[^=]/;  // if (const auto x = ...)
const kCompares = /[<>=!&|]/;

const places = (code, pattern) => [...code.matchAll(pattern)]
  .map((match) => ({ at: match.index, end: match.index + match[0].length, match }));

const operators = (code) => places(code, kBinary)
  .flatMap((place) => kOperators[place.match[1]].map((to) => ({ ...place, to })));

const negations = (code) => [
  ...places(code, kNegative).map((place) => ({ ...place, to: '' })),
  ...places(code, kNot).map((place) => ({ ...place, to: '' })),
  ...places(code, kBooleans).map((place) => ({ ...place, to: place.match[0] === 'true' ? 'false' : 'true' })),
];

const steps = (code) => places(code, kSteps).map((place) => ({ ...place, to: place.match[0] === '++' ? '--' : '++' }));

const kDecimals = 9;  // more than a float has

function timesFour(digits) {
  const plain = digits.replaceAll("'", '');
  if (/^0x/i.test(plain)) return `0x${(4n * BigInt(plain)).toString(16)}`;
  if (/^\d+$/.test(plain)) return (4n * BigInt(plain)).toString();
  const value = Number((4 * Number(plain)).toPrecision(kDecimals)).toString();
  return /[.e]/.test(value) ? value : `${value}.0`;
}

// A suffix of its own, as in 1.5_m, or octal digits are left alone.
function constants(code) {
  return places(code, kNumber).flatMap((place) => {
    const suffix = /^0x/i.test(place.match[0]) ? '' : place.match[1];
    const digits = place.match[0].slice(0, place.match[0].length - suffix.length);
    if (!/^(|[fFlL]|[uU]?[lL]{0,2})$/.test(suffix) || /^0\d/.test(digits)) return [];
    if (Number(digits.replaceAll("'", '')) === 0) return [];
    const zero = /^[\d']+$|^0x/i.test(digits) ? '0' : '0.0';
    return [timesFour(digits), zero].map((to) => ({ ...place, to: to + suffix }));
  });
}

// A guard that never holds: its condition stays in use, so that no warning about it fails the build.
// And a plain condition that holds when it should not.
function conditions(code) {
  return places(code, kIf).flatMap(({ end }) => {
    const close = closing(code, end - 1) - 1, condition = code.slice(end, close);
    if (condition.includes('\n') || kDeclares.test(condition)) return [];
    const mutations = [];
    if (kLeaves.test(code.slice(close + 1)))
      mutations.push({ at: end, end: close, wrap: ['false && (', ')'], deletes: true });
    if (!kCompares.test(condition)) mutations.push({ at: end, end: close, wrap: ['!(', ')'] });
    return mutations;
  });
}

function lineStarts(text) {
  const starts = [0];
  for (const { index } of text.matchAll(/\n/g)) starts.push(index + 1);
  return starts;
}

// [{ line, before, after, at, end, to }]: the line's number and its text before and after, trimmed;
// `to` stands for the text from `at` to `end`. In the order of the text.
export function mutationsIn(text) {
  const code = codeOf(text), starts = lineStarts(text), lines = text.split('\n');
  const kinds = [operators, negations, steps, constants, conditions];
  return kinds.flatMap((kind) => kind(code)).sort((a, b) => a.at - b.at || a.end - b.end)
    .map(({ at, end, to, wrap, deletes }) => {
      const replaced = wrap ? wrap[0] + text.slice(at, end) + wrap[1] : to;
      const line = starts.findLastIndex((start) => start <= at);
      const whole = lines[line], from = at - starts[line];
      const changed = whole.slice(0, from) + replaced + whole.slice(end - starts[line]);
      return { line: line + 1, before: whole.trim(), after: deletes ? '(guard deleted)' : changed.trim(),
        at, end, to: replaced };
    });
}

export const mutated = (text, { at, end, to }) => text.slice(0, at) + to + text.slice(end);

// Numbers from 0 to 1 that are the same for the same seed (the generator is called mulberry32).
export function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

// `count` of them, the same for the same seed, in their order.
export function sample(all, count, seed) {
  const random = randomFrom(seed), numbers = all.map((_, i) => i);
  for (let i = 0; i < Math.min(count, all.length); ++i) {
    const j = i + Math.floor(random() * (numbers.length - i));
    [numbers[i], numbers[j]] = [numbers[j], numbers[i]];
  }
  return numbers.slice(0, count).sort((a, b) => a - b).map((i) => all[i]);
}
