// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/flash against a bootloader on a pseudo-terminal: what it writes, and what it says when
// something is wrong.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { checkPort } from '../../../../toolchain/flash_tool/port.mjs';
import { fileOf, flash, intelHex, newFolder, noise, root, run, startBoard } from './rig.mjs';

const kOld = { flash: 0x5a, eeprom: 0xa5 };  // what the bootloader's memories hold before
const kBootloader = 0x3e000;
const all = (bytes, value) => bytes.every((byte) => byte === value);

// Reaches past 64 KiB and past 128 KiB, and ends within a page.
const image = noise(0x20000 + 1234);
const image_file = fileOf('firmware.hex', intelHex(image));
const small_file = fileOf('small.hex', intelHex(noise(1000)));
const eeprom = noise(4096, 2);

test('the image is in the board, byte for byte, and its EEPROM untouched', async () => {
  const board = await startBoard();
  const { status, last } = await flash(board.port, '--board', 'apm2', '--image', image_file);
  const left = await board.end();

  assert.equal(status, 0, last);
  assert.match(last, /written and verified/);
  assert.deepEqual(left.flash.subarray(0, image.length), image);
  const page_end = Math.ceil(image.length / 256) * 256;
  assert.ok(all(left.flash.subarray(page_end), kOld.flash), 'nothing behind it is touched');
  assert.ok(all(left.eeprom, kOld.eeprom));
});

test('the conversation is that of a bootloader: no chip erase, everything read back', async () => {
  const board = await startBoard();
  const file = fileOf('new.eep', intelHex(eeprom));
  await flash(board.port, '--board', 'apm1', '--image', small_file, '--eeprom', file);
  const { conversation } = await board.end();

  assert.deepEqual(conversation.slice(0, 3), ['sign on', 'enter programming', 'read signature']);
  assert.ok(!conversation.includes('chip erase'));
  const order = ['program flash', 'read flash', 'program eeprom', 'read eeprom', 'leave programming'];
  assert.deepEqual(conversation.slice(-5), order);
});

for (const [name, contents] of [['new.eep', intelHex(eeprom)], ['new.bin', eeprom]])
  test(`an EEPROM image is written when asked for, from ${name}`, async () => {
    const board = await startBoard();
    const { status, last } = await flash(board.port, '--board', 'apm2', '--image', small_file,
                                         '--eeprom', fileOf(name, contents));
    const left = await board.end();

    assert.equal(status, 0, last);
    assert.deepEqual(left.eeprom, eeprom);
  });

