// SPDX-License-Identifier: GPL-3.0-or-later
// What the flights of the image took of the processor, held to its limits.
//   work_report.mjs budgets TASKS.json FLIGHT...     each task against its budget
//   work_report.mjs cycles BUDGETS.json FLIGHT...    frames, interrupts, tasks; a board or a flight has
//                                                    the budgets of all but for those under its name
// FLIGHT is a folder with a summary.json.
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

const kCycles_us = 16;

const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));
const readFlight = (folder) => ({ name: basename(folder), ...readJson(join(folder, 'summary.json')) });
const us = (count) => (count / kCycles_us).toFixed(1);
const percent = (share) => (share * 100).toFixed(1);

// Columns as wide as their widest cell; the first is words, the others are numbers.
function table(rows) {
  const width = rows[0].map((_, column) => Math.max(...rows.map((row) => String(row[column]).length)));
  return rows.map((row) => row.map((cell, column) => (
    column === 0 ? String(cell).padEnd(width[0]) : String(cell).padStart(width[column]))).join('  ').trimEnd()).join('\n');
}

// Over all flights: runs, mean and longest of everything with this key, and where the longest was.
function gathered(flights, list, key) {
  const all = new Map();
  for (const flight of flights)
    for (const entry of flight[list]) {
      const sum = all.get(entry[key]) ?? { runs: 0, cycles: 0, max_cycles: 0, where: '', name: entry.name };
      sum.runs += entry.runs;
      sum.cycles += entry.cycles ?? entry.mean_cycles * entry.runs;
      if (entry.max_cycles > sum.max_cycles) {
        sum.max_cycles = entry.max_cycles;
        sum.where = flight.name;
      }
      all.set(entry[key], sum);
    }
  return all;
}

// Their longest run is not in every flight: a mission sends a parameter while a link has no room.
const kSeldomLong = new Set(['reportVariables']);

// A budget says what a task takes: never less, and no more than double.
function verdict(name, longest_us, budget_us) {
  if (longest_us > budget_us) return 'OVER';
  return longest_us * 2 < budget_us && !kSeldomLong.has(name) ? 'too roomy' : 'ok';
}

function budgets([tasks, ...folders]) {
  const measured = gathered(folders.map(readFlight), 'tasks', 'number');
  const rows = readJson(tasks).map((task) => {
    const seen = measured.get(task.number);
    if (!seen) return [task.name, '-', '-', task.budget_us, '', 'never ran', ''];
    const longest_us = seen.max_cycles / kCycles_us;
    return [task.name, us(seen.cycles / seen.runs), longest_us.toFixed(1), task.budget_us,
      `${(100 * longest_us / task.budget_us).toFixed(0)} %`, verdict(task.name, longest_us, task.budget_us), seen.where];
  });
  console.log(table([['task', 'mean, us', 'longest, us', 'budget, us', 'used', '', 'longest in'], ...rows]));
  const wrong = rows.filter((row) => row[5] !== 'ok');
  console.log(`${rows.length - wrong.length} of ${rows.length} tasks lie between half their budget and all of it`);
  return wrong.length === 0;
}

function cycles([budgetsPath, ...folders]) {
  const flights = folders.map(readFlight);
  const all = readJson(budgetsPath);
  const faults = [];
  const hold = (flight, what, value, most) => {
    if (typeof value !== 'number' || typeof most !== 'number') faults.push(`${flight.name}: ${what} is not known`);
    else if (value > most) faults.push(`${flight.name}: ${what} ${value} is more than ${most}`);
  };
  const rows = flights.map((flight) => {
    const longest = Math.max(...flight.interrupts.map((interrupt) => interrupt.max_cycles));
    const budget = { ...all, ...all[flight.board], ...all[flight.name] };
    hold(flight, 'processor load in percent', 100 * flight.cpu_load, budget.processor_percent);
    // the rough flight's lists and uploads are answered in what the frames leave
    const fills = ['elf_rough', 'elf_failsafes'].includes(flight.name);
    if (!fills) hold(flight, 'longest frame', flight.frame_max_us, budget.frame_us);
    hold(flight, 'interrupts in percent', 100 * flight.interrupt_load, budget.interrupts_percent);
    hold(flight, 'longest interrupt in cycles', longest, budget.interrupt_cycles);
    hold(flight, 'frames late', flight.frame_overruns, 0);
    if (flight.board !== 'apm1') {  // nothing there says when a sample is ready
      hold(flight, 'longest latency', flight.latency_max_us, budget.gyro_to_servo_us);
      hold(flight, 'inertial samples lost', flight.imu_samples_lost, 0);
      hold(flight, 'inertial samples read twice', flight.imu_samples_repeated, 0);
    }
    return [flight.name, percent(flight.cpu_load), percent(flight.interrupt_load), flight.frames,
      flight.frame_mean_us, flight.frame_p99_us, flight.frame_max_us, flight.frame_overruns, flight.latency_mean_us,
      flight.latency_max_us, us(longest),
      flight.imu_samples, flight.imu_samples_lost, flight.imu_samples_repeated];
  });
  console.log('busy time per frame, interrupts and received bytes included; from the newest inertial sample to the last servo; longest interrupt; inertial samples\n');
  console.log(table([['flight', 'CPU, %', 'interrupts, %', 'frames', 'mean, us', 'p99, us', 'max, us', 'late',
    'latency, us', 'max, us', 'interrupt, us', 'samples', 'lost', 'twice'], ...rows]));
  for (const [list, key, what] of [['tasks', 'number', 'task'], ['interrupts', 'vector', 'interrupt']]) {
    const emulated = flights.reduce((sum, flight) => sum + flight.emulated_s, 0) * 1e6 * kCycles_us;
    const entries = [...gathered(flights, list, key)].map(([number, seen]) => [seen.name ?? number, seen.runs,
      Math.round(seen.cycles / seen.runs), seen.max_cycles, us(seen.cycles / seen.runs), us(seen.max_cycles),
      (100 * seen.cycles / emulated).toFixed(2)]);
    console.log(`\n${table([[what, 'runs', 'mean, cycles', 'longest, cycles', 'mean, us', 'longest, us', 'load, %'],
      ...entries])}`);
  }
  for (const fault of faults) console.log(`FAILED  ${fault}`);
  return faults.length === 0;
}

const verbs = { budgets, cycles };
const [verb, ...words] = process.argv.slice(2);
if (!verbs[verb] || words.length < 2) {
  console.error('usage: work_report.mjs budgets|cycles FILE FLIGHT...');
  process.exitCode = 2;
} else if (!verbs[verb](words)) {
  process.exitCode = 1;
}
