// SPDX-License-Identifier: GPL-3.0-or-later
// What is looked at: the time of the cursor, the span that is shown, and whether it plays.

export class Signal<T> {
  private readonly listeners = new Set<(value: T) => void>();
  on(listener: (value: T) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
  emit(value: T): void { for (const listener of this.listeners) listener(value); }
}

const kShortest_s = 0.5;

export class View {
  readonly moved = new Signal<number>();
  readonly zoomed = new Signal<readonly [number, number]>();
  readonly changed = new Signal<void>();  // playing, rate, live
  playing = false;
  rate = 1;
  live = false;  // the cursor stays at the newest sample
  time_s: number;
  span: readonly [number, number];

  constructor(public from_s: number, public to_s: number) {
    this.time_s = from_s;
    this.span = [from_s, to_s];
  }

  moveTo(time_s: number): void {
    this.time_s = Math.min(Math.max(time_s, this.from_s), this.to_s);
    this.moved.emit(this.time_s);
  }
  // By the user, which ends what moves by itself.
  jumpTo(time_s: number): void {
    this.setLive(false);
    if (this.playing) this.play(false);
    this.moveTo(time_s);
    const [from, to] = this.span;
    const wide = to - from;
    if (this.time_s < from || this.time_s > to) this.zoom(this.time_s - wide / 2, this.time_s + wide / 2);
  }
  zoom(from_s: number, to_s: number): void {
    const wide = Math.min(Math.max(to_s - from_s, kShortest_s), this.to_s - this.from_s || kShortest_s);
    const from = Math.min(Math.max(from_s, this.from_s), Math.max(this.to_s - wide, this.from_s));
    this.span = [from, from + wide];
    this.zoomed.emit(this.span);
  }
  zoomBy(factor: number): void {
    const [from, to] = this.span;
    this.zoom(this.time_s - (this.time_s - from) * factor, this.time_s + (to - this.time_s) * factor);
  }
  whole(): boolean { return this.span[0] <= this.from_s && this.span[1] >= this.to_s; }
  showWhole(): void { this.zoom(this.from_s, this.to_s); }

  play(playing: boolean): void {
    if (playing && this.time_s >= this.to_s) this.moveTo(this.from_s);
    this.playing = playing;
    this.changed.emit();
  }
  setRate(rate: number): void {
    this.rate = rate;
    this.changed.emit();
  }
  setLive(live: boolean): void {
    if (this.live === live) return;
    this.live = live;
    this.changed.emit();
  }
  // A live flight has become longer; who draws the span looks at it when it draws next.
  grow(from_s: number, to_s: number): void {
    const whole = this.whole();
    this.from_s = from_s;
    this.to_s = to_s;
    if (whole) this.span = [from_s, to_s];
    if (this.live) this.moveTo(to_s);
  }
}
