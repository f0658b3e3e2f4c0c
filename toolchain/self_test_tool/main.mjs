// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/self_test.
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline/promises';
import { fileURLToPath } from 'node:url';

import { openPort, realClock } from '../bench_tool/port.mjs';
import { commandFor, quoted, run } from '../flash_tool/avrdude.mjs';
import { boards } from '../flash_tool/boards.mjs';
import { checkImage } from '../flash_tool/contents.mjs';
import { checkPort } from '../flash_tool/port.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';
import { checkOutput } from '../shared/output.mjs';
import { readOptions, usage } from './options.mjs';
import { selfTest, table } from './run.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const print = (line) => process.stdout.write(`${line}\n`);
const say = (line) => process.stderr.write(`${line}\n`);

// Both images before anything is written: what cannot be built must not leave the board without firmware.
function buildImages(folder) {
  const made = spawnSync(join(root, 'toolchain/build'), [`avr:self_test_${folder}`, `avr:firmware_${folder}`], { stdio: ['ignore', 2, 2] });
  if (made.status !== 0) throw new Refusal('the images could not be built; nothing was written', 1);
}

function serialDevice({ port, address, board: name }) {
  const board = boards[name];
  const image = (program) => join(root, 'build/avr', board.folder, `${program}.hex`);
  const flash = async (program) => {
    checkImage(image(program));
    const command = commandFor({ port: address.path, board, image: image(program) });
    say(quoted(command));
    await run(command, { board, port: address.path });
  };
  return { flashes: true, flash, open: () => openPort(address), command: `toolchain/flash ${port} --board ${name}` };
}

const simulated = ({ address }) => ({ flashes: false, open: () => openPort(address) });

async function confirm({ yes }) {
  print('Propeller off, nothing in the outputs: they get pulses of up to 1000 us.');
  if (yes) return;
  if (!process.stdin.isTTY) throw new Refusal('nobody to ask: --yes says that it is so');
  const lines = createInterface({ input: process.stdin, output: process.stdout });
  await lines.question('Enter when it is so, Ctrl-C to leave: ');
  lines.close();
}

async function main(words) {
  const options = readOptions(words);
  if (options.help) {
    print(usage);
    return 0;
  }
  const serial = options.address.kind === 'serial';
  if (serial) checkPort(options.address.path);
  await confirm(options);
  if (serial) buildImages(boards[options.board].folder);
  else print('Over TCP nothing is written: the simulator must fly the image of the self-test.');
  let stopped = false;
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => { stopped = true; });
  const device = serial ? serialDevice(options) : simulated(options);
  const { passed, results, report } = await selfTest({ board: options.board, device, clock: { ...realClock, stopped: () => stopped }, print });
  for (const line of table(results, report)) print(line);
  print(passed ? 'The board passes its self-test.' : 'The board DOES NOT PASS its self-test.');
  if (options.out) writeFileSync(options.out, `${JSON.stringify({ board: report.board, passed, unknown: report.unknown,
    parts: results.map(({ title, verdict, values, limit }) => ({ title, verdict, values, limit: limit.text })) }, null, 2)}\n`);
  return passed ? 0 : 1;
}

checkOutput('self_test');
try {
  process.exitCode = await main(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof Refusal)) throw error;
  say(`self_test: ${error.message}`);
  process.exitCode = error.status ?? 2;
}
