// SPDX-License-Identifier: GPL-3.0-or-later
// The live page's server with a flight behind it, natively compiled and, shorter, as the image.
// MINUTES is a file for the emulated minutes.
import assert from 'node:assert/strict';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { appendFileSync, mkdirSync, readFileSync } from 'node:fs';
import { connect } from 'node:net';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { embedded } from '../../support/flight_document.mjs';
import { messages, nodeMavlink } from '../../support/node_mavlink.mjs';
import { Stream, withServed } from './served.mjs';

const { FLY_BOARD, MINUTES } = process.env;
const native = FLY_BOARD === 'native';
const onNative = native ? test : () => {};

const kHome = { lat: 47.3977, lon: 8.5456 };
const metresFrom = ({ lat_deg, lon_deg }, { lat, lon }) =>
  Math.hypot((lat_deg - lat) * 111_200, (lon_deg - lon) * 111_200 * Math.cos(lat * Math.PI / 180));

function count(time_s) {
  if (native) return;
  mkdirSync(dirname(MINUTES), { recursive: true });
  appendFileSync(MINUTES, `${time_s / 60}\n`);
}

onNative('a flight by the page: arm, take off, fly to here, fail, pause, end', withServed(async (served) => {
  const { stream } = served;
  const flight = await stream.until('flight');
  assert.deepEqual([flight.format, flight.version, flight.kind], ['apm-flight', 1, 'live']);
  assert.equal(flight.provenance.native, true);
  assert.ok(flight.offers.faults.includes('gps:lost') && flight.offers.modes.includes('GUIDED'));
  await stream.until('samples');
  const declared = flight.series.map(({ name, kind }) => (kind === 'truth' ? name : `${name}:${kind}`)).sort();
  assert.deepEqual(Object.keys(stream.last.values).sort(), declared);

  // before it is ready the autopilot's own words come back
  await stream.until('status', ({ mode }) => mode !== 'unknown');
  const early = await served.do({ do: 'arm' });
  assert.equal(early.ok, false);
  assert.match(early.text, /^FAILED: .*PreArm/);
  assert.deepEqual(await served.do({ do: 'takeoff' }), { status: 200, ok: false, text: 'not armed' });

  await served.must({ do: 'speed', times: 20 });
  await served.armWhenReady();
  await stream.until('status', ({ armed }) => armed);
  await stream.until('event', ({ kind, text }) => kind === 'armed' && text === 'armed');
  await served.must({ do: 'mode', mode: 'FBWA' });
  await stream.until('status', ({ mode }) => mode === 'FBWA');
  await served.must({ do: 'takeoff' });
  await stream.until('status', ({ mode }) => mode === 'AUTO');
  // the mission it was given is drawn as the board holds it
  const planned = await stream.until('flight', ({ plan }) => plan.items.length === 3);
  assert.deepEqual(planned.plan.items.map(({ name }) => name), ['HOME', 'TAKEOFF', 'LOITER_UNLIM']);
  assert.ok(metresFrom(planned.plan.home, kHome) < 20);
  await stream.until('samples', ({ values }) => values.height_m > 40, 'a height of 40 m');

  const place = { lat: kHome.lat + 0.0027, lon: kHome.lon };
  await served.must({ do: 'goto', lat_deg: place.lat, lon_deg: place.lon, altitude_m: 80 });
  await stream.until('status', ({ mode }) => mode === 'GUIDED');
  await stream.until('samples', ({ values }) => metresFrom(values, place) < 90 && values.height_m > 70, 'the place');

  await served.must({ do: 'fault', name: 'gps_lost', on: true });
  await stream.until('band', ({ kind, name }) => kind === 'fault' && name === 'gps:lost');
  const failsafe = await stream.until('band', ({ kind }) => kind === 'failsafe');
  assert.equal(failsafe.name, 'GPS lost: dead reckoning');
  await stream.until('event', ({ kind, text }) => kind === 'failsafe' && /^GPS lost/.test(text));
  await served.must({ do: 'fault', name: 'gps_lost', on: false });
  await stream.until('band', ({ kind, to_s }) => kind === 'fault' && to_s > 0);
  await stream.until('band', ({ kind, to_s }) => kind === 'failsafe' && to_s > failsafe.from_s);

  await served.must({ do: 'wind', speed_mps: 6, from_deg: 270 });
  await stream.until('event', ({ text }) => text === 'wind 6 m/s from 270 deg');
  await stream.until('samples', ({ values }) =>
    Math.abs(values.wind_mps - 6) < 0.1 && Math.abs(values.wind_from_deg - 270) < 1);

  // paused nothing goes on, for as long as wanted
  await served.must({ do: 'pause' });
  await stream.until('status', ({ paused }) => paused);
  const stood_s = stream.last.time_s;
  await new Promise((resolve) => { setTimeout(resolve, 400); });
  assert.ok(stream.last.time_s - stood_s < 0.15, 'it went on');
  assert.match((await served.do({ do: 'mode', mode: 'RTL' })).text, /^paused/);
  await served.must({ do: 'resume' });
  await served.must({ do: 'speed', times: 2 });
  await stream.until('status', ({ speed, times }) => times === 2 && speed > 0 && speed < 2.5);
  await served.must({ do: 'speed', times: 'max' });
  await stream.until('samples', ({ time_s }) => time_s > stood_s + 30);
  await stream.until('status', ({ speed, times }) => times === 'max' && speed > 4, 'a speed that is not held to any multiple');
  await served.must({ do: 'speed', times: 5 });
  await stream.until('status', ({ times }) => times === 5);
  await served.must({ do: 'mode', mode: 'RTL' });
  await stream.until('status', ({ mode }) => mode === 'RTL');

  // the sticks are the receiver's
  await served.must({ do: 'sticks', roll: 0.5, pitch: 0, throttle: 0.25, yaw: 0 });
  await stream.until('samples', ({ values }) =>
    values['rc1_us:measured'] === 1700 && values['rc3_us:measured'] === 1300);

  assert.equal(await served.stop(), 0, served.said);
  assert.match(served.said, /client|page looks on/);
  for (const line of [/ s {2}armed$/m, / s {2}mode GUIDED$/m, / s {2}GPS lost: dead reckoning$/m, / s {2}gps:lost$/m])
    assert.match(served.said, line);
  const summary = JSON.parse(readFileSync(join(served.out, 'summary.json')));
  assert.equal(summary.mission, 'served');
  assert.equal(summary.reason, 'served flight: ended in the air');
  assert.ok(summary.flight_time_s > 30, `${summary.flight_time_s} s in the air`);
  const happened = summary.events.map(({ text }) => text);
  for (const text of ['armed', 'gps:lost', 'gps:lost is over', 'wind 6 m/s from 270 deg', 'mode GUIDED'])
    assert.ok(happened.includes(text), `${text} is not in ${happened}`);
  const rows = readFileSync(join(served.out, 'flight.csv'), 'utf8').trim().split('\n');
  assert.ok(rows.length > 400, `${rows.length} rows`);
  assert.match(readFileSync(join(served.out, 'report.html'), 'utf8'), /served flight: ended in the air/);
}));

