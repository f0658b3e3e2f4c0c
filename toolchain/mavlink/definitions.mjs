// SPDX-License-Identifier: GPL-3.0-or-later
// The messages and constants of messages.json as npm mavlink-mappings defines them.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const require = createRequire(new URL('../node/package.json', import.meta.url));
const mappings = require('mavlink-mappings');
const dialects = [mappings.minimal, mappings.common, mappings.standard, mappings.ardupilotmega];

export const definitionsVersion = require('mavlink-mappings/package.json').version;

const wanted = JSON.parse(readFileSync(new URL('messages.json', import.meta.url)));

function messageClass(name) {
  for (const dialect of dialects)
    for (const candidate of Object.values(dialect.REGISTRY))
      if (candidate.MSG_NAME === name) return candidate;
  throw new Error(`mavlink-mappings knows no message ${name}`);
}

function enumEntries(name, keys) {
  const values = {};
  for (const dialect of dialects)
    for (const [key, value] of Object.entries(dialect[name] ?? {}))
      if (typeof value === 'number') values[key] = value;
  const chosen = keys === '*' ? Object.keys(values) : keys;
  return chosen.map((key) => {
    if (!(key in values)) throw new Error(`mavlink-mappings knows no ${name}.${key}`);
    return { key, value: values[key] };
  });
}

// Sorted by id. Fields come in wire order, extensions last, as mavlink-mappings lists them.
export function messages() {
  return wanted.messages.map(messageClass)
    .map((type) => ({
      name: type.MSG_NAME,
      id: type.MSG_ID,
      crcExtra: type.MAGIC_NUMBER,
      fields: type.FIELDS.map((field) => ({
        name: field.source,
        type: field.type.replace('[]', '').replace('_mavlink_version', ''),
        size: field.size,
        count: field.length || 0,
        offset: field.offset,
        extension: field.extension,
      })),
    }))
    .sort((a, b) => a.id - b.id);
}

export function enums() {
  return Object.entries(wanted.enums)
    .map(([name, keys]) => ({ name, entries: enumEntries(name, keys) }));
}
