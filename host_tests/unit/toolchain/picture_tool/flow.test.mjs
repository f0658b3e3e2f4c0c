// SPDX-License-Identifier: GPL-3.0-or-later
// docs/architecture.svg is what docs/architecture.txt says, and what that names is in the sources.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

import { drawing, read } from '../../../../toolchain/picture_tool/flow.mjs';

const root = new URL('../../../../', import.meta.url);
const file = (path) => readFileSync(new URL(path, root), 'utf8');
const source = file('docs/architecture.txt');

function* headersAndSources(folder) {
  for (const entry of readdirSync(new URL(folder, root), { withFileTypes: true }))
    if (entry.isDirectory()) yield* headersAndSources(`${folder}${entry.name}/`);
    else if (/\.[hc]pp$/.test(entry.name)) yield file(folder + entry.name);
}
const code = ['firmware/', 'libraries/'].flatMap((folder) => [...headersAndSources(folder)]).join('\n');

test('docs/architecture.svg is what is drawn', () => {
  assert.equal(file('docs/architecture.svg'), drawing(source), 'node toolchain/picture_tool/flow.mjs docs/architecture.txt');
});

test('the functions, members and tables in the boxes are in the sources', () => {
  const lines = read(source).flows.flatMap((flow) => flow.boxes).flatMap((box) => box.lines);
  const names = lines.flatMap((line) => [...line.matchAll(/(\w+)\(\)|vehicle\.(\w+)|\b(k[A-Z]\w+)|::([A-Z]\w+)/g)])
    .map((found) => found.slice(1).find(Boolean));
  assert.ok(names.length > 20);
  assert.deepEqual(names.filter((name) => !new RegExp(`\\b${name}\\b`).test(code)), []);
});

test('a wrong line is an error with its number', () => {
  assert.throws(() => read('title: a\nBox | line\n'), /line 2: there is no "flow: "/);
  assert.throws(() => read('title: a\nflow: b | c\nBox | 1 | 2 | 3 | 4\n'), /line 3: "Box" has 4 lines/);
  assert.throws(() => read('title: a\nflow: b | c\nBox | a line that is far longer than its box\n'), /line 3: .*longer than/);
  assert.throws(() => read('title: a\nflow: b | c\nBox | 1\nback: Box > Other | no\n'), /line 4: no boxes/);
  assert.throws(() => read('flow: b | c\nBox | 1\n'), /no title/);
});