test('it arms, changes its mode and is flown by ground stations beside the page', withServed(async (served) => {
  const { stream } = served;
  const station = connect(served.telemetry, '127.0.0.1');
  await once(station, 'data');
  await stream.until('status', ({ clients }) => clients === 1);
  await served.must({ do: 'speed', times: 'max' });
  await served.armWhenReady();
  await served.must({ do: 'mode', mode: 'LOITER' });
  await stream.until('status', ({ armed, mode }) => armed && mode === 'LOITER');
  await served.must({ do: 'disarm' });
  await stream.until('status', ({ armed }) => !armed);
  stream.got.status.length = 0;
  station.destroy();
  await stream.until('status', ({ clients }) => clients === 0);
  count(stream.last.time_s);
  assert.equal(await served.stop(), 0, served.said);
  assert.match(served.said, /client connected[^]*armed[^]*mode LOITER[^]*disarmed[^]*client disconnected/);
}));

// PARAM_SET of MAVLink 1, in node-mavlink's words.
function parameterSet(name, value) {
  const message = Object.assign(new messages.PARAM_SET(), { targetSystem: 1, targetComponent: 1, paramId: name, paramValue: value, paramType: 9 });
  return new nodeMavlink.MavLinkProtocolV1(255, 190).serialize(message, 0);
}

