// SPDX-License-Identifier: GPL-3.0-or-later
// The document that the page makes of a log against the one that toolchain/log makes of it. FLY and
// LOG_TOOL name the programs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { decoded, embedded } from '../support/flight_document.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const { build } = createRequire(join(root, 'web/package.json'))('esbuild');
let folder, tool, page, source;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'log-document-'));
  const image = join(folder, 'flash.bin'), log = join(folder, 'log.bin'), html = join(folder, 'log.html');
  execFileSync(process.env.FLY, ['--native', '--wind', '5,320', '--gusts', '--fault', 'radio:lost@60-90', '--fault', 'gps:lost@120-140',
    '--dataflash', image, '--out', join(folder, 'flight')], { stdio: 'ignore' });
  execFileSync(process.env.LOG_TOOL, ['extract', image, '-o', log]);
  execFileSync(process.env.LOG_TOOL, ['report', log, '-o', html]);
  await build({ entryPoints: [join(root, 'web/src/source/log_document.ts')], bundle: true, format: 'esm',
    outfile: join(folder, 'log_document.mjs'), logLevel: 'warning' });
  source = await import(pathToFileURL(join(folder, 'log_document.mjs')));
  const bytes = readFileSync(log);
  tool = embedded(html);
  page = source.logDocument(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 'log.bin');
});
after(() => rmSync(folder, { recursive: true }));

const near = (a, b, by, what) => assert.ok(Math.abs(a - b) <= by || (Number.isNaN(a) && Number.isNaN(b)), `${what}: ${a} and ${b}`);

test('it has the same series, at the same times, with the same values', () => {
  const shapes = (document) => document.series.map(({ name, title, unit, group, kind, time }) => [name, title, unit, group, kind, time].join(' '));
  assert.deepEqual(shapes(page), shapes(tool));
  assert.ok(page.series.length > 50, `${page.series.length} series`);
  const [times, others] = [page.times, tool.times].map((all) => all.map(decoded));
  assert.deepEqual(times.map((all) => all.length), others.map((all) => all.length));
  times.forEach((all, k) => all.forEach((time_s, i) => near(time_s, others[k][i], 1e-4, `time ${i} of ${k}`)));
  for (const [k, series] of tool.series.entries()) {
    const values = decoded(series.values);
    decoded(page.series[k].values).forEach((value, i) => near(value, values[i], series.values.scale * 0.51 + 1e-9, `${series.name} ${i}`));
  }
});

test('it has the same events and bands, a failsafe among them', () => {
  const rounded = (entry) => Object.fromEntries(Object.entries(entry).map(([key, value]) => [key, typeof value === 'number' ? Math.round(value * 100) / 100 : value]));
  assert.deepEqual(page.events.map(rounded), tool.events.map(rounded));
  assert.deepEqual(page.bands.map(rounded), tool.bands.map(rounded));
  for (const kind of ['mode', 'failsafe']) assert.ok(tool.bands.some((band) => band.kind === kind), kind);
  for (const kind of ['mode', 'text', 'armed', 'item', 'failsafe', 'error']) assert.ok(tool.events.some((event) => event.kind === kind), kind);
});

test('it has the same plan, title, verdict and parameters', () => {
  assert.deepEqual([page.title, page.verdict, page.kind], [tool.title, tool.verdict, tool.kind]);
  assert.equal(page.plan.items.length, tool.plan.items.length);
  for (const [i, item] of tool.plan.items.entries()) {
    const mine = page.plan.items[i];
    assert.deepEqual([mine.index, mine.name, mine.text, mine.radius_m], [item.index, item.name, item.text, item.radius_m]);
    assert.equal(mine.lat_deg === undefined, item.lat_deg === undefined);
    if (item.lat_deg !== undefined) near(mine.lat_deg, item.lat_deg, 1e-7, item.text);
  }
  assert.deepEqual(Object.keys(page.provenance.parameters).sort(), Object.keys(tool.provenance.parameters).sort());
  assert.ok(Object.keys(page.provenance.parameters).length > 200);
});