test('a board with another chip is not written', async () => {
  const board = await startBoard('--signature', '1e9703');
  const { status, last } = await flash(board.port, '--board', 'apm1', '--image', small_file);
  const left = await board.end();

  assert.equal(status, 1);
  assert.match(last, /^flash: the chip's signature is 1e9703, that of an ATmega1280.*ATmega2560/);
  assert.ok(all(left.flash, kOld.flash));
});

test('a byte that reads back differently is reported with its place', async () => {
  const board = await startBoard('--stuck', '123');
  const { status, last } = await flash(board.port, '--board', 'apm2', '--image', small_file);
  await board.end();

  assert.equal(status, 1);
  assert.match(last, /^flash: what was read back differs .*0x0*123\b.*do not fly/);
});

test('a port where nothing answers is reported with what to try', async () => {
  const board = await startBoard('--silent');
  const { status, last } = await flash(board.port, '--board', 'apm2', '--image', small_file);
  await board.end();

  assert.equal(status, 1);
  assert.match(last, /^flash: no bootloader answers on .* at 115200 baud.*reset/);
});

test('an image that reaches the bootloader is refused before the board is touched', async () => {
  const board = await startBoard();
  const file = fileOf('large.hex', intelHex(noise(kBootloader + 1)));
  const { status, said } = await flash(board.port, '--board', 'apm2', '--image', file);
  const left = await board.end();

  assert.equal(status, 2);
  assert.match(said, /^flash: .*large.hex does not fit: it ends at 0x3e001, 1 bytes inside the bootloader/);
  assert.deepEqual(left.conversation, ['']);
});

test('an image that ends right before the bootloader is taken', async () => {
  const file = fileOf('full.hex', intelHex(noise(kBootloader)));

  assert.equal((await flash('/dev/x', '--board', 'apm2', '--image', file, '--dry-run')).status, 0);
});

test('files that are not whole, empty, too long or of no known form are refused', async () => {
  const whole = intelHex(noise(64)), lines = whole.split('\n');
  const damaged = lines[1].slice(0, -1) + (lines[1].endsWith('0') ? '1' : '0');
  const cases = [
    ['--image', 'cut.hex', whole.slice(0, 100), /cut.hex:3: no line of Intel hex/],
    ['--image', 'cut_line.hex', lines.slice(0, 2).join('\n'), /ends without its end record/],
    ['--image', 'sum.hex', whole.replace(lines[1], damaged), /sum.hex:2: the checksum is wrong/],
    ['--image', 'none.hex', ':00000001FF\n', /none.hex is empty/],
    ['--image', 'elf.hex', '\x7fELF', /elf.hex:1: no line of Intel hex/],
    ['--image', 'high.hex', intelHex(noise(16), 512), /no image of the firmware.*0x200/],
    ['--eeprom', 'long.bin', noise(4097), /ends at byte 4097 of 4096/],
    ['--eeprom', 'long.eep', intelHex(noise(16), 4090), /ends at byte 4106 of 4096/],
    ['--eeprom', 'plan.waypoints', 'QGC WPL 110', /ends in .eep or .hex/],
  ];
  for (const [option, name, contents, why] of cases) {
    const image_words = option === '--image' ? [] : ['--image', small_file];
    const { status, said } = await flash('/dev/x', '--board', 'apm2', '--dry-run', ...image_words,
                                         option, fileOf(name, contents));
    assert.equal(status, 2, name);
    assert.match(said, why);
    assert.equal(said.trim().split('\n').length, 1, 'one line');
  }
});

test('a dry run prints the command alone and needs no board', async () => {
  const file = fileOf('my image.hex', intelHex(noise(100)));
  const { status, out } = await flash('/dev/ttyACM9', '--board', 'apm2', '--image', file,
                                      '--eeprom', fileOf('e.bin', eeprom, '/tmp'), '--dry-run');

  assert.equal(status, 0);
  assert.equal(out, `avrdude -c wiring -p m2560 -P /dev/ttyACM9 -b 115200 -D -U 'flash:w:${file}:i'` +
                    ' -U eeprom:w:/tmp/e.bin:r\n');
});

test('what cannot be understood is answered by one line and status 2', async () => {
  const cases = [
    [[], /say which port/],
    [['/dev/x'], /say which board it is: --board apm1 or apm2/],
    [['/dev/x', '--board', 'apm3'], /there is no board apm3/],
    [['/dev/x', '--board', 'toString'], /there is no board toString/],
    [['/dev/x', '--board'], /--board wants a value/],
    [['/dev/x', '/dev/y', '--board', 'apm2'], /one port, please/],
    [['/dev/x', '--board', 'apm2', '--fast'], /there is no option --fast/],
    [['/dev/x', '--board', 'apm2', '--image', '/none.hex', '--dry-run'], /there is no file \/none.hex/],
    [['/dev/none', '--board', 'apm2'], /there is no port \/dev\/none; there (are|is no)/],
    [['/dev/null/x', '--board', 'apm2'], /there is no port/],
    [[small_file, '--board', 'apm2'], /is no serial port/],
  ];
  for (const [words, why] of cases) {
    const { status, said, out } = await flash(...words);
    assert.match(said, why);
    assert.equal(said.trim().split('\n').length, 1, 'one line');
    assert.deepEqual([status, out], [2, '']);
  }
});

test('a port that another program holds is not used, and the program is named', async () => {
  const board = await startBoard();
  const holder = spawn('sh', ['-c', `exec sleep 60 <${board.port}`], { stdio: 'ignore' });
  const until = Date.now() + 5000;
  let answer;
  do answer = await flash(board.port, '--board', 'apm2', '--image', small_file);
  while (!/sleep/.test(answer.said) && Date.now() < until);  // it may still be starting
  holder.kill();
  await board.end();

  assert.equal(answer.status, 2);
  assert.match(answer.said, new RegExp(`in use by sleep \\(process ${holder.pid}\\)`));
});

test('a user without the right to the port is shown how to get it', () => {
  const ask = { isSerial: () => true, mayUse: () => false, user: () => 'ada', ports: () => [] };

  assert.throws(() => checkPort('/dev/ttyACM0', ask), /usermod -aG dialout ada/);
});

test('the ports that there are are offered instead of a missing one', () => {
  const missing = () => { throw new Error('ENOENT'); };
  const ask = { isSerial: missing, ports: () => ['/dev/ttyACM0', '/dev/ttyUSB3'] };

  assert.throws(() => checkPort('/dev/ttyACM7', ask), /there are \/dev\/ttyACM0, \/dev\/ttyUSB3/);
});

// The command as a whole, in a project whose build is made up.
function project() {
  const folder = newFolder();
  mkdirSync(join(folder, 'toolchain'));
  for (const part of ['flash', 'flash_tool', 'shared'])
    cpSync(join(root, 'toolchain', part), join(folder, 'toolchain', part), { recursive: true });
  const script = (name, text) =>
      writeFileSync(join(folder, 'toolchain', name), `#!/bin/sh\n${text}\n`, { mode: 0o755 });
  script('setup', `echo "setup $*" >>${folder}/log`);
  script('build', `echo "build $*" >>${folder}/log; board=\${1#avr:firmware_};` +
                  ` mkdir -p ${folder}/build/avr/$board;` +
                  ` cp ${small_file} ${folder}/build/avr/$board/firmware.hex; echo built`);
  return { folder, script, log: () => `${readFileSync(join(folder, 'log'))}`.trim().split('\n'),
           flash: (...words) => run(join(folder, 'toolchain/flash'), words, { cwd: folder }) };
}

test('what is missing is installed and the image of the board is built first', async () => {
  const made = project();
  const { status, out } = await made.flash('/dev/x', '--board', 'apm1', '--dry-run');

  assert.equal(status, 0);
  assert.deepEqual(made.log(), ['setup flash', 'build avr:firmware_apm1']);
  assert.equal(out, 'avrdude -c wiring -p m2560 -P /dev/x -b 115200 -D -U flash:w:build/avr/apm1/firmware.hex:i\n');
});

test('an image that cannot be built is not flashed', async () => {
  const made = project();
  made.script('build', 'echo "error: 42" >&2; exit 1');
  const { status, said } = await made.flash('/dev/x', '--board', 'apm2', '--dry-run');

  assert.equal(status, 1);
  assert.match(said, /error: 42\n.*flash: the image for APM 2 could not be built/s);
});

test('avrdude that is not there is reported with the command that installs it', async () => {
  const board = await startBoard();
  const { status, last } = await run(
      process.execPath, [join(root, 'toolchain/flash_tool/main.mjs'), board.port, '--board', 'apm2',
                         '--image', small_file], { env: { PATH: '/nonexistent' } });
  await board.end();

  assert.deepEqual([status, last],
                   [1, 'flash: avrdude is not installed: run toolchain/setup flash']);
});
