// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a self-test as JSON, --out.
import { accessSync, constants, statSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';

import { Refusal } from '../flash_tool/refusal.mjs';

const refused = (path, error, status) => new Refusal(`${path} cannot be written: ${error.code}`, status);

// Before the board is touched, rather than after the test.
export function checkFile(path) {
  try {
    const there = statSync(path, { throwIfNoEntry: false });
    if (there?.isDirectory()) throw Object.assign(new Error(), { code: 'EISDIR' });
    accessSync(there ? path : dirname(path), constants.W_OK);
  } catch (error) {
    throw refused(path, error, 2);
  }
}

export function writeFigures(path, { report, results, passed }) {
  const parts = results.map(({ title, verdict, values, limit }) => ({ title, verdict, values, limit: limit.text }));
  const text = JSON.stringify({ board: report.board, passed, unknown: report.unknown, parts }, null, 2);
  try {
    writeFileSync(path, `${text}\n`);
  } catch (error) {
    throw refused(path, error, 1);
  }
}
