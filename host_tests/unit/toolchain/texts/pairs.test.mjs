// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { kHeaders, packedSize, pairsFor, stored, textsOf } from '../../../../toolchain/texts/pairs.mjs';

const bytes = (texts, pairs) => packedSize(texts, pairs) + 2 * pairs.length;

for (const header of kHeaders) {
  test(`the pairs of ${header.file} are nearly the best for today's texts`, () => {
    const texts = header.texts(), now = bytes(texts, stored(header)), best = bytes(texts, pairsFor(texts));
    assert.ok(texts.length > 40, `${texts.length} texts found`);
    assert.ok(now <= best * 1.03, `${now} B, ${best} B with new ones: node toolchain/texts/main.mjs`);
  });
}

test('texts are found in calls, over lines, and in the rows of tables, and names and comments are not', () => {
  const source = `
// STATUS_TEXT("not this one")
#include "nor this"
    sendStatusText(a ? STATUS_TEXT("one # %") : STATUS_TEXT("two "
                                                           "halves"));
    {kBit, f, "a row", nullptr},
    "a row of one",
    {"NAME", 3},
`;
  assert.deepEqual(textsOf(source), ['one # %', 'two halves', 'a row', 'a row of one']);
});

test('a pair is joined from left to right, and a pair of pairs later', () => {
  assert.equal(packedSize(['aaa'], [[97, 97]]), 2);
  assert.equal(packedSize(['abab'], [[97, 98], [0x80, 0x80]]), 1);
  assert.deepEqual(pairsFor(['abab', 'ab']), [[97, 98]]);
});
