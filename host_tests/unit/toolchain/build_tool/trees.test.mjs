// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compilerCrashed } from '../../../../toolchain/build_tool/trees.mjs';

test('a crash of the compiler is no mistake in the source', () => {
  const crash = ['FAILED: apm1/firmware.elf', 'lto1: internal compiler error: Segmentation fault'];
  assert.ok(compilerCrashed({ status: 1, said: crash }));
  assert.ok(!compilerCrashed({ status: 0, said: crash }));
  assert.ok(!compilerCrashed({ status: 1, said: ['a.cpp:1:1: error: expected declaration'] }));
});
