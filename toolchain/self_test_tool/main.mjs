// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/self_test.
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { realClock } from '../bench_tool/port.mjs';
import { boards } from '../flash_tool/boards.mjs';
import { checkPort } from '../flash_tool/port.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';
import { checkOutput } from '../shared/output.mjs';
import { buildImages, serialDevice, simulated } from './device.mjs';
import { checkFile, writeFigures } from './figures_file.mjs';
import { readOptions, usage } from './options.mjs';
import { waitForEnter, watchStops } from './person.mjs';
import { selfTest, table } from './run.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const print = (line) => process.stdout.write(`${line}\n`);
const say = (line) => process.stderr.write(`${line}\n`);

async function confirm({ yes }) {
  print('Propeller off, nothing in the outputs: they get pulses of up to 1000 us.');
  if (yes) return;
  if (!process.stdin.isTTY) throw new Refusal('nobody to ask: --yes says that it is so');
  await waitForEnter(process.stdin, process.stdout);
}

// What the test runs on, when nothing is in its way.
async function prepare(options) {
  const serial = options.address.kind === 'serial';
  if (options.out) checkFile(options.out);
  if (serial) checkPort(options.address.path);
  await confirm(options);
  if (serial) buildImages(root, boards[options.board].folder);
  else print('Over TCP nothing is written: the simulator must fly the image of the self-test.');
  return serial ? serialDevice(options, { root, say }) : simulated(options);
}

async function main(words) {
  const options = readOptions(words);
  if (options.help) {
    print(usage);
    return 0;
  }
  const device = await prepare(options);
  const stop = watchStops({ say });
  const outcome = await selfTest({ board: options.board, device, clock: { ...realClock, stopped: () => stop.stopped }, print });
  stop.release();
  for (const line of table(outcome.results, outcome.report)) print(line);
  print(outcome.passed ? 'The board passes its self-test.' : 'The board DOES NOT PASS its self-test.');
  if (options.out) writeFigures(options.out, outcome);
  return outcome.passed ? 0 : 1;
}

checkOutput('self_test');
try {
  process.exitCode = await main(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof Refusal)) throw error;
  say(`self_test: ${error.message}`);
  process.exitCode = error.status ?? 2;
}
