// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { edited, filesOf, kBugs } from '../../../../toolchain/known_bugs_tool/bugs.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
const textOf = (path) => readFileSync(join(root, path), 'utf8');

test('each bug can still be put back', () => {
  for (const bug of kBugs)
    for (const file of filesOf(bug)) assert.notEqual(edited(textOf(file), file, bug.edits), textOf(file));
});

test('each violates an invariant that there is', () => {
  const names = [...textOf('simulator/invariants/watch.cpp').matchAll(/\{"(\w+)",/g)].map(([, name]) => name);
  assert.ok(names.length > 8);
  for (const { name, violates } of kBugs)
    for (const each of violates) assert.ok(names.includes(each), `${name}: ${each}`);
});

test('an edit has one place', () => {
  const edits = [{ file: 'a', from: 'one', to: '$1' }, { file: 'b', from: 'two', to: '' }];
  assert.equal(edited('one two', 'a', edits), '$1 two');
  assert.equal(edited('one two', 'b', edits), 'one ');
  assert.throws(() => edited('two', 'a', edits), /a: 0 times: one/);
  assert.throws(() => edited('one one', 'a', edits), /a: 2 times: one/);
});
