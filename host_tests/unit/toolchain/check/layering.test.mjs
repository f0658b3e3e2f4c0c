// SPDX-License-Identifier: GPL-3.0-or-later
// The layering check finds what it is for: each rule broken once in a copy of the sources.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, rmdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');

// One copy for all, each of which puts back what it changes: a copy is a thousand files.
const copy = mkdtempSync(join(tmpdir(), 'layering_'));
for (const folder of ['firmware', 'libraries', 'hal_avr', 'simulator'])
  cpSync(join(root, folder), join(copy, folder), { recursive: true });
after(() => rmSync(copy, { recursive: true }));

const check = () =>
  spawnSync(process.execPath, [join(root, 'toolchain/check/layering.mjs'), copy], { encoding: 'utf8' });

function checkedWith(file, text) {
  const path = join(copy, file), folder = dirname(path);
  const was = existsSync(path) ? readFileSync(path) : undefined, isNew = !existsSync(folder);
  mkdirSync(folder, { recursive: true });
  writeFileSync(path, text);
  try {
    return check();
  } finally {
    if (was) writeFileSync(path, was);
    else rmSync(path);
    if (isNew) rmdirSync(folder);
  }
}

const append = (file, text) => () => checkedWith(file, readFileSync(join(copy, file), 'utf8') + text);
const write = (file, text) => () => checkedWith(file, text);
const spdx = '// SPDX-License-Identifier: GPL-3.0-or-later\n';

test('the sources as they are break no rule', () => {
  const { status, stdout } = check();
  assert.equal(status, 0, stdout);
});

for (const [what, checked, says] of [
  ['a room that includes one above it', append('firmware/state/vehicle.cpp', '#include "firmware/modes/modes.hpp"\n'),
    'firmware/state must not include "firmware/modes/modes.hpp"'],
  ['a library that includes the firmware', append('libraries/core/maths.hpp', '#include "firmware/state/vehicle.hpp"\n'),
    'libraries/core must not include "firmware/state/vehicle.hpp"'],
  ['a room that nobody ranked', write('firmware/attic/box.hpp', spdx), 'firmware/attic: is no room of firmware'],
  ['a file outside the rooms', write('firmware/box.hpp', spdx), 'firmware/box.hpp: is no room of firmware'],
  ['a file in another namespace', write('firmware/gcs/box.hpp', `${spdx}namespace firmware {\n}\n`),
    'firmware/gcs is the namespace gcs'],
  ['a header that only a computer has', append('firmware/gcs/link.cpp', '#include <vector>\n'),
    '<vector> does not exist on every side'],
  ['a second writer of a section', append('firmware/gcs/link.cpp',
    'template <>\nstruct Publisher<HomeState> : Writable<HomeState> {};\n'),
    'HomeState has 2 publishers firmware/'],
  ['a writer of everything', append('firmware/gcs/link.cpp', 'auto& all = Publisher<Vehicle>::state();\n'),
    'firmware/gcs/link.cpp: writes past the publishers'],
  ['a header of another room that is not for others', append('firmware/modes/rtl.cpp',
    '#include "firmware/guidance/path_state.hpp"\n'),
    '"firmware/guidance/path_state.hpp" is between the files of its folder only'],
]) {
  test(`${what} is printed and fails`, () => {
    const { status, stdout } = checked();
    assert.equal(status, 1, stdout);
    assert.ok(stdout.includes(says), stdout);
  });
}
