// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for, or why it cannot be read.
import { addressOf } from '../bench_tool/port.mjs';
import { boards } from '../flash_tool/boards.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';

export const usage = `usage: toolchain/self_test PORT --board apm1|apm2 [--out FILE] [--yes]

Writes the board's self-test in place of the firmware, shows what it measures beside the limits, and
writes the firmware back, also after an error or Ctrl-C. Parameters, missions and logs stay. About a
minute and a half, and a build before it. Take the propeller off and unplug what is in the outputs:
they get pulses of 800 to 1000 us, at which a speed controller keeps its motor still.

  PORT            the board's USB port, such as /dev/ttyACM0; or tcp:HOST:PORT of a simulator that
                  flies the self-test's image: nothing is written then
  --board BOARD   apm1 or apm2
  --out FILE      also write the figures as JSON
  --yes           do not ask for the propeller

Exit status: 0 all parts passed, 1 a part failed or is missing, 2 the command line is wrong.
docs/bench.md says what the parts are.`;

export function readOptions(words) {
  const options = { port: null, board: null, out: null, yes: false, help: false };
  const rest = [...words];
  while (rest.length > 0) {
    const word = rest.shift();
    if (word === '--help' || word === '-h') return { ...options, help: true };
    if (word === '--yes') options.yes = true;
    else if (word === '--board' || word === '--out') {
      const value = rest.shift();
      if (value === undefined || value.startsWith('--')) throw new Refusal(`${word} wants a value`);
      options[word.slice(2)] = value;
    } else if (word.startsWith('-')) throw new Refusal(`there is no option ${word}; see --help`);
    else if (options.port !== null) throw new Refusal(`one port, please: ${options.port} or ${word}?`);
    else options.port = word;
  }
  if (options.port === null) throw new Refusal('say which port the board is on; see --help');
  if (options.board === null || !Object.hasOwn(boards, options.board))
    throw new Refusal(`say which board it is: --board ${Object.keys(boards).join(' or ')}`);
  return { ...options, address: addressOf(options.port) };
}
