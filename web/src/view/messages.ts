// SPDX-License-Identifier: GPL-3.0-or-later
// What was said and what happened, in order of time; a click moves the cursor there.
import { byId, make } from '../dom';
import type { EventEntry, EventKind } from '../document';
import type { Flight } from '../flight';
import { clock } from '../units';
import type { View } from '../view';

const kFilters: [string, EventKind[]][] = [
  ['texts', ['text']], ['modes', ['mode', 'armed']], ['items', ['item']], ['trouble', ['failsafe', 'fault', 'error']],
];
const kWarning = 4, kError = 3;  // MAV_SEVERITY

function classOf({ kind, severity }: EventEntry): string {
  if ((severity !== undefined && severity <= kError) || kind === 'failsafe') return 'severe';
  if (severity === kWarning || kind === 'fault' || kind === 'error') return 'warning';
  return kind === 'mode' || kind === 'armed' ? 'mode' : '';
}

export class Messages {
  private readonly list = byId('message-list');
  private rows: { event: EventEntry; row: HTMLElement }[] = [];
  private readonly hidden = new Set<EventKind>();
  private now?: HTMLElement;

  constructor(private readonly flight: Flight, private readonly view: View) {
    for (const [name, kinds] of kFilters) {
      if (flight.document.kind !== 'live' && !flight.events.some(({ kind }) => kinds.includes(kind))) continue;
      byId('filters').append(this.filter(name, kinds));
    }
    this.fill(false);
    requestAnimationFrame(() => this.move(view.time_s));
    view.moved.on((time_s) => this.move(time_s));
  }
  private filter(name: string, kinds: EventKind[]): HTMLElement {
    const button = make('button', { type: 'button', 'aria-pressed': 'true' }, name);
    button.addEventListener('click', () => {
      const on = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', String(on));
      for (const kind of kinds) {
        if (on) this.hidden.delete(kind);
        else this.hidden.add(kind);
      }
      this.fill();
    });
    return button;
  }
  private fill(scroll = true): void {
    this.rows = [];
    this.list.replaceChildren();
    for (const event of this.flight.events) this.add(event);
    if (scroll) this.move(this.view.time_s);
  }
  add(event: EventEntry): void {
    if (this.hidden.has(event.kind)) return;
    const button = make('button', { type: 'button', class: classOf(event) }, make('time', {}, clock(event.time_s)), make('span', {}, event.text));
    button.addEventListener('click', () => this.view.jumpTo(event.time_s));
    const row = make('li', {}, button);
    this.rows.push({ event, row });
    this.list.append(row);
  }
  private move(time_s: number): void {
    const now = this.rows.findLast(({ event }) => event.time_s <= time_s + 0.05)?.row;
    if (now === this.now) return;
    this.now?.classList.remove('now');
    now?.classList.add('now');
    this.now = now;
    if (!now) return;
    const { offsetTop: top, offsetHeight: height } = now, { list } = this;
    if (top < list.scrollTop || top + height > list.scrollTop + list.clientHeight) list.scrollTop = top - list.clientHeight / 2;
  }
}
