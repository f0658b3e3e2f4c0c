// SPDX-License-Identifier: GPL-3.0-or-later
// Distributions of figures with their goals, and where the airplanes touched down.
import uPlot from 'uplot';
import { colour, make, onThemeChange, sized } from '../dom';
import { different, shareWithin, sortedValues } from './document';
import type { Campaign, Flight, Goal } from './document';

const kColours = 8, kFont = '11px system-ui, sans-serif';

export const airplaneColour = (campaign: Campaign, airplane: string): string =>
  colour(`c${different(campaign.flights.map((flight) => flight.airplane)).indexOf(airplane) % kColours}`);

interface Line { airplane: string; calm: boolean; values: number[] }

function linesOf(campaign: Campaign, flights: Flight[], goal: Goal): Line[] {
  return different(campaign.flights.map(({ airplane }) => airplane)).flatMap((airplane) => [true, false].map((calm) => ({
    airplane, calm, values: sortedValues(flights.filter((flight) => flight.airplane === airplane && flight.calm === calm), goal.figure),
  }))).filter(({ values }) => values.length > 0);
}

// The share of the flights that stay at or below each value.
const curve = (values: number[]): uPlot.AlignedData => {
  const last = new Map<number, number>();
  values.forEach((value, i) => last.set(value, 100 * (i + 1) / values.length));
  return [[...last.keys()], [...last.values()]];
};

function goalLines(goal: Goal, kinds: boolean[]): (u: uPlot) => void {
  return (u) => {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.strokeStyle = colour('bad');
    ctx.lineWidth = 1.5 * (devicePixelRatio || 1);
    for (const calm of kinds) {
      const x = Math.round(u.valToPos(calm ? goal.calm : goal.windy, 'x', true));
      ctx.setLineDash(calm || goal.calm === goal.windy ? [] : [6, 4]);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  };
}

export function distribution(campaign: Campaign, flights: Flight[], goal: Goal): HTMLElement | undefined {
  const lines = linesOf(campaign, flights, goal);
  if (lines.length === 0) return undefined;
  const share = shareWithin(flights, goal), kinds = different(lines.map(({ calm }) => String(calm))).map((calm) => calm === 'true');
  const most = Math.max(...lines.map(({ values }) => values[values.length - 1]), ...kinds.map((calm) => (calm ? goal.calm : goal.windy)));
  const place = make('div', { class: 'canvas-box', role: 'img', 'aria-label': `Distribution of ${goal.name}: ${(share * 100).toFixed(0)} of 100 flights within the goal` });
  let plot: uPlot | undefined;
  const draw = (): void => {
    plot?.destroy();
    const axis = { stroke: colour('soft'), grid: { stroke: colour('grid'), width: 1 }, ticks: { show: false }, font: kFont };
    plot = new uPlot({
      width: place.clientWidth || 260, height: place.clientHeight || 120, legend: { show: false }, padding: [6, 12, 0, 0],
      cursor: { show: false },
      scales: { x: { time: false, range: [0, most * 1.06] }, y: { range: [0, 100] } },
      axes: [{ ...axis, size: 20, gap: 2, space: 40 }, { ...axis, size: 38, gap: 3, space: 24, values: (_, all) => all.map((value) => `${value} %`) }],
      series: [{}, ...lines.map(({ airplane, calm }): uPlot.Series => ({
        stroke: airplaneColour(campaign, airplane), width: 1.6, dash: calm ? undefined : [5, 3], points: { show: false }, spanGaps: true,
        paths: uPlot.paths.stepped?.({ align: 1 }),
      }))],
      hooks: { draw: [goalLines(goal, kinds)] },
    }, uPlot.join(lines.map(({ values }) => curve(values))), place);
  };
  onThemeChange(draw);
  new ResizeObserver(draw).observe(place);
  const chip = make('b', { class: share >= 1 ? 'met' : share >= 0.95 ? '' : 'missed' }, `${(Math.floor(share * 1000) / 10).toFixed(share === 1 ? 0 : 1)} % within`);
  return make('section', { class: 'distribution', 'data-figure': goal.figure }, make('h3', {}, `${goal.name}, ${goal.unit} `, chip), place);
}

// Seen from above, the airplanes come from below.
export function scatter(campaign: Campaign, flights: Flight[]): HTMLElement {
  const canvas = make('canvas', { id: 'scatter', role: 'img', 'aria-label': 'Touch-downs around the landing point' });
  const known = flights.filter(({ touchdown_m }) => touchdown_m);
  const rings = campaign.goals.filter(({ figure }) => figure === 'landed_distance_m').flatMap(({ calm, windy }) => [calm, windy]);
  const far = Math.max(...rings, ...known.map(({ touchdown_m: at }) => Math.hypot(...(at as [number, number])))) * 1.08;
  const draw = (): void => {
    const { context, width, height } = sized(canvas);
    if (width === 0) return;
    const scale = Math.min(width, height) / 2 / far, [x0, y0] = [width / 2, height / 2];
    context.clearRect(0, 0, width, height);
    context.font = kFont;
    context.strokeStyle = colour('grid');
    for (const [x1, y1, x2, y2] of [[0, y0, width, y0], [x0, 0, x0, height]]) {
      context.beginPath();
      context.moveTo(x1, y1);
      context.lineTo(x2, y2);
      context.stroke();
    }
    for (const [i, ring] of rings.entries()) {
      context.strokeStyle = context.fillStyle = colour('bad');
      context.setLineDash(i === 0 ? [] : [6, 4]);
      context.beginPath();
      context.arc(x0, y0, ring * scale, 0, 2 * Math.PI);
      context.stroke();
      context.fillText(`${ring} m`, x0 + ring * scale * 0.72 + 3, y0 - ring * scale * 0.72 - 3);
    }
    context.setLineDash([]);
    for (const { airplane, calm, touchdown_m: at } of known) {
      const [long, right] = at as [number, number];
      context.fillStyle = context.strokeStyle = airplaneColour(campaign, airplane);
      context.globalAlpha = 0.75;
      context.beginPath();
      context.arc(x0 + right * scale, y0 - long * scale, 3, 0, 2 * Math.PI);
      if (calm) context.fill();
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