// The same log, with every item of the mission on the meridian of Greenwich.
function atGreenwich(path) {
  const bytes = readFileSync(path), kCmd = 'CMD\0';
  const formats = new Map();
  for (let at = 0; at < bytes.length;) {
    const type = bytes[at + 2];
    if (type === 128) formats.set(bytes[at + 3], { length: bytes[at + 4], name: bytes.toString('latin1', at + 5, at + 9),
      fields: bytes.toString('latin1', at + 9, at + 25), labels: bytes.toString('latin1', at + 25, at + 89).replace(/\0.*/s, '').split(',') });
    const format = type === 128 ? { length: 89 } : formats.get(type);
    if (format.name === kCmd) {
      const size = (letter) => ({ Q: 8, H: 2, B: 1, f: 4, L: 4 })[letter];
      const before_ = [...format.fields].slice(0, format.labels.indexOf('Lng')).reduce((sum, letter) => sum + size(letter), 3);
      bytes.writeInt32LE(0, at + before_);
    }
    at += format.length;
  }
  return bytes;
}

test('a mission on the meridian of Greenwich is drawn from both', () => {
  const path = join(folder, 'greenwich.bin'), html = join(folder, 'greenwich.html'), bytes = atGreenwich(join(folder, 'log.bin'));
  writeFileSync(path, bytes);
  execFileSync(process.env.LOG_TOOL, ['report', path, '-o', html]);
  const plans = [embedded(html), source.logDocument(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 'greenwich.bin')];
  for (const { plan } of plans) {
    assert.equal(plan.home.lon_deg, 0);
    assert.deepEqual(plan.items.map(({ lat_deg }) => lat_deg !== undefined), page.plan.items.map(({ lat_deg }) => lat_deg !== undefined));
    assert.ok(plan.items.filter(({ lon_deg }) => lon_deg === 0).length > 5);
  }
});

test('what is no log is refused, and a cut one is read as far as it goes', () => {
  assert.throws(() => source.logDocument(new Uint8Array(1000).buffer, 'zeros'), /no log/);
  assert.throws(() => source.logDocument(new ArrayBuffer(0), 'nothing'), /no log/);
  const bytes = readFileSync(join(folder, 'log.bin'));
  const half = source.logDocument(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + (bytes.length >> 1) + 7), 'half');
  assert.equal(half.verdict.good, false);
  assert.ok(half.series.length > 50);
});

test('names of modes are those of the simulator', () => {
  const names = JSON.parse(readFileSync(join(root, 'web/src/source/names.json'), 'utf8'));
  const code = readFileSync(join(root, 'simulator/ground/telemetry.cpp'), 'utf8');
  const table = /kNames = \{([^}]*)\}/.exec(code)[1].split(',').map((word) => word.trim()).map((word) => (word === 'nullptr' ? null : JSON.parse(word)));
  assert.deepEqual(names.modes, table);
});

test('failsafes are those of the manual', () => {
  const names = JSON.parse(readFileSync(join(root, 'web/src/source/names.json'), 'utf8'));
  const rows = readFileSync(join(root, 'docs/failsafes.md'), 'utf8').split('\n').filter((line) => line.startsWith('| '))
    .map((line) => line.split('|').map((cell) => cell.trim())).filter((cells) => /^\d+, \d+$/.test(cells[6] ?? '') && cells[3] !== '');
  const begun = new Map(names.failsafes);
  for (const [, cause, , text, , ends] of rows) {
    const words = text.replaceAll('"', '');
    if (cause === 'GPS jump') continue;  // over at once
    assert.ok(begun.has(words), words);
    if (ends) assert.equal(begun.get(words), ends.replaceAll('"', ''), words);
  }
  assert.ok(rows.length >= 11);
});
