// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers and pens on a plot: one draws a span, as the mouse does; two pinch and push the span that
// is shown. Up and down the page scrolls, as everywhere.
const kDrag_px = 8;

export interface Touched {
  time(x_px: number): number;
  drawn(from_px: number, to_px: number): void;  // so far
  chosen(from_px: number, to_px: number): void;
  dropped(): void;
  zoom(from_s: number, to_s: number): void;
}

// The span under a plot of this width, so that two times are at two places.
export function pinched(times: readonly [number, number], places_px: readonly [number, number], width_px: number): [number, number] {
  const apart_px = places_px[1] - places_px[0] || 1;
  const per_px = Math.abs((times[1] - times[0]) / (Math.abs(apart_px) < kDrag_px ? Math.sign(apart_px) * kDrag_px : apart_px));
  const middle_s = (times[0] + times[1]) / 2, middle_px = (places_px[0] + places_px[1]) / 2;
  return [middle_s - middle_px * per_px, middle_s + (width_px - middle_px) * per_px];
}

export class Touch {
  private readonly fingers = new Map<number, number>();  // where each is
  private from_px = 0;
  private held?: readonly [number, number];  // the times under two fingers
  private pinching = false;

  constructor(private readonly over: HTMLElement, private readonly on: Touched) {
    over.style.touchAction = 'pan-y';
    const listen = (name: 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel', take: (event: PointerEvent) => void): void =>
      over.addEventListener(name, (event) => { if (event.pointerType !== 'mouse') take(event); });
    listen('pointerdown', (event) => this.down(event));
    listen('pointermove', (event) => this.move(event));
    listen('pointerup', (event) => this.up(event, true));
    listen('pointercancel', (event) => this.up(event, false));
  }
  private place(event: PointerEvent): number { return event.clientX - this.over.getBoundingClientRect().left; }
  private both(): [number, number] { return [...this.fingers.values()].slice(0, 2) as [number, number]; }

  private down(event: PointerEvent): void {
    this.fingers.set(event.pointerId, this.place(event));
    if (this.fingers.size === 1) this.from_px = this.place(event);
    if (this.fingers.size !== 2) return;
    this.pinching = true;
    this.on.dropped();
    const [a, b] = this.both();
    this.held = [this.on.time(a), this.on.time(b)];
  }
  private move(event: PointerEvent): void {
    if (!this.fingers.has(event.pointerId)) return;
    this.fingers.set(event.pointerId, this.place(event));
    if (this.held && this.fingers.size > 1) return this.on.zoom(...pinched(this.held, this.both(), this.over.clientWidth));
    if (!this.pinching && Math.abs(this.place(event) - this.from_px) > kDrag_px) this.on.drawn(...this.span(event));
  }
  private up(event: PointerEvent, ended: boolean): void {
    if (!this.fingers.delete(event.pointerId)) return;
    const drawn = ended && !this.pinching && Math.abs(this.place(event) - this.from_px) > kDrag_px;
    if (drawn) this.on.chosen(...this.span(event));
    this.on.dropped();
    this.held = undefined;
    if (this.fingers.size === 0) this.pinching = false;
  }
  private span(event: PointerEvent): [number, number] {
    const to_px = Math.min(Math.max(this.place(event), 0), this.over.clientWidth);
    return this.from_px < to_px ? [this.from_px, to_px] : [to_px, this.from_px];
  }
}
