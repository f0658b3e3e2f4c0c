// SPDX-License-Identifier: GPL-3.0-or-later
// Where two files of a flight differ first, in words for a person. Every function answers null for
// the same bytes and for nothing else.
import { framesIn, textOf } from './mavlink.mjs';

const kPage_bytes = 528;  // of the DataFlash chip
const hex = (byte) => (byte === undefined ? 'nothing' : `0x${byte.toString(16).padStart(2, '0')}`);

function firstOffset(before, after) {
  const shorter = Math.min(before.length, after.length);
  for (let at = 0; at < shorter; ++at) if (before[at] !== after[at]) return at;
  return shorter;
}

// Byte by byte; `place` names an offset.
function differenceOfBytes(before, after, place = (at) => `byte ${at}`) {
  const at = firstOffset(before, after);
  return `${place(at)}: ${hex(before[at])} and ${hex(after[at])}`;
}

const linesOf = (bytes) => bytes.toString('latin1').split('\n');
const shown = (value) => (value === undefined ? 'no line' : value === '' ? 'nothing' : value);

// The columns have the names of the first line.
function differenceOfTables(before, after) {
  const [ours, theirs] = [linesOf(before), linesOf(after)];
  const row = ours.findIndex((line, i) => line !== theirs[i]);
  if (row < 0) return `line ${ours.length + 1}: no line and ${shown(theirs[ours.length])}`;
  const names = ours[0].split(',');
  const [a, b] = [ours[row].split(','), theirs[row]?.split(',')];
  if (!b || ours[row] === '' || theirs[row] === '')
    return `line ${row + 1}: ${shown(ours[row])} and ${shown(theirs[row])}`.slice(0, 200);
  const column = a.findIndex((value, i) => value !== b[i]);
  if (column < 0) return `line ${row + 1}: ${a.length} columns and ${b.length}`;
  const [, unit] = /^time_(u?s)$/.exec(names[0]) ?? [];
  const when = unit && column > 0 ? ` at ${a[0]} ${unit}` : '';
  return `line ${row + 1}${when}, ${names[column] ?? `column ${column + 1}`}: ` +
    `${shown(a[column])} and ${shown(b[column])}`;
}

function differenceOfTexts(before, after) {
  const [ours, theirs] = [linesOf(before), linesOf(after)];
  const length = Math.max(ours.length, theirs.length);
  for (let row = 0; row < length; ++row)
    if (ours[row] !== theirs[row]) return `line ${row + 1}: ${shown(ours[row])} and ${shown(theirs[row])}`;
  return 'other ends of lines';
}

// The message in which they part.
function differenceOfMessages(before, after) {
  const at = firstOffset(before, after);
  const { frames } = framesIn(before);
  const number = frames.findLastIndex((each) => each.at <= at);
  const place = (offset) => (number < 0 ? `byte ${offset}`
    : `message ${number + 1} (id ${frames[number].id}), byte ${offset - frames[number].at}`);
  const twin = framesIn(after).frames[number];
  const [a, b] = [number < 0 ? undefined : textOf(frames[number]), twin && textOf(twin)];
  if (a !== undefined && b !== undefined && a !== b) return `message ${number + 1}: "${a}" and "${b}"`;
  return differenceOfBytes(before, after, place);
}

const inPages = (at) => `page ${Math.floor(at / kPage_bytes)}, byte ${at % kPage_bytes}`;

// What a flight leaves behind. `of_texts`: what a change of status texts changes.
export const kKinds = [
  { name: 'flight.csv', difference: differenceOfTables, of_texts: false },
  { name: 'summary.txt', difference: differenceOfTexts, of_texts: true },
  { name: 'telemetry.bin', difference: differenceOfMessages, of_texts: true },
  { name: 'usb.bin', difference: differenceOfMessages, of_texts: true },
  { name: 'log.bin', difference: (a, b) => differenceOfBytes(a, b, inPages), of_texts: true },
  { name: 'eeprom.bin', difference: differenceOfBytes, of_texts: true },
];
const kindOf = (path) => kKinds.find(({ name }) => path.split('/').at(-1) === name);

export const isCompared = (path, { texts_may_differ }) => {
  const kind = kindOf(path);
  return kind !== undefined && !(texts_may_differ && kind.of_texts);
};

// Null, or where the two contents of the file of this name differ first.
export function firstDifference(path, before, after) {
  if (before.equals(after)) return null;
  return kindOf(path).difference(before, after);
}

// summary.json as a line for each value, without how fast this computer was and which command flew it.
export function flattened(summary) {
  const lines = [];
  const walk = (value, path) => {
    if (value !== null && typeof value === 'object')
      for (const [key, inner] of Object.entries(value)) walk(inner, path ? `${path}.${key}` : key);
    else if (path !== 'speedup' && !path.startsWith('provenance.')) lines.push(`${path}: ${value}`);
  };
  walk(summary, '');
  return `${lines.join('\n')}\n`;
}

// What became of a flight: { verdict: 'same' | 'different' | 'failed', words }. Each side is
// { failure, files }: a failure in words or null, and a Map of path to contents.
export function compared(before, after, options = {}) {
  for (const [which, { failure }] of [['before', before], ['after', after]])
    if (failure) return { verdict: 'failed', words: `${which}: ${failure}` };
  const all = [...new Set([...before.files.keys(), ...after.files.keys()])];
  const paths = all.filter((path) => isCompared(path, options));
  if (paths.length === 0) return { verdict: 'failed', words: 'left nothing that can be compared' };
  for (const path of paths) {
    const [a, b] = [before.files.get(path), after.files.get(path)];
    if (!a || !b) return { verdict: 'different', words: `${path}: written by one side only` };
    const difference = firstDifference(path, a, b);
    if (difference) return { verdict: 'different', words: `${path} ${difference}` };
  }
  return { verdict: 'same', words: paths.join(', ') };
}
