// SPDX-License-Identifier: GPL-3.0-or-later
// What simulator/campaign/document.cpp gives to the page (docs/campaign_document.md), and what is worked out of it.

export interface Flown {
  seed: number; command: string; completed: boolean; figures: Record<string, number>; failure?: string;
  touchdown_m?: [long: number, right: number];
  report?: string;
}
export interface Figure { figure: string; name: string; unit: string }
interface Document {
  format: 'apm-campaign'; version: number; verdict: { good: boolean; text: string }; planned: number; wall_s: number; emulated_s: number;
}

export interface Flight extends Flown { airplane: string; mission: string; wind: string; calm: boolean; command_on_the_chip: string }
export interface Goal extends Figure { calm: number; windy: number }
export interface Campaign extends Document { kind: 'planned'; goals: Goal[]; flights: Flight[] }

export interface DrawnFlight extends Flown { met_all: boolean; world: Record<string, number> }
export interface Limit extends Figure { limit: number }
export interface Drawn { key: string; name: string; unit: string }
export interface DrawnCampaign extends Document {
  kind: 'drawn'; limit_times: number; met_all: number; drawn: Drawn[]; goals: Limit[]; flights: DrawnFlight[];
}

// Of flights of chaos: an event, an airplane; how often it came, in how many flights, and what became of those.
export interface Happened { name: string; times: number; flights: number; crashed: number; violated: number }
export interface Violation { time_s: number; name: string; numbers: string }
export interface ChaosFlight {
  seed: number; command: string; airplane: string; wind_mps: number; gusts: boolean; emulated_s: number; airborne: boolean; crashed: boolean;
  must_survive: boolean; events: Record<string, number>; violations: Violation[]; scenario?: string; replay?: string;
}
export interface ChaosCampaign extends Document {
  kind: 'chaos'; firmware: string; flown: number; airborne: number; crashed: number; must_survive: number; violated: number;
  airplanes: Happened[]; events: Happened[]; violations: { name: string; flights: number }[]; flights: ChaosFlight[];
}

export type AnyCampaign = Campaign | DrawnCampaign | ChaosCampaign;

export function parse(text: string): AnyCampaign {
  const found = JSON.parse(text) as Partial<AnyCampaign>;
  if (found.format !== 'apm-campaign' || found.version !== 2) throw new Error('this is no campaign');
  return found as AnyCampaign;
}

// Whether it lands and where, then how it keeps its way, then what it knows of itself.
const kOrder = ['landed_distance_m', 'touchdown_sink_mps', 'crosstrack_rms_m', 'crosstrack_settled_rms_m', 'altitude_level_rms_m',
  'altitude_sloped_rms_m', 'airspeed_rms_mps', 'loiter_radius_rms_m'];
const placeOf = ({ figure }: Figure): number => (kOrder.includes(figure) ? kOrder.indexOf(figure) : kOrder.length);
export const inOrder = <T extends Figure>(figures: T[]): T[] => [...figures].sort((a, b) => placeOf(a) - placeOf(b));

export const different = (names: string[]): string[] => [...new Set(names)];
export const goalFor = (goal: Goal, flight: Flight): number => (flight.calm ? goal.calm : goal.windy);

export function sortedValues(flights: Flown[], figure: string): number[] {
  return flights.map(({ figures }) => figures[figure]).filter((value) => Number.isFinite(value)).sort((a, b) => a - b);
}

// `share` 0..1 of the values are not larger (nearest rank); NaN of none.
export function percentile(sorted: number[], share: number): number {
  const rank = Math.min(Math.max(Math.ceil(share * sorted.length), 1), sorted.length);
  return sorted[rank - 1] ?? NaN;
}

export function shareWithin(flights: Flight[], goal: Goal): number {
  const known = flights.filter(({ figures }) => Number.isFinite(figures[goal.figure]));
  return known.length === 0 ? NaN : known.filter((flight) => flight.figures[goal.figure] <= goalFor(goal, flight)).length / known.length;
}

// A figure that a flight does not have is held against nothing.
export const keepsAll = (flight: Flight, goals: Goal[]): boolean => flight.completed
  && goals.every((goal) => !(flight.figures[goal.figure] > goalFor(goal, flight)));

export interface Worst { flight: Flight; goal?: Goal; times: number }

// By how many times its goal a flight's worst figure is; one that failed is worse than all that did not.
export function worst(campaign: Campaign, count: number): Worst[] {
  const ranked = campaign.flights.map((flight): Worst => {
    let most: Worst = { flight, times: flight.failure ? Infinity : 0 };
    for (const goal of campaign.goals) {
      const times = flight.figures[goal.figure] / goalFor(goal, flight);
      if (times > most.times) most = { flight, goal, times };
    }
    return most;
  });
  return ranked.sort((a, b) => b.times - a.times).slice(0, count);
}
