// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/same.
import { mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

import { NotTried, beAlone, commitNamed, workingTree } from '../shared/checkout.mjs';
import { checkOutput } from '../shared/output.mjs';
import { flattened, compared } from './compare.mjs';
import { kFlights } from './flights.mjs';
import { built } from './versions.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kFolder = join(root, 'build/same');
const kAtOnce = 2;
const kWritten = /\.(csv|json|bin)$/;  // by a flight

export const usage = `usage: toolchain/same BEFORE [AFTER | --worktree] [--expect-text]

Does the airplane fly as before? Builds two commits, flies each natively with the same seeds, and
compares what the flights left behind, byte for byte: flight.csv, the messages on both serial lines
or the events and texts, the DataFlash with the log, and the EEPROM.

  BEFORE, AFTER  commits, as git names them; AFTER is HEAD if not given
  --worktree     after is the working tree with everything that is not committed
  --expect-text  status texts may differ: only flight.csv is compared

The flights:
${kFlights.map(({ name, what }) => `  ${name.padEnd(10)}  ${what}`).join('\n')}

Missions are those of this working tree on both sides; airplanes and their parameters are each
commit's own. A flight that fails is reported and counts as different. Checkouts and files of the
flights stay in build/same/. Exit status: 0 the same, 1 different, 2 it could not be tried.`;

class WrongUsage extends Error {}

export function readOptions(words) {
  const known = ['--worktree', '--expect-text'];
  const wrong = words.find((word) => word.startsWith('-') && !known.includes(word));
  if (wrong) throw new WrongUsage(`there is no option ${wrong}; see --help`);
  const [before, after, ...more] = words.filter((word) => !word.startsWith('-'));
  const worktree = words.includes('--worktree');
  if (!before) throw new WrongUsage('which commit is before? toolchain/same BEFORE [AFTER], see --help');
  if (more.length > 0) throw new WrongUsage(`two commits are compared, not also ${more[0]}`);
  if (worktree && after) throw new WrongUsage(`after is ${after} or the working tree, not both`);
  return { before, after: after ?? 'HEAD', worktree, texts_may_differ: words.includes('--expect-text') };
}

// Path below the folder to contents; of a summary.json also its lines, which is what is compared.
function filesIn(folder) {
  const files = new Map();
  for (const name of readdirSync(folder, { recursive: true }).sort()) {
    if (!kWritten.test(name)) continue;
    const bytes = readFileSync(join(folder, name));
    files.set(name, bytes);
    if (!name.endsWith('.json')) continue;
    files.delete(name);
    files.set(name.replace(/json$/, 'txt'), Buffer.from(flattened(JSON.parse(bytes))));
  }
  return files;
}

// One flight of one side: { failure, files }.
async function flown(flight, side, host) {
  const folder = join(kFolder, 'flights', side, flight.name);
  mkdirSync(folder, { recursive: true });
  let failure = null;
  try {
    await flight.fly({ host, missions: join(root, 'simulator/missions'), folder });
  } catch (error) {
    failure = error.message;
  }
  return { failure, files: filesIn(folder) };
}

const kWords = { same: 'same', different: 'differs', failed: 'FAILED' };

// Two flights at a time; a line for each in the order of the table.
async function compareAll(sides, options) {
  const waiting = [...kFlights], verdicts = new Map();
  const worker = async () => {
    for (let flight = waiting.shift(); flight; flight = waiting.shift()) {
      const before = await flown(flight, 'before', sides.before);
      verdicts.set(flight, compared(before, await flown(flight, 'after', sides.after), options));
    }
  };
  await Promise.all(Array.from({ length: kAtOnce }, worker));
  return kFlights.map((flight) => ({ name: flight.name, ...verdicts.get(flight) }));
}

export function verdictOf(results, { texts_may_differ = false }) {
  const unlike = results.filter(({ verdict }) => verdict !== 'same');
  const failed = unlike.filter(({ verdict }) => verdict === 'failed').length;
  const note = texts_may_differ ? '; only flight.csv was compared' : '';
  if (unlike.length === 0) return `the same: ${results.length} of ${results.length} flights${note}`;
  return `different: ${unlike.length} of ${results.length} flights${failed ? `, ${failed} of them failed` : ''}${note}`;
}

function prepare(options) {
  const before = commitNamed(root, options.before);
  const after = options.worktree ? workingTree(root, kFolder) : commitNamed(root, options.after);
  const taken = [], hosts = {};
  for (const [side, version] of [['before', before], ['after', after]]) {
    if (side === 'after' && version.tree === before.tree) {
      console.log(`after   ${version.words}: the same files as before`);
      hosts.after = hosts.before;
      continue;
    }
    const { host, reused } = built(root, kFolder, version, taken);
    hosts[side] = host;
    console.log(`${side.padEnd(6)}  ${version.words}${reused ? ', built already' : ''}`);
  }
  return hosts;
}

async function main(words) {
  if (words.includes('--help') || words.includes('-h')) {
    console.log(usage);
    return 0;
  }
  const options = readOptions(words);
  beAlone(kFolder);
  const sides = prepare(options);
  rmSync(join(kFolder, 'flights'), { recursive: true, force: true });
  const results = await compareAll(sides, options);
  for (const { name, verdict, words: how } of results)
    console.log(`${name.padEnd(10)}  ${kWords[verdict]}${verdict === 'same' ? '' : `  ${how}`}`);
  console.log(verdictOf(results, options));
  console.log(`files: ${relative(process.cwd(), join(kFolder, 'flights'))}`);
  return results.every(({ verdict }) => verdict === 'same') ? 0 : 1;
}

if (process.argv[1]?.startsWith(root) && process.argv[1].endsWith('main.mjs')) {
  checkOutput('same');
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    if (!(error instanceof NotTried || error instanceof WrongUsage)) throw error;
    console.error(`same: ${error.message}`);
    process.exitCode = 2;
  }
}
