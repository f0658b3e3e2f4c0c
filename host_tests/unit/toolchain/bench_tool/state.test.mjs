// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { chmodSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { loadState, saveState, stateFile, writeWhole } from '../../../../toolchain/bench_tool/state.mjs';

const whose = { board: 'apm2', name: 'x' };
const folder = () => mkdtempSync(join(tmpdir(), 'bench-state-'));

test('a new one is empty, a saved one comes back', () => {
  const here = folder();
  const state = loadState(here, whose);
  assert.deepEqual(state.steps, {});
  state.steps[3] = { verdict: 'fail', parts: [] };
  state.restore.LOG_BITMASK = 7;
  saveState(here, state);
  assert.deepEqual(loadState(here, whose), state);
});

for (const [what, text] of [['empty', ''], ['torn', '{"kind": "bench session", "ver'], ['a list', '[]'], ['null', 'null'], ['another tool\'s', '{"kind":"flight"}'],
  ['a later version', '{"kind":"bench session","version":2}'], ['without steps', '{"kind":"bench session","version":1,"steps":null,"restore":{}}'],
  ['with a wrong verdict', '{"kind":"bench session","version":1,"steps":{"1":{"verdict":"good","parts":[]}},"restore":{}}'],
  ['with a wrong step', '{"kind":"bench session","version":1,"steps":{"x":{"verdict":"pass","parts":[]}},"restore":{}}'],
  ['without what to restore', '{"kind":"bench session","version":1,"steps":{}}'],
  ['another board\'s', '{"kind":"bench session","version":1,"board":"apm1","name":"x","steps":{},"restore":{}}']])
  test(`a file that is ${what} is refused and left alone`, () => {
    const here = folder();
    writeFileSync(stateFile(here), text);
    assert.throws(() => loadState(here, whose), /session\.json .*(move it away)/);
    assert.equal(readFileSync(stateFile(here), 'utf8'), text);
  });

test('a file that cannot be written is one line', () => {
  assert.throws(() => writeWhole('/proc/none/x', 'x'), /\/proc\/none\/x cannot be written/);
  const here = folder();
  writeFileSync(stateFile(here), 'old');
  chmodSync(here, 0o700);
  writeWhole(stateFile(here), 'new');
  assert.equal(readFileSync(stateFile(here), 'utf8'), 'new');
});
