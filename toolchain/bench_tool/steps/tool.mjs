// SPDX-License-Identifier: GPL-3.0-or-later
// Another of the project's tools on the board's serial port, which is free meanwhile.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';

import { NotDone } from '../errors.mjs';

// Runs toolchain/NAME PORT WORDS and gives its status. `instead`: of a simulated board, called with the port.
export async function runTool({ board, options, print }, name, words, instead) {
  if (!board.port.canReset) throw new NotDone('TCP reaches no bootloader');
  const { path } = board.port.address;
  board.port.pause();
  print(`  toolchain/${name} ${path} ${words.join(' ')}`);
  const status = await (instead?.(path) ??
    spawnSync(join(options.root, 'toolchain', name), [path, ...words], { stdio: ['ignore', 2, 2] }).status);
  await board.port.resume();
  return status;
}
