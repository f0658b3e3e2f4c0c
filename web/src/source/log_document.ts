// SPDX-License-Identifier: GPL-3.0-or-later
// The flight document of a log, as toolchain/log makes it (toolchain/log_tool/log_document.cpp), but
// for the deviations, which need the geometry of the mission.
import type { BandEntry, EventEntry, FlightDocument, Kind, Plan, PlanItem, SeriesEntry } from '../document';
import { DataflashLog } from './dataflash';
import type { Fields, LogRecord } from './dataflash';
import rows from './log_series.json';
import names from './names.json';

interface Row { message: string; field: string; name: string; title: string; unit: string; group: string; kind?: string; scale?: number }
type Table = Record<string, string | undefined>;

const kMaxSamples = 5000, kOurs = 'ArduPilotMega autopilot';
const kCircles = [17, 19];  // MAV_CMD_NAV_LOITER_UNLIM to ..._TIME
const kArmed = 10, kDisarmed = 11, kInTheAir = 28;

const seconds = (fields: Fields): number => Number(fields.TimeUS) * 1e-6;
const timed = ({ fields }: LogRecord): boolean => Number.isFinite(seconds(fields));

export const modeName = (mode: number): string => names.modes[mode] ?? `mode ${mode}`;
export const eventName = (id: number): string => (names.events as Table)[id] ?? `event ${id}`;

export function errorName(subsystem: number, code: number, ours: boolean): string {
  const known = (ours ? names.our_codes : names.ardupilot_codes) as Table;
  const meaning = known[`${subsystem}.${code}`] ?? (code === 0 ? 'resolved' : code === 1 && !ours ? 'failsafe occurred' : `code ${code}`);
  return `${names.subsystems[subsystem] ?? `subsystem ${subsystem}`}: ${meaning}`;
}

function banner(log: DataflashLog): string {
  return log.named('MSG').map(({ Message }) => String(Message)).find((text) => text.startsWith(kOurs) || text.startsWith('ArduPlane')) ?? '';
}

const general = (value: number): string => String(+value.toPrecision(6));

export function itemText(command: number, altitude_m: number, parameters: number[]): string {
  const name = ((names.commands as Table)[command] ?? `command ${command}`).toLowerCase().replaceAll('_', ' ');
  const height = altitude_m !== 0 ? `, ${general(altitude_m)} m` : '';
  return name + height + (parameters.some((each) => each !== 0) ? `, parameters ${parameters.map(general).join(' ')}` : '');
}

function planOf(log: DataflashLog): Plan {
  const items = new Map<number, PlanItem>();
  const loiter_m = log.named('PARM').filter(({ Name }) => Name === 'WP_LOITER_RAD').map(({ Value }) => Number(Value)).at(-1);
  for (const { CNum, CId, Lat, Lng, Alt, Prm1, Prm2, Prm3, Prm4 } of log.named('CMD')) {
    if (items.has(Number(CNum))) continue;
    const placed = Number(CId) < 96 && (Number(Lat) !== 0 || Number(Lng) !== 0);
    items.set(Number(CNum), {
      index: Number(CNum), name: (names.commands as Table)[Number(CId)] ?? `COMMAND ${CId}`,
      text: itemText(Number(CId), Number(Alt), [Prm1, Prm2, Prm3, Prm4].map(Number)),
      ...(placed ? { lat_deg: Number(Lat), lon_deg: Number(Lng), altitude_m: Number(Alt) } : {}),
      ...(placed && Number(CId) >= kCircles[0] && Number(CId) <= kCircles[1] ? { radius_m: Number(Prm3) || loiter_m } : {}),
    });
  }
  const home = items.get(0);
  const rest = [...items.values()].filter(({ index }) => index > 0).sort((a, b) => a.index - b.index);
  return {
    ...(home?.lat_deg !== undefined && home.lon_deg !== undefined
      ? { home: { lat_deg: home.lat_deg, lon_deg: home.lon_deg, altitude_m: home.altitude_m } } : {}),
    items: rest,
  };
}

