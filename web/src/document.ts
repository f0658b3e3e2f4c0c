// SPDX-License-Identifier: GPL-3.0-or-later
// The flight document, version 1: what a report, a log and a live flight give to the page. It is
// described in docs/flight_document.md.

export type Numbers = (number | null)[] | { f32: string } | { i16: string; scale: number; offset: number };

export interface Place { lat_deg: number; lon_deg: number; altitude_m?: number }
export interface PlanItem {
  index: number; name: string; text: string;
  lat_deg?: number; lon_deg?: number; altitude_m?: number; radius_m?: number;
}
// Of the fence: corners, or with a radius the centre.
export interface Zone { keeps: 'in' | 'out'; rim: Place[]; radius_m?: number }
export interface Plan {
  set?: string; home?: Place; items?: PlanItem[]; fence?: Place[]; zones?: Zone[]; rally?: Place[];
}

export type Kind = 'truth' | 'estimate' | 'demand' | 'measured';
export interface SeriesEntry {
  name: string; title: string; unit: string; group: string; kind?: Kind; time: number; values: Numbers;
}

export type EventKind = 'mode' | 'text' | 'failsafe' | 'fault' | 'armed' | 'item' | 'error';
export interface EventEntry { time_s: number; kind: EventKind; text: string; severity?: number; end_s?: number }

export type BandKind = 'mode' | 'failsafe' | 'fault';
export interface BandEntry { kind: BandKind; name: string; from_s: number; to_s?: number }

export interface Deviation { name: string; value: number; unit: string; goal?: number; met?: boolean }
export interface TableEntry { title: string; note?: string; heads: string[]; rows: (string | number)[][] }
export type Provenance = Record<string, unknown>;
// What a live flight can be asked for: modes of its firmware, faults as PART:HOW.
export interface Offers { modes: string[]; faults: string[] }

export interface FlightDocument {
  format: 'apm-flight'; version: number; kind: 'simulated' | 'log' | 'live'; title: string;
  verdict?: { good: boolean; text: string };
  provenance?: Provenance; plan?: Plan; offers?: Offers;
  series: SeriesEntry[]; times: Numbers[];
  events?: EventEntry[]; bands?: BandEntry[]; deviations?: Deviation[]; tables?: TableEntry[];
}

const kNone = -32768;  // of an i16: no value

function bytesOf(base64: string): DataView {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new DataView(bytes.buffer);
}

// NaN where there is no value.
export function decode(numbers: Numbers): number[] {
  if (Array.isArray(numbers)) return numbers.map((value) => value ?? NaN);
  if ('f32' in numbers) {
    const bytes = bytesOf(numbers.f32);
    return Array.from({ length: bytes.byteLength >> 2 }, (_, i) => bytes.getFloat32(4 * i, true));
  }
  const bytes = bytesOf(numbers.i16);
  return Array.from({ length: bytes.byteLength >> 1 }, (_, i) => {
    const step = bytes.getInt16(2 * i, true);
    return step === kNone ? NaN : numbers.offset + numbers.scale * step;
  });
}

export class WrongDocument extends Error {}

export function parseDocument(text: string): FlightDocument {
  const found = JSON.parse(text) as Partial<FlightDocument> | null;
  if (found?.format !== 'apm-flight') throw new WrongDocument('this is no flight document');
  if (found.version !== 1) throw new WrongDocument(`flight documents of version ${found.version} are not known here`);
  if (!Array.isArray(found.series) || !Array.isArray(found.times))
    throw new WrongDocument('the flight document has no series');
  return found as FlightDocument;
}
