// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { climb_m, deviation, heading_deg, percentOff, singleDips, wrapped_deg } from '../../../../toolchain/bench_tool/figures.mjs';

const near = (value, wanted, by = 0.1) => assert.ok(Math.abs(value - wanted) < by, `${value} is not ${wanted}`);

test('a metre of air at sea level is 12 Pa', () => near(climb_m(101325, 101325 - 12.01, 15), 1, 0.005));
test('the spread of two values', () => assert.equal(deviation([1, 3]), 1));
test('percent of the true value', () => near(percentOff(4.75, 5), -5, 1e-9));
test('angles wrap', () => {
  for (const [angle, wanted] of [[190, -170], [-190, 170], [360, 0], [45, 45], [-725, -5]]) assert.equal(wrapped_deg(angle), wanted);
});

// The field of Zürich, turned into the body: rolled first about x, then yawed.
test('headings of a field, level and rolled', () => {
  const north = 215, down = 434;
  for (const heading of [0, 90, 180, 270])
    for (const roll of [0, Math.PI / 4]) {
      const angle = heading * Math.PI / 180;
      const level = { x: north * Math.cos(angle), y: -north * Math.sin(angle), z: down };
      const body = { x: level.x, y: level.y * Math.cos(roll) + level.z * Math.sin(roll), z: -level.y * Math.sin(roll) + level.z * Math.cos(roll) };
      near(wrapped_deg(heading_deg(body, roll, 0) - heading), 0, 1e-6);
    }
  near(heading_deg({ x: 0, y: 215, z: 434 }, 0, 0), 270, 1e-6);
});

test('single readings that stand out are counted, steps and noise are not', () => {
  const flat = Array.from({ length: 50 }, (_, i) => (i % 2) * 3);
  assert.equal(singleDips(flat, 50).length, 0);
  const dipped = [...flat];
  dipped[20] = -280;
  dipped[40] = -280;
  assert.deepEqual(singleDips(dipped, 50), [-280, -280]);
  assert.equal(singleDips([...flat, ...flat.map((each) => each + 500)], 50).length, 0, 'a step');
});
