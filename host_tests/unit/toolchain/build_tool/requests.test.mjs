// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { WrongUsage, requestsOf } from '../../../../toolchain/build_tool/requests.mjs';

test('a tree that is named twice is built once, with the targets of both', () => {
  assert.deepEqual(requestsOf(['host:fly,param_tool', 'avr:firmware_apm2', 'host:chaos,fly']), [
    { tree: 'host', targets: ['fly', 'param_tool', 'chaos'] },
    { tree: 'avr', targets: ['firmware_apm2'] },
  ]);
});

test('a tree without targets is all of it, and what is named beside it', () => {
  assert.deepEqual(requestsOf(['host']), [{ tree: 'host', targets: ['all'] }]);
  assert.deepEqual(requestsOf(['avr:cost_programs', 'avr']), [{ tree: 'avr', targets: ['cost_programs', 'all'] }]);
  assert.deepEqual(requestsOf(['avr', 'avr:cost_programs']), [{ tree: 'avr', targets: ['all', 'cost_programs'] }]);
});

test('a tree that does not exist is refused by name', () => {
  assert.throws(() => requestsOf(['hots:fly']), (error) => error instanceof WrongUsage && /hots:fly/.test(error.message));
});
