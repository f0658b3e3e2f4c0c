// SPDX-License-Identifier: GPL-3.0-or-later
// The bar below: plays the flight, shows modes and events over time, and the keys that do the same.
import { byId, colour, make, onThemeChange, sized } from '../dom';
import type { Flight } from '../flight';
import { clock } from '../units';
import type { View } from '../view';
import { drawModes, drawTroubles } from './bands';

const kRates = [0.25, 0.5, 1, 2, 5, 10, 20, 50];
const kStep_s = 1, kLeap_s = 10;

export class Playback {
  private readonly button = make('button', { id: 'play', type: 'button', class: 'main', 'aria-label': 'Play' }, '▶');
  private readonly now = make('span', { id: 'now' });
  private readonly slider = make('input', { type: 'range', 'aria-label': 'Time of the cursor', step: 0.1 });
  private readonly strip = make('canvas', { role: 'img', 'aria-label': 'Modes and events over time' });
  private readonly rates = make('select', { id: 'rate', 'aria-label': 'Speed of the playback' },
    ...kRates.map((rate) => make('option', { value: rate, selected: rate === 1 }, `${rate}×`)));
  private readonly whole = make('button', { id: 'whole', type: 'button', title: 'Show the whole flight (0)' }, 'whole flight');
  private readonly live = make('button', { id: 'go-live', type: 'button', hidden: true }, 'live');
  private last_ms = 0;

  constructor(private readonly flight: Flight, private readonly view: View) {
    byId('playback').append(this.button, this.now, make('div', { id: 'timeline' }, this.strip, this.slider), this.rates, this.whole, this.live);
    this.button.addEventListener('click', () => { view.setLive(false); view.play(!view.playing); });
    this.slider.addEventListener('input', () => view.jumpTo(Number(this.slider.value)));
    this.rates.addEventListener('change', () => view.setRate(Number(this.rates.value)));
    this.whole.addEventListener('click', () => view.showWhole());
    this.live.addEventListener('click', () => { view.setLive(true); view.moveTo(view.to_s); });
    document.addEventListener('keydown', (event) => this.key(event));
    view.moved.on(() => this.move());
    view.changed.on(() => this.change());
    view.zoomed.on(() => { this.whole.disabled = view.whole(); });
    new ResizeObserver(() => this.draw()).observe(this.strip);
    onThemeChange(() => this.draw());
    this.whole.disabled = true;
    this.limits();
    this.change();
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest('select, input:not([type=range]), #map')) return;
    const { view } = this;
    const by = event.shiftKey ? kLeap_s : kStep_s;
    const actions: Record<string, () => void> = {
      ' ': () => view.play(!view.playing),
      ArrowLeft: () => view.jumpTo(view.time_s - by),
      ArrowRight: () => view.jumpTo(view.time_s + by),
      Home: () => view.jumpTo(view.from_s),
      End: () => view.jumpTo(view.to_s),
      '+': () => view.zoomBy(0.5),
      '-': () => view.zoomBy(2),
      0: () => view.showWhole(),
    };
    const action = actions[event.key];
    const ownKey = target.closest('button, label, [role=tab]') && [' ', 'ArrowLeft', 'ArrowRight'].includes(event.key);
    const scrolls = target.closest('[tabindex="0"]') && ['Home', 'End'].includes(event.key);
    if (!action || ownKey || scrolls) return;
    event.preventDefault();
    action();
  }

  private change(): void {
    const { view } = this;
    this.button.textContent = view.playing ? '❚❚' : '▶';
    this.button.setAttribute('aria-label', view.playing ? 'Pause' : 'Play');
    this.live.hidden = this.flight.document.kind !== 'live';
    this.live.setAttribute('aria-pressed', String(view.live));
    if (!view.playing || this.last_ms !== 0) return;
    this.last_ms = performance.now();
    requestAnimationFrame((now_ms) => this.frame(now_ms));
  }
  private frame(now_ms: number): void {
    const { view } = this;
    if (!view.playing) return void (this.last_ms = 0);
    const next_s = view.time_s + Math.max(now_ms - this.last_ms, 0) / 1000 * view.rate;
    this.last_ms = now_ms;
    view.moveTo(next_s);
    if (next_s > view.span[1] && !view.whole()) view.zoom(next_s, next_s + view.span[1] - view.span[0]);
    if (next_s >= view.to_s) view.play(false);
    requestAnimationFrame((ms) => this.frame(ms));
  }
  private move(): void {
    const { view } = this;
    this.now.textContent = `${clock(view.time_s)} / ${clock(view.to_s)}`;
    this.slider.value = String(view.time_s);
    if (!view.playing) this.slider.setAttribute('aria-valuetext', clock(view.time_s));
  }
  private limits(): void {
    const { view } = this;
    this.slider.min = String(view.from_s);
    this.slider.max = String(view.to_s);
    this.move();
  }
  grow(): void {
    this.limits();
    this.draw();
  }
  draw(): void {
    const { context, width, height } = sized(this.strip);
    if (width === 0) return;
    const { from_s, to_s } = this.view;
    const x = (time_s: number): number => (time_s - from_s) / Math.max(to_s - from_s, 1e-3) * width;
    context.clearRect(0, 0, width, height);
    context.fillStyle = colour('grid');
    context.fillRect(0, 0, width, height);
    context.font = '600 10px system-ui, sans-serif';
    drawModes(context, this.flight, x, 0, height, width, true);
    context.fillStyle = colour('panel');
    for (const { kind, time_s } of this.flight.events) if (kind === 'item') context.fillRect(x(time_s), 0, 1, height);
    drawTroubles(context, this.flight, x, 0, height);
    drawTroubles(context, this.flight, x, height - 4, 4);
  }
}
