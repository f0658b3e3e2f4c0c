// SPDX-License-Identifier: GPL-3.0-or-later
// The page of flights in drawn worlds: what share of them stays within each limit, where they touch down, which miss by most, which
// failed and why, and what it depends on.
import { byId, make } from '../dom';
import { table } from '../view/tables';
import { plotted, scattered } from './charts';
import { again } from './copy';
import { inOrder, sortedValues } from './document';
import { bar, box, percent, reportLink, scrolling, tile } from './parts';
import type { DrawnCampaign, DrawnFlight, Limit } from './document';
import { dependences, failuresOf, meets, misses, shareOf } from './drawn_document';
import type { Dependence, Part } from './drawn_document';

const kWorst = 10, kFailures = 8, kSeeds = 12, kDependences = 12;
const kLanding = 'landed_distance_m';

// docs/airplanes.md has the ranges.
const kWhat = 'Each number is a world: an airplane of 0.5 to 8 kg with the derivatives of textbooks times 0.5 to 1.5, its motor, servos and linkage; '
  + 'sensors with 0.05 to 3 times the usual noise, a GPS of 1, 5 or 10 Hz that is 50 to 400 ms late, a compass beside the motor\'s wires; wind to '
  + '10 m/s, gusts, thermals; a field anywhere from 70°S to 70°N, up to 3,000 m high. A third is thrown. AUTOTUNE flies first, from the defaults '
  + 'and what an owner knows, then a box with a climb, a descent, a loiter and a landing on what it found.';

const shown = (value: number): string => (Number.isFinite(value) ? value.toFixed(2) : '');
const amount = (value: number): string => (Math.abs(value) >= 100 ? value.toFixed(0) : String(+value.toPrecision(2)));

function head(campaign: DrawnCampaign): void {
  const { flights, verdict, wall_s, emulated_s, limit_times } = campaign;
  const numbers = flights.map(({ seed }) => seed);
  document.title = 'Campaign in drawn worlds';
  document.querySelector('h1')?.replaceChildren('Campaign in drawn worlds');
  const chip = byId('verdict');
  chip.textContent = verdict.text;
  if (!verdict.good) chip.className = 'chip bad';
  byId('subtitle').textContent = [
    numbers.length === 1 ? `world ${numbers[0]}` : `worlds ${Math.min(...numbers)} to ${Math.max(...numbers)}`,
    `a limit is ${limit_times} times the goal in wind`,
    `${(emulated_s / 3600).toFixed(1)} h of flight in ${(wall_s / 60).toFixed(1)} min`, 'natively compiled firmware'].join(' · ');
}

function tiles({ flights, goals, met_all }: DrawnCampaign): HTMLElement {
  const of = (met: number): string => `${met} of ${flights.length}`, done = flights.filter(({ completed }) => completed).length;
  const landing = goals.find(({ figure }) => figure === kLanding), misses_one = flights.filter((flight) => flight.completed
    && goals.filter((limit) => !meets(flight, limit)).length === 1).length;
  return make('div', { id: 'tiles' },
    tile(percent(met_all, flights.length), 'every limit met', `by ${of(met_all)}`),
    tile(percent(done, flights.length), 'flown to the end', of(done)),
    ...(landing ? [tile(percent(flights.filter((flight) => meets(flight, landing)).length, flights.length), 'touched down in place', `within ${landing.limit} m of the point`)] : []),
    tile(String(misses_one), 'miss one limit alone', 'flown to the end'));
}

function limits({ flights, goals }: DrawnCampaign): HTMLElement {
  return table(['figure', 'limit', 'flights within', 'median', '95 of 100', 'worst', 'its world'], inOrder(goals).map((limit) => {
    const share = shareOf(flights, limit);
    return [`${limit.name}, ${limit.unit}`, shown(limit.limit), bar(share.met, share.flights), shown(share.median), shown(share.p95), shown(share.worst), share.worst_seed ?? ''];
  }));
}

// A curve is of all flights, so that it crosses the limit at the share that meets it. What is far beyond the limit is cut off.
function distribution(flights: DrawnFlight[], limit: Limit): HTMLElement {
  const values = sortedValues(flights, limit.figure), share = shareOf(flights, limit), most = Math.min(Math.max(limit.limit * 1.3, share.worst || 0), limit.limit * 3);
  const beyond = values.filter((value) => value > most * 1.06).length;
  const place = make('div', { class: 'canvas-box', role: 'img', 'aria-label': `Distribution of ${limit.name}: ${percent(share.met, share.flights)} of the flights within the limit` });
  if (values.length > 0) plotted(place, [{ colour: 'c0', dashed: false, values }], [{ at: limit.limit, dashed: false }], most, flights.length);
  return make('section', { class: 'distribution', 'data-figure': limit.figure },
    make('h3', {}, `${limit.name}, ${limit.unit} `, make('b', { title: `limit ${limit.limit} ${limit.unit}` }, `${percent(share.met, share.flights)} within ${+limit.limit.toFixed(2)}`)), place,
    make('p', { class: 'soft beyond' }, beyond > 0 ? `${beyond} beyond ${+(most * 1.06).toPrecision(2)}, worst ${shown(share.worst)}` : ''));
}

function touchdowns({ flights, goals }: DrawnCampaign): HTMLElement[] {
  const limit = goals.find(({ figure }) => figure === kLanding)?.limit ?? 30, far_m = 3 * limit;
  const dots = flights.flatMap(({ touchdown_m: at, completed }) => (at ? [{ long_m: at[0], right_m: at[1], colour: completed ? 'c0' : 'bad', filled: true }] : []));
  const beyond = dots.filter(({ long_m, right_m }) => Math.hypot(long_m, right_m) > far_m).length;
  return [make('p', { class: 'soft' }, `blue: flown to the end, red: failed; circle: the limit. ${dots.length} of ${flights.length} touched down, ${beyond} farther away than ${far_m} m, on the edge`),
    scattered(dots, [{ m: limit, dashed: false }], far_m)];
}

