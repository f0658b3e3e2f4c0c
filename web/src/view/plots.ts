// SPDX-License-Identifier: GPL-3.0-or-later
// The plots: one for each group of series, with one cursor and one zoom for all of them.
import uPlot from 'uplot';
import { colour, make, onThemeChange } from '../dom';
import type { Flight, Series } from '../flight';
import type { View } from '../view';
import { clock, shown } from '../units';
import { drawModes, drawTroubles } from './bands';
import { Touch } from './touch';

const kTitles: Record<string, string> = {
  height: 'Height', speed: 'Speeds', roll: 'Roll', pitch: 'Pitch', heading: 'Heading', climb: 'Climb', track: 'Crosstrack',
  controls: 'Controls', servos: 'Servos', energy: 'Energy', battery: 'Battery', wind: 'Wind', gps: 'GPS', vibration: 'Vibration',
  rc: 'RC inputs', cpu: 'CPU', frames: 'Frames', rates: 'Rates', sensors: 'Sensors',
};
const kFirst = ['height', 'speed', 'roll', 'pitch', 'climb'];  // shown until others are chosen
const kColours = 8, kTableRows = 60, kStrip = 5;

const titleOf = (group: string): string => kTitles[group] ?? group[0].toUpperCase() + group.slice(1);

function nullable(values: number[]): (number | null)[] {
  return values.map((value) => (Number.isFinite(value) ? value : null));
}

// The series on one axis of time.
function aligned(all: Series[]): uPlot.AlignedData {
  const bases = [...new Set(all.map(({ times }) => times))];
  const plain = all.every(({ times }) => times.length === all[0].times.length && times[times.length - 1] === all[0].times[times.length - 1]);
  if (bases.length === 1 || plain) return [all[0].times, ...all.map(({ values }) => nullable(values))] as uPlot.AlignedData;
  return uPlot.join(all.map(({ times, values }) => [times, nullable(values)] as uPlot.AlignedData));
}

class Plot {
  readonly box: HTMLElement;
  private readonly place = make('div', { class: 'canvas-box' });
  private readonly line = make('div', { class: 'cursor-line' });
  private readonly values: HTMLElement[] = [];
  private plot?: uPlot;
  private table?: HTMLElement;
  private visible = false;

  constructor(private readonly flight: Flight, private readonly view: View, private readonly group: string,
    private readonly series: Series[], seen: IntersectionObserver) {
    const head = make('div', { class: 'plot-head' }, make('h3', {}, titleOf(group)));
    for (const [i, each] of series.entries()) head.append(this.toggle(each, i));
    const asTable = make('button', { class: 'as-table', type: 'button', 'aria-pressed': 'false', 'aria-label': `${titleOf(group)} as a table` }, 'table');
    asTable.addEventListener('click', () => this.showTable(asTable));
    head.append(asTable);
    if (series.length > 4) this.place.classList.add('tall');
    this.box = make('section', { class: 'plot', 'data-group': group, 'aria-label': `Plot: ${titleOf(group)}` }, head, this.place);
    seen.observe(this.box);
  }

  private toggle(each: Series, i: number): HTMLElement {
    const swatch = make('i', { class: each.kind ?? '' });
    swatch.style.borderColor = `var(--c${i % kColours})`;
    const value = make('b');
    this.values.push(value);
    const kind = each.kind && each.kind !== 'measured' ? ` ${each.kind}` : '';
    const name = this.series.filter(({ title }) => title === each.title).length === this.series.length && kind ? kind.trim() : each.title + kind;
    const button = make('button', { type: 'button', 'aria-pressed': 'true', title: `${each.name}, ${each.unit || 'no unit'}` }, swatch, name, value);
    button.addEventListener('click', () => {
      const on = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', String(on));
      this.plot?.setSeries(i + 1, { show: on });
    });
    return button;
  }

  show(visible: boolean): void {
    this.visible = visible;
    if (!visible) return;
    if (!this.plot && !this.table) this.draw();
    this.move(this.view.time_s);
  }

