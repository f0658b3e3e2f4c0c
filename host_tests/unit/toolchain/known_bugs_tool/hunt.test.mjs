// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { foundIn, verdictOf } from '../../../../toolchain/known_bugs_tool/hunt.mjs';

const bug = { name: 'S9', violates: ['late_frame', 'mission_jump'] };
const flight = (seed, ...names) => ({ seed, violations: names.map((name) => ({ time_s: 1, name, numbers: `by ${seed}` })) });

test('a bug is found by the first flight that violates one of its invariants', () => {
  const document = { flights: [flight(4), flight(5, 'crashed'), flight(6, 'crashed', 'mission_jump'), flight(7, 'late_frame')] };
  assert.deepEqual(foundIn(document, bug.violates), { seed: 6, line: 'mission_jump: by 6' });
  assert.equal(foundIn(document, ['armed_by_itself']), undefined);
  assert.equal(foundIn({ flights: [] }, bug.violates), undefined);
});

test('the verdict has the flights that it took', () => {
  assert.equal(verdictOf(bug, { flights: 3, found: { seed: 6, line: 'mission_jump: by 6' } }),
    'S9  found after 3 flights, seed 6: mission_jump: by 6');
  assert.equal(verdictOf(bug, { flights: 10 }), 'S9  not found in 10 flights (late_frame, mission_jump)');
});
