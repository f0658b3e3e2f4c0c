// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { Refusal } from '../../../../toolchain/flash_tool/refusal.mjs';
import { checkFile, writeFigures } from '../../../../toolchain/self_test_tool/figures_file.mjs';

const folder = mkdtempSync(join(tmpdir(), 'self-test-'));
const limit = { text: 'at least 100' };

test('the figures of each part are written, and looking beforehand leaves nothing behind', () => {
  const path = join(folder, 'figures.json');
  checkFile(path);
  assert.equal(existsSync(path), false);
  const results = [{ title: 'compass', verdict: 'pass', values: [100], limit }, { title: 'ram', verdict: 'missing', limit }];
  writeFigures(path, { passed: false, results, report: { board: 'APM 2', unknown: ['~'] } });
  assert.deepEqual(JSON.parse(readFileSync(path, 'utf8')), { board: 'APM 2', passed: false, unknown: ['~'], parts: [
    { title: 'compass', verdict: 'pass', values: [100], limit: limit.text }, { title: 'ram', verdict: 'missing', limit: limit.text }] });
  checkFile(path);
});

test('a file that cannot be written is refused in one line, beforehand with status 2', () => {
  for (const path of [join(folder, 'none/figures.json'), folder]) {
    const refusedWith = (status) => (error) => error instanceof Refusal && error.status === status && error.message.startsWith(`${path} cannot be written: E`);
    assert.throws(() => checkFile(path), refusedWith(2));
    assert.throws(() => writeFigures(path, { passed: true, results: [], report: {} }), refusedWith(1));
  }
});
