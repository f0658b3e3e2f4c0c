// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for, or why it cannot be read.
import { boards } from './boards.mjs';
import { Refusal } from './refusal.mjs';

export const usage = `usage: toolchain/flash PORT --board apm1|apm2 [--eeprom FILE] [--image FILE] [--dry-run]

Builds the image of the board and writes it through the board's bootloader, then reads it back and
compares. Take the propeller off first.

  PORT            the board's USB port, such as /dev/ttyACM0
  --board BOARD   apm1 or apm2; both have the same chip, so only you know which one it is
  --eeprom FILE   also write this EEPROM image, over all parameters and missions: .eep or .hex
                  (Intel hex) or .bin (raw), such as toolchain/mission compile makes
  --image FILE    write this Intel hex file instead of building
  --dry-run       build and check, print avrdude's command, leave the port alone

What to do when it fails, fuses and bootloader: docs/flashing.md.`;

const kFiles = { '--board': 'board', '--eeprom': 'eeprom', '--image': 'image' };

export function readOptions(words) {
  const options = { port: null, board: null, eeprom: null, image: null, dry_run: false, help: false };
  const rest = [...words];
  while (rest.length > 0) {
    const word = rest.shift();
    if (word === '--help' || word === '-h') return { ...options, help: true };
    if (word === '--dry-run') options.dry_run = true;
    else if (word in kFiles) {
      const value = rest.shift();
      if (value === undefined || value.startsWith('--')) throw new Refusal(`${word} wants a value`);
      options[kFiles[word]] = value;
    } else if (word.startsWith('-')) throw new Refusal(`there is no option ${word}; see --help`);
    else if (options.port !== null) throw new Refusal(`one port, please: ${options.port} or ${word}?`);
    else options.port = word;
  }
  const known = Object.keys(boards).join(' or ');
  if (options.port === null) throw new Refusal('say which port the board is on; see --help');
  if (options.board === null) throw new Refusal(`say which board it is: --board ${known}`);
  if (!Object.hasOwn(boards, options.board))
    throw new Refusal(`there is no board ${options.board}: ${known}`);
  return options;
}
