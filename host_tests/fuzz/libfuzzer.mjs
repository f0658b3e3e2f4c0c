// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a libFuzzer program for a counted number of executions (FUZZ_RUNS, otherwise `runs`) and
// prints the count. Fewer, or a crash, is a failure; what the fuzzer found is kept.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export function fuzz({ program, name, seeds, longest, environment, runs = 100_000 }) {
  const wanted = Number(process.env.FUZZ_RUNS ?? runs);
  if (!(Number.isInteger(wanted) && wanted > 0)) throw new Error(`FUZZ_RUNS: ${process.env.FUZZ_RUNS} is no number of executions`);
  const folder = mkdtempSync(join(tmpdir(), 'fuzz-'));
  const files = seeds.map((_, i) => join(folder, `seed_${i}`));
  for (const [i, seed] of seeds.entries()) writeFileSync(files[i], seed);
  // In no folder of a corpus, which costs a file for each input that is kept. A feature is rare while
  // so many executions have had it: for each feature of an execution the rare ones are searched.
  const run = spawnSync(program, [`-seed_inputs=${files.join()}`, `-runs=${wanted}`, '-seed=1',
    `-max_len=${longest}`, '-entropic_feature_frequency_threshold=20', '-print_final_stats=1',
    '-detect_leaks=0', `-artifact_prefix=${folder}/`, '-verbosity=0'],
    { encoding: 'utf8', maxBuffer: 1 << 26, env: { ...process.env, ...environment } });
  const count = +(/stat::number_of_executed_units: (\d+)/.exec(run.stderr)?.[1] ?? 0);
  console.log(`${name}: ${count.toLocaleString('en')} executions`);
  if (run.status !== 0 || count < wanted) {
    console.error(run.stderr?.slice(-20_000) ?? run.error);
    console.error(`fuzz: ${name} ended with status ${run.status}; what it found is in ${folder}`);
    process.exitCode = 1;
  } else {
    rmSync(folder, { recursive: true });
  }
}
