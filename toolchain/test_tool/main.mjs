// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind toolchain/test: asks ctest which tests are wanted, builds what these need, and
// runs them.
import { spawn, spawnSync } from 'node:child_process';
import { relative } from 'node:path';
import { createInterface } from 'node:readline';
import { cpus } from 'node:os';

import { BuildFailed, build, configure, folderOf, kTrees, root } from '../build_tool/trees.mjs';
import { Slowest } from './slowest.mjs';

const kFuzzRunsLong = '1000000';

export const usage = `usage: toolchain/test [quick] [--again] [--long] [CTEST OPTION...]

Builds what the tests need, and runs them.

  quick     only unit tests (by GCC; otherwise by clang with the sanitizers), a dozen native flights,
            the images' budgets, layering, style and documents
  --again   also what has passed before and depends on nothing that has changed since
            (always so where CI is set)
  --long    fuzzers: 1,000,000 executions each instead of 100,000 (files: 30,000); the unit tests by
            both compilers; the bench's session with an APM 1
  CTEST OPTION, for example:
    -R NAME       only tests whose name matches, and what they need; builds only that
    -L LABEL      unit, native (flights), simavr (the images on emulated boards), sanitize, fuzz,
                  interop (node-mavlink, avrdude), image (budgets), quick
    -N            only list them`;

// Some tests run only among the quick ones, or with --long: declare_test's ONLY.
function configuration(words) {
  if (words.includes('--long')) return ['-C', 'long'];
  return words.includes('quick') ? ['-C', 'quick'] : [];
}

export function readOptions(words) {
  const rest = words.filter((word) => !['quick', '--again', '--long'].includes(word));
  return {
    help: words.includes('--help') || words.includes('-h'),
    quick: words.includes('quick'),
    again: words.includes('--again') || Boolean(process.env.CI),
    long: words.includes('--long'),
    list: rest.includes('-N') || rest.includes('--show-only'),
    ctest: [...(words.includes('quick') ? ['-L', '^quick$'] : []), ...configuration(words), ...rest],
  };
}

// The files that the chosen tests need, as targets of the trees they are in.
export function requestsFor(tests) {
  const wanted = new Map(kTrees.map((tree) => [tree, new Set()]));
  for (const { properties = [] } of tests) {
    const files = properties.find(({ name }) => name === 'REQUIRED_FILES')?.value ?? [];
    for (const file of files) {
      const tree = kTrees.find((each) => file.startsWith(`${folderOf(each)}/`));
      if (tree) wanted.get(tree).add(relative(folderOf(tree), file));
    }
  }
  return ['avr', 'host', 'sanitize', 'fuzz'].filter((tree) => wanted.get(tree).size > 0)
    .map((tree) => ({ tree, targets: [...wanted.get(tree)] }));
}

function chosenTests(options) {
  const { stdout, stderr, status } = spawnSync('ctest', ['--show-only=json-v1', ...options],
    { cwd: folderOf('host'), encoding: 'utf8', maxBuffer: 1 << 28 });
  if (status === 0) return JSON.parse(stdout).tests;
  throw new BuildFailed(`ctest refused ${options.join(' ')}: ${stderr.trim()}`);
}

function runTests({ ctest, again, long }) {
  const environment = { ...process.env };
  if (!again) environment.REUSE_RESULTS = '1';
  if (long) environment.FUZZ_RUNS = kFuzzRunsLong;
  const slowest = new Slowest();
  // one more than cores: some tests wait for a peer most of their time
  const run = spawn('ctest', ['--output-on-failure', '--parallel', String(cpus().length + 1), ...ctest],
    { cwd: folderOf('host'), env: environment, stdio: ['inherit', 'pipe', 'inherit'] });
  createInterface({ input: run.stdout }).on('line', (line) => {
    for (const shown of slowest.withSummary(line)) console.log(shown);
  });
  return new Promise((resolve) => { run.on('close', (status) => resolve(status ?? 1)); });
}

async function main(words) {
  const options = readOptions(words);
  if (options.help) {
    console.log(usage);
    return 0;
  }
  configure('host', { tests: true });
  spawnSync('ninja', ['-C', folderOf('host'), 'build.ninja']);  // tests may have been added or renamed
  const tests = chosenTests(options.ctest);
  if (tests.length === 0) throw new BuildFailed(`no test matches ${options.ctest.join(' ')}`);
  if (!options.list) await build(requestsFor(tests), { tests: true });
  return runTests(options);
}

if (process.argv[1]?.startsWith(root) && process.argv[1].endsWith('main.mjs')) {
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    if (!(error instanceof BuildFailed)) throw error;
    console.error(`test: ${error.message}`);
    process.exitCode = 1;
  }
}
