// SPDX-License-Identifier: GPL-3.0-or-later
// avrdude: its command, its run, and what its failures mean in plain words.
import { spawn } from 'node:child_process';

import { Refusal } from './refusal.mjs';

const kSilence_ms = 60000;  // it has been seen to wait for ever for a port that went away

// -D: no chip erase. The bootloaders have none; they erase each page before they write it.
export function commandFor({ port, board, image, eeprom }) {
  return ['avrdude', '-c', board.programmer, '-p', board.part, '-P', port, '-b', String(board.baud),
          '-D', '-U', `flash:w:${image}:i`,
          ...(eeprom ? ['-U', `eeprom:w:${eeprom.path}:${eeprom.form}`] : [])];
}

export const quoted = (words) =>
  words.map((word) => /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`)
       .join(' ');

const kOtherChips = { '1e9703': 'that of an ATmega1280, which early APM 1 boards have' };

function signatureOf(output) {
  return /Device signature = (?:0x)?([0-9a-f]{2} ?[0-9a-f]{2} ?[0-9a-f]{2})/i.exec(output)?.[1]
      .replaceAll(' ', '').toLowerCase();
}

// In this order: the first that fits is the reason, the others follow from it.
const kReasons = [
  [/unable to read signature/i, () =>
    'the chip does not send its signature: press reset and try again; nothing was written'],
  [/expected signature|does not match/i, (output, { board }) => {
    const found = signatureOf(output) ?? 'unknown';
    return `the chip's signature is ${found}, ${kOtherChips[found] ?? `that of another chip`}: ` +
           `this firmware needs an ${board.chip}; nothing was written`;
  }],
  [/verification (error|mismatch)/i, (output) => {
    const place = /at (?:addr|byte) (0x[0-9a-f]+)/i.exec(output)?.[1];
    return `what was read back differs from what was written${place ? ` (first at ${place})` : ''}: ` +
           'do not fly this board; flash it again, and if it fails at the same place its memory is worn out';
  }],
  [/permission denied/i, (_, { port }) => `${port} may not be used by this user: see the group dialout`],
  [/busy/i, (_, { port }) => `${port} is held by another program: close it and try again`],
  [/timeout|timed out|not in sync|not responding|cannot open programmer|unable to open/i, (_, { port, board }) =>
    `no bootloader answers on ${port} at ${board.baud} baud: is this the board's own USB port? press its ` +
    'reset button as the command starts; when that does not help either, the bootloader is gone, see docs/flashing.md'],
];

export function explain(output, context) {
  const reason = kReasons.find(([pattern]) => pattern.test(output));
  return reason ? reason[1](output, context) : `avrdude failed; what it said stands above`;
}

// Runs it, passing on what it says; throws a Refusal when it did not end well. `detached`: the terminal's Ctrl-C does
// not reach it.
export async function run(words, context, { detached = false } = {}) {
  const child = spawn(words[0], words.slice(1), { stdio: ['ignore', 'pipe', 'pipe'], detached });
  let output = '', silent = false, timer;
  const heard = () => {
    clearTimeout(timer);
    timer = setTimeout(() => { silent = true; child.kill('SIGKILL'); }, kSilence_ms);
  };
  for (const stream of [child.stdout, child.stderr])
    stream.on('data', (chunk) => { heard(); output += chunk; process.stderr.write(chunk); });
  heard();
  const status = await new Promise((resolve, reject) => {
    child.on('error', (error) => reject(error.code === 'ENOENT'
        ? new Refusal('avrdude is not installed: run toolchain/setup flash', 1) : error));
    child.on('close', resolve);
  }).finally(() => clearTimeout(timer));
  if (silent) throw new Refusal(`avrdude said nothing for ${kSilence_ms / 1000} s and was stopped: is the board still there?`, 1);
  if (status !== 0) throw new Refusal(explain(output, context), 1);
}
