// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/build.
import { WrongUsage, requestsOf } from './requests.mjs';
import { BuildFailed, build } from './trees.mjs';

const usage = `usage: toolchain/build TREE[:TARGET,TARGET...]...

Configures and builds the trees in build/ (CMakePresets.json), two at a time. Prints the progress;
the compilers' output is in build/TREE/build.log and is shown when something fails.

  host      simulator, tools and tests: host:fly,mission_tool
  avr       the images of both boards: avr:firmware_apm2
  sanitize  the unit tests with the sanitizers
  fuzz      the fuzzers (needs clang)`;

async function main(words) {
  if (words.includes('--help') || words.includes('-h')) return console.log(usage);
  if (words.length === 0) throw new WrongUsage('which tree? toolchain/build TREE[:TARGET,TARGET...], see --help');
  const requests = requestsOf(words);
  const tests = requests.some(({ targets }) => targets.some((target) => target.endsWith('_test')));
  return build(requests, { tests });
}

try {
  await main(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof BuildFailed || error instanceof WrongUsage)) throw error;
  console.error(`build: ${error.message}`);
  process.exitCode = error instanceof WrongUsage ? 2 : 1;
}
