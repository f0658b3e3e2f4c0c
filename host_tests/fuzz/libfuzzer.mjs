// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer program run for a counted number of executions, which it says; fewer, or a crash, is
// a failure of the process, and what the fuzzer found is kept.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export function fuzz({ program, name, seeds, wanted, longest, environment }) {
  const folder = mkdtempSync(join(tmpdir(), 'fuzz-'));
  for (const [i, seed] of seeds.entries()) writeFileSync(join(folder, `seed_${i}`), seed);
  const run = spawnSync(program, [folder, `-runs=${wanted}`, '-seed=1', `-max_len=${longest}`,
    '-print_final_stats=1', '-detect_leaks=0', `-artifact_prefix=${folder}/`, '-verbosity=0'],
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
