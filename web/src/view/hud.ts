// SPDX-License-Identifier: GPL-3.0-or-later
// The head-up display: horizon, speed and height on tapes, heading, climb, throttle, mode.
import { byId, colour, onThemeChange, sized } from '../dom';
import type { Flight, Series } from '../flight';
import type { View } from '../view';

const kPixelsPerDegree = 2.2, kTape = 46;

interface Values { roll: number; pitch: number; yaw: number; airspeed: number; height: number; climb: number; throttle: number; mode: string }

export class Hud {
  private readonly canvas = byId<HTMLCanvasElement>('hud');
  private readonly series: Record<string, Series | undefined> = {};
  private words = '';

  constructor(private readonly flight: Flight, private readonly view: View) {
    for (const name of ['roll_deg', 'pitch_deg', 'yaw_deg', 'airspeed_mps', 'height_m', 'climb_mps', 'throttle_percent'])
      this.series[name] = flight.find(name, 'truth', 'estimate', 'measured');
    view.moved.on(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    onThemeChange(() => this.draw());
  }

  private values(): Values {
    const { flight, view: { time_s }, series } = this;
    return {
      roll: flight.smooth(series.roll_deg, time_s, true), pitch: flight.smooth(series.pitch_deg, time_s),
      yaw: flight.smooth(series.yaw_deg, time_s, true), airspeed: flight.smooth(series.airspeed_mps, time_s),
      height: flight.smooth(series.height_m, time_s), climb: flight.smooth(series.climb_mps, time_s),
      throttle: flight.at(series.throttle_percent, time_s), mode: flight.bandAt('mode', time_s)?.name ?? '',
    };
  }

  draw(): void {
    const { context, width, height } = sized(this.canvas);
    if (width === 0 || height === 0) return;
    const now = this.values();
    this.horizon(context, width, height, now);
    this.tape(context, 0, height, now.airspeed, 'm/s', 1);
    this.tape(context, width - kTape, height, now.height, 'm', -1);
    this.texts(context, width, height, now);
    this.describe(now);
  }
  private describe(now: Values): void {
    const whole = (value: number): string => (Number.isFinite(value) ? value.toFixed(0) : 'unknown');
    const words = `Head-up display: roll ${whole(now.roll)}°, pitch ${whole(now.pitch)}°, airspeed ${whole(now.airspeed)} m/s, height ${whole(now.height)} m, mode ${now.mode || 'unknown'}`;
    if (words === this.words || this.view.playing) return;
    this.words = words;
    this.canvas.setAttribute('aria-label', words);
  }

  private horizon(context: CanvasRenderingContext2D, width: number, height: number, { roll, pitch }: Values): void {
    context.save();
    context.fillStyle = colour('sky');
    context.fillRect(0, 0, width, height);
    context.translate(width / 2, height / 2);
    context.rotate(-(Number.isFinite(roll) ? roll : 0) * Math.PI / 180);
    const down = (Number.isFinite(pitch) ? pitch : 0) * kPixelsPerDegree, far = width + height;
    context.fillStyle = colour('earth');
    context.fillRect(-far, down, 2 * far, 2 * far);
    context.strokeStyle = context.fillStyle = '#ffffff';
    context.lineWidth = 1.2;
    context.font = '10px system-ui, sans-serif';
    context.textAlign = 'left';
    this.stroke(context, -far, down, far, down);
    for (let degrees = -60; degrees <= 60; degrees += 10) {
      const y = down - degrees * kPixelsPerDegree;
      if (degrees === 0 || Math.abs(y) > height / 2 - 12) continue;
      this.stroke(context, -16, y, 16, y);
      context.fillText(String(Math.abs(degrees)), 20, y + 3.5);
    }
    context.restore();
    context.strokeStyle = '#ffd54a';
    context.lineWidth = 2.5;
    const [x, y] = [width / 2, height / 2];
    this.stroke(context, x - 34, y, x - 13, y);
    this.stroke(context, x + 13, y, x + 34, y);
    this.stroke(context, x, y - 1, x, y + 1);
  }
  private stroke(context: CanvasRenderingContext2D, x1: number, y1: number, x2: number, y2: number): void {
    context.beginPath();
    context.moveTo(x1, y1);
    context.lineTo(x2, y2);
    context.stroke();
  }

  private tape(context: CanvasRenderingContext2D, left: number, height: number, value: number, unit: string, side: 1 | -1): void {
    const middle = height / 2, perUnit = unit === 'm' ? 1.6 : 6, by = unit === 'm' ? 20 : 5;
    context.fillStyle = 'rgba(10,18,26,.42)';
    context.fillRect(left, 0, kTape, height);
    context.fillStyle = context.strokeStyle = '#ffffff';
    context.lineWidth = 1;
    context.font = '10px system-ui, sans-serif';
    context.textAlign = side > 0 ? 'right' : 'left';
    const edge = side > 0 ? left + kTape : left;
    if (Number.isFinite(value)) {
      for (let mark = Math.ceil((value - middle / perUnit) / by) * by; mark <= value + middle / perUnit; mark += by) {
        const y = middle - (mark - value) * perUnit;
        this.stroke(context, edge, y, edge - side * 5, y);
        if (Math.abs(y - middle) > 14) context.fillText(String(mark), edge - side * 8, y + 3.5);
      }
    }
    context.fillStyle = '#0c151d';
    context.fillRect(left, middle - 10, kTape, 20);
    context.fillStyle = '#ffffff';
    context.font = '600 12px system-ui, sans-serif';
    context.textAlign = 'center';
    context.fillText(Number.isFinite(value) ? value.toFixed(1) : '–', left + kTape / 2, middle + 4.5);
    context.font = '9px system-ui, sans-serif';
    context.fillText(unit, left + kTape / 2, height - 4);
  }

  private texts(context: CanvasRenderingContext2D, width: number, height: number, now: Values): void {
    context.textAlign = 'center';
    context.fillStyle = 'rgba(10,18,26,.55)';
    context.fillRect(width / 2 - 24, 2, 48, 16);
    context.fillRect(kTape, height - 17, width - 2 * kTape, 17);
    context.fillStyle = '#ffffff';
    context.font = '600 11px system-ui, sans-serif';
    const heading = Number.isFinite(now.yaw) ? ((now.yaw % 360) + 360) % 360 : NaN;
    context.fillText(Number.isFinite(heading) ? `${heading.toFixed(0).padStart(3, '0')}°` : '–', width / 2, 14);
    const part = (value: number, words: (value: number) => string): string[] => (Number.isFinite(value) ? [words(value)] : []);
    const line = [now.mode, ...part(now.climb, (v) => `${v >= 0 ? '↑' : '↓'}${Math.abs(v).toFixed(1)}`), ...part(now.throttle, (v) => `${v.toFixed(0)} %`)];
    context.fillText(line.filter(Boolean).join('  '), width / 2, height - 5, width - 2 * kTape - 6);
  }
}
