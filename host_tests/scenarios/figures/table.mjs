// SPDX-License-Identifier: GPL-3.0-or-later
// How exactly it flies: flies a mission natively with each airplane in calm air and in wind with
// gusts, three seeds each, and holds the worst of the three of every figure.
//   table.mjs LIMITS.json FLY MISSION OUT [AIRPLANE=FOUND.param ...]
// With parameters that AUTOTUNE has found, the airplanes named fly on those, and the goals are LIMITS.json's "tuned_times" of the others.
// An air is words of the command line or a --world; LIMITS.json's "settings" are set beside the airplane's own parameters.
// A figure may be no more than its goal, or, where LIMITS.json says "least", no less. It is held at its goal, or, where LIMITS.json
// says "held", there: what is reached today with some room, so that it can only get better. What landings.mjs holds over many
// flights is only shown.
import { readFileSync } from 'node:fs';

import { flyEach, parametersFound, printTable } from './flights.mjs';

const [limits_path, fly, mission, out, ...found] = process.argv.slice(2);
const limits = JSON.parse(readFileSync(limits_path, 'utf8'));
const tuned = parametersFound(found);
const airplanes = found.length > 0 ? Object.keys(tuned) : limits.airplanes;

// NaN where a flight does not have the figure: it is within no limit.
function worstOf(flights, { key, least }) {
  const values = flights.map((flight) => (typeof flight[key] === 'number' ? flight[key] : NaN));
  return least ? Math.min(...values) : Math.max(...values);
}

const within = (figure, value, limit) => (figure.least ? value >= limit : value <= limit);

function verdict(figure, worst, goal, limit) {
  if (!within(figure, worst, limit)) return 'NOT HELD';
  if (!within(figure, worst, goal)) return 'goal not met';
  return within(figure, limit, goal) ? 'met' : 'met, but not by enough to hold it there';
}

function goalOf(figure, airplane, air) {
  const goal = (figure.goal[airplane] ?? figure.goal)[air];
  return found.length > 0 ? Number((goal * limits.tuned_times).toFixed(3)) : goal;
}

function limitOf(figure, airplane, air) {
  return (found.length === 0 && figure.held?.[airplane]?.[air]) || goalOf(figure, airplane, air);
}

const heldByLandings = (figure, air) => air === limits.landings?.air &&
  limits.landings.figures.some((each) => each.key === figure.key && each.instead_of_worst);

function rowOf(figure, airplane, air, flights) {
  const worst = worstOf(flights.filter((flight) => flight.airplane === airplane && flight.air === air), figure);
  const goal = goalOf(figure, airplane, air);
  const limit = limitOf(figure, airplane, air);
  const held = heldByLandings(figure, air) ? ['-', 'see landings'] : [limit, verdict(figure, worst, goal, limit)];
  return [`${figure.name}, ${figure.unit}`, air, goal, worst.toFixed(2), held[0], figure.peer?.[air] ?? '-', held[1]].map(String);
}

const { flights, broken: incomplete } = await flyEach({ airplanes, airs: Object.keys(limits.airs), seeds: limits.seeds },
  { fly, mission, out, airs: limits.airs, parameters: tuned, settings: limits.settings });
let broken = incomplete;
for (const airplane of airplanes) {
  const rows = limits.figures.flatMap((figure) => Object.keys(limits.airs).map(
    (air) => rowOf(figure, airplane, air, flights)));
  console.log(`\n${airplane}, worst of seeds ${limits.seeds.join(', ')}\n`);
  printTable([['figure', 'air', 'goal', 'flown', 'held at', 'peer', ''], ...rows]);
  const count = (word) => rows.filter((row) => row[6].startsWith(word)).length;
  console.log(`\n${count('met')} of ${rows.length} meet their goal, ${count('NOT HELD')} are not held`);
  broken += count('NOT HELD');
}
process.exit(broken === 0 ? 0 : 1);