function airplaneOf({ world }: DrawnFlight): string {
  if (!Number.isFinite(world.mass_kg)) return '';
  return `${amount(world.mass_kg)} kg, ${world.thrown ? 'thrown' : 'wheels'}, stall ${amount(world.stall_mps)}; servo ${amount(world.servo_s)} s; GPS ${world.gps_rate_hz} Hz ${world.gps_age_ms.toFixed(0)} ms; wind ${amount(world.wind_mps)}, gusts ${amount(world.gust_mps)}`;
}

function worst(campaign: DrawnCampaign): HTMLElement {
  return table(['world', 'worst figure', 'value', 'limit', 'times', 'what was drawn', 'report', 'fly it again'], misses(campaign).slice(0, kWorst).map(({ flight, limit, times }) => [
    make('b', {}, String(flight.seed)), `${limit.name}, ${limit.unit}`, limit.figure in flight.figures ? shown(flight.figures[limit.figure]) : 'none', shown(limit.limit),
    Number.isFinite(times) ? make('span', { class: 'missed' }, times.toFixed(1)) : '', airplaneOf(flight), reportLink(flight.report, `world ${flight.seed}`), again(flight.command)]));
}

function seeds(flights: DrawnFlight[]): HTMLElement {
  const list = flights.slice(0, kSeeds).flatMap((flight, i) => [...(i > 0 ? [', '] : []),
    flight.report ? make('a', { href: flight.report, title: flight.failure }, String(flight.seed)) : make('span', { title: flight.failure }, String(flight.seed))]);
  return make('span', {}, ...list, flights.length > kSeeds ? ', …' : '');
}

function failed(flights: DrawnFlight[]): HTMLElement {
  const reasons = failuresOf(flights);
  if (reasons.length === 0) return make('p', { class: 'soft' }, 'none');
  return make('div', {}, table(['reason', 'flights', 'worlds', 'the first again'], reasons.slice(0, kFailures).map(({ reason, flights: of }) =>
    [make('span', { class: 'reason' }, reason), of.length, seeds(of), again(of[0].command)])),
  make('p', { class: 'soft' }, reasons.length > kFailures ? `and ${reasons.length - kFailures} more reasons` : ''));
}

function cell({ from, to, met, flights }: Part, unit: string): HTMLElement {
  const share = flights === 0 ? 0 : met / flights;
  const made = make('div', { class: 'part' }, make('b', {}, percent(met, flights)), make('span', { class: 'soft' }, from === to ? `${amount(from)} ${unit}` : `${amount(from)} – ${amount(to)} ${unit}`));
  made.style.setProperty('--share', `${(100 * share).toFixed(0)}%`);
  return made;
}

const named = ({ drawn, parts }: Dependence): (string | Node)[] => (drawn.key === 'thrown' && parts.length === 2
  ? [drawn.name, ...parts.map((part) => cell({ ...part, from: NaN, to: NaN }, '')).map((made, i) => { made.lastChild?.replaceWith(make('span', { class: 'soft' }, i === 0 ? 'on wheels' : 'thrown')); return made; }), '']
  : [drawn.name, ...parts.map((part) => cell(part, drawn.unit)), ...Array<string>(3 - parts.length).fill('')]);

function depends(campaign: DrawnCampaign): HTMLElement[] {
  const questions: [string, (flight: DrawnFlight) => boolean][] = [['every limit met', ({ met_all }) => met_all], ['flown to the end', ({ completed }) => completed],
    ...inOrder(campaign.goals).map((limit): [string, (flight: DrawnFlight) => boolean] => [limit.name, (flight) => meets(flight, limit)])];
  const select = make('select', { 'aria-label': 'Share of' }, ...questions.map(([name], i) => make('option', { value: i, selected: i === 1 }, name)));
  const place = make('div', { class: 'scroll tall', tabindex: 0, role: 'region', 'aria-label': 'What it depends on' });
  const draw = (): void => {
    const rows = dependences(campaign, questions[select.selectedIndex][1]).slice(0, kDependences);
    place.replaceChildren(table(['drawn', 'lowest third', 'middle third', 'highest third'], rows.map(named)));
  };
  select.addEventListener('change', draw);
  draw();
  return [make('div', { class: 'bar' }, make('h2', {}, 'What it depends on: share of'), select), place,
    make('p', { class: 'soft' }, `the ${Math.min(kDependences, campaign.drawn.length)} it depends on most; flights in thirds by what was drawn`)];
}

export function showDrawn(campaign: DrawnCampaign): void {
  const { flights, goals, met_all } = campaign, missing = misses(campaign).length, failures = flights.filter(({ completed }) => !completed).length;
  head(campaign);
  byId('campaign-main').append(
    tiles(campaign),
    make('div', { class: 'columns wide-left' },
      box(`Limits: every limit met by ${met_all} of ${flights.length}`, scrolling('Limits', limits(campaign))),
      box('Touch-downs', ...touchdowns(campaign))),
    make('div', { id: 'distributions', class: 'drawn' }, ...inOrder(goals).map((limit) => distribution(flights, limit))),
    box(`The worst ${Math.min(kWorst, missing)} of ${missing} that were flown to the end and miss a limit`, scrolling('The worst flights', worst(campaign))),
    make('div', { class: 'columns halves' },
      make('section', { class: 'box' }, ...depends(campaign)),
      make('div', { class: 'stack' }, box(`Failed: ${failures} of ${flights.length}`, scrolling('Failed flights', failed(flights))), box('What is drawn', make('p', {}, kWhat)))));
}
