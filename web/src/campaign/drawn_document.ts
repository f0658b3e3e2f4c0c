// SPDX-License-Identifier: GPL-3.0-or-later
// What is worked out of flights in drawn worlds.
import { percentile, sortedValues } from './document';
import type { Drawn, DrawnCampaign, DrawnFlight, Limit } from './document';

// A flight that does not have the figure has not met its limit.
export const meets = (flight: DrawnFlight, { figure, limit }: Limit): boolean => flight.figures[figure] <= limit;

export interface Share { limit: Limit; met: number; flights: number; median: number; p95: number; worst: number; worst_seed?: number }

export function shareOf(flights: DrawnFlight[], limit: Limit): Share {
  const values = sortedValues(flights, limit.figure), worst = values[values.length - 1];
  return {
    limit, met: flights.filter((flight) => meets(flight, limit)).length, flights: flights.length,
    median: percentile(values, 0.5), p95: percentile(values, 0.95), worst: worst ?? NaN,
    worst_seed: values.length === 0 ? undefined : flights.find(({ figures }) => figures[limit.figure] === worst)?.seed,
  };
}

export interface Miss { flight: DrawnFlight; limit: Limit; times: number }

// Flown to their end, with the figure that misses its limit by most; those first that miss by most.
export function misses({ flights, goals }: DrawnCampaign): Miss[] {
  return flights.filter(({ completed, met_all }) => completed && !met_all).map((flight) => {
    const times = goals.map((limit) => (flight.figures[limit.figure] ?? Infinity) / limit.limit);
    const most = times.indexOf(Math.max(...times));
    return { flight, limit: goals[most], times: times[most] };
  }).sort((a, b) => b.times - a.times);
}

export interface Reason { reason: string; flights: DrawnFlight[] }

// By their reasons but for the numbers in them; the most frequent first.
export function failuresOf(flights: DrawnFlight[]): Reason[] {
  const reasons = new Map<string, DrawnFlight[]>();
  for (const flight of flights.filter(({ completed }) => !completed)) {
    const reason = (flight.failure ?? '').split('; it said')[0].replace(/^drawn: /, '').replace(/^violated: [\d.]+ s (\w+):.*/, 'violated: $1').replace(/\b\d+(?= m from\b)/, '…').replace(/item \d+/, 'item …');
    reasons.set(reason, [...(reasons.get(reason) ?? []), flight]);
  }
  return [...reasons].map(([reason, of]) => ({ reason, flights: of })).sort((a, b) => b.flights.length - a.flights.length);
}

export interface Part { from: number; to: number; met: number; flights: number }
export interface Dependence { drawn: Drawn; parts: Part[]; spread: number }

function partOf(flights: DrawnFlight[], key: string, good: (flight: DrawnFlight) => boolean): Part {
  const values = flights.map(({ world }) => world[key]);
  return { from: Math.min(...values), to: Math.max(...values), met: flights.filter(good).length, flights: flights.length };
}

// The flights in thirds by a drawn value, or by its values where there are no more than three. `spread`: between the best part's
// share and the worst's, in units of what chance alone gives.
function dependenceOn(flights: DrawnFlight[], drawn: Drawn, good: (flight: DrawnFlight) => boolean): Dependence {
  const known = flights.filter(({ world }) => Number.isFinite(world[drawn.key])).sort((a, b) => a.world[drawn.key] - b.world[drawn.key]);
  const values = [...new Set(known.map(({ world }) => world[drawn.key]))];
  const third = (part: number): number => Math.round(part * known.length / 3);
  const parts = (values.length <= 3 ? values.map((value) => known.filter(({ world }) => world[drawn.key] === value))
    : [0, 1, 2].map((part) => known.slice(third(part), third(part + 1)))).filter(({ length }) => length > 0).map((part) => partOf(part, drawn.key, good));
  const shares = parts.map(({ met, flights: all }) => met / all), mean = known.filter(good).length / Math.max(1, known.length);
  const chance = Math.sqrt(Math.max(mean * (1 - mean), 1e-9) * 3 / Math.max(1, known.length));
  return { drawn, parts, spread: parts.length < 2 ? 0 : (Math.max(...shares) - Math.min(...shares)) / chance };
}

// What it depends on most, first.
export const dependences = ({ flights, drawn }: DrawnCampaign, good: (flight: DrawnFlight) => boolean): Dependence[] =>
  drawn.map((each) => dependenceOn(flights, each, good)).sort((a, b) => b.spread - a.spread);
