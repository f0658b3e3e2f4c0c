// SPDX-License-Identifier: GPL-3.0-or-later
// How it lands in gusts: a dozen landings of each airplane, as a single one is also luck. The median
// and the 95th percentile of all of them are held; those of each airplane are shown.
//   landings.mjs LIMITS.json FLY MISSION OUT
import { readFileSync } from 'node:fs';

import { flyEach, printTable } from './flights.mjs';

const [limits_path, fly, mission, out] = process.argv.slice(2);
const { airplanes, airs, landings } = JSON.parse(readFileSync(limits_path, 'utf8'));

// By nearest rank: a value that was flown. NaN where a flight does not have the figure.
function percentile(values, percent) {
  if (values.some((value) => typeof value !== 'number')) return NaN;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.ceil(sorted.length * percent / 100) - 1];
}

const seeds = Array.from({ length: landings.seeds }, (_, i) => i + 1);
const { flights, broken: incomplete } = await flyEach({ airplanes, airs: [landings.air], seeds }, { fly, mission, out, airs, parameters: {} });
let broken = incomplete;
const rows = landings.figures.flatMap(({ name, unit, key, held }) => Object.entries(held).map(([percent, most]) => {
  const value = (of) => percentile(of.map((flight) => flight[key]), Number(percent));
  const all = value(flights);
  const good = all <= most;
  if (!good) ++broken;
  return [`${name}, ${unit}`, `${percent} %`, ...airplanes.map((airplane) => value(flights.filter(
    (flight) => flight.airplane === airplane)).toFixed(2)), all.toFixed(2), String(most), good ? 'held' : 'NOT HELD'];
}));
printTable([['figure', 'of landings', ...airplanes, `all ${flights.length}`, 'held at', ''], ...rows]);
process.exit(broken === 0 ? 0 : 1);
