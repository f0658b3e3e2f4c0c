// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a campaign: how many flights keep each goal, where they touch down, the worst ten.
import { byId, colour, make } from '../dom';
import { table } from '../view/tables';
import { airplaneColour, distribution, scatter } from './charts';
import { showChaos } from './chaos';
import { again } from './copy';
import { different, goalFor, inOrder, keepsAll, parse, percentile, sortedValues, worst } from './document';
import type { Campaign, Flight, Worst } from './document';
import { showDrawn } from './drawn';
import { box, percent, reportLink, scrolling, tile } from './parts';

const kWorst = 10, kMaxFailures = 50, kLanding = 'landed_distance_m';

const nameOf = ({ airplane, mission, wind, seed }: Flight): string => `${airplane} ${mission} ${wind}, seed ${seed}`;
const groupOf = ({ airplane, mission, wind }: Flight): string => `${airplane} ${mission} ${wind}`;
const count = (all: string[], word: string): string => `${different(all).length} ${word}${different(all).length === 1 ? '' : 's'}`;

function head(campaign: Campaign): void {
  const { flights, verdict, wall_s, emulated_s } = campaign;
  const chip = byId('verdict');
  chip.textContent = verdict.text;
  if (!verdict.good) chip.className = 'chip bad';
  byId('subtitle').textContent = [
    `${flights.length} flights`, count(flights.map(({ airplane }) => airplane), 'airplane'), count(flights.map(({ mission }) => mission), 'mission'),
    count(flights.map(({ wind }) => wind), 'wind'), `${(emulated_s / 3600).toFixed(1)} h of flight in ${(wall_s / 60).toFixed(1)} min`,
    'natively compiled firmware · sensor errors and gusts drawn from each seed'].join(' · ');
}

function tiles({ flights, goals, planned }: Campaign): HTMLElement {
  const of = (count_: number): string => `${count_} of ${flights.length}`;
  const kept = flights.filter((flight) => keepsAll(flight, goals)).length, done = flights.filter(({ completed }) => completed).length;
  const landing = goals.find(({ figure }) => figure === kLanding);
  const landed = flights.filter((flight) => landing && flight.figures[kLanding] <= goalFor(landing, flight)).length;
  return make('div', { id: 'tiles' },
    tile(percent(kept, flights.length), 'every goal kept', `by ${of(kept)}`),
    tile(percent(done, flights.length), 'flown to the end', of(done)),
    ...(landing ? [tile(percent(landed, flights.length), 'touched down in place', `within ${landing.calm} m, in wind ${landing.windy} m`)] : []),
    ...(flights.length < planned ? [tile(String(planned - flights.length), 'not flown', `of ${planned}`)] : []));
}

function legend(campaign: Campaign): HTMLElement {
  const entries = different(campaign.flights.map(({ airplane }) => airplane)).map((airplane) => {
    const line = make('i');
    line.style.borderColor = airplaneColour(campaign, airplane);
    return make('span', {}, line, airplane);
  });
  const goal = make('i');
  goal.style.borderColor = colour('bad');
  return make('p', { class: 'legend' }, ...entries, make('span', {}, make('i'), 'calm'), make('span', {}, make('i', { class: 'demand' }), 'wind'), make('span', {}, goal, 'goal'));
}

function worstTable(all: Worst[]): HTMLElement {
  return table(['flight', 'seed', 'worst figure', 'value', 'goal', 'times', 'report', 'fly it again'], all.map(({ flight, goal, times }) => [
    groupOf(flight), flight.seed,
    flight.failure ? make('span', { class: 'missed' }, flight.failure) : goal ? `${goal.name}, ${goal.unit}` : '',
    goal && !flight.failure ? flight.figures[goal.figure].toFixed(2) : '', goal && !flight.failure ? goalFor(goal, flight) : '',
    Number.isFinite(times) ? make('span', { class: times > 1 ? 'missed' : 'met' }, times.toFixed(2)) : '',
    reportLink(flight.report, nameOf(flight)), again(flight.command),
  ]));
}

