// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/bench.
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

import { Refusal } from '../flash_tool/refusal.mjs';
import { beAlone, NotTried } from '../shared/checkout.mjs';
import { checkOutput } from '../shared/output.mjs';
import { Board } from './board.mjs';
import { Stopped } from './errors.mjs';
import { readOptions, usage } from './options.mjs';
import { atTerminal, fromFile, kWords } from './person.mjs';
import { addressOf, openPort, realClock } from './port.mjs';
import { commitOf, formFile, Session } from './session.mjs';
import { loadState, makeFolder } from './state.mjs';
import { kSteps } from './steps/table.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const print = (line) => process.stdout.write(`${line}\n`);
const kInterrupted = 130;

// Set by a signal: waiting ends, what was begun is undone. A second signal ends it at once.
class Stop {
  stopped = false;
  #listeners = [];
  onStop(listener) { this.#listeners.push(listener); }
  now() {
    if (this.stopped) {
      print('bench: ended at once; what was changed is NOT restored, take the board\'s power away');
      process.exit(kInterrupted);
    }
    this.stopped = true;
    for (const listener of this.#listeners) listener();
  }
}

function stepsFor(options, state) {
  if (options.steps) return options.steps;
  return kSteps.map(({ number }) => number).filter((number) => state.steps[number]?.verdict !== 'pass');
}

function list(state) {
  for (const { number, title } of kSteps)
    print(`${String(number).padStart(2)}  ${(state.steps[number]?.verdict ?? 'not done').padEnd(8)}  ${title}`);
}

async function run(options, state) {
  const stop = new Stop();
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => stop.now());
  const telemetry = options.telemetry ? addressOf(options.telemetry, 57600) : null;
  const port = await openPort(addressOf(options.port));
  const board = new Board(port, realClock);
  const person = options.answers ? fromFile(options.answers, process.stdout)
    : atTerminal(process.stdin, process.stdout, stop);
  stop.onStop(() => { board.stopping = true; });
  const beating = setInterval(() => board.beat(), 500);
  const session = new Session({ board, person, state, print, options: { ...options, telemetry, commit: commitOf(root), root } });
  try {
    const steps = stepsFor(options, state);
    if (steps.length === 0) print('All steps have passed; --step N repeats one.');
    else print(kWords);
    const all = await session.run(steps);
    return all ? 0 : 1;
  } catch (error) {
    if (!(error instanceof Stopped)) throw error;
    print('\nStopped; the same command resumes.');
    return stop.stopped ? kInterrupted : 1;
  } finally {
    clearInterval(beating);
    person.close();
    port.close();
    if (state.port) print(`Form: ${relative('', formFile(options.folder))}`);
    if (session.undone) process.exitCode = 1;
  }
}

async function main(words) {
  const options = readOptions(words, new Date().toISOString().slice(0, 10));
  if (options.help) {
    print(usage);
    return 0;
  }
  addressOf(options.port);
  options.folder = options.out ?? join(root, 'build/bench', options.name);
  const state = loadState(options.folder, options);
  if (options.list) {
    list(state);
    return 0;
  }
  makeFolder(options.folder);
  beAlone(options.folder);
  return run(options, state);
}

checkOutput('bench');
try {
  process.exitCode = await main(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof Refusal || error instanceof NotTried)) throw error;
  process.stderr.write(`bench: ${error.message}\n`);
  process.exitCode = error.status ?? 2;
}
