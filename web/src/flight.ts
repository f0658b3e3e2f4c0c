// SPDX-License-Identifier: GPL-3.0-or-later
// A flight document with its numbers decoded, to which a live source adds samples.
import { decode } from './document';
import type { BandEntry, EventEntry, FlightDocument, Kind, SeriesEntry } from './document';

export interface Series {
  name: string; title: string; unit: string; group: string; kind?: Kind;
  times: number[]; readonly values: number[];
}

// Its values are decoded when they are first asked for: most series of a flight are never looked at.
function seriesOf(entry: SeriesEntry, times: number[]): Series {
  const { name, title, unit, group, kind } = entry;
  let values: number[] | undefined;
  return { name, title, unit, group, kind, times, get values() { return values ??= decode(entry.values); } };
}

// The index of the last time that is not after `time_s`; -1: all are.
export function indexAt(times: ArrayLike<number>, time_s: number): number {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time_s) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

const kStale_s = 5;  // a value older than this is none

export class Flight {
  readonly series: Series[];
  readonly events: EventEntry[];
  readonly bands: BandEntry[];
  from_s = 0;
  to_s = 0;

  constructor(readonly document: FlightDocument) {
    const times = document.times.map(decode);
    this.series = document.series.map((entry) => seriesOf(entry, times[entry.time] ?? []));
    if (document.kind === 'live') for (const each of this.series) each.times = [...each.times];
    this.events = [...(document.events ?? [])].sort((a, b) => a.time_s - b.time_s);
    this.bands = document.bands ?? [];
    const used = times.filter((each) => each.length > 0);
    this.from_s = used.length > 0 ? Math.min(...used.map((each) => each[0])) : 0;
    this.to_s = used.length > 0 ? Math.max(...used.map((each) => each[each.length - 1])) : 0;
  }

  // The first of the kinds that there is; without kinds the first of the name.
  find(name: string, ...kinds: Kind[]): Series | undefined {
    const named = this.series.filter((each) => each.name === name);
    for (const kind of kinds) {
      const found = named.find((each) => each.kind === kind);
      if (found) return found;
    }
    return named[0];
  }

  // NaN: there is none then.
  at(series: Series | undefined, time_s: number): number {
    if (!series) return NaN;
    const i = indexAt(series.times, time_s);
    return i < 0 || time_s - series.times[i] > kStale_s ? NaN : series.values[i];
  }

  // Between two samples on a straight line; of angles the shorter way round.
  smooth(series: Series | undefined, time_s: number, angle = false): number {
    if (!series) return NaN;
    const i = indexAt(series.times, time_s);
    const [a, b] = [series.values[i], series.values[i + 1]];
    if (i < 0 || b === undefined || !Number.isFinite(b)) return this.at(series, time_s);
    const part = (time_s - series.times[i]) / (series.times[i + 1] - series.times[i]);
    const way = angle ? b - a - 360 * Math.round((b - a) / 360) : b - a;
    return a + part * way;
  }

  bandAt(kind: BandEntry['kind'], time_s: number): BandEntry | undefined {
    return this.bands.find((band) => band.kind === kind && band.from_s <= time_s && time_s < (band.to_s ?? Infinity));
  }

  // A live sample. A name that the document has not is passed over.
  append(time_s: number, values: Record<string, number | null>): void {
    for (const series of this.series) {
      const key = series.kind && `${series.name}:${series.kind}` in values ? `${series.name}:${series.kind}` : series.name;
      const value = values[key];
      if (value === undefined) continue;
      series.times.push(time_s);
      series.values.push(value ?? NaN);
    }
    if (this.to_s === 0) this.from_s = time_s;
    this.to_s = Math.max(this.to_s, time_s);
  }
}