  draw(): void {
    const shownSeries = this.plot?.series.map(({ show }) => show);
    this.plot?.destroy();
    this.plot = new uPlot(this.options(shownSeries), aligned(this.series), this.place);
    this.plot.over.append(this.line);
    this.plot.over.setAttribute('data-group', this.group);
    this.pointer(this.plot);
    this.touch(this.plot);
    this.move(this.view.time_s);
  }
  private options(shownSeries?: (boolean | undefined)[]): uPlot.Options {
    const units = [...new Set(this.series.map(({ unit }) => unit))].slice(0, 2);
    const scaleOf = (unit: string): string => (units.includes(unit) ? unit : units[0]) || 'y';
    const axis = (unit: string, side: 1 | 3): uPlot.Axis => ({
      scale: scaleOf(unit), side, stroke: colour('soft'), size: 46, gap: 3, font: '11px system-ui, sans-serif',
      grid: { show: side === 3, stroke: colour('grid'), width: 1 }, ticks: { show: false }, space: 22,
      values: (_: uPlot, all: number[]) => all.map((value, i) => (i === all.length - 1 && unit ? `${+value.toPrecision(6)} ${unit}` : String(+value.toPrecision(6)))),
    });
    return {
      width: Math.max(this.place.clientWidth, 50), height: this.place.clientHeight, padding: [kStrip + 3, units.length > 1 ? 0 : 10, 0, 0],
      legend: { show: false },
      scales: { x: { time: false, range: () => [...this.view.span] as [number, number] } },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: false }, dataIdx: (_, __, i) => i },
      series: [{}, ...this.series.map((each, i): uPlot.Series => ({
        scale: scaleOf(each.unit), stroke: colour(`c${i % kColours}`), width: each.kind === 'truth' ? 1.7 : 1.2,
        dash: each.kind === 'demand' ? [5, 3] : undefined, points: { show: false }, spanGaps: false, show: shownSeries?.[i + 1] ?? true,
      }))],
      axes: [
        { stroke: colour('soft'), grid: { stroke: colour('grid'), width: 1 }, ticks: { show: false }, size: 20, gap: 2, font: '11px system-ui, sans-serif',
          values: (_, all) => all.map((value) => clock(value).replace(/\.0$/, '')) },
        axis(units[0], 3), ...(units.length > 1 ? [axis(units[1], 1)] : []),
      ],
      hooks: {
        drawClear: [(u) => this.behind(u)],
        draw: [() => this.move(this.view.time_s)],
        setSelect: [(u) => this.selected(u)],
      },
    };
  }
  private behind(u: uPlot): void {
    const { ctx, bbox } = u, ratio = devicePixelRatio || 1;
    const x = (time_s: number): number => u.valToPos(time_s, 'x', true);
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, 0, bbox.width, bbox.top + bbox.height);
    ctx.clip();
    drawTroubles(ctx, this.flight, x, bbox.top, bbox.height);
    drawModes(ctx, this.flight, x, bbox.top - (kStrip + 1) * ratio, kStrip * ratio, bbox.left + bbox.width, false);
    ctx.restore();
  }
  private selected(u: uPlot): void {
    const { left, width } = u.select;
    if (width > 4) this.view.zoom(u.posToVal(left, 'x'), u.posToVal(left + width, 'x'));
    if (width > 0) this.unselect(u);
  }
  private unselect(u: uPlot): void { u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false); }
  private touch(u: uPlot): void {
    const time = (x_px: number): number => u.posToVal(x_px, 'x');
    new Touch(u.over, {
      time,
      drawn: (from_px, to_px) => u.setSelect({ left: from_px, top: 0, width: to_px - from_px, height: u.over.clientHeight }, false),
      chosen: (from_px, to_px) => this.view.zoom(time(from_px), time(to_px)),
      dropped: () => this.unselect(u),
      zoom: (from_s, to_s) => this.view.zoom(from_s, to_s),
    });
  }
  private pointer(u: uPlot): void {
    const to = (event: MouseEvent): void => {
      if (this.view.playing || this.view.live) return;
      this.view.moveTo(u.posToVal(event.clientX - u.over.getBoundingClientRect().left, 'x'));
    };
    u.over.addEventListener('mousemove', to);
    u.over.addEventListener('click', (event) => this.view.jumpTo(u.posToVal(event.clientX - u.over.getBoundingClientRect().left, 'x')));
    u.over.addEventListener('dblclick', () => this.view.showWhole());
    u.over.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.view.zoomBy(event.deltaY > 0 ? 1.25 : 0.8);
    }, { passive: false });
  }

  zoom(): void {
    const [min, max] = this.view.span;
    if (this.visible) this.plot?.setScale('x', { min, max });
    this.move(this.view.time_s);
  }
  resize(): void {
    if (this.plot && this.place.clientWidth > 0 && this.place.clientWidth !== this.plot.width) {
      this.plot.setSize({ width: this.place.clientWidth, height: this.place.clientHeight });
      this.move(this.view.time_s);
    }
  }
  grow(): void {
    if (!this.visible || !this.plot) return;
    this.plot.setData(aligned(this.series), false);
    const [min, max] = this.view.span;
    this.plot.setScale('x', { min, max });
  }
  move(time_s: number): void {
    if (!this.visible) return;
    for (const [i, series] of this.series.entries()) {
      const text = shown(this.flight.at(series, time_s), series.unit);
      if (this.values[i].textContent !== text) this.values[i].textContent = text;
    }
    if (!this.plot) return;
    const x = this.plot.valToPos(time_s, 'x');
    this.line.hidden = !(x >= 0 && x <= this.plot.over.clientWidth);
    this.line.style.transform = `translateX(${x}px)`;
  }

  private showTable(button: HTMLElement): void {
    const on = !this.table;
    button.setAttribute('aria-pressed', String(on));
    this.place.hidden = on;
    this.table?.remove();
    this.table = on ? this.tableOf() : undefined;
    if (this.table) this.box.append(this.table);
    else if (!this.plot) this.draw();
  }
  private tableOf(): HTMLElement {
    const [from, to] = this.view.span;
    const rows = Array.from({ length: kTableRows + 1 }, (_, i) => from + (to - from) * i / kTableRows);
    const heads = ['time', ...this.series.map((each) => `${each.title}${each.kind ? ` ${each.kind}` : ''}`)];
    return make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': `${titleOf(this.group)}, table` }, make('table', {},
      make('thead', {}, make('tr', {}, ...heads.map((head, i) => make('th', { scope: 'col', class: i ? 'n' : '' }, head)))),
      make('tbody', {}, ...rows.map((time_s) => make('tr', {}, make('td', {}, clock(time_s)),
        ...this.series.map((each) => make('td', { class: 'n' }, shown(this.flight.at(each, time_s), each.unit))))))));
  }
}

