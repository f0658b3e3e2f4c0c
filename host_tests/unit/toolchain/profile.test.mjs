// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/profile and toolchain/build as their users meet them.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { closeSync, mkdtempSync, openSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const folder = mkdtempSync(join(tmpdir(), 'profile-'));

function compile(name, source) {
  const path = join(folder, name);
  writeFileSync(`${path}.cpp`, source);
  execFileSync('avr-g++', ['-mmcu=atmega2560', '-Os', '-o', `${path}.elf`, `${path}.cpp`]);
  return `${path}.elf`;
}
const flown = compile('flown', 'namespace firmware { __attribute__((noinline)) void fly() { for (;;) asm(""); } } int main() { firmware::fly(); }');
const other = compile('other', 'namespace firmware { __attribute__((noinline)) void fly() { for (;;) asm("nop"); } } int main() { firmware::fly(); }');

let profiles = 0;
function profileOf(elf, more = {}) {
  const path = join(folder, `profile_${++profiles}.json`);
  const fly = execFileSync('avr-nm', ['-C', elf], { encoding: 'utf8' }).match(/([0-9a-f]+) T firmware::fly/)[1];
  writeFileSync(path, JSON.stringify({
    program: { path: elf, sha256: createHash('sha256').update(readFileSync(elf)).digest('hex') },
    all: 1000, cycles: [[parseInt(fly, 16), 250]], calls: [], ...more }));
  return path;
}

function started(program, words, stdout) {
  const { status, stdout: said, stderr } = spawnSync(program, words,
    { encoding: 'utf8', stdio: ['ignore', stdout, 'pipe'] });
  return { status, said, stderr };
}
const run = (tool, words, stdout = 'pipe') => started(join(root, 'toolchain', tool), words, stdout);
const runNode = (script, words, stdout) =>
  started(process.execPath, [join(root, 'toolchain', script), ...words], stdout);

test('the table is of the program that was flown', () => {
  const { status, said, stderr } = run('profile', [profileOf(flown), flown]);
  assert.equal(status, 0, stderr);
  assert.match(said, /fly +0 +25\.00/);
});

test('another program is refused in one line that names both', () => {
  const { status, said, stderr } = run('profile', [profileOf(flown), other]);
  assert.equal(status, 1);
  assert.equal(said, '');
  assert.equal(stderr.trimEnd().split('\n').length, 1, stderr);
  assert.ok(stderr.includes(flown) && stderr.includes(other), stderr);
});

test('what is no profile, or does not name its program, is refused', () => {
  const text = join(folder, 'text');
  writeFileSync(text, 'hello');
  for (const [words, says] of [
    [[text, flown], /no profile that fly --profile has written/],
    [[profileOf(flown, { program: undefined }), flown], /does not say of which program/],
    [[join(folder, 'none'), flown], /cannot be read: ENOENT/],
    [[profileOf(flown), join(folder, 'none')], /cannot be read: ENOENT/],
    [[profileOf(flown), folder], /cannot be read: EISDIR/]]) {
    const { status, stderr } = run('profile', words);
    assert.equal(status, 1, stderr);
    assert.match(stderr, says);
    assert.equal(stderr.trimEnd().split('\n').length, 1, stderr);
  }
});

test('an output that cannot be written is a failure', () => {
  const full = openSync('/dev/full', 'w');
  const profile = run('profile', [profileOf(flown), flown], full);
  const flash = runNode('flash_tool/main.mjs', ['--help'], full);
  closeSync(full);
  assert.equal(profile.status, 1);
  assert.match(profile.stderr, /^profile: the standard output cannot be written: ENOSPC\n$/);
  assert.match(flash.stderr, /^flash: the standard output cannot be written: ENOSPC\n$/);
  assert.equal(flash.status, 1);
});

test('build without a tree, or with one that does not exist, says how it is called', () => {
  for (const words of [[], ['nowhere']]) {
    const { status, stderr } = run('build', words);
    assert.equal(status, 2);
    assert.match(stderr, /^build: (which tree\? toolchain\/build TREE|there is no tree nowhere: host, avr)/);
    assert.equal(stderr.trimEnd().split('\n').length, 1, stderr);
  }
});