function eventOf({ name, fields }: LogRecord, ours: boolean): EventEntry | undefined {
  const time_s = seconds(fields);
  if (name === 'MODE') return { time_s, kind: 'mode', text: `mode ${modeName(Number(fields.ModeNum))}` };
  if (name === 'MSG') {
    const text = String(fields.Message);
    return { time_s, kind: text.startsWith('Mission item ') ? 'item' : 'text', text };
  }
  if (name === 'EV') {
    const id = Number(fields.Id);
    return { time_s, kind: id === kArmed || id === kDisarmed ? 'armed' : 'text', text: eventName(id) };
  }
  if (name !== 'ERR') return undefined;
  const text = errorName(Number(fields.Subsys), Number(fields.ECode), ours);
  return { time_s, kind: text.startsWith('FAILSAFE_') ? 'failsafe' : 'error', text };
}

// Each lasts until the next of its kind and subsystem, the last one to the end.
function bandsOf(log: DataflashLog, end_s: number, ours: boolean): BandEntry[] {
  const bands: BandEntry[] = [];
  const open = new Map<string, BandEntry>();
  const begin = (key: string, band: BandEntry | undefined, at_s: number): void => {
    const before = open.get(key);
    if (before) before.to_s = at_s;
    open.delete(key);
    if (!band) return;
    bands.push(band);
    open.set(key, band);
  };
  for (const { name, fields } of log.records.filter(timed)) {
    const from_s = seconds(fields);
    if (name === 'MODE') begin('mode', { kind: 'mode', name: modeName(Number(fields.ModeNum)), from_s, to_s: end_s }, from_s);
    const subsystem = names.subsystems[Number(fields.Subsys)] ?? '';
    if (name !== 'ERR' || !subsystem.startsWith('FAILSAFE_')) continue;
    const text = errorName(Number(fields.Subsys), Number(fields.ECode), ours);
    begin(subsystem, Number(fields.ECode) === 0 ? undefined : { kind: 'failsafe', name: text, from_s, to_s: end_s }, from_s);
  }
  return bands;
}

class SeriesMaker {
  readonly times: number[][] = [];
  readonly series: SeriesEntry[] = [];
  private readonly of = new Map<string, { index: number; records: Fields[] }>();
  constructor(private readonly log: DataflashLog) {}

  private thinned(message: string): { index: number; records: Fields[] } {
    const known = this.of.get(message);
    if (known) return known;
    const all = this.log.named(message).filter((fields) => Number.isFinite(seconds(fields)));
    const by = Math.max(1, Math.ceil(all.length / kMaxSamples));
    const made = { index: this.times.length, records: all.filter((_, i) => i % by === 0) };
    this.of.set(message, made);
    if (made.records.length > 0) this.times.push(made.records.map(seconds));
    return made;
  }
  add({ message, field, scale, ...row }: Row): void {
    if (this.series.some(({ name, kind }) => name === row.name && kind === row.kind)) return;
    const { index, records } = this.thinned(message);
    if (records.length === 0 || !(field in records[0])) return;
    const values = records.map((fields) => Number(fields[field]) * (scale ?? 1));
    if (!values.some(Number.isFinite)) return;
    this.series.push({ ...row, kind: row.kind as Kind | undefined, time: index, values });
  }
}

export function logDocument(bytes: ArrayBuffer, file: string): FlightDocument {
  const log = new DataflashLog(bytes);
  const made = new SeriesMaker(log);
  for (const row of rows) made.add(row);
  const said = banner(log), ours = said.startsWith(kOurs);
  const times = log.records.filter(timed).map(({ fields }) => seconds(fields));
  const end_s = times.reduce((a, b) => Math.max(a, b), 0);
  const ids = log.named('EV').map(({ Id }) => Number(Id));
  const flown = ids.includes(kInTheAir) && ids.lastIndexOf(kDisarmed) > ids.indexOf(kInTheAir);
  return {
    format: 'apm-flight', version: 1, kind: 'log', title: `${file} · ${said || 'firmware unknown'}`,
    verdict: { good: flown, text: flown ? 'flown and disarmed' : 'the log ends before the airplane was disarmed after a flight' },
    provenance: {
      log: file, firmware: { name: said || 'unknown' },
      parameters: Object.fromEntries(log.named('PARM').map(({ Name, Value }) => [String(Name), Number(Value)])),
    },
    plan: planOf(log), series: made.series, times: made.times,
    events: log.records.filter(timed).map((record) => eventOf(record, ours)).filter((event) => event !== undefined),
    bands: bandsOf(log, end_s, ours),
  };
}
