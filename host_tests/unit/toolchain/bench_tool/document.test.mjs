// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { written } from '../../../../toolchain/bench_tool/document.mjs';

test('docs/bench.md has the steps, parts and limits of the table', () => {
  const document = readFileSync(new URL('../../../../docs/bench.md', import.meta.url), 'utf8');
  assert.equal(document, written(document), 'node toolchain/bench_tool/document.mjs writes it');
  assert.notEqual(written(document.replace('4.85', '4.80')), document.replace('4.85', '4.80'));
});
