// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/mutate.
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { NotTried, beAlone, checkOut, compilerCache, workingTree } from '../shared/checkout.mjs';
import { checkOutput } from '../shared/output.mjs';
import { mutated, mutationsIn, sample } from './mutations.mjs';
import { Interrupted, Runner, prepared } from './programs.mjs';
import { outcomeOf, summaryOf } from './trial.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kFolder = join(root, 'build/mutate');

export const usage = `usage: toolchain/mutate FILE... [--at LINE[-LINE]] [--limit N] [--seed S] [--list]

Do the unit tests notice a mistake? Makes small ones in C++ sources, one at a time: a comparison
with its bound moved or turned round, && for ||, + for -, a sign left out, a guard that returns
deleted, a boolean negated, a number times 4 or 0, ++ for --. Then builds and runs the quick unit
tests that depend on the file, and prints each mutation that all of them passed.

  FILE            a .cpp or .hpp of this project, as it is in the working tree
  --at LINE-LINE  only these lines, of one FILE
  --limit N       a sample of N mutations
  --seed S        another sample, 1; the same seed takes the same one
  --list          prints the mutations and tries none

Works in a copy of the working tree, build/mutate/tree; the working tree itself is not changed, also
when interrupted. A mutation that does not compile, or compiles to the same program as without it,
is counted apart, and so is one with which a test runs ten times as long as it should.
Exit status: 0 no mutation survived, 1 some did or it was interrupted, 2 it could not be tried.`;

class WrongUsage extends Error {}

function count(option, word) {
  if (!/^\d+$/.test(word ?? '')) throw new WrongUsage(`${option} needs a number, not ${word ?? 'nothing'}`);
  return Number(word);
}

function range(word) {
  const [, first, last = first] = /^(\d+)(?:-(\d+))?$/.exec(word ?? '') ?? [];
  if (!first || Number(last) < Number(first))
    throw new WrongUsage(`--at needs LINE or LINE-LINE, not ${word ?? 'nothing'}`);
  return { first: Number(first), last: Number(last) };
}

export function readOptions(words) {
  const options = { files: [], at: null, limit: Infinity, seed: 1, list: false };
  const rest = [...words];
  while (rest.length > 0) {
    const word = rest.shift();
    if (word === '--list') options.list = true;
    else if (word === '--at') options.at = range(rest.shift());
    else if (word === '--limit') options.limit = count(word, rest.shift());
    else if (word === '--seed') options.seed = count(word, rest.shift());
    else if (word.startsWith('-')) throw new WrongUsage(`there is no option ${word}; see --help`);
    else options.files.push(word);
  }
  if (options.files.length === 0) throw new WrongUsage('which file? toolchain/mutate FILE..., see --help');
  if (options.at && options.files.length > 1) throw new WrongUsage('--at is of one FILE');
  return options;
}

// As the project names it.
function fileNamed(word) {
  const file = relative(root, resolve(word));
  if (!/\.(cpp|hpp)$/.test(file)) throw new WrongUsage(`${word}: only .cpp and .hpp are mutated`);
  if (file.startsWith('..') || !/^(firmware|libraries|simulator|toolchain|host_tests)\//.test(file))
    throw new WrongUsage(`${word}: no source of this project that unit tests are built from`);
  if (!statSync(join(root, file), { throwIfNoEntry: false })?.isFile())
    throw new WrongUsage(`${word}: no such file`);
  return file;
}

function chosenFrom(options) {
  const whole = [...new Set(options.files.map(fileNamed))].flatMap((file) =>
    mutationsIn(readFileSync(join(root, file), 'utf8')).map((mutation) => ({ file, ...mutation })))
    .filter(({ line }) => !options.at || (line >= options.at.first && line <= options.at.last));
  if (whole.length === 0) throw new NotTried('nothing there can be mutated');
  return { whole, chosen: sample(whole, options.limit, options.seed) };
}

const described = ({ file, line, before, after }) => `${file}:${line}: ${before}  ->  ${after}`;

// How far it is, where somebody looks on.
function showProgress(done, all) {
  if (process.stderr.isTTY) process.stderr.write(done < all ? `\r${done}/${all} ` : '\r\x1b[K');
}

async function tryAll(runner, chosen, outcomes) {
  console.error('building and running the unit tests without a mutation');
  const ready = await prepared(runner, [...new Set(chosen.map(({ file }) => file))]);
  for (const [file, programs] of ready)
    console.error(`${file}: ${programs.map(({ name }) => name).join(', ')}`);
  for (const mutation of chosen) {
    showProgress(outcomes.length, chosen.length);
    const path = join(runner.tree, mutation.file), text = readFileSync(path, 'utf8');
    writeFileSync(path, mutated(text, mutation));
    try {
      const outcome = await outcomeOf(runner, ready.get(mutation.file));
      outcomes.push(outcome);
      showProgress(chosen.length, chosen.length);
      if (outcome === 'survived') console.log(described(mutation));
      if (outcome === 'timed out') console.log(`${described(mutation)}  (timed out)`);
    } finally {
      writeFileSync(path, text);
    }
  }
}

async function main(words) {
  if (words.includes('--help') || words.includes('-h')) {
    console.log(usage);
    return 0;
  }
  const options = readOptions(words);
  const { whole, chosen } = chosenFrom(options);
  if (options.list) {
    for (const mutation of chosen) console.log(described(mutation));
    return 0;
  }
  beAlone(kFolder);
  const tree = join(kFolder, 'tree'), outcomes = [];
  const runner = new Runner(tree, compilerCache(kFolder));
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => runner.stop());
  try {
    checkOut(root, tree, workingTree(root, kFolder).commit);
    await runner.configure();
    await tryAll(runner, chosen, outcomes);
  } catch (error) {
    if (!(error instanceof Interrupted)) throw error;
    console.log(summaryOf(outcomes, chosen.length, whole.length));
    console.error('mutate: interrupted; the working tree was not touched, only the copy in build/mutate');
    return 1;
  }
  console.log(summaryOf(outcomes, chosen.length, whole.length));
  return outcomes.includes('survived') ? 1 : 0;
}

if (process.argv[1]?.startsWith(root) && process.argv[1].endsWith('main.mjs')) {
  checkOutput('mutate');
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    if (!(error instanceof NotTried || error instanceof WrongUsage)) throw error;
    console.error(`mutate: ${error.message}`);
    process.exitCode = 2;
  }
}
