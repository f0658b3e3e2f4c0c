// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/flash.
import { spawnSync } from 'node:child_process';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

import { commandFor, quoted, run } from './avrdude.mjs';
import { boards } from './boards.mjs';
import { checkEeprom, checkImage } from './contents.mjs';
import { readOptions, usage } from './options.mjs';
import { checkOutput } from '../shared/output.mjs';
import { checkPort } from './port.mjs';
import { Refusal } from './refusal.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const say = (line) => process.stderr.write(`${line}\n`);

function build(board) {
  const made = spawnSync(join(root, 'toolchain/build'), [`avr:firmware_${board.folder}`], { stdio: ['ignore', 2, 2] });
  if (made.status !== 0) throw new Refusal(`the image for ${board.name} could not be built`, 1);
  const image = join(root, 'build/avr', board.folder, 'firmware.hex');
  return relative('', image) || image;
}

async function flash(options) {
  const board = boards[options.board];
  if (!options.dry_run) checkPort(options.port);  // before a build that may take a minute
  const eeprom = options.eeprom ? { path: options.eeprom, ...checkEeprom(options.eeprom) } : null;
  const image = options.image ?? build(board);
  const reach = checkImage(image);
  const command = commandFor({ port: options.port, board, image, eeprom });
  if (options.dry_run) return console.log(quoted(command));

  say(`${board.name} on ${options.port}: ${reach.bytes} bytes of flash` +
      (eeprom ? `, ${eeprom.bytes} of EEPROM` : '; parameters and missions stay'));
  say(quoted(command));
  await run(command, { board, port: options.port });
  say(`written and verified; the board starts the new firmware`);
}

checkOutput('flash');
try {
  const options = readOptions(process.argv.slice(2));
  if (options.help) console.log(usage);
  else await flash(options);
} catch (error) {
  if (!(error instanceof Refusal)) throw error;
  say(`flash: ${error.message}`);
  process.exitCode = error.status;
}
