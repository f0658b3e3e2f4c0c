// SPDX-License-Identifier: GPL-3.0-or-later
// Flies natively in the airs of LIMITS.json, as many at a time as there are cores.
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const kAirplanes = fileURLToPath(new URL('../../../simulator/airplanes', import.meta.url));

// An air is words of fly's command line, or an object: a --world FILE.
function wordsOf(air, folder) {
  if (Array.isArray(air)) return air;
  const world = join(folder, 'world.json');
  writeFileSync(world, JSON.stringify(air));
  return ['--world', world];
}

// The airplane's own .param file with more lines behind it.
function withSettings(airplane, settings, folder) {
  const own = readFileSync(join(kAirplanes, `${airplane}.param`), 'utf8');
  const file = join(folder, 'settings.param');
  writeFileSync(file, [own, ...settings, ''].join('\n'));
  return file;
}

// What a flight's summary says, with the flight's own { airplane, air, seed }. A flight that does not
// complete has a summary, too; a program that ends otherwise is an error.
function flown(flight, { fly, mission, out, airs, parameters, settings }) {
  const folder = join(out, `${flight.airplane}_${flight.air}_${flight.seed}`);
  mkdirSync(folder, { recursive: true });
  const file = settings ? withSettings(flight.airplane, settings, folder) : parameters[flight.airplane];
  const words = ['--native', '--airplane', flight.airplane, '--seed', flight.seed, ...wordsOf(airs[flight.air], folder),
    ...(file ? ['--param', file] : []), '--out', folder, mission].map(String);
  return new Promise((resolve, reject) => {
    const run = spawn(fly, words, { stdio: ['ignore', 'ignore', 'inherit'] });
    run.on('error', reject);
    run.on('close', (status) => (status === 0 || status === 1
      ? resolve({ ...flight, ...JSON.parse(readFileSync(join(folder, 'summary.json'), 'utf8')) })
      : reject(new Error(`${fly} ${words.join(' ')} ended with ${status}`))));
  });
}

// In the order of the flights.
async function flyAll(flights, how) {
  const results = [];
  let next = 0;
  const work = async () => {
    for (let i; (i = next++) < flights.length;) results[i] = await flown(flights[i], how);
  };
  await Promise.all(Array.from({ length: cpus().length }, work));
  return results;
}

// From words AIRPLANE=FILE.param of the command line: by airplane.
export const parametersFound = (words) => Object.fromEntries(words.map((each) => each.split('=')));

// Those of every airplane, air and seed; what did not complete is printed with its reason.
export async function flyEach({ airplanes, airs, seeds }, how) {
  const flights = await flyAll(airplanes.flatMap((airplane) => airs.flatMap(
    (air) => seeds.map((seed) => ({ airplane, air, seed })))), how);
  const broken = flights.filter((flight) => !flight.completed);
  for (const flight of broken)
    console.log(`${flight.airplane}, ${flight.air}, seed ${flight.seed}: ${flight.reason}`);
  return { flights, broken: broken.length };
}

export function printTable(rows) {
  const width = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const line = (row) => `| ${row.map((cell, column) => cell.padEnd(width[column])).join(' | ')} |`;
  console.log([line(rows[0]), `|${width.map((w) => '-'.repeat(w + 2)).join('|')}|`, ...rows.slice(1).map(line)].join('\n'));
}
