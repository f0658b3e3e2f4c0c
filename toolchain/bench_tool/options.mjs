// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for, or why it cannot be read.
import { boards } from '../flash_tool/boards.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';

export const kLastStep = 16;

export const usage = `usage: toolchain/bench PORT --board apm1|apm2 [OPTIONS]

The bench protocol of a real board in 16 steps: asks for one action at a time, measures by MAVLink
what can be measured, asks for readings of meters for the rest, compares with limits, and writes a
form to sign. About an hour. Take the propeller off first. Nothing moves the motor's output but what
three confirmations, each typed in full, have allowed. docs/bench.md has the protocol.

  PORT              /dev/ttyACM0, /dev/ttyUSB0:57600, or tcp:HOST:PORT
  --board BOARD     apm1 or apm2
  --name NAME       of this board, such as its serial number; if not given the day's date
  --out FOLDER      for the form and the results; if not given build/bench/NAME
  --step N[,M-K]    these steps alone, though they have passed; if not given all that have not
  --telemetry PORT  the radio's port, for step 13
  --answers FILE    JSON, from the names of the questions to what would be typed; "*" for all others
  --list            print the steps and their state, measure nothing

At any question: skip, none, fail REASON, remark TEXT, quit. Ctrl-C ends it as quit does: what was
armed is disarmed, what was changed is restored, and the next run resumes.

Exit status: 0 all 16 steps have passed, 1 not all, 2 it could not be tried.`;

const kValues = { '--board': 'board', '--name': 'name', '--out': 'out', '--step': 'step', '--telemetry': 'telemetry',
  '--answers': 'answers' };

// "1,4-6" to [1, 4, 5, 6].
export function stepsOf(text) {
  const numbers = text.split(',').flatMap((range) => {
    const [, from, to = from] = /^(\d+)(?:-(\d+))?$/.exec(range) ?? [];
    if (!from || +from < 1 || +to > kLastStep || +from > +to)
      throw new Refusal(`--step ${text}: expected steps 1 to ${kLastStep}, such as 3 or 1,4-6`);
    return Array.from({ length: to - from + 1 }, (_, i) => +from + i);
  });
  return [...new Set(numbers)].sort((a, b) => a - b);
}

function read(words) {
  const options = { port: null, list: false, help: false };
  const rest = [...words];
  while (rest.length > 0) {
    const word = rest.shift();
    if (word === '--help' || word === '-h') return { help: true };
    if (word === '--list') options.list = true;
    else if (Object.hasOwn(kValues, word)) {
      const value = rest.shift();
      if (value === undefined || value.startsWith('--')) throw new Refusal(`${word} wants a value`);
      options[kValues[word]] = value;
    } else if (word.startsWith('-')) throw new Refusal(`there is no option ${word}; see --help`);
    else if (options.port !== null) throw new Refusal(`one port, please: ${options.port} or ${word}?`);
    else options.port = word;
  }
  return options;
}

export function readOptions(words, today) {
  const options = read(words);
  if (options.help) return options;
  const known = Object.keys(boards).join(' or ');
  if (options.port === null) throw new Refusal('say which port the board is on; see --help');
  if (!options.board) throw new Refusal(`say which board it is: --board ${known}`);
  if (!Object.hasOwn(boards, options.board)) throw new Refusal(`there is no board ${options.board}: ${known}`);
  options.name ??= today;
  if (!/^[\w.-]+$/.test(options.name) || /^\.+$/.test(options.name)) throw new Refusal('--name takes letters, digits, _ . -');
  options.steps = options.step === undefined ? null : stepsOf(options.step);
  return options;
}
