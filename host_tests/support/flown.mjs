// SPDX-License-Identifier: GPL-3.0-or-later
// Flies natively with the program that FLY names, and gives the rows of flight.csv.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

// Objects of numbers by the names of the columns; a flight that fails fails the test. The report's
// folder is `out`.
export function flown(out, options) {
  const { status, stdout } = spawnSync(process.env.FLY, ['--native', ...options, '--out', out], { encoding: 'utf8' });
  assert.equal(status, 0, stdout);
  const [head, ...rows] = readFileSync(join(out, 'flight.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  return rows.map((row) => Object.fromEntries(head.map((column, at) => [column, Number(row[at])])));
}
