// SPDX-License-Identifier: GPL-3.0-or-later
// Words that this project has replaced by those of the field (send, report, accept, measure, check,
// damage) do not come back in the sources and the documents. This file alone names the old ones.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const retired = [
  /\b(tell|tells|told|telling|tell[A-Z]\w*|\w+Told)\b/, /\bails?\b/, /\b(believ(e[sd]?|able)|doubt[s]?)\b/,
  /\bheals?\b/, /\b(feel|feels|felt|feel[A-Z]\w*)\b/, /\b(haste|hurry|hurries|slowness|pace|paces|kPace\w*)\b/,
  /\bonlooker\b/i, /\bkMost([A-Z]\w*|_\w+)?\b/, /\bkBeyond\w*\b/, /\bhand_held\b/, /\bown_airplane\b/,
  /\bservosForgotten\b/, /\bspoil(s|t|ed)?\b/i, /\b(judge[sd]?|judging|judge[A-Z]\w*)\b/, /\bkOdd([A-Z]\w*|_\w+)?\b/,
];

function* sources(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory() && entry.name !== 'node_modules') yield* sources(path);
    else if (entry.isFile() && /\.(hpp|cpp|S|mjs|ts|css|html|md|txt|cmake|sh)$|^[a-z_]+$/.test(entry.name)) yield path;
  }
}

// The names of tests are sentences with _ between the words.
export const sentences = (text) => text.replace(/(?<=\bTEST(?:_F|_P)?\()[^)]*/g, (name) => name.replaceAll('_', ' '));

export function retiredIn(text) {
  return text.split('\n').flatMap((line, index) => {
    const found = retired.map((word) => word.exec(line)?.[0]).find(Boolean);
    return found ? [`${index + 1}: ${found}`] : [];
  });
}

test('a retired word is found with its line', () => {
  assert.deepEqual(retiredIn('int a;\n// it tells the pilot\nbool kMostRows;\n'), ['2: tells', '3: kMostRows']);
  assert.deepEqual(retiredIn('// intelligent, hotels, details'), []);
  assert.deepEqual(retiredIn(sentences('TEST_F(Fence,\n  tells_the_pilot) {')), ['2: tells']);
});

for (const folder of ['firmware', 'libraries', 'hal_avr', 'simulator', 'toolchain', 'docs', 'host_tests', 'web'])
  test(`${folder} speaks the words of the field`, () => {
    const others = [...sources(join(root, folder))].filter((path) => path !== fileURLToPath(import.meta.url));
    const found = others.flatMap((path) =>
      retiredIn(sentences(readFileSync(path, 'utf8'))).map((place) => `${relative(root, path)}:${place}`));
    assert.deepEqual(found, []);
  });

// "has_a_name_of_three_words_or_more", so that the list of a program's tests reads as what it promises
export const isSentence = (name) => /^[a-z][a-z0-9]*(_[a-zA-Z0-9]+){2,}$/.test(name);

test('a name that is no sentence is found', () => {
  assert.deepEqual(['keeps_its_height', 'KeepsItsHeight', 'height', 'of_nothing'].map(isSentence),
    [true, false, false, false]);
});

test('the name of every test of a program is a sentence', () => {
  const tests = [...sources(join(root, 'host_tests'))].filter((path) => path.endsWith('.cpp'));
  const found = tests.flatMap((path) =>
    [...readFileSync(path, 'utf8').matchAll(/\bTEST(?:_F|_P)?\(\s*\w+,\s*(\w+)\)/g)]
      .filter(([, name]) => !isSentence(name)).map(([, name]) => `${relative(root, path)}: ${name}`));
  assert.deepEqual(found, []);
});

test('the two documents of the root speak them too', () => {
  const found = ['README.md', 'CONTRIBUTING.md'].filter((path) => existsSync(join(root, path)))
    .flatMap((path) => retiredIn(readFileSync(join(root, path), 'utf8')).map((place) => `${path}:${place}`));
  assert.deepEqual(found, []);
});