onNative('what was set and injected on the way is in the provenance of the flight', withServed(async (served) => {
  const { stream } = served;
  const station = connect(served.telemetry, '127.0.0.1');
  await once(station, 'data');
  await stream.until('status', ({ mode }) => mode !== 'unknown');
  station.write(parameterSet('WP_RADIUS', 44.7));
  station.write(parameterSet('TRIM_ARSPD_CM', 1310));
  station.write(parameterSet('NO_SUCH_THING', 7));
  await served.must({ do: 'fault', name: 'compass:lost', on: true });
  await stream.until('band', ({ kind, name }) => kind === 'fault' && name === 'compass:lost');
  const { time_s } = stream.last;
  await stream.until('samples', (sample) => sample.time_s > time_s + 1);
  await served.must({ do: 'fault', name: 'compass:lost', on: false });
  await stream.until('band', ({ kind, to_s }) => kind === 'fault' && to_s > 0);
  assert.equal(await served.stop(), 0, served.said);
  const { provenance } = JSON.parse(readFileSync(join(served.out, 'summary.json')));
  assert.deepEqual(provenance.parameters, { TRIM_ARSPD_CM: 1310, WP_RADIUS: 45 });
  assert.match(provenance.faults.join(), /^compass:lost@[\d.]+-[\d.]+$/);
  const { bands, events } = embedded(join(served.out, 'report.html'));
  const [band] = bands.filter(({ kind }) => kind === 'fault');
  assert.ok(band.name === 'compass:lost' && band.to_s > band.from_s + 0.9, JSON.stringify(band));
  assert.deepEqual(events.filter(({ kind }) => kind === 'fault').map(({ text }) => text),
    ['fault injected: compass:lost', 'compass:lost is over']);
}));

onNative('two pages look on and see the same', withServed(async (served) => {
  const second = new Stream(served.port);
  for (const stream of [served.stream, second]) await stream.until('samples', ({ time_s }) => time_s > 2.5);
  const [a, b] = [served.stream, second].map(({ got }) => new Map(got.samples.map((each) => [each.time_s, each])));
  const shared = [...a.keys()].filter((time_s) => b.has(time_s));
  assert.ok(shared.length > 5, `${shared}`);
  for (const time_s of shared) assert.deepEqual(a.get(time_s), b.get(time_s));
  const times = served.stream.got.samples.map(({ time_s }) => time_s);
  assert.deepEqual(times, [...times].sort((x, y) => x - y));
  second.close();
  await served.says(/2 pages look on[^]*1 page looks on/);
  assert.equal(await served.stop(), 0, served.said);
}));

onNative('nobody else is served, and nonsense has an answer', withServed(async (served) => {
  const local = { Host: `127.0.0.1:${served.port}`, 'Content-Type': 'application/json' };
  const status = async (path, options) => (await served.ask(path, options)).status;
  const post = (headers, body = '{"do":"arm"}') =>
    status('/command', { method: 'POST', headers: { ...local, ...headers }, body });
  const page = await served.ask('/');
  assert.equal(page.status, 200);
  assert.match(page.text, /<meta name="source" content="live">/);
  assert.equal(await status('/', { headers: { Host: `localhost:${served.port}` } }), 200);
  assert.equal(await status('/', { headers: { Host: 'evil.example' } }), 403);
  assert.equal(await status('/live', { headers: { Host: `evil.example:${served.port}` } }), 403);
  assert.equal(await post({ Origin: 'http://evil.example' }), 403);
  assert.equal(await post({ Origin: 'null' }), 403);
  assert.equal(await post({ Origin: `http://127.0.0.1:${served.port}` }), 200);
  assert.equal(await post({ 'Content-Type': 'text/plain' }), 415);
  assert.equal(await status('/etc/passwd'), 404);
  assert.equal(await status('/command'), 405);
  assert.equal(await status('/', { method: 'DELETE' }), 405);
  for (const body of ['', '{', '[]', '{"do":"explode"}', '{"do":"mode","mode":"WARP"}',
    '{"do":"fault","name":"x","on":true}',
    '{"do":"goto","lat_deg":"north"}', '{"do":"wind","speed_mps":99,"from_deg":0}', '['.repeat(9000)]) {
    const answer = await served.post(body);
    assert.equal(answer.status, 400, body.slice(0, 60));
    assert.equal(answer.ok, false);
    assert.ok(answer.text.length > 5);
  }
  assert.equal(await post({}, 'x'.repeat(20_000)), 413);
  assert.match(await served.raw('\x16\x03\x01garbage'), /^HTTP\/1\.1 400 /);
  assert.match(await served.raw('GET / HTTP/1.1\r\n\r\n'.replace('GET', 'GET ')), /^HTTP\/1\.1 400 /);
  assert.match(await served.raw(`GET / HTTP/1.1\r\nx: ${'y'.repeat(20_000)}`), /^HTTP\/1\.1 431 /);

  // half a request, and one who reads nothing, hold nobody up
  const half = connect(served.port, '127.0.0.1');
  half.write('POST /command HTTP/1.1\r\nContent-Le');
  const deaf = connect(served.port, '127.0.0.1');
  deaf.pause().write(`GET /live HTTP/1.1\r\nHost: 127.0.0.1:${served.port}\r\n\r\n`);
  await served.must({ do: 'speed', times: 'max' });
  const { time_s } = await served.stream.until('samples');
  await served.stream.until('samples', (sample) => sample.time_s > time_s + 100);
  for (const socket of [half, deaf]) socket.destroy();
  assert.equal(await served.stop(), 0, served.said);
}));

