// SPDX-License-Identifier: GPL-3.0-or-later
// Which folder may include which: prints every line that breaks a rule and fails.
//   node toolchain/check/layering.mjs [ROOT]
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = resolve(process.argv[2] ?? join(dirname(fileURLToPath(import.meta.url)), '../..'));

// A folder, and the first words its quoted includes may begin with.
const libraries = {
  core: [],
  hal: ['core'],
  geo: ['core'],
  control: ['core'],
  estimation: ['core', 'geo'],
  navigation: ['core', 'geo', 'control'],
  storage: ['core', 'hal'],
  parameters: ['core', 'hal', 'storage'],
  mission: ['core', 'hal', 'geo', 'storage'],
  scheduler: ['core', 'hal'],
  crypto: ['core'],
  mavlink: ['core'],
  drivers: ['core', 'hal'],
  logging: ['core', 'hal'],
};
const allLibraries = Object.keys(libraries);

// The rooms of firmware/, from the ground up: each is a namespace and may include those before it.
const rooms = ['notify', 'state', 'sensors', 'estimator', 'control', 'guidance', 'actuators', 'mission',
  'modes', 'safety', 'logger', 'gcs', 'app'];
const belowOrIn = (room) => rooms.slice(0, rooms.indexOf(room) + 1);
const rules = [
  ...allLibraries.map((name) => ({
    folder: `libraries/${name}`,
    may: [name, ...libraries[name]],
    freestanding: true,
  })),
  ...rooms.map((room) => ({
    folder: `firmware/${room}`,
    may: ['board.hpp', ...allLibraries, ...belowOrIn(room).map((each) => `firmware/${each}`)],
    namespace: room,
    freestanding: true,
  })),
  { folder: 'hal_avr', may: null, forbidden: /^(firmware|simulator|host_tests)\// },
  { folder: 'simulator/devices', may: ['simulator'] },
  { folder: 'simulator/airplane', may: ['simulator'] },
  { folder: 'simulator/machine', may: ['simulator', 'hal'] },
];

// What avr-libc offers to code that must also run on the host.
const freestandingHeaders = new Set(['stdint.h', 'stddef.h', 'string.h', 'math.h']);
const knowTheChip = new Set([...['rom', 'multiply', 'convert', 'crc', 'file_state'].map((name) => `libraries/core/${name}.hpp`),
  'libraries/crypto/rounds.hpp']);

function* sources(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) yield* sources(path);
    else if (/\.(hpp|cpp)$/.test(entry.name)) yield path;
  }
}

function* broken(rule, path, text) {
  const name = relative(root, path);
  if (!text.startsWith('// SPDX-License-Identifier: GPL-3.0-or-later'))
    yield [1, 'the first line must be the SPDX line'];
  if (rule.namespace && !/\/main\.cpp$|_host\.cpp$/.test(name) && !text.includes(`\nnamespace ${rule.namespace} {`))
    yield [1, `${rule.folder} is the namespace ${rule.namespace}`];
  for (const [index, line] of text.split('\n').entries()) {
    const quoted = /^#include "([^"]+)"/.exec(line)?.[1];
    const angled = /^#include <([^>]+)>/.exec(line)?.[1];
    if (quoted && rule.may && !rule.may.some((folder) => quoted === folder || quoted.startsWith(`${folder}/`)))
      yield [index + 1, `${rule.folder} must not include "${quoted}"`];
    if (quoted && rule.forbidden?.test(quoted))
      yield [index + 1, `${rule.folder} must not include "${quoted}"`];
    if (rule.freestanding && !knowTheChip.has(name)) {
      if (angled && !freestandingHeaders.has(angled))
        yield [index + 1, `<${angled}> does not exist on every side`];
      if (/^#\s*(if|ifdef|ifndef)\b/.test(line))
        yield [index + 1, `no conditional compilation outside ${[...knowTheChip].join(', ')}`];
    }
  }
}

const kPrivate = /etween the files of this folder only/;
const isPrivate = (path, text) => path.endsWith('.hpp') && kPrivate.test(text.split('\n').slice(0, 6).join(' '));
const firmwareFiles = [...sources(join(root, 'firmware'))].map((path) => [relative(root, path), readFileSync(path, 'utf8')]);

// A header between the files of its folder is included by nobody else.
function* privateHeadersUsedElsewhere() {
  const headers = new Set(firmwareFiles.filter(([path, text]) => isPrivate(path, text)).map(([path]) => path));
  for (const [path, text] of firmwareFiles)
    for (const [index, line] of text.split('\n').entries()) {
      const header = /^#include "([^"]+)"/.exec(line)?.[1];
      if (headers.has(header) && dirname(header) !== dirname(path))
        yield `${path}:${index + 1}: "${header}" is between the files of its folder only`;
    }
}

// Each section of the shared state has one writer: whoever defines its Publisher.
function* sectionsWithoutOneWriter() {
  const storage = readFileSync(join(root, 'firmware/state/vehicle.hpp'), 'utf8');
  for (const [, section] of storage.matchAll(/& section\((\w+)\*\)/g)) {
    if (section === 'Vehicle') continue;
    const writers = firmwareFiles.filter(([path, text]) => path !== 'firmware/state/published.hpp'
      && text.includes(`struct Publisher<${section}>`));
    if (writers.length !== 1)
      yield `${section} has ${writers.length} publishers${writers.map(([path]) => ` ${path}`).join()}`;
    for (const [path, text] of writers)
      if (path.endsWith('.hpp') && !isPrivate(path, text))
        yield `${path}:1: a header with a Publisher must be between the files of its folder only`;
  }
  for (const [path, text] of firmwareFiles)
    if (text.includes('Publisher<Vehicle>')) yield `${path}: writes past the publishers of the sections`;
}

let failures = 0;
let read = 0;
for (const message of [...privateHeadersUsedElsewhere(), ...sectionsWithoutOneWriter()]) {
  console.log(message);
  ++failures;
}
for (const entry of readdirSync(join(root, 'firmware'), { withFileTypes: true }))
  if (!entry.isDirectory() || !rooms.includes(entry.name)) {
    console.log(`firmware/${entry.name}: is no room of firmware`);
    ++failures;
  }
for (const rule of rules)
  for (const path of sources(join(root, rule.folder))) {
    ++read;
    for (const [line, why] of broken(rule, path, readFileSync(path, 'utf8'))) {
      console.log(`${relative(root, path)}:${line}: ${why}`);
      ++failures;
    }
  }
console.log(`${read} files, ${failures} broken rules`);
process.exit(failures === 0 && read > 0 ? 0 : 1);
