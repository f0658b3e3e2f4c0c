// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/mutate.
import { readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { NotTried, beAlone, checkOut, compilerCache, workingTree } from '../shared/checkout.mjs';
import { checkOutput } from '../shared/output.mjs';
import { Direct } from './direct.mjs';
import { mutated, mutationsIn, sample } from './mutations.mjs';
import { Interrupted, Runner, prepared } from './programs.mjs';
import { outcomeOf, summaryOf } from './trial.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kFolder = join(root, 'build/mutate');

export const usage = `usage: toolchain/mutate FILE... [--at LINE[-LINE]] [--limit N] [--seed S] [--jobs N]
       toolchain/mutate FILE... --list

Do the unit tests notice a mistake? Makes small ones in C++ sources, one at a time: a comparison
with its bound moved or turned round, && for ||, + for -, a sign left out, a guard that returns
deleted, a boolean negated, a number times 4 or 0, ++ for --. Then builds and runs the quick unit
tests that depend on the file, those of its folder first, and prints each mutation that all of them
passed. A program of tests that takes more than 5 s is run only for files of its folder.

  FILE            a .cpp or .hpp of this project, as it is in the working tree
  --at LINE-LINE  only these lines, of one FILE
  --limit N       a sample of N mutations
  --seed S        another sample, 1; the same seed takes the same one
  --jobs N        so many at once of a .cpp; as many as there are processors
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
  const options = { files: [], at: null, limit: Infinity, seed: 1, jobs: cpus().length, list: false };
  const rest = [...words];
  while (rest.length > 0) {
    const word = rest.shift();
    if (word === '--list') options.list = true;
    else if (word === '--at') options.at = range(rest.shift());
    else if (word === '--limit') options.limit = count(word, rest.shift());
    else if (word === '--jobs') options.jobs = Math.max(1, count(word, rest.shift()));
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

// A header is compiled into many objects: the build makes them.
class Whole {
  constructor(runner, file) {
    Object.assign(this, { runner, path: join(runner.tree, file) });
  }
  write(text) {
    if (text !== readFileSync(this.path, 'utf8')) writeFileSync(this.path, text);
  }
  builds(name) { return this.runner.builds(name); }
  hashOf(name) { return this.runner.hashOf(name); }
  uses() { return true; }
  test(...words) { return this.runner.test(...words); }
}

// What each program is compiled to without a mutation. Those that have a double of the file are left
// out.
async function unchanged(builder, programs, text) {
  const used = [], hashes = new Map();
  builder.write(text);
  for (const program of programs) {
    const { name } = program;
    if (!await builder.builds(name)) throw new NotTried(`without any mutation ${name} does not build`);
    if (!await builder.uses(name)) continue;
    hashes.set(name, await builder.hashOf(name));
    used.push(program);
  }
  if (used.length === 0) throw new NotTried('no test is linked with what was compiled');
  return { used, hashes };
}

// The mutations of one file, by as many at once as there are builders.
async function tryFile(builders, programs, mutations, text, report) {
  const waiting = [...mutations];
  await Promise.all(builders.map(async (builder) => {
    const { used, hashes } = await unchanged(builder, programs, text);
    for (let mutation = waiting.shift(); mutation; mutation = waiting.shift()) {
      builder.write(mutated(text, mutation));
      try {
        report(mutation, await outcomeOf(builder, used, hashes));
      } finally {
        builder.write(text);
      }
    }
  }));
}

function buildersFor(runner, file, jobs) {
  if (!file.endsWith('.cpp')) return [new Whole(runner, file)];
  const folder = join(kFolder, 'jobs');
  rmSync(folder, { recursive: true, force: true });
  return Array.from({ length: jobs }, (_, i) => new Direct(runner, file, join(folder, `${i + 1}`)));
}

async function tryAll(runner, chosen, whole, { jobs }, outcomes) {
  const files = [...new Set(chosen.map(({ file }) => file))];
  console.error('building and running the unit tests without a mutation');
  const ready = await prepared(runner, files);
  for (const file of files) {
    const programs = ready.get(file), of = ({ file: each }) => each === file, own = [];
    console.error(`${file}: ${[...new Set(programs.map(({ name }) => name))].join(', ')}`);
    const text = readFileSync(join(runner.tree, file), 'utf8');
    await tryFile(buildersFor(runner, file, jobs), programs, chosen.filter(of), text, (mutation, outcome) => {
      outcomes.push(outcome);
      own.push(outcome);
      showProgress(outcomes.length, chosen.length);
      if (outcome === 'survived') console.log(described(mutation));
      if (outcome === 'timed out') console.log(`${described(mutation)}  (timed out)`);
    });
    if (files.length > 1) console.log(`${file}: ${summaryOf(own, own.length, whole.filter(of).length)}`);
  }
  showProgress(chosen.length, chosen.length);
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
    await tryAll(runner, chosen, whole, options, outcomes);
  } catch (error) {
    runner.stop();
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
