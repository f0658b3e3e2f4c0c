// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the schedule as JSON, for whoever shows what the tasks took: number, name, tier, period
// and phase in frames, and budget.
//   node toolchain/schedule/task_rows.mjs firmware/app/tasks.cpp TASKS.json
import { readFileSync, writeFileSync } from 'node:fs';

export function taskRows(source) {
  const table = /#define TASKS\(TASK\)((?:.*\\\n)*.*\n)/.exec(source)?.[1];
  if (table === undefined) throw new Error('there is no table TASKS');
  const bare = table.replace(/\/\*.*?\*\//g, '');
  const rows = [...bare.matchAll(/TASK\(\s*(fast|medium|slow)\s*,\s*(\w+)\s*,\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*\)/g)];
  const opened = bare.split('(').length - 1;
  if (rows.length === 0 || rows.length !== opened)
    throw new Error(`of ${opened} rows only ${rows.length} could be read`);
  return rows.map(([, tier, name, period, phase, budget], number) => (
    { number, name, tier, period: Number(period), phase: Number(phase), budget_us: Number(budget) }));
}

if (process.argv[1]?.endsWith('task_rows.mjs')) {
  const [source, target] = process.argv.slice(2);
  try {
    writeFileSync(target, `${JSON.stringify(taskRows(readFileSync(source, 'utf8')), null, 1)}\n`);
  } catch (error) {
    console.error(`task_rows: ${source}: ${error.message}`);
    process.exitCode = 1;
  }
}
