// SPDX-License-Identifier: GPL-3.0-or-later
// What the self-test runs on: a board behind a serial port, which gets both programs through its bootloader, or
// one behind TCP, which is left as it is.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';

import { openPort } from '../bench_tool/port.mjs';
import { commandFor, quoted, run as runAvrdude } from '../flash_tool/avrdude.mjs';
import { boards } from '../flash_tool/boards.mjs';
import { checkImage } from '../flash_tool/contents.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';

const kPrograms = ['self_test', 'firmware'];
const imageOf = (root, folder, program) => join(root, 'build/avr', folder, `${program}.hex`);

// Both images before anything is written: what cannot be built or does not fit must not leave the board without
// firmware.
export function buildImages(root, folder) {
  const made = spawnSync(join(root, 'toolchain/build'), kPrograms.map((program) => `avr:${program}_${folder}`),
    { stdio: ['ignore', 2, 2] });
  if (made.status !== 0) throw new Refusal('the images could not be built; nothing was written', 1);
  for (const program of kPrograms) checkImage(imageOf(root, folder, program));
}

// avrdude is in a session of its own: Ctrl-C and a terminal that goes away end the test, but not the writing of a
// program.
export function serialDevice({ address, board: name }, { root, say, run = runAvrdude }) {
  const board = boards[name];
  const flash = async (program) => {
    const command = commandFor({ port: address.path, board, image: imageOf(root, board.folder, program) });
    say(quoted(command));
    await run(command, { board, port: address.path }, { detached: true });
  };
  return { flashes: true, flash, open: () => openPort(address), command: `toolchain/flash ${address.path} --board ${name}` };
}

export const simulated = ({ address }) => ({ flashes: false, open: () => openPort(address) });