onNative('it ends with its last ground station, when that was asked for', withServed(async (served) => {
  const station = connect(served.telemetry, '127.0.0.1');
  await once(station, 'data');
  await served.stream.until('status', ({ clients }) => clients === 1);
  station.destroy();
  assert.equal(await served.gone, 0, served.said);
  assert.match(served.said, /client disconnected/);
  await served.stream.until('status', ({ ended }) => /ended on the ground/.test(ended ?? ''));
}, ['--serve', '--listen', '0', '--end-with-client']));

onNative('a mission that is watched goes at real time, or as fast as it can', withServed(async (served) => {
  const { stream } = served;
  const flight = await stream.until('flight');
  assert.equal(flight.title, 'first_flight.waypoints, live');
  await stream.until('samples', ({ time_s }) => time_s > 1);
  await stream.until('status', ({ speed }) => speed > 0.7 && speed < 1.3);
  await served.must({ do: 'speed', times: 'max' });
  await stream.until('flight', ({ plan }) => plan.items.length > 5, 'the mission on the board');
  await stream.until('event', ({ kind, text }) => kind === 'item' && /reached item 2/.test(text));
  await served.must({ do: 'wind', speed_mps: 3, from_deg: 90 });
  await stream.until('status', ({ ended }) => ended === 'mission completed');
  assert.equal(await served.gone, 0, served.said);
  assert.match(served.said, /mission completed\n/);
  const summary = JSON.parse(readFileSync(join(served.out, 'summary.json')));
  assert.ok(summary.completed && summary.events.some(({ text }) => text === 'wind 3 m/s from 90 deg'));
}, ['--watch', '--http', '0']));

onNative('FlightGear is sent what the airplane does', async () => {
  const view = createSocket('udp4');
  view.bind(0, '127.0.0.1');
  await once(view, 'listening');
  const packets = [];
  view.on('message', (bytes) => packets.push(bytes));
  await withServed(async (served) => {
    const from_s = (await served.stream.until('samples')).time_s;
    packets.length = 0;
    await served.stream.until('samples', ({ time_s }) => time_s > from_s + 3);
    const near = packets.length / (served.stream.last.time_s - from_s);
    assert.ok(near > 25 && near < 35, `${near} packets a second`);
    const { values } = served.stream.last;
    const packet = packets.at(-1);
    assert.equal(packet.length, 408);
    assert.equal(packet.readUInt32BE(0), 24);
    assert.ok(Math.abs(packet.readDoubleBE(8) * 180 / Math.PI - values.lon_deg) < 1e-5);
    assert.ok(Math.abs(packet.readDoubleBE(16) * 180 / Math.PI - values.lat_deg) < 1e-5);
    assert.ok(Math.abs(packet.readDoubleBE(24) - values.altitude_m) < 0.1);
    assert.ok(Math.abs(packet.readFloatBE(40) * 180 / Math.PI - values.pitch_deg) < 0.5);
    assert.equal(await served.stop(), 0, served.said);
  }, ['--serve', '--listen', '0', '--flightgear', `127.0.0.1:${view.address().port}`])();
  view.close();
});
