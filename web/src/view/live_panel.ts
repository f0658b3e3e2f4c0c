// SPDX-License-Identifier: GPL-3.0-or-later
// What a ground station and the simulator's own commands can do to a live flight; and gamepad or
// keyboard as its sticks.
import { byId, make } from '../dom';
import type { Offers } from '../document';
import type { Page } from '../page';
import type { Answer, Command } from '../source/live';
import { Sticks } from './sticks';

export interface LiveStatus { armed: boolean; mode: string; item: number; speed: number; times: number | 'max'; paused: boolean; clients: number; ended?: string }
type Send = (command: Command) => Promise<Answer>;

const kSpeeds: [string, number | 'max'][] = [['1×', 1], ['2×', 2], ['5×', 5], ['10×', 10], ['max', 'max']];

type Options = Node[];
const option = (value: string, text = value): HTMLElement => make('option', { value }, text);

// By the part that fails: gps: lost, stuck, ...
function faultOptions(faults: string[]): Options {
  const parts = [...new Set(faults.map((name) => name.split(':')[0]))];
  return parts.map((part) => make('optgroup', { label: part },
    ...faults.filter((name) => name.split(':')[0] === part).map((name) => option(name, name.replace(':', ' ').replaceAll('_', ' ')))));
}

export class LivePanel {
  private readonly state = make('span', { class: 'state', 'aria-live': 'polite' }, 'waiting…');
  private readonly answer = make('div', { id: 'live-answer', role: 'status' });
  private readonly arm = make('button', { id: 'arm', type: 'button', class: 'main' }, 'arm');
  private readonly pause = make('button', { id: 'pause', type: 'button' }, 'pause');
  private readonly goTo = make('button', { id: 'goto', type: 'button', 'aria-pressed': 'false' }, 'fly to here');
  private readonly height = make('input', { type: 'number', value: 60, min: 10, max: 500, 'aria-label': 'Height of fly to here, m' });
  private readonly speeds = kSpeeds.map(([name, times]) => this.speed(name, times));
  private readonly over = this.choice('end a fault', [], (name) => void this.do({ do: 'fault', name, on: false }));
  private status?: LiveStatus;

  constructor(private readonly page: Page, private readonly send: Send) {
    const panel = byId('live-panel');
    panel.hidden = false;
    panel.replaceChildren(this.flying(), this.world(), this.answer);
    this.arm.addEventListener('click', () => void this.do({ do: this.status?.armed ? 'disarm' : 'arm' }));
    this.pause.addEventListener('click', () => void this.do({ do: this.status?.paused ? 'resume' : 'pause' }));
    this.goTo.addEventListener('click', () => this.aim(this.goTo.getAttribute('aria-pressed') !== 'true'));
    this.faultsChanged();
    page.map.fit();
    const { flight } = page;
    new Sticks((command) => void this.send(command), () => flight.at(flight.find('rc3_us'), flight.to_s), panel);
  }
  private get offers(): Offers { return this.page.flight.document.offers ?? { modes: [], faults: [] }; }
  // What fails now can be ended.
  faultsChanged(): void {
    const failing = this.page.flight.bands.filter(({ kind, to_s }) => kind === 'fault' && to_s === undefined).map(({ name }) => name);
    this.over.replaceChildren(option('', 'end a fault…'), ...failing.map((name) => option(name)));
    this.over.disabled = failing.length === 0;
  }
  private row(...children: (Node | string)[]): HTMLElement { return make('div', { class: 'row' }, ...children); }
  private choice(label: string, options: Options, run: (name: string) => void): HTMLSelectElement {
    const select = make('select', { 'aria-label': label }, option('', `${label}…`), ...options);
    select.addEventListener('change', () => {
      if (select.value) run(select.value);
      select.value = '';
    });
    return select;
  }
  private speed(name: string, times: number | 'max'): HTMLElement {
    const button = make('button', { type: 'button', 'aria-pressed': 'false' }, name);
    button.addEventListener('click', () => void this.do({ do: 'speed', times }));
    return button;
  }
  private flying(): HTMLElement {
    const takeoff = make('button', { type: 'button' }, 'take-off');
    takeoff.addEventListener('click', () => void this.do({ do: 'takeoff' }));
    return this.row(this.state, this.arm, takeoff,
      this.choice('mode', this.offers.modes.map((name) => option(name)), (mode) => void this.do({ do: 'mode', mode })), this.goTo, make('span', {}, 'at ', this.height, ' m'));
  }
  private world(): HTMLElement {
    const speed = make('input', { type: 'number', value: 5, min: 0, max: 30, 'aria-label': 'Wind, m/s' });
    const from = make('input', { type: 'number', value: 320, min: 0, max: 360, 'aria-label': 'Wind from, degrees' });
    const wind = make('button', { type: 'button', 'aria-label': 'set wind' }, 'set');
    wind.addEventListener('click', () => void this.do({ do: 'wind', speed_mps: Number(speed.value), from_deg: Number(from.value) }));
    const speeds = make('span', { role: 'group', 'aria-label': 'Speed of the simulation', class: 'row' }, ...this.speeds);
    return this.row(this.pause, speeds,
      this.choice('inject a fault', faultOptions(this.offers.faults), (name) => void this.do({ do: 'fault', name, on: true })), this.over,
      make('span', {}, 'wind ', speed, ' m/s from ', from, '° ', wind));
  }
  private aim(on: boolean): void {
    this.goTo.setAttribute('aria-pressed', String(on));
    this.page.map.onPlace = !on ? undefined : ({ lat, lng }) => {
      this.aim(false);
      void this.do({ do: 'goto', lat_deg: lat, lon_deg: lng, altitude_m: Number(this.height.value) });
    };
    if (on) this.answer.textContent = 'click on the map';
  }
  private async do(command: Command): Promise<void> {
    const { ok, text } = await this.send(command);
    this.answer.textContent = text;
    this.answer.style.color = ok ? '' : 'var(--bad)';
  }
  show(status: LiveStatus): void {
    this.status = status;
    this.arm.textContent = status.armed ? 'disarm' : 'arm';
    for (const [i, [, times]] of kSpeeds.entries()) this.speeds[i].setAttribute('aria-pressed', String(times === status.times));
    this.pause.textContent = status.paused ? 'resume' : 'pause';
    const clients = status.clients > 0 ? ` · ${status.clients} ground station${status.clients > 1 ? 's' : ''}` : '';
    this.state.textContent = `${status.armed ? 'armed' : 'disarmed'} · ${status.mode} · item ${status.item} · ${status.paused ? 'paused' : `${status.speed.toFixed(1)}×`}${clients}`;
  }
}