function spreads(flights: Flight[], figure: string): HTMLElement {
  return table(['', 'flights', 'median', '95 of 100', 'worst', 'its seed'], different(flights.map(groupOf)).flatMap((group) => {
    const own = flights.filter((flight) => groupOf(flight) === group), values = sortedValues(own, figure);
    if (values.length === 0) return [];
    const last = values[values.length - 1];
    return [[group, values.length, ...[percentile(values, 0.5), percentile(values, 0.95), last].map((value) => value.toFixed(2)),
      own.find(({ figures }) => figures[figure] === last)?.seed ?? '']];
  }));
}

function chosen(name: string, all: string[], run: () => void): HTMLSelectElement {
  const select = make('select', { 'aria-label': name }, ...all.map((each) => make('option', { value: each }, each)));
  select.addEventListener('change', run);
  return select;
}

class Page {
  private readonly charts = make('div', { id: 'distributions' });
  private readonly landing = make('div', {});
  private readonly spread = make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Spread of a figure by group' });
  private readonly mission: HTMLSelectElement;
  private readonly wind: HTMLSelectElement;
  private readonly figure: HTMLSelectElement;

  constructor(private readonly campaign: Campaign) {
    const { flights, goals } = campaign;
    const draw = (): void => this.draw();
    this.mission = chosen('Mission', ['every mission', ...different(flights.map(({ mission }) => mission))], draw);
    this.wind = chosen('Wind', ['every wind', ...different(flights.map(({ wind }) => wind))], draw);
    const figures = different([...inOrder(goals).map(({ figure }) => figure), ...flights.flatMap((flight) => Object.keys(flight.figures))]);
    this.figure = chosen('Figure', figures.filter((figure) => flights.some((flight) => figure in flight.figures)), draw);
    byId('campaign-main').append(tiles(campaign),
      make('div', { class: 'bar' }, make('h2', {}, 'Goals kept'), legend(campaign), make('span', { class: 'grow' }), this.mission, this.wind),
      this.charts,
      make('div', { class: 'columns' },
        box('Touch-downs', make('p', { class: 'soft' }, 'filled: calm; rings: wind; circles: the goals'), this.landing),
        box(`The worst ${Math.min(kWorst, flights.length)}, by their worst figure over its goal`,
          scrolling('The worst flights', worstTable(worst(campaign, kWorst))))),
      make('section', { class: 'box' }, make('div', { class: 'bar' }, make('h2', {}, 'Spread of'), this.figure), this.spread));
    this.failures();
    this.draw();
  }
  private shown(): Flight[] {
    const [mission, wind] = [this.mission, this.wind].map((select) => (select.selectedIndex === 0 ? undefined : select.value));
    return this.campaign.flights.filter((flight) => (mission ?? flight.mission) === flight.mission && (wind ?? flight.wind) === flight.wind);
  }
  private draw(): void {
    const flights = this.shown();
    this.charts.replaceChildren(...inOrder(this.campaign.goals).map((goal) => distribution(this.campaign, flights, goal)).filter((each) => each !== undefined));
    this.landing.replaceChildren(scatter(this.campaign, flights));
    this.spread.replaceChildren(spreads(flights, this.figure.value));
  }
  private failures(): void {
    const failed = this.campaign.flights.filter(({ failure }) => failure);
    if (failed.length === 0) return;
    byId('campaign-main').prepend(make('details', { class: 'box', open: failed.length <= 3 },
      make('summary', {}, `${failed.length} flights failed`), ...failed.slice(0, kMaxFailures).map((flight) =>
        make('p', {}, make('b', {}, `${nameOf(flight)}: `), flight.failure ?? '', ' ', reportLink(flight.report, nameOf(flight)), make('br'), make('code', {}, flight.command)))));
  }
}

const campaign = parse(byId('campaign').textContent ?? '');
if (campaign.kind === 'drawn') {
  showDrawn(campaign);
} else if (campaign.kind === 'chaos') {
  showChaos(campaign);
} else {
  head(campaign);
  new Page(campaign);
}
