// SPDX-License-Identifier: GPL-3.0-or-later
// What of a C++ text is code that a mutation may change: everything else becomes spaces, so that
// every place stays where it is.
const kBlank = /[^\n]/g;
const blank = (text) => text.replace(kBlank, ' ');

// Comments, strings, characters and lines of the preprocessor. A ' between digits is no character.
const kNoCode = new RegExp([
  /\/\/(?:\\\n|[^\n])*/, /\/\*[\s\S]*?\*\//,
  /R"([^(\s]*)\([\s\S]*?\)\1"/, /"(?:\\.|[^"\\\n])*"/, /(?<![0-9a-fA-F])'(?:\\[^\n]+?|[^'\\\n])'/,
  /^[ \t]*#(?:\\\n|[^\n])*/,
].map(({ source }) => source).join('|'), 'gm');

// Checked by the compiler, or texts: a mutation of it would say nothing about a test.
const kCalls = /\b(?:static_assert|STATUS_TEXT|PSTR)\s*\(/g;

// The place behind the bracket that closes the one at `open`.
export function closing(text, open) {
  let depth = 0;
  for (let at = open; at < text.length; ++at) {
    if (text[at] === '(') ++depth;
    if (text[at] === ')' && --depth === 0) return at + 1;
  }
  return text.length;
}

function withoutCalls(text) {
  let result = text;
  for (const call of text.matchAll(kCalls)) {
    const end = closing(text, call.index + call[0].length - 1);
    result = result.slice(0, call.index) + blank(result.slice(call.index, end)) + result.slice(end);
  }
  return result;
}

// How long a text may be, and how many bits a boolean has.
const kSizes = /\bchar \w+(?:\[[^\]\n]*\])+|\bbool \w+ : \d+/g;

export const codeOf = (text) => withoutCalls(text.replace(kNoCode, blank)).replace(kSizes, blank);
