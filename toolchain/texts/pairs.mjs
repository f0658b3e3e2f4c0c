// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the pairs by which texts are packed into the image (core/packed_text.hpp) and writes them
// into three headers: for the texts to the pilot, for the log's formats and for the names of
// parameters. Any pairs are right; the nearer to today's texts, the smaller the image.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kFirstPair = 0x80;
const kPairs = 128;  // codes above kFirstPair
const kDeepest = 8;  // kPairsDeep of core/packed_text.hpp
const kWorth = 3;    // a pair takes two bytes itself

const unquoted = (literals) => [...literals.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, text]) => text).join('');

// What STATUS_TEXT("...") and the rows of tables hold.
export function textsOf(source) {
  const code = source.replace(/^\s*(#|\/\/).*$/gm, '');
  const called = [...code.matchAll(/STATUS_TEXT\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\)/g)].map(([, literals]) => unquoted(literals));
  const rows = [...code.matchAll(/^ {4}[{"].*$/gm)].flatMap(([row]) => [...row.matchAll(/"(?:[^"\\]|\\.)*"/g)].map(([literal]) => unquoted(literal)));
  return [...called, ...rows.filter((text) => / /.test(text))];
}

export function statusTexts() {
  const folder = join(root, 'firmware');
  const files = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith('.cpp')).sort();
  return files.flatMap((name) => textsOf(readFileSync(join(folder, name), 'utf8')));
}

export function parameterNames() {
  const [, ...rows] = readFileSync(join(root, 'firmware/state/parameters.csv'), 'utf8').trim().split('\n');
  return rows.map((row) => row.split(',')[0]);
}

// The rows of the log's formats, and its units.
export function formatTexts() {
  const source = readFileSync(join(root, 'firmware/logger/records.cpp'), 'utf8');
  const table = source.slice(source.indexOf('kShapes[kFormats] = {'), source.indexOf('// clang-format on'));
  return [...table.matchAll(/"([^"]+)"/g)].map(([, text]) => text);
}

function joined(codes, [first, second], code) {
  const to = [];
  for (let i = 0; i < codes.length; ++i) {
    const is = codes[i] === first && codes[i + 1] === second;
    to.push(is ? code : codes[i]);
    if (is) ++i;
  }
  return to;
}

function mostFrequent(texts, depth) {
  const counts = new Map();
  for (const codes of texts) {
    for (let i = 0; i + 1 < codes.length; ++i) {
      const key = codes[i] * 256 + codes[i + 1];
      counts.set(key, (counts.get(key) ?? 0) + 1);
      if (codes[i] === codes[i + 1] && codes[i] === codes[i + 2]) ++i;  // "###" holds one pair
    }
  }
  const fits = (key) => Math.max(depth(key >> 8) + 1, depth(key & 255)) <= kDeepest;
  const [best] = [...counts].filter(([key, times]) => times >= kWorth && fits(key)).sort(([a, m], [b, n]) => n - m || a - b);
  return best && [best[0] >> 8, best[0] & 255];
}

// Joins what is most frequent, again and again.
export function pairsFor(texts) {
  let packed = texts.map((text) => [...Buffer.from(text, 'latin1')]);
  const pairs = [], depths = [];
  const depth = (code) => (code < kFirstPair ? 0 : depths[code - kFirstPair]);
  while (pairs.length < kPairs) {
    const pair = mostFrequent(packed, depth);
    if (!pair) break;
    packed = packed.map((codes) => joined(codes, pair, kFirstPair + pairs.length));
    depths.push(Math.max(depth(pair[0]) + 1, depth(pair[1])));
    pairs.push(pair);
  }
  return pairs;
}

export const packedSize = (texts, pairs) => texts.reduce((sum, text) =>
  sum + pairs.reduce((codes, pair, i) => joined(codes, pair, kFirstPair + i), [...Buffer.from(text, 'latin1')]).length, 0);

const codeOf = (code) => (code >= kFirstPair ? `0x${code.toString(16).toUpperCase()}` : code === 39 ? "'\\''" : `'${String.fromCharCode(code)}'`);

function header({ namespace, name, of, pairs }) {
  const rows = [];
  for (const pair of pairs.map((codes) => `{${codes.map(codeOf).join(', ')}},`)) {
    if (rows.length > 0 && rows.at(-1).length + pair.length + 1 <= 96) rows[rows.length - 1] += ` ${pair}`;
    else rows.push(`    ${pair}`);
  }
  return `// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs by which ${of} are packed, code 0x80 and on.
// Made by toolchain/texts/main.mjs.
#pragma once
#include "core/packed_text.hpp"

namespace firmware {
namespace ${namespace} {

// Only for the compiler: what is read in flight lies in flash.
// clang-format off
constexpr core::CodePair ${name}[] = {
${rows.join('\n')}
};
// clang-format on

}  // namespace ${namespace}
}  // namespace firmware
`;
}

export const kHeaders = [
  { file: 'firmware/notify/text_pairs.hpp', namespace: 'notify', name: 'kTextPairs', of: 'the texts to the pilot', texts: statusTexts },
  { file: 'firmware/logger/format_pairs.hpp', namespace: 'logger', name: 'kFormatPairs', of: "the log's formats and units", texts: formatTexts },
  { file: 'firmware/state/name_pairs.hpp', namespace: 'state', name: 'kNamePairs', of: "the parameters' names", texts: parameterNames },
];

export function pairsIn(text) {
  const code = (word) => (word.startsWith('0x') ? Number(word) : word.replace(/^'\\?(.)'$/, '$1').charCodeAt(0));
  return [...text.matchAll(/\{('(?:\\.|[^'])'|0x[0-9A-F]{2}), ('(?:\\.|[^'])'|0x[0-9A-F]{2})\}/g)].map(([, first, second]) => [code(first), code(second)]);
}
export const stored = ({ file }) => pairsIn(readFileSync(join(root, file), 'utf8'));

export function write() {
  for (const to of kHeaders) writeFileSync(join(root, to.file), header({ ...to, pairs: pairsFor(to.texts()) }));
}
