// SPDX-License-Identifier: GPL-3.0-or-later
// The documents: every one is linked from the README, links and named files exist, and prose stays
// within 120 columns.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const kColumns = 120;
const manuals = readdirSync(join(root, 'docs')).filter((name) => name.endsWith('.md')).map((name) => `docs/${name}`);
const documents = ['README.md', 'CONTRIBUTING.md', ...manuals].filter((path) => existsSync(join(root, path)));
const read = (path) => readFileSync(join(root, path), 'utf8');

// The lines that are prose, with their numbers: no code blocks, fenced or indented, and no tables.
export function prose(text) {
  let fenced = false, listed = false;
  return text.split('\n').map((line, index) => ({ line, number: index + 1 })).filter(({ line }) => {
    if (line.startsWith('```')) fenced = !fenced;
    if (fenced || line.startsWith('```') || line.startsWith('|')) return false;
    if (/^\s*([-*]|\d+\.) /.test(line)) listed = true;
    else if (/^\S/.test(line)) listed = false;
    return listed || !/^ {4}/.test(line);
  });
}

export const tooLong = (text) => prose(text).filter(({ line }) => [...line].length > kColumns)
  .map(({ number, line }) => `${number} (${[...line].length})`);

// [text](target) and ![text](target), but for those to elsewhere.
export const localLinks = (text) => [...text.matchAll(/\]\(([^)\s]+)\)/g)].map(([, target]) => target)
  .filter((target) => !/^[a-z]+:/.test(target));

// As GitHub makes an anchor of a heading.
export const anchors = (text) => [...text.matchAll(/^#+ (.*)$/gm)]
  .map(([, heading]) => heading.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '').replace(/ /g, '-'));

export function brokenLinks(path) {
  return localLinks(read(path)).filter((target) => {
    const [file, anchor] = target.split('#');
    const found = file ? join(dirname(path), file) : path;
    if (!existsSync(join(root, found))) return true;
    return Boolean(anchor) && !anchors(read(found)).includes(anchor);
  });
}

// Words in backticks that look like a file or folder of this repository, build/ left out: they
// begin with one of its folders, or are a name with an ending that lies in the root.
const folders = readdirSync(root, { withFileTypes: true }).filter((entry) => entry.isDirectory())
  .map(({ name }) => name).filter((name) => !['.git', 'build'].includes(name));
export function namedFiles(text) {
  return [...text.matchAll(/`([^`\n]+)`/g)].flatMap(([, code]) => code.split(/\s+/))
    .filter((word) => folders.includes(word.split('/')[0]) && word.includes('/') && !/[*…<>]/.test(word))
    .map((word) => word.replace(/[.,;:]+$/, ''));
}

test('every document of docs/ is linked from the README', () => {
  const linked = new Set(localLinks(read('README.md')).map((target) => target.split('#')[0]));
  assert.deepEqual(manuals.filter((path) => !linked.has(path)), []);
});

for (const path of documents) {
  test(`${path}: no line of prose is past ${kColumns} columns`, () => {
    assert.deepEqual(tooLong(read(path)), []);
  });
  test(`${path}: every local link leads somewhere`, () => {
    assert.deepEqual(brokenLinks(path), []);
  });
  test(`${path}: every file that is named exists`, () => {
    assert.deepEqual(namedFiles(read(path)).filter((name) => !existsSync(join(root, name))), []);
  });
}

test('the README has no line past the limit in code blocks either', () => {
  const long = read('README.md').split('\n').filter((line) => [...line].length > kColumns);
  assert.deepEqual(long, []);
});

test('what the checks look for is found', () => {
  const long = 'x'.repeat(kColumns + 1);
  assert.equal(tooLong(`${long}\n| ${long} |\n\n    ${long}\n\`\`\`\n${long}\n\`\`\`\n- a\n    ${long}`).length, 2);
  assert.deepEqual(localLinks('[a](b.md#c) ![d](e.svg) [f](https://g)'), ['b.md#c', 'e.svg']);
  assert.deepEqual(anchors('# How a LAND is flown, 2\n## `x`: y'), ['how-a-land-is-flown-2', 'x-y']);
  assert.deepEqual(namedFiles('`toolchain/none --option` and `docs/none.md`, `build/x`, `a/b`'),
    ['toolchain/none', 'docs/none.md']);
});
