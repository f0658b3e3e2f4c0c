// SPDX-License-Identifier: GPL-3.0-or-later
// Flight documents as tests read them: out of a page, their numbers decoded.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

export function embedded(file, id = 'flight') {
  const found = new RegExp(`<script type="application/json" id="${id}">([^]*?)</script>`).exec(readFileSync(file, 'utf8'));
  assert.ok(found, `${file} holds no ${id}`);
  return JSON.parse(found[1]);
}

export function decoded(numbers) {
  if (Array.isArray(numbers)) return numbers.map((value) => value ?? NaN);
  const bytes = Buffer.from(numbers.f32 ?? numbers.i16, 'base64');
  if (numbers.f32 !== undefined) return Array.from({ length: bytes.length / 4 }, (_, i) => bytes.readFloatLE(4 * i));
  return Array.from({ length: bytes.length / 2 }, (_, i) => {
    const step = bytes.readInt16LE(2 * i);
    return step === -32768 ? NaN : numbers.offset + numbers.scale * step;
  });
}

// { times, values, step } of a series; `step` is how finely it is stored.
export function seriesOf(document, name, kind) {
  const found = document.series.find((each) => each.name === name && each.kind === kind);
  assert.ok(found, `no series ${name} ${kind ?? ''}`);
  return { times: decoded(document.times[found.time]), values: decoded(found.values), step: found.values.scale ?? 0 };
}
