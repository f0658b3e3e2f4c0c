// SPDX-License-Identifier: GPL-3.0-or-later
// A live flight: a stream of server-sent events in, commands as JSON out.
import type { BandEntry, EventEntry, FlightDocument } from '../document';
import { clear, show } from '../page';
import type { Page } from '../page';
import { LivePanel } from '../view/live_panel';
import type { LiveStatus } from '../view/live_panel';

export type Command = Record<string, string | number | boolean>;
export interface Answer { ok: boolean; text: string }

const kRedraw_ms = 400;  // of plots and timeline; map, display and attitude follow every picture

export async function send(command: Command): Promise<Answer> {
  try {
    const response = await fetch('/command', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(command) });
    return await response.json() as Answer;
  } catch {
    return { ok: false, text: 'the simulator does not answer' };
  }
}

class LiveFlight {
  private page?: Page;
  private panel?: LivePanel;
  private due = false;
  private pictured = true;
  private bandsChanged = false;
  private ended = '';  // why, once it has

  constructor(private readonly notice: (words: string) => void) {
    const stream = new EventSource('/live');
    const on = <T>(name: string, take: (data: T) => void): void =>
      stream.addEventListener(name, (event) => take(JSON.parse((event as MessageEvent<string>).data) as T));
    on<FlightDocument>('flight', (found) => this.take(found));
    on<{ time_s: number; values: Record<string, number | null> }>('samples', ({ time_s, values }) => this.sample(time_s, values));
    on<EventEntry>('event', (entry) => this.event(entry));
    on<BandEntry>('band', (entry) => this.band(entry));
    on<LiveStatus>('status', (status) => this.status(status));
    stream.addEventListener('open', () => { this.ended = ''; notice(''); });
    stream.addEventListener('error', () => notice(this.ended || 'The simulator has gone; this page waits for it.'));
  }

  private status(status: LiveStatus): void {
    this.panel?.show(status);
    if (!status.ended) return;
    this.ended = `The flight has ended: ${status.ended}`;
    this.notice(this.ended);
  }

  // The first one begins the page; a later one brings another plan, and what was flown stays.
  private take(found: FlightDocument): void {
    const before = this.page?.flight;
    if (before && found.series.length === before.series.length) {
      Object.assign(before.document, { plan: found.plan, provenance: found.provenance });
      return this.page?.map.draw();
    }
    if (before) clear();
    this.page = show(found);
    this.panel = new LivePanel(this.page, send);
  }
  private sample(time_s: number, values: Record<string, number | null>): void {
    if (!this.page) return;
    this.page.flight.append(time_s, values);
    this.redrawSoon();
    if (!this.pictured) return;
    this.pictured = false;
    requestAnimationFrame(() => this.picture());
  }
  private picture(): void {
    this.pictured = true;
    if (!this.page) return;
    const { flight, view, map } = this.page;
    if (this.bandsChanged) map.draw();
    else map.grow();
    this.bandsChanged = false;
    view.grow(flight.from_s, flight.to_s);
  }
  private redrawSoon(): void {
    if (this.due) return;
    this.due = true;
    setTimeout(() => {
      this.due = false;
      this.page?.plots.grow();
      this.page?.playback.grow();
    }, kRedraw_ms);
  }
  private event(entry: EventEntry): void {
    this.page?.flight.events.push(entry);
    this.page?.messages.add(entry);
  }
  // One that was open is the same band when it comes again with its end.
  private band(entry: BandEntry): void {
    if (!this.page) return;
    const { bands } = this.page.flight;
    const open = bands.find(({ kind, name, to_s }) => to_s === undefined && kind === entry.kind && (kind === 'mode' || name === entry.name));
    if (open && open.name === entry.name) open.to_s = entry.to_s;
    else {
      if (open) open.to_s = entry.from_s;
      bands.push(entry);
    }
    this.bandsChanged = true;
    if (entry.kind === 'fault') this.panel?.faultsChanged();
  }
}

export function connect(notice: (words: string) => void): void {
  notice('connecting…');
  new LiveFlight(notice);
}
