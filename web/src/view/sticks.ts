// SPDX-License-Identifier: GPL-3.0-or-later
// A gamepad, or W A S D and the arrow keys, as the transmitter's sticks (mode 2).
import { make } from '../dom';
import type { Command } from '../source/live';

const kEvery_ms = 50, kDeadZone = 0.06, kThrottleStep = 0.02;
const kIdle_us = 1100, kTravel_us = 800;  // of the throttle's stick

const beyond = (value: number): number => (Math.abs(value) < kDeadZone ? 0 : value);

export class Sticks {
  private readonly button = make('button', { id: 'sticks', type: 'button', 'aria-pressed': 'false',
    title: 'gamepad, or arrows: roll and pitch; A D: rudder; W S: throttle' }, 'sticks');
  private readonly keys = new Set<string>();
  private throttle = 0;
  private timer?: ReturnType<typeof setInterval>;
  private last = '';

  // `throttle_us`: where that stick is now, NaN while it is not known.
  constructor(private readonly send: (command: Command) => void, private readonly throttle_us: () => number, panel: HTMLElement) {
    panel.firstElementChild?.append(this.button);
    this.button.addEventListener('click', () => this.set(this.timer === undefined));
    addEventListener('keydown', (event) => this.key(event, true), true);
    addEventListener('keyup', (event) => this.key(event, false), true);
    addEventListener('blur', () => this.keys.clear());
  }
  private set(on: boolean): void {
    this.button.setAttribute('aria-pressed', String(on));
    clearInterval(this.timer);
    const now = (this.throttle_us() - kIdle_us) / kTravel_us;
    if (on && Number.isFinite(now)) this.throttle = Math.min(Math.max(now, 0), 1);
    this.timer = on ? setInterval(() => this.tick(), kEvery_ms) : undefined;
  }
  private key(event: KeyboardEvent, down: boolean): void {
    if (this.timer === undefined || !/^(Arrow(Left|Right|Up|Down)|[wasd])$/.test(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    if (down) this.keys.add(event.key);
    else this.keys.delete(event.key);
  }
  private pair(plus: string, minus: string): number { return Number(this.keys.has(plus)) - Number(this.keys.has(minus)); }
  private tick(): void {
    const pad = navigator.getGamepads().find((each) => each?.connected && each.axes.length >= 4);
    this.throttle = pad ? (1 - pad.axes[1]) / 2 : Math.min(Math.max(this.throttle + this.pair('w', 's') * kThrottleStep, 0), 1);
    const command: Command = {
      do: 'sticks',
      roll: pad ? beyond(pad.axes[2]) : this.pair('ArrowRight', 'ArrowLeft') * 0.6,
      pitch: pad ? beyond(pad.axes[3]) : this.pair('ArrowDown', 'ArrowUp') * 0.6,
      throttle: +this.throttle.toFixed(2),
      yaw: pad ? beyond(pad.axes[0]) : this.pair('d', 'a') * 0.6,
    };
    const text = JSON.stringify(command);
    if (text === this.last) return;
    this.last = text;
    this.send(command);
  }
}
