// SPDX-License-Identifier: GPL-3.0-or-later
// The build trees (CMakePresets.json): configuring them, and building targets of several at once
// with one line of progress.
import { spawn, spawnSync } from 'node:child_process';
import { createWriteStream, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

import { Progress } from './progress.mjs';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
export const kTrees = ['host', 'avr', 'sanitize', 'fuzz'];
const kAtOnce = 2, kLongestLine = 300;
const kStatus = { ...process.env, NINJA_STATUS: '[%f/%t] ' };
const kShown = /^(flash|ram|stack|note)/;  // what the image weighs is worth a line when it was linked

export class BuildFailed extends Error {}

export const folderOf = (tree) => join(root, 'build', tree);

function cached(tree, name) {
  const file = join(folderOf(tree), 'CMakeCache.txt');
  if (!existsSync(file)) return undefined;
  return new RegExp(`^${name}:\\w+=(.*)$`, 'm').exec(readFileSync(file, 'utf8'))?.[1];
}

// Configures when that has not been done. The host's tree can do without what only the tests need
// (`tests` false) as long as nobody wanted them.
export function configure(tree, { tests }) {
  const missing = !existsSync(join(folderOf(tree), 'build.ninja'));
  const wanted = tests || cached(tree, 'TESTS') === 'ON' ? 'ON' : 'OFF';
  if (!missing && (tree !== 'host' || cached(tree, 'TESTS') === wanted)) return;
  console.error(`configuring build/${tree}`);
  const options = tree === 'host' ? [`-DTESTS=${wanted}`] : [];
  const { status, stdout, stderr, error } = spawnSync('cmake', ['--preset', tree, ...options],
    { cwd: root, encoding: 'utf8' });
  if (status === 0) return;
  process.stderr.write(error ? `${error.message}\n` : `${stdout}${stderr}`);
  throw new BuildFailed(`build/${tree} could not be configured`);
}

// How many steps ninja would take now; first it counts those that look for new files.
function stepsAhead({ tree, targets }) {
  const dry = spawnSync('ninja', ['-C', folderOf(tree), '-n', ...targets],
    { env: kStatus, encoding: 'utf8', maxBuffer: 1 << 28 });
  return Math.max(0, ...[...(dry.stdout ?? '').matchAll(/^\[\d+\/(\d+)\]/gm)].map(([, total]) => Number(total)));
}

function runNinja({ tree, targets }, progress) {
  mkdirSync(folderOf(tree), { recursive: true });
  const log = createWriteStream(join(folderOf(tree), 'build.log'));
  const ninja = spawn('ninja', ['-C', folderOf(tree), ...targets],
    { env: kStatus, stdio: ['ignore', 'pipe', 'pipe'] });
  const said = [];
  const take = (line) => {
    log.write(`${line}\n`);
    const step = /^\[(\d+)\/(\d+)\]/.exec(line);
    if (step) progress.update(tree, Number(step[1]), Number(step[2]));
    else said.push(line);
  };
  const readers = [ninja.stdout, ninja.stderr].map((input) => createInterface({ input }).on('line', take));
  const ended = readers.map((reader) => new Promise((resolve) => { reader.on('close', resolve); }));
  return new Promise((resolve, reject) => {
    ninja.on('error', reject);
    ninja.on('close', async (status) => {
      await Promise.all(ended);
      log.end();
      resolve({ tree, status, said });
    });
  });
}

// avr-gcc 5.4's linker plugin jumps onto its own stack once in some hundred links and is gone; what
// it was given is built the next time.
export const compilerCrashed = ({ status, said }) =>
  status !== 0 && said.some((line) => line.includes('internal compiler error'));

async function runTree(request, progress) {
  const result = await runNinja(request, progress);
  if (!compilerCrashed(result)) return result;
  progress.clear();
  console.error(`build/${request.tree}: the compiler crashed; once more`);
  return runNinja(request, progress);
}

function report({ tree, status, said }) {
  if (status === 0) {
    for (const line of said) if (kShown.test(line)) console.error(line);
    return;
  }
  for (const line of said.slice(-300)) console.error(line.slice(0, kLongestLine));
  throw new BuildFailed(`build/${tree} failed; all of its output is in build/${tree}/build.log`);
}

// requests: [{ tree, targets }], no targets meaning the tree's default; two trees at a time, in
// their order. Throws BuildFailed after having shown what the compiler said.
export async function build(requests, { tests = false } = {}) {
  for (const { tree } of requests) configure(tree, { tests });
  const progress = new Progress(new Map(requests.map((request) => [request.tree, stepsAhead(request)])));
  const waiting = [...requests];
  const worker = async () => {
    while (waiting.length > 0) {
      const result = await runTree(waiting.shift(), progress);
      if (result.status !== 0) waiting.length = 0;
      progress.clear();
      report(result);
    }
  };
  const ends = await Promise.allSettled(Array.from({ length: kAtOnce }, worker));
  for (const { status, reason } of ends) if (status === 'rejected') throw reason;
  progress.end();
}
