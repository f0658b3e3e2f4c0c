// SPDX-License-Identifier: GPL-3.0-or-later
// On a machine without clang and node the simulator and the unit tests still configure.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
const kHidden = /^(clang|node|npm|npx)/;

// A folder with links to all programs of PATH but the hidden ones.
function programsWithout(hidden, folder) {
  for (const each of process.env.PATH.split(':')) {
    let names = [];
    try {
      names = readdirSync(each);
    } catch { /* a folder of PATH that does not exist */ }
    for (const name of names.filter((one) => !hidden.test(one))) {
      try {
        symlinkSync(join(each, name), join(folder, name));
      } catch { /* an earlier folder of PATH has it */ }
    }
  }
  return folder;
}

test('the host tree configures with clang and node hidden, without the tests that need them', () => {
  const bin = mkdtempSync(join(tmpdir(), 'bin-')), tree = mkdtempSync(join(tmpdir(), 'tree-'));
  const env = { PATH: programsWithout(kHidden, bin), HOME: process.env.HOME };
  const run = (program, ...words) => spawnSync(join(bin, program), words, { env, encoding: 'utf8', cwd: root });
  try {
    const configured = run('cmake', '-S', root, '-B', tree, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release');
    assert.equal(configured.status, 0, configured.stderr);
    assert.match(configured.stdout, /node is missing/);
    assert.match(configured.stdout, /clang\+\+ is missing/);
    const listed = run('ctest', '--test-dir', tree, '-N', '-C', 'quick').stdout;
    assert.match(listed, /: geo_test\n/);
    assert.doesNotMatch(listed, /fuzz\./);
  } finally {
    for (const folder of [bin, tree]) rmSync(folder, { recursive: true });
  }
});