export class Plots {
  private readonly plots: Plot[] = [];

  constructor(flight: Flight, view: View, pane: HTMLElement) {
    const groups = [...new Set([...Object.keys(kTitles), ...flight.series.map(({ group }) => group)])]
      .map((group) => ({ group, series: flight.series.filter((each) => each.group === group && each.group !== '') }))
      .filter(({ series }) => series.length > 0);
    const bar = make('div', { id: 'groups', role: 'group', 'aria-label': 'Groups of plots' });
    pane.append(bar);
    const seen = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) this.plots.find(({ box }) => box === target)?.show(isIntersecting);
    }, { root: null, rootMargin: '80px' });
    for (const { group, series } of groups) {
      const plot = new Plot(flight, view, group, series, seen);
      this.plots.push(plot);
      plot.box.hidden = !kFirst.includes(group);
      bar.append(this.choice(group, plot));
      pane.append(plot.box);
    }
    view.moved.on((time_s) => { for (const plot of this.plots) plot.move(time_s); });
    view.zoomed.on(() => { for (const plot of this.plots) plot.zoom(); });
    new ResizeObserver(() => { for (const plot of this.plots) plot.resize(); }).observe(pane);
    onThemeChange(() => { for (const plot of this.plots) plot.show(false); this.redraw(); });
  }
  private choice(group: string, plot: Plot): HTMLElement {
    const button = make('button', { type: 'button', 'aria-pressed': String(!plot.box.hidden), 'data-group': group }, titleOf(group));
    button.addEventListener('click', () => {
      plot.box.hidden = !plot.box.hidden;
      button.setAttribute('aria-pressed', String(!plot.box.hidden));
      if (!plot.box.hidden) plot.box.scrollIntoView({ block: 'nearest' });
    });
    return button;
  }
  private redraw(): void {
    for (const plot of this.plots) {
      if (plot.box.hidden) continue;
      plot.draw();
      plot.show(true);
    }
  }
  grow(): void { for (const plot of this.plots) plot.grow(); }
}

