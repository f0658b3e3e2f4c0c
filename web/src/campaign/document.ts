// SPDX-License-Identifier: GPL-3.0-or-later
// What simulator/campaign/page.cpp gives to the page, and what is worked out of it.

export interface Flight {
  airplane: string; mission: string; wind: string; calm: boolean; seed: number; command: string; command_on_the_chip: string;
  figures: Record<string, number>; failure?: string; touchdown_m?: [long: number, right: number];
}
export interface Goal { figure: string; name: string; unit: string; calm: number; windy: number }
export interface Campaign {
  format: 'apm-campaign'; version: number; verdict: { good: boolean; text: string }; wall_s: number; emulated_s: number;
  goals: Goal[]; flights: Flight[];
}

export function parse(text: string): Campaign {
  const found = JSON.parse(text) as Partial<Campaign>;
  if (found.format !== 'apm-campaign' || found.version !== 1) throw new Error('this is no campaign');
  return found as Campaign;
}

export const different = (names: string[]): string[] => [...new Set(names)];
export const goalFor = (goal: Goal, flight: Flight): number => (flight.calm ? goal.calm : goal.windy);

export function sortedValues(flights: Flight[], figure: string): number[] {
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
