// SPDX-License-Identifier: GPL-3.0-or-later
// What a source file of firmware/ or libraries/ remembers from call to call is in a core::FileState, so that one
// call of a test puts all of it back (libraries/core/file_state.hpp). Prints every variable of a file
// or function that is not, and fails. Constants and what survives a reset (.noinit) are no such state.
//   node toolchain/check/file_states.mjs [ROOT]
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { codeOf } from '../mutate_tool/code.mjs';
import { closingBrace } from './lengths.mjs';

const root = resolve(process.argv[2] ?? join(dirname(fileURLToPath(import.meta.url)), '../..'));

const kAttribute = /__attribute__\s*\(\(.*?\)\)|\balignas\s*\([^)]*\)/g;
const kIsValue = /^(?!(?:bool|text|int|float|void|\w+_t)$)(?:k[A-Z]\w*|[a-z]\w*)$/;

// T name(value, value); of a function each argument would be a type.
const initialised = (parameters) => parameters.trim() !== '' &&
  parameters.split(',').every((each) => kIsValue.test(each.trim()));

// Is this declaration, its braces empty, one of a variable that may change?
export function isMutable(declaration) {
  if (/section\s*\(\s*"?\s*\.?\w*"?\s*\)/.test(declaration)) return false;
  const text = declaration.replace(kAttribute, '').replace(/\s+/g, ' ').trim();
  if (text === '' || /\bcore::FileState</.test(text)) return false;
  if (/^(?:using|static_assert|extern|typedef|friend|template)\b/.test(text)) return false;
  if (/^(?:enum|struct|class|union)\b/.test(text)) return (text.includes('{}') ? /\} ?\w/ : /^\w+ (?!class )\w+ \w/).test(text);
  if (/\bconstexpr\b/.test(text)) return false;
  const pointer = /^(?:static )?const\b[^=(]*\*/.test(text) && !/\* ?const\b/.test(text);
  if (/^(?:static )?const\b/.test(text) && !pointer) return false;
  if (/\(\s*\*\s*(?!const\b)\w+\s*\)\s*\(/.test(text)) return true;  // a pointer to a function
  const before_value = text.split(/[={]/)[0];
  const open = before_value.indexOf('(');
  return open < 0 || initialised(before_value.slice(open + 1, before_value.lastIndexOf(')')));
}

const kIsBody = /\)\s*(?:const|noexcept|override|->[^;{}]*|:[^:][^;]*|\s)*$/;

// Lines of the variables of a file, and of the static ones in its functions.
export function looseVariables(source) {
  const text = codeOf(source.replace(/\bchar\b/g, 'text'));  // of a char array codeOf leaves nothing
  const found = [];
  const lineOf = (at) => text.slice(0, at).split('\n').length;
  let begin = 0, head = '';
  const next = (at) => { begin = at + 1; head = ''; };
  for (let at = 0; at < text.length; ++at) {
    if (text[at] === ';') {
      if (isMutable(head)) found.push(lineOf(begin + text.slice(begin).search(/\S/)));
      next(at);
    } else if (text[at] === '}') {
      next(at);
    } else if (text[at] !== '{') {
      head += text[at];
    } else if (/\b(?:namespace|extern)\b[^()]*$/.test(head)) {
      next(at);
    } else {
      const close = closingBrace(text, at);
      for (const each of text.slice(at, close).matchAll(/\bstatic\s[^;{]*/g))
        if (isMutable(each[0].replace(/^static\s+/, ''))) found.push(lineOf(at + each.index));
      head += '{}';
      at = close;
      if (kIsBody.test(head.slice(0, -2).replace(kAttribute, '')) && !/=/.test(head.split('(')[0])) next(at);
    }
  }
  return found;
}

function* sources(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) yield* sources(path);
    else if (entry.name.endsWith('.cpp')) yield path;
  }
}

function main() {
  let failures = 0, states = 0;
  const fail = (message) => { console.log(message); ++failures; };
  for (const path of ['firmware', 'libraries'].flatMap((folder) => [...sources(join(root, folder))])) {
    const name = relative(root, path), text = readFileSync(path, 'utf8');
    states += text.match(/\bcore::FileState</g)?.length ?? 0;
    const lines = looseVariables(text);
    for (const line of lines) fail(`${name}:${line}: belongs in a core::FileState`);
  }
  console.log(`${states} states of files, ${failures} faults`);
  process.exitCode = failures === 0 && states > 0 ? 0 : 1;
}

if (process.argv[1]?.endsWith('file_states.mjs')) main();
