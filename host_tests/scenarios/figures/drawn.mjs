// SPDX-License-Identifier: GPL-3.0-or-later
// A dozen drawn worlds: how many are flown to their end, and what share of them meets each limit, may only get better.
//   drawn.mjs HELD.json CAMPAIGN OUT
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const [held_path, campaign, out] = process.argv.slice(2);
const held = JSON.parse(readFileSync(held_path, 'utf8'));
const run = spawnSync(campaign, ['--drawn', held.worlds, '--out', out], { encoding: 'utf8' });
process.stdout.write(run.stdout);
process.stderr.write(run.stderr);
if (run.status !== 0 && run.status !== 1) throw new Error(`the campaign ended with ${run.status}`);

const percents = Object.fromEntries([...run.stdout.matchAll(/^(\S.*?), \S+ +[\d.]+ +(\d+)% /gm)]
  .map(([, figure, percent]) => [figure, Number(percent)]));
const failed = Number(/^\d+ flights, (\d+) failed$/m.exec(run.stdout)?.[1] ?? NaN);
const worse = Object.entries(held.met_percent)
  .filter(([figure, least]) => !(percents[figure] >= least))
  .map(([figure, least]) => `${figure}: ${percents[figure] ?? 'no'} % meet the limit, ${least} % did`);
if (!(failed <= held.failed)) worse.push(`${failed} flights failed, ${held.failed} did`);
for (const line of worse) console.log(`WORSE: ${line}`);
process.exit(worse.length === 0 ? 0 : 1);
