// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

import { drawing, read } from '../../../../toolchain/picture_tool/wiring.mjs';

const folder = new URL('../../../../docs/wiring/', import.meta.url);
const file = (name) => readFileSync(new URL(name, folder), 'utf8');
const sources = readdirSync(folder).filter((name) => name.endsWith('.txt'));

for (const name of sources)
  test(`docs/wiring/${name} is what is drawn`, () => {
    assert.equal(file(name.replace('.txt', '.svg')), drawing(file(name)), 'node toolchain/picture_tool/wiring.mjs docs/wiring/*.txt');
  });

test('every line fits into its box', () => {
  for (const name of sources) for (const { device } of ['left', 'right'].flatMap((side) => read(file(name))[side])) assert.ok(device.length <= 88, device);
});

test('a wrong line is an error with its number', () => {
  assert.throws(() => read('title: a\nboard: b\nleft | x | y | rope\n'), /line 3/);
  assert.throws(() => read('left | x | y | bus\n'), /no title/);
});
