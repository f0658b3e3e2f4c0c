// SPDX-License-Identifier: GPL-3.0-or-later
// How it lands in gusts: many landings of each airplane, as a dozen are also luck. The median
// and the 95th percentile of all of them are held; those of each airplane are shown.
//   landings.mjs LIMITS.json FLY MISSION OUT [AIRPLANE=FOUND.param ...]
// With parameters that AUTOTUNE has found, the airplanes named fly on those, within "held_tuned".
import { readFileSync } from 'node:fs';

import { flyEach, parametersFound, printTable } from './flights.mjs';

const [limits_path, fly, mission, out, ...found] = process.argv.slice(2);
const limits = JSON.parse(readFileSync(limits_path, 'utf8'));
const { airs, landings } = limits;
const parameters = parametersFound(found);
const airplanes = found.length > 0 ? Object.keys(parameters) : limits.airplanes;
const limitsOf = (figure) => (found.length > 0 ? figure.held_tuned : figure.held);

// By nearest rank: a value that was flown. NaN where a flight does not have the figure.
function percentile(values, percent) {
  if (values.some((value) => typeof value !== 'number')) return NaN;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.ceil(sorted.length * percent / 100) - 1];
}

const seeds = Array.from({ length: found.length > 0 ? landings.seeds_tuned : landings.seeds }, (_, i) => i + 1);
const { flights, broken: incomplete } = await flyEach({ airplanes, airs: [landings.air], seeds }, { fly, mission, out, airs, parameters });
let broken = incomplete;
const rows = landings.figures.flatMap((figure) => Object.entries(limitsOf(figure)).map(([percent, most]) => {
  const { name, unit, key } = figure;
  const value = (of) => percentile(of.map((flight) => flight[key]), Number(percent));
  const all = value(flights);
  const good = all <= most;
  if (!good) ++broken;
  return [`${name}, ${unit}`, `${percent} %`, ...airplanes.map((airplane) => value(flights.filter(
    (flight) => flight.airplane === airplane)).toFixed(2)), all.toFixed(2), String(most), good ? 'held' : 'NOT HELD'];
}));
printTable([['figure', 'of landings', ...airplanes, `all ${flights.length}`, 'held at', ''], ...rows]);
process.exit(broken === 0 ? 0 : 1);
