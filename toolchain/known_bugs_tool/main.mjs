// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/known_bugs.
import { existsSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { Interrupted, Runner } from '../mutate_tool/programs.mjs';
import { NotTried, beAlone, checkOut, compilerCache, workingTree } from '../shared/checkout.mjs';
import { checkOutput } from '../shared/output.mjs';
import { edited, filesOf, kBugs } from './bugs.mjs';
import { foundIn, verdictOf } from './hunt.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kFolder = join(root, 'build/known_bugs');

export const usage = `usage: toolchain/known_bugs [NAME...] [--flights N] [--seed S] [--jobs N] [--list]

Does chaos find a bug? Puts known ones back, one at a time, and flies drawn scenarios with each
until an invariant fails that it breaks. The same scenario is then flown without the bug: only when
nothing fails there was it the bug.

  NAME         only these bugs, S1 to S6; all if not given
  --flights N  at most so many flights with each, 10000
  --seed S     of the first flight, 1
  --jobs N     flights at the same time, 1
  --list       prints the bugs and flies none

Works in a copy of the working tree, build/known_bugs/tree; the working tree itself is not changed.
Exit status: 0 all of them were found, 1 some were not or it was interrupted, 2 it could not be tried.`;

class WrongUsage extends Error {}

function count(option, word) {
  if (!/^[1-9]\d*$/.test(word ?? '')) throw new WrongUsage(`${option} needs a number from 1 on, not ${word ?? 'nothing'}`);
  return Number(word);
}

export function readOptions(words) {
  const options = { names: [], flights: 10_000, seed: 1, jobs: 1, list: false };
  const rest = [...words];
  while (rest.length > 0) {
    const word = rest.shift();
    if (word === '--list') options.list = true;
    else if (['--flights', '--seed', '--jobs'].includes(word)) options[word.slice(2)] = count(word, rest.shift());
    else if (word.startsWith('-')) throw new WrongUsage(`there is no option ${word}; see --help`);
    else if (!kBugs.some(({ name }) => name === word)) throw new WrongUsage(`there is no bug ${word}; see --list`);
    else options.names.push(word);
  }
  return options;
}

const described = ({ name, what, violates }) => `${name}  ${what} (${violates.join(' or ')})`;

// With the bug's edits, which are taken back whatever happens.
async function build(runner, bug) {
  const texts = filesOf(bug).map((file) => ({ file, path: join(runner.tree, file) }))
    .map((each) => ({ ...each, text: readFileSync(each.path, 'utf8') }));
  try {
    for (const { file, path, text } of texts) writeFileSync(path, edited(text, file, bug.edits));
    await runner.mustBuild('chaos');
  } finally {
    for (const { path, text } of texts) writeFileSync(path, text);
  }
}

// The campaign document of these flights.
async function flown(runner, words) {
  const folder = join(kFolder, 'flights'), document = join(folder, 'campaign.json');
  rmSync(document, { force: true });
  await runner.run(join(runner.host, 'chaos'), ['--no-shrink', '--out', folder, ...words].map(String), { cwd: runner.host });
  if (!existsSync(document)) throw new NotTried('chaos wrote no campaign.json');
  return JSON.parse(readFileSync(document, 'utf8'));
}

async function failsWithout(runner, bug, { seed }) {
  await runner.mustBuild('chaos');
  return foundIn(await flown(runner, ['--flights', 1, '--seed', seed]), bug.violates) !== undefined;
}

// With the bug until it is found, then that scenario without it. One that fails there, too, is no
// evidence: the seeds behind it have to show it.
async function search(runner, bug, { flights: most, seed, jobs }) {
  const until = bug.violates.flatMap((name) => ['--until', name]);
  let flights = 0;
  while (flights < most) {
    await build(runner, bug);
    const document = await flown(runner,
      ['--flights', most - flights, '--seed', seed + flights, '--jobs', jobs, ...until]);
    flights += document.flown;
    const found = foundIn(document, bug.violates);
    if (!found) break;
    if (!await failsWithout(runner, bug, found)) return { flights, found };
  }
  return { flights };
}

async function main(words) {
  if (words.includes('--help') || words.includes('-h')) {
    console.log(usage);
    return 0;
  }
  const options = readOptions(words);
  const bugs = kBugs.filter(({ name }) => options.names.length === 0 || options.names.includes(name));
  if (options.list) {
    for (const bug of bugs) console.log(described(bug));
    return 0;
  }
  beAlone(kFolder);
  const tree = join(kFolder, 'tree'), runner = new Runner(tree, compilerCache(kFolder));
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => runner.stop());
  let missed = 0;
  try {
    checkOut(root, tree, workingTree(root, kFolder).commit);
    const packages = join(tree, 'web/node_modules');  // of the pages
    rmSync(packages, { force: true, recursive: true });
    symlinkSync(join(root, 'web/node_modules'), packages);
    if (!existsSync(join(runner.host, 'build.ninja'))) await runner.must('cmake', ['--preset', 'host', '-DTESTS=OFF']);
    for (const bug of bugs) {
      const result = await search(runner, bug, options);
      if (!result.found) ++missed;
      console.log(verdictOf(bug, result));
    }
  } catch (error) {
    if (!(error instanceof Interrupted)) throw error;
    console.error('known_bugs: interrupted; the working tree was not touched, only the copy in build/known_bugs');
    return 1;
  }
  return missed === 0 ? 0 : 1;
}

if (process.argv[1]?.startsWith(root) && process.argv[1].endsWith('main.mjs')) {
  checkOutput('known_bugs');
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    if (!(error instanceof NotTried || error instanceof WrongUsage)) throw error;
    console.error(`known_bugs: ${error.message}`);
    process.exitCode = 2;
  }
}
