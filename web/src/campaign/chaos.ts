// SPDX-License-Identifier: GPL-3.0-or-later
// The page of flights of chaos: what was violated and how it is flown again, what was drawn and what became of it, and the crashes
// that no promise of the firmware forbids.
import { byId, make } from '../dom';
import { table } from '../view/tables';
import { plotted } from './charts';
import { again } from './copy';
import type { ChaosCampaign, ChaosFlight, Happened } from './document';
import { bar, box, percent, scrolling, tile } from './parts';

const kSeeds = 12, kCrashes = 60;
type Figure = [name: string, unit: string, value: (flight: ChaosFlight) => number];
const kFigures: Figure[] = [
  ['Wind', 'm/s', ({ wind_mps }) => wind_mps],
  ['Events in a flight', '', ({ events }) => Object.values(events).reduce((a, b) => a + b, 0)],
  ['Flown', 's', ({ emulated_s }) => emulated_s],
];

const count = (number: number, word: string): string => `${number.toLocaleString('en')} ${word}${number === 1 ? '' : 's'}`;

function head({ flights, verdict, wall_s, emulated_s, firmware }: ChaosCampaign): void {
  const seeds = flights.map(({ seed }) => seed);
  document.title = 'Chaos';
  document.querySelector('h1')?.replaceChildren('Chaos');
  const chip = byId('verdict');
  chip.textContent = verdict.text;
  if (!verdict.good) chip.className = 'chip bad';
  byId('subtitle').textContent = [
    ...(seeds.length > 0 ? [`seeds from ${seeds.reduce((a, b) => Math.min(a, b))}`] : []), firmware,
    `${(emulated_s / 3600).toFixed(1)} h of flight in ${(wall_s / 60).toFixed(1)} min`,
    'missions, faults, restarts, sticks, parameters and hostile ground stations, all drawn from the seed'].join(' · ');
}

function tiles({ flown, planned, airborne, crashed, must_survive, violated }: ChaosCampaign): HTMLElement {
  return make('div', { id: 'tiles' },
    tile(violated.toLocaleString('en'), 'flights violated an invariant', `of ${flown.toLocaleString('en')}${flown < planned ? `, ${planned.toLocaleString('en')} planned` : ''}`),
    tile(must_survive.toLocaleString('en'), 'must not crash', 'all in them is survived'),
    tile(crashed.toLocaleString('en'), 'crashed', `${percent(crashed, flown)} of all`),
    tile(percent(airborne, flown), 'were in the air', count(airborne, 'flight')));
}

// The first flight of each invariant that has a scenario of its own, else the first.
function violations({ flights, violations: all }: ChaosCampaign): HTMLElement {
  if (all.length === 0) return make('p', { class: 'soft' }, 'none: every invariant was held by every flight');
  return table(['invariant', 'flights', 'of the first: at, s', 'what it was', 'seeds', 'fly it again'], all.map(({ name, flights: number }) => {
    const own = flights.filter((flight) => flight.violations.some((each) => each.name === name));
    const first = own.find(({ replay }) => replay) ?? own[0], what = first.violations.find((each) => each.name === name);
    const seeds = own.slice(0, kSeeds).map(({ seed }) => seed).join(', ') + (number > kSeeds ? ', …' : '');
    return [make('span', { class: 'missed' }, name), number, what?.time_s.toFixed(1) ?? '', make('span', { class: 'reason' }, what?.numbers ?? ''), seeds, again(first.replay ?? first.command)];
  }));
}

// Those first after which most flights crashed.
function drawn(all: Happened[], what: string): HTMLElement {
  const sorted = [...all].sort((a, b) => b.violated - a.violated || b.crashed / b.flights - a.crashed / a.flights);
  return table([what, 'times', 'flights', 'of them crashed', 'violated'], sorted.map(({ name, times, flights, crashed, violated }) =>
    [name, times, flights, bar(crashed, flights), violated > 0 ? make('span', { class: 'missed' }, String(violated)) : '0']));
}

const eventsOf = ({ events }: ChaosFlight): string => Object.entries(events).map(([name, times]) => (times > 1 ? `${times} × ${name}` : name)).join(', ') || 'nothing';

function crashes({ flights }: ChaosCampaign): HTMLElement[] {
  const allowed = flights.filter(({ crashed, must_survive }) => crashed && !must_survive);
  if (allowed.length === 0) return [make('p', { class: 'soft' }, 'none')];
  return [scrolling('Crashes that were allowed', table(['seed', 'airplane', 'wind, m/s', 'flown, s', 'what came', 'fly it again'], allowed.slice(0, kCrashes).map((flight) =>
    [make('b', {}, String(flight.seed)), flight.airplane, flight.wind_mps.toFixed(1) + (flight.gusts ? ' gusts' : ''), flight.emulated_s.toFixed(0),
      make('span', { class: 'reason' }, eventsOf(flight)), again(flight.command)]))),
  make('p', { class: 'soft' }, `${allowed.length > kCrashes ? `the first ${kCrashes} of ${allowed.length}; ` : ''}what came in them is more than docs/failsafes.md and docs/restart.md promise to survive`)];
}

function distribution(flights: ChaosFlight[], [name, unit, value]: Figure): HTMLElement {
  const sorted = (own: ChaosFlight[]): number[] => own.map(value).sort((a, b) => a - b);
  const curves = [{ colour: 'c0', dashed: false, values: sorted(flights.filter(({ crashed }) => !crashed)) },
    { colour: 'bad', dashed: false, values: sorted(flights.filter(({ crashed }) => crashed)) }].filter(({ values }) => values.length > 0);
  const place = make('div', { class: 'canvas-box', role: 'img', 'aria-label': `Distribution: ${name}, of the flights that crashed and of the others` });
  if (curves.length > 0) plotted(place, curves, [], Math.max(...curves.map(({ values }) => values[values.length - 1]), 1));
  return make('section', { class: 'distribution', 'data-figure': name }, make('h3', {}, unit ? `${name}, ${unit}` : name), place);
}

function legend(): HTMLElement {
  const line = (ink: string): HTMLElement => {
    const made = make('i');
    made.style.borderColor = `var(--${ink})`;
    return made;
  };
  return make('p', { class: 'legend' }, make('span', {}, line('c0'), 'did not crash'), make('span', {}, line('bad'), 'crashed'));
}

export function showChaos(campaign: ChaosCampaign): void {
  const { flights, flown } = campaign;
  head(campaign);
  byId('campaign-main').append(
    tiles(campaign),
    box('Violations', scrolling('Violations', violations(campaign))),
    make('div', { class: 'columns halves' },
      box('What was drawn', scrolling('What was drawn', drawn(campaign.events, 'event'), true)),
      make('div', { class: 'stack' },
        box('Airplanes', scrolling('Airplanes', drawn(campaign.airplanes, 'airplane'))),
        box('Crashes that were allowed', ...crashes(campaign)))),
    make('div', { class: 'bar' }, make('h2', {}, 'Flights that crashed and others'), legend(),
      make('span', { class: 'soft' }, flights.length < flown ? `the ${flights.length} flights that are listed` : '')),
    make('div', { id: 'distributions' }, ...kFigures.map((figure) => distribution(flights, figure))));
}
