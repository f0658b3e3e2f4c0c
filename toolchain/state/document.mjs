// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the table of the shared state's writers in docs/architecture.md from firmware/state/vehicle.hpp
// and the Publishers of firmware/.
//   node toolchain/state/document.mjs           writes
//   node toolchain/state/document.mjs --check   exit 1 when what is there differs
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';

const root = new URL('../../', import.meta.url);
const read = (path) => readFileSync(new URL(path, root), 'utf8');
const kDocument = 'docs/architecture.md';
const kBegin = '<!-- state: written by toolchain/state/document.mjs, checked by host_tests/unit/docs/architecture.test.mjs -->';
const kEnd = '<!-- end of state -->';

function* firmwareFiles() {
  for (const room of readdirSync(new URL('firmware/', root)).sort())
    for (const name of readdirSync(new URL(`firmware/${room}/`, root)).sort()) yield `firmware/${room}/${name}`;
}

export function publishers() {
  const found = new Map();
  for (const path of firmwareFiles())
    for (const [, section] of read(path).matchAll(/^struct Publisher<(\w+)> :/gm)) found.set(section, path);
  return found;
}

// The names of a struct's fields, bit fields and arrays too.
function fields(source, struct) {
  const body = new RegExp(`struct ${struct} \\{\\n([^]*?)\\n\\};`).exec(source)?.[1].replace(/\/\/.*$/gm, '') ?? '';
  return body.split(';').map((line) => line.replace(/\[.*?\]|: 1/g, '').trim()).filter(Boolean)
    .flatMap((line) => line.replace(/^[\w:]+\s/, '').split(',').map((part) => part.trim()));
}

// Each section: its struct and how a reader writes it.
export function sections(source) {
  const inside = new Map([...source.matchAll(/^ {4}(\w+) (\w+);$/gm)].map(([, struct, name]) => [struct, name]));
  return [...source.matchAll(/& section\((\w+)\*\)/g)].map(([, struct]) => struct)
    .filter((struct) => struct !== 'Vehicle')
    .map((struct) => ({ struct, reads: inside.has(struct) ? [inside.get(struct)] : fields(source, struct) }));
}

export function table(source, writers) {
  const rows = sections(source).map(({ struct, reads }) =>
    `| \`${struct}\` | ${reads.map((name) => `\`${name}\``).join(', ')} | \`${writers.get(struct)}\` |`);
  return ['| section | read as `vehicle.` | publisher |', '|---|---|---|', ...rows].join('\n');
}

export function written(document, text) {
  const begin = document.indexOf(kBegin), end = document.indexOf(kEnd);
  if (begin < 0 || end < begin) throw new Error(`${kDocument} has no place for the state: ${kBegin} ... ${kEnd}`);
  return `${document.slice(0, begin)}${kBegin}\n${text}\n${document.slice(end)}`;
}

if (import.meta.url === `file://${process.argv[1]}`) {
  const document = read(kDocument);
  const now = written(document, table(read('firmware/state/vehicle.hpp'), publishers()));
  if (process.argv[2] === '--check') process.exit(now === document ? 0 : 1);
  if (now !== document) writeFileSync(new URL(kDocument, root), now);
}
