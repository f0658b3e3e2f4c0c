// SPDX-License-Identifier: GPL-3.0-or-later
// No name without an effect: the field behind every row of the parameter table is read somewhere
// else in the flight program.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
const text = (path) => readFileSync(join(root, path), 'utf8').replace(/\/\/.*$/gm, '');
const table = text('firmware/state/parameters.cpp');
const sources = ['firmware', 'libraries/control', 'libraries/navigation']
  .flatMap((folder) => readdirSync(join(root, folder), { recursive: true })
    .map((name) => join(folder, String(name))))
  .filter((path) => path.endsWith('.cpp') && path !== join('firmware/state', 'parameters.cpp'));
const code = sources.map(text).join('\n');

// The fields of all rows, those of the macros for channels and streams once.
function fieldsOf(source) {
  const rows = [...source.matchAll(/\bP\((?:[^,()"]|\([^()]*\))*,\s*"[^,]*,\s*([\w.[\] -]+?)\s*,/g)];
  return rows.map((row) => row[1].replace(/\[[^\]]*\]/g, ''));
}

// Read by its whole path, or handed over with the struct it stands in and read there by name; a
// stream's rate is read by whoever has a message in that stream.
function effect(field) {
  const parts = field.split('.');
  const [first, last] = [parts[0], parts.at(-1)];
  if (first === 'format_version')
    return /parameters\.format_version\s*!=\s*0/.test(table);
  if (!new RegExp(`\\bparameters\\.${first}\\b`).test(code)) return false;
  if (first === 'streams') return new RegExp(`row<[^>]+>\\(Stream::${last}\\)`).test(code);
  return parts.length === 1 || new RegExp(`\\.${last}\\b`).test(code);
}

test('every row of the parameter table is found', () => {
  const names = [...table.matchAll(/\bP\([^"\n]*"/g)].length;
  assert.equal(fieldsOf(table).length, names);
  assert.ok(names > 100, `only ${names}`);
});

for (const field of new Set(fieldsOf(table)))
  test(`${field} has an effect`, () => assert.ok(effect(field)));

test('a field that nobody reads is found out', () => {
  assert.equal(effect('no_such_field'), false);
  assert.equal(effect('streams.no_such_stream'), false);
  assert.equal(effect('roll.axis.no_such_gain'), false);
});
