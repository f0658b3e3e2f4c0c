// SPDX-License-Identifier: GPL-3.0-or-later
// How exactly it flies: flies a mission natively with each airplane in calm air and in wind with
// gusts, three seeds each, and holds the worst of the three of every figure.
//   table.mjs LIMITS.json FLY MISSION OUT [AIRPLANE=FOUND.param ...]
// With parameters that AUTOTUNE has found, the airplanes named fly on those, and the goals are LIMITS.json's "tuned_times" of the others.
// On the sensor errors of --calibrated. A figure is held at its goal, or, where LIMITS.json says "held", there: what is reached today
// with some room, so that it can only get better.
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';

const [limits_path, fly, mission, out, ...found] = process.argv.slice(2);
const limits = JSON.parse(readFileSync(limits_path, 'utf8'));
const tuned = Object.fromEntries(found.map((each) => each.split('=')));
const airplanes = found.length > 0 ? Object.keys(tuned) : limits.airplanes;

function flown(flight) {
  const folder = join(out, `${flight.airplane}_${flight.air}_${flight.seed}`);
  mkdirSync(folder, { recursive: true });
  const words = ['--native', '--airplane', flight.airplane, '--seed', flight.seed, ...limits.airs[flight.air],
    ...(tuned[flight.airplane] ? ['--param', tuned[flight.airplane]] : []), '--out', folder, mission].map(String);
  return new Promise((resolve, reject) => {
    const run = spawn(fly, words, { stdio: ['ignore', 'ignore', 'inherit'] });
    run.on('error', reject);
    run.on('close', (status) => (status === 0 || status === 1
      ? resolve({ ...flight, ...JSON.parse(readFileSync(join(folder, 'summary.json'), 'utf8')) })
      : reject(new Error(`${fly} ${words.join(' ')} ended with ${status}`))));
  });
}

// As many at a time as there are cores, in the order of the flights.
async function all(flights) {
  const results = [];
  let next = 0;
  const work = async () => {
    for (let i; (i = next++) < flights.length;) results[i] = await flown(flights[i]);
  };
  await Promise.all(Array.from({ length: cpus().length }, work));
  return results;
}

// NaN where a flight does not have the figure: it is within no limit.
const worstOf = (flights, key) => flights.reduce(
  (worst, flight) => Math.max(worst, typeof flight[key] === 'number' ? flight[key] : NaN), -Infinity);

function verdict(worst, goal, most) {
  if (!(worst <= most)) return 'NOT HELD';
  if (worst > goal) return 'goal not met';
  return most > goal ? 'met, but not by enough to hold it there' : 'met';
}

function goalOf(figure, air) {
  const goal = figure.goal[air];
  return found.length > 0 ? Number((goal * limits.tuned_times).toFixed(3)) : goal;
}

function mostOf(figure, airplane, air) {
  return (found.length === 0 && figure.held?.[airplane]?.[air]) || goalOf(figure, air);
}

function rowOf(figure, airplane, air, flights) {
  const worst = worstOf(flights.filter((flight) => flight.airplane === airplane && flight.air === air), figure.key);
  const goal = goalOf(figure, air);
  const most = mostOf(figure, airplane, air);
  return [`${figure.name}, ${figure.unit}`, air, goal, worst.toFixed(2), most, figure.peer?.[air] ?? '-',
    verdict(worst, goal, most)].map(String);
}

function print(rows) {
  const width = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const line = (row) => `| ${row.map((cell, column) => cell.padEnd(width[column])).join(' | ')} |`;
  console.log([line(rows[0]), `|${width.map((w) => '-'.repeat(w + 2)).join('|')}|`, ...rows.slice(1).map(line)].join('\n'));
}

const flights = await all(airplanes.flatMap((airplane) => Object.keys(limits.airs).flatMap(
  (air) => limits.seeds.map((seed) => ({ airplane, air, seed })))));
let broken = 0;
for (const flight of flights.filter((each) => !each.completed)) {
  ++broken;
  console.log(`${flight.airplane}, ${flight.air}, seed ${flight.seed}: ${flight.reason}`);
}
for (const airplane of airplanes) {
  const rows = limits.figures.flatMap((figure) => Object.keys(limits.airs).map(
    (air) => rowOf(figure, airplane, air, flights)));
  console.log(`\n${airplane}, worst of seeds ${limits.seeds.join(', ')}\n`);
  print([['figure', 'air', 'goal', 'flown', 'held at', 'peer', ''], ...rows]);
  const count = (word) => rows.filter((row) => row[6].startsWith(word)).length;
  console.log(`\n${count('met')} of ${rows.length} meet their goal, ${count('NOT HELD')} are not held`);
  broken += count('NOT HELD');
}
process.exit(broken === 0 ? 0 : 1);
