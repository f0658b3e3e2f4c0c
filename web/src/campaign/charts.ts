// SPDX-License-Identifier: GPL-3.0-or-later
// Distributions of figures with their goals, and where the airplanes touched down.
import uPlot from 'uplot';
import { colour, make, onThemeChange, sized } from '../dom';
import { different, shareWithin, sortedValues } from './document';
import type { Campaign, Flight, Goal } from './document';

export interface Mark { at: number; dashed: boolean }
export interface Curve { colour: string; dashed: boolean; values: number[] }

const kColours = 8, kFont = '11px system-ui, sans-serif';

const airplaneColourName = (campaign: Campaign, airplane: string): string =>
  `c${different(campaign.flights.map((flight) => flight.airplane)).indexOf(airplane) % kColours}`;
export const airplaneColour = (campaign: Campaign, airplane: string): string => colour(airplaneColourName(campaign, airplane));

interface Line { airplane: string; calm: boolean; values: number[] }

function linesOf(campaign: Campaign, flights: Flight[], goal: Goal): Line[] {
  return different(campaign.flights.map(({ airplane }) => airplane)).flatMap((airplane) => [true, false].map((calm) => ({
    airplane, calm, values: sortedValues(flights.filter((flight) => flight.airplane === airplane && flight.calm === calm), goal.figure),
  }))).filter(({ values }) => values.length > 0);
}

// The share of `all` flights that stay at or below each value.
const steps = (values: number[], all: number): uPlot.AlignedData => {
  const last = new Map<number, number>();
  values.forEach((value, i) => last.set(value, 100 * (i + 1) / all));
  return [[...last.keys()], [...last.values()]];
};

function goalLines(marks: Mark[]): (u: uPlot) => void {
  return (u) => {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.strokeStyle = colour('bad');
    ctx.lineWidth = 1.5 * (devicePixelRatio || 1);
    for (const { at, dashed } of marks) {
      const x = Math.round(u.valToPos(at, 'x', true));
      ctx.setLineDash(dashed ? [6, 4] : []);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  };
}

// `all`: of how many flights a curve shows the share; without it of those that have the figure.
export function plotted(place: HTMLElement, curves: Curve[], marks: Mark[], most: number, all?: number): void {
  let plot: uPlot | undefined;
  const draw = (): void => {
    plot?.destroy();
    const axis = { stroke: colour('soft'), grid: { stroke: colour('grid'), width: 1 }, ticks: { show: false }, font: kFont };
    plot = new uPlot({
      width: place.clientWidth || 260, height: place.clientHeight || 120, legend: { show: false }, padding: [6, 12, 0, 0],
      cursor: { show: false },
      scales: { x: { time: false, range: [0, most * 1.06] }, y: { range: [0, 100] } },
      axes: [{ ...axis, size: 20, gap: 2, space: 40 }, { ...axis, size: 38, gap: 3, space: 24, values: (_, values) => values.map((value) => `${value} %`) }],
      series: [{}, ...curves.map(({ colour: name, dashed }): uPlot.Series => ({
        stroke: colour(name), width: 1.6, dash: dashed ? [5, 3] : undefined, points: { show: false }, spanGaps: true,
        paths: uPlot.paths.stepped?.({ align: 1 }),
      }))],
      hooks: { draw: [goalLines(marks)] },
    }, uPlot.join(curves.map(({ values }) => steps(values, all ?? values.length))), place);
  };
  onThemeChange(draw);
  new ResizeObserver(draw).observe(place);
}

export function distribution(campaign: Campaign, flights: Flight[], goal: Goal): HTMLElement | undefined {
  const lines = linesOf(campaign, flights, goal);
  if (lines.length === 0) return undefined;
  const share = shareWithin(flights, goal), kinds = different(lines.map(({ calm }) => String(calm))).map((calm) => calm === 'true');
  const marks = kinds.map((calm) => ({ at: calm ? goal.calm : goal.windy, dashed: !calm && goal.calm !== goal.windy }));
  const most = Math.max(...lines.map(({ values }) => values[values.length - 1]), ...marks.map(({ at }) => at));
  const place = make('div', { class: 'canvas-box', role: 'img', 'aria-label': `Distribution of ${goal.name}: ${(share * 100).toFixed(0)} of 100 flights within the goal` });
  plotted(place, lines.map(({ airplane, calm, values }) => ({ colour: airplaneColourName(campaign, airplane), dashed: !calm, values })), marks, most);
  const chip = make('b', { class: share >= 1 ? 'met' : share >= 0.95 ? '' : 'missed' }, `${(Math.floor(share * 1000) / 10).toFixed(share === 1 ? 0 : 1)} % within`);
  return make('section', { class: 'distribution', 'data-figure': goal.figure }, make('h3', {}, `${goal.name}, ${goal.unit} `, chip), place);
}

export interface Dot { long_m: number; right_m: number; colour: string; filled: boolean }

// Seen from above, the airplanes come from below. Dots farther away than `far_m` lie on the edge.
export function scattered(dots: Dot[], rings: { m: number; dashed: boolean }[], far_m: number): HTMLElement {
  const canvas = make('canvas', { id: 'scatter', role: 'img', 'aria-label': 'Touch-downs around the landing point' });
  const draw = (): void => {
    const { context, width, height } = sized(canvas);
    if (width === 0) return;
    const scale = Math.min(width, height) / 2 / far_m, [x0, y0] = [width / 2, height / 2];
    context.clearRect(0, 0, width, height);
    context.font = kFont;
    context.strokeStyle = colour('grid');
    for (const [x1, y1, x2, y2] of [[0, y0, width, y0], [x0, 0, x0, height]]) {
      context.beginPath();
      context.moveTo(x1, y1);
      context.lineTo(x2, y2);
      context.stroke();
    }
    for (const { m, dashed } of rings) {
      context.strokeStyle = context.fillStyle = colour('bad');
      context.setLineDash(dashed ? [6, 4] : []);
      context.beginPath();
      context.arc(x0, y0, m * scale, 0, 2 * Math.PI);
      context.stroke();
      context.fillText(`${m} m`, x0 + m * scale * 0.72 + 3, y0 - m * scale * 0.72 - 3);
    }
    context.setLineDash([]);
    for (const { long_m, right_m, colour: name, filled } of dots) {
      const out = Math.min(1, far_m * 0.98 / Math.hypot(long_m, right_m));
      context.fillStyle = context.strokeStyle = colour(name);
      context.globalAlpha = 0.75;
      context.beginPath();
      context.arc(x0 + out * right_m * scale, y0 - out * long_m * scale, 3, 0, 2 * Math.PI);
      if (filled) context.fill();
      else context.stroke();
      context.globalAlpha = 1;
    }
    context.fillStyle = colour('soft');
    context.fillText('↑ flown this way', 6, height - 6);
  };
  onThemeChange(draw);
  new ResizeObserver(draw).observe(canvas);
  return canvas;
}

export function scatter(campaign: Campaign, flights: Flight[]): HTMLElement {
  const dots = flights.flatMap(({ airplane, calm, touchdown_m: at }) =>
    (at ? [{ long_m: at[0], right_m: at[1], colour: airplaneColourName(campaign, airplane), filled: calm }] : []));
  const rings = campaign.goals.filter(({ figure }) => figure === 'landed_distance_m').flatMap(({ calm, windy }) => [{ m: calm, dashed: false }, { m: windy, dashed: true }]);
  return scattered(dots, rings, 1.08 * Math.max(...rings.map(({ m }) => m), ...dots.map(({ long_m, right_m }) => Math.hypot(long_m, right_m))));
}
