// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of flights in drawn worlds works out, on flights that are made up.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const { build } = createRequire(join(root, 'web/package.json'))('esbuild');
let folder, logic, page;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'drawn-'));
  const bundled = async (name) => {
    const outfile = join(folder, `${name}.mjs`);
    await build({ entryPoints: [join(root, `web/src/campaign/${name}.ts`)], bundle: true, format: 'esm', outfile, logLevel: 'warning' });
    return import(pathToFileURL(outfile));
  };
  [logic, page] = [await bundled('drawn_document'), await bundled('document')];
});
after(() => rmSync(folder, { recursive: true }));

const kTrack = { figure: 'crosstrack_rms_m', name: 'Crosstrack', unit: 'm', limit: 2 };
const kLanding = { figure: 'landed_distance_m', name: 'Touch-down', unit: 'm', limit: 30 };
const kYaw = { figure: 'yaw_error_rms_deg', name: 'Yaw', unit: '°', limit: 1.5 };
const kGoals = [kYaw, kTrack, kLanding];

const flight = (seed, figures, more = {}) => ({ seed, command: `toolchain/campaign --drawn ${seed}-${seed}`, completed: !more.failure, met_all: false, figures, world: {}, ...more });
const of = (flights, drawn = []) => ({ kind: 'drawn', goals: kGoals, flights, drawn });

test('a document of another version is refused', () => {
  assert.throws(() => page.parse('{"format":"apm-campaign","version":1}'), /no campaign/);
  assert.equal(page.parse('{"format":"apm-campaign","version":2,"kind":"drawn"}').kind, 'drawn');
});

test('the landing comes first, what the autopilot knows of itself last', () => {
  assert.deepEqual(page.inOrder(kGoals).map(({ name }) => name), ['Touch-down', 'Crosstrack', 'Yaw']);
  assert.equal(kGoals[0], kYaw, 'the document is left as it is');
});

test('a share is of all flights, also of those that do not have the figure', () => {
  const share = logic.shareOf([flight(1, { crosstrack_rms_m: 1 }), flight(2, { crosstrack_rms_m: 2 }), flight(3, { crosstrack_rms_m: 9 }), flight(4, {})], kTrack);
  assert.deepEqual([share.met, share.flights, share.median, share.worst, share.worst_seed], [2, 4, 2, 9, 3]);
  const none = logic.shareOf([flight(4, {})], kTrack);
  assert.deepEqual([none.met, none.worst_seed], [0, undefined]);
  assert.ok(Number.isNaN(none.worst));
});

test('the worst flights come with the figure that misses its limit by most; failed ones and good ones are not among them', () => {
  const good = { crosstrack_rms_m: 1, landed_distance_m: 3, yaw_error_rms_deg: 1 };
  const all = logic.misses(of([
    flight(1, { ...good, crosstrack_rms_m: 3 }), flight(2, { ...good, landed_distance_m: 90, crosstrack_rms_m: 4 }), flight(3, good, { met_all: true }),
    flight(4, { ...good, yaw_error_rms_deg: 90 }, { failure: 'crashed' }), flight(5, { crosstrack_rms_m: 1, landed_distance_m: 3 })]));
  assert.deepEqual(all.map(({ flight: { seed }, limit, times }) => [seed, limit.name, times]), [[5, 'Yaw', Infinity], [2, 'Touch-down', 3], [1, 'Crosstrack', 1.5]]);
});

test('failures are gathered by their reasons, the most frequent first', () => {
  const reasons = logic.failuresOf([
    flight(1, {}, { failure: 'crashed after item 3' }), flight(2, {}), flight(3, {}, { failure: 'it touched down 97 m from the landing point, more than 60 m' }),
    flight(4, {}, { failure: 'crashed after item 14' }), flight(5, {}, { failure: 'it touched down 165 m from the landing point, more than 60 m' }),
    flight(6, {}, { failure: 'drawn: AUTOTUNE: the airplane crashed' }), flight(7, {}, { failure: 'crashed after item 14' }),
    flight(8, {}, { failure: 'the airplane did not leave the ground within 60 s; it said: Mission item 1' }),
    flight(9, {}, { failure: 'violated: 407.28 s surface_at_its_stop: output 1 has been at 1900 us' })]);
  assert.deepEqual(reasons.map(({ reason, flights }) => [reason, flights.map(({ seed }) => seed)]), [
    ['crashed after item …', [1, 4, 7]], ['it touched down … m from the landing point, more than 60 m', [3, 5]], ['AUTOTUNE: the airplane crashed', [6]],
    ['the airplane did not leave the ground within 60 s', [8]], ['violated: surface_at_its_stop', [9]]]);
});

test('what it depends on is found, in thirds, and comes before what it does not depend on', () => {
  const flights = Array.from({ length: 30 }, (_, i) => flight(i, {}, { met_all: i % 30 < 10, world: { wind_mps: i / 3, mass_kg: (i * 7) % 30, thrown: i % 2 } }));
  const drawn = [['thrown', ''], ['mass_kg', 'kg'], ['wind_mps', 'm/s'], ['missing', '']].map(([key, unit]) => ({ key, name: key, unit }));
  const found = logic.dependences(of(flights, drawn), ({ met_all }) => met_all);
  assert.equal(found[0].drawn.key, 'wind_mps');
  assert.deepEqual(found[0].parts.map(({ met, flights: all }) => [met, all]), [[10, 10], [0, 10], [0, 10]]);
  assert.deepEqual([found[0].parts[0].from, found[0].parts[2].to], [0, 29 / 3]);
  const thrown = found.find(({ drawn: { key } }) => key === 'thrown');
  assert.deepEqual(thrown.parts, [{ from: 0, to: 0, met: 5, flights: 15 }, { from: 1, to: 1, met: 5, flights: 15 }], 'of two values two parts');
  assert.deepEqual(found.find(({ drawn: { key } }) => key === 'missing').parts, []);
});

test('a single flight, and one whose world is unknown, are worked out too', () => {
  const one = of([flight(7, {}, { failure: 'crashed' })], [{ key: 'mass_kg', name: 'mass', unit: 'kg' }]);
  assert.deepEqual(logic.misses(one), []);
  assert.deepEqual(logic.dependences(one, () => true)[0].parts, []);
});
