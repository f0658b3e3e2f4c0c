// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { run } from '../../../../toolchain/flash_tool/avrdude.mjs';
import { Refusal } from '../../../../toolchain/flash_tool/refusal.mjs';
import { buildImages, serialDevice, simulated } from '../../../../toolchain/self_test_tool/device.mjs';

const kImage = ':0400000001020304F2\n:00000001FF\n';
const options = { port: '/dev/ttyACM0:57600', address: { kind: 'serial', path: '/dev/ttyACM0', baud: 57600 }, board: 'apm2' };

// A project whose build is made up; `script` is what it does.
function project(script = 'exit 0') {
  const root = mkdtempSync(join(tmpdir(), 'self-test-'));
  mkdirSync(join(root, 'toolchain'));
  mkdirSync(join(root, 'build/avr/apm2'), { recursive: true });
  for (const program of ['self_test', 'firmware']) writeFileSync(join(root, 'build/avr/apm2', `${program}.hex`), kImage);
  writeFileSync(join(root, 'toolchain/build'), `#!/bin/sh\necho "$*" >${root}/asked\n${script}\n`, { mode: 0o755 });
  return root;
}

test('both images of the board are built before anything is written', () => {
  const root = project();
  buildImages(root, 'apm2');
  assert.equal(readFileSync(join(root, 'asked'), 'utf8'), 'avr:self_test_apm2 avr:firmware_apm2\n');
});

test('an image that cannot be built, is missing or is not whole is refused', () => {
  const refusedFor = (why) => (error) => error instanceof Refusal && why.test(error.message);
  assert.throws(() => buildImages(project('exit 1'), 'apm2'), refusedFor(/could not be built; nothing was written/));
  for (const program of ['self_test', 'firmware']) {
    const root = project(), path = join(root, 'build/avr/apm2', `${program}.hex`);
    writeFileSync(path, kImage.split('\n')[0]);
    assert.throws(() => buildImages(root, 'apm2'), refusedFor(/without its end record/), program);
    rmSync(path);
    assert.throws(() => buildImages(root, 'apm2'), refusedFor(/there is no file/), program);
  }
});

test('either program goes through the bootloader, out of reach of Ctrl-C', async () => {
  const runs = [], said = [];
  const device = serialDevice(options, { root: '/p', say: (line) => said.push(line), run: async (...words) => { runs.push(words); } });
  for (const program of ['self_test', 'firmware']) await device.flash(program);
  assert.deepEqual(runs.map(([words]) => words.join(' ')), ['self_test', 'firmware'].map((program) =>
    `avrdude -c wiring -p m2560 -P /dev/ttyACM0 -b 115200 -D -U flash:w:/p/build/avr/apm2/${program}.hex:i`));
  assert.deepEqual(said, runs.map(([words]) => words.join(' ')));
  assert.deepEqual(runs.map(([,, how]) => how), [{ detached: true }, { detached: true }]);
  assert.deepEqual([device.flashes, device.command], [true, 'toolchain/flash /dev/ttyACM0 --board apm2']);
  assert.equal(simulated(options).flashes, false);
});

test('a program that runs detached has a session of its own', async () => {
  const sessionOf = (stat) => stat.split(' ')[5];
  const mine = sessionOf(readFileSync('/proc/self/stat', 'utf8'));
  for (const detached of [false, true]) {
    const path = join(mkdtempSync(join(tmpdir(), 'self-test-')), 'stat');
    await run(['sh', '-c', `cat /proc/self/stat >${path}`], {}, { detached });
    assert.equal(sessionOf(readFileSync(path, 'utf8')) !== mine, detached);
  }
});
