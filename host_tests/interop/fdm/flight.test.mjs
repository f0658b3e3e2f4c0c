// SPDX-License-Identifier: GPL-3.0-or-later
// Flights whose airplane is in another program, over ArduPilot's JSON SITL protocol: with the
// example program, and with one that is nothing but a socket.
// FLY and PEER name the programs, FLY_BOARD is `native` or `elf`, MINUTES a file for the minutes.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { appendFileSync, mkdirSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test from 'node:test';

const { FLY, PEER, FLY_BOARD, MINUTES } = process.env;
const native = FLY_BOARD === 'native';
// What has nothing to do with the board is tried once, on the quick one.
const onNative = native ? test : () => {};
const out = mkdtempSync(join(tmpdir(), 'fdm-'));

async function bound(port = 0) {
  const socket = createSocket('udp4');
  socket.bind(port, '127.0.0.1');
  await once(socket, 'listening');
  return socket;
}

// A port with a free one above it.
async function freePort() {
  for (;;) {
    const first = await bound();
    const { port } = first.address();
    const second = port < 65534 && (await bound(port + 1).catch(() => null));
    first.close();
    if (!second) continue;
    second.close();
    return port;
  }
}

async function fly(port, ...words) {
  const kind = native ? ['--native'] : [];
  const child = spawn(FLY, [...kind, '--fdm', `json:${port}`, '--out', out, ...words]);
  let said = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => { said += text; });
  const [status] = await once(child, 'close');
  return { status, said };
}

async function withPeer(words, run) {
  const peer = spawn(PEER, words, { stdio: ['ignore', 'pipe', 'inherit'] });
  await once(peer.stdout, 'data');
  try {
    return await run();
  } finally {
    peer.kill();
  }
}

const summary = () => JSON.parse(readFileSync(join(out, 'summary.json')));

function count(minutes) {
  if (native) return;
  mkdirSync(dirname(MINUTES), { recursive: true });
  appendFileSync(MINUTES, `${minutes}\n`);
}

onNative('the whole mission is flown in another program\'s airplane', async () => {
  const port = await freePort();
  const run = await withPeer([`${port}`], () => fly(port));
  assert.equal(run.status, 0, run.said);
  const flown = summary();
  assert.ok(flown.crosstrack_rms_m < 3 && flown.altitude_rms_m < 2, run.said);
});

test('it takes off', async () => {
  const port = await freePort();
  const run = await withPeer([`${port}`], () => fly(port, '--time-limit', '28'));
  const flown = summary();
  count(flown.emulated_s / 60);
  assert.match(run.said, /time limit reached/);
  assert.ok(flown.events.some((event) => event.text === 'airborne'), run.said);
  const bootloader_s = native ? 0 : 1.2;
  assert.ok(flown.frames >= (28 - bootloader_s) * 100 - 20, `${flown.frames} frames`);
});

onNative('a thrown wing flies too, on its own parameters', async () => {
  const port = await freePort();
  const run = await withPeer([`${port}`, 'flying_wing'],
    () => fly(port, '--airplane', 'flying_wing', '--time-limit', '60'));
  assert.ok(summary().events.some((event) => event.text === 'airborne'), run.said);
  assert.ok(summary().items_reached.includes(1), run.said);
});

test('packets are counted, one for an answer, and the answer\'s time is the board\'s', async () => {
  const port = await freePort();
  const model = await bound(port);
  const packets = [];
  let late = 0;
  model.on('message', (bytes, from) => {
    packets.push(bytes);
    const time_s = 7 + packets.length * 0.005;  // its own step, twice what is proposed
    if (packets.length === 100) late = 1;        // one answer that says nothing new
    const text = JSON.stringify({ timestamp: time_s - late * 0.005,
      imu: { gyro: [0, 0, 0], accel_body: [0, 0, -9.80665] }, position: [0, 0, 0],
      quaternion: [1, 0, 0, 0], velocity: [0, 0, 0], rc: { rc_1: 1600 } });
    model.send(`\n${text}\n`, from.port, from.address);
  });
  const run = await fly(port, '--time-limit', '4');
  model.close();
  count(4 / 60);
  assert.match(run.said, /time limit reached/);
  const due = 4 / 0.005;
  assert.ok(Math.abs(packets.length - due) < 10, `${packets.length} packets, ${due} due`);
  packets.forEach((packet, i) => {
    assert.equal(packet.length, 40);
    assert.equal(packet.readUInt16LE(0), 18458);
    assert.equal(packet.readUInt16LE(2), 400);
    assert.equal(packet.readUInt32LE(4), i + 1);
  });
  const pulses = Array.from({ length: 16 }, (_, i) => packets.at(-1).readUInt16LE(8 + 2 * i));
  assert.ok(pulses.slice(0, 8).every((us) => us >= 900 && us <= 2100), `${pulses}`);
  assert.ok(pulses.slice(8).every((us) => us === 0), `${pulses}`);
  assert.notEqual(pulses[0], 1500);  // the model's transmitter moves the aileron
});

onNative('a model that was begun anew goes on', async () => {
  const port = await freePort();
  const model = await bound(port);
  let answers = 0;
  model.on('message', (bytes, from) => {
    ++answers;
    const time_s = (answers > 400 ? 0 : 5000) + answers * 0.0025;
    model.send(`{"timestamp":${time_s},"imu":{"gyro":[0,0,0],"accel_body":[0,0,-9.8]},` +
      '"position":[0,0,0],"attitude":[0,0,0],"velocity":[0,0,0]}', from.port, from.address);
  });
  const run = await fly(port, '--time-limit', '3');
  model.close();
  assert.match(run.said, /time limit reached/);
  assert.match(run.said, /flight model +begun anew 1 times in flight/);
  assert.ok(Math.abs(answers - 1200) < 20, `${answers} answers`);
});

const state = (time_s) => `{"timestamp":${time_s},"imu":{"gyro":[0,0,0],"accel_body":[0,0,-9.8]},` +
  '"position":[0,0,0],"attitude":[0,0,0],"velocity":[0,0,0]}';

for (const [what, time_s, says] of [
  ['goes back', (answer) => 100 - answer * 0.0025, /its timestamp goes back by 0\.0025 s with every answer; expected up to 1 s on/],
  ['counts milliseconds', (answer) => answer * 2.5, /its timestamp goes on by 2\.5 s with every answer; expected up to 1 s on/],
  ['stands still', () => 7, /its timestamp stands still/]])
  onNative(`a model whose time ${what} ends the flight with its reason`, async () => {
    const port = await freePort();
    const model = await bound(port);
    let answers = 0;
    model.on('message', (bytes, from) => model.send(state(time_s(++answers)), from.port, from.address));
    const run = await fly(port, '--time-limit', '3');
    model.close();
    assert.equal(run.status, 1);
    assert.match(run.said, says);
  });

// It takes one question after the other, and each is a step to it.
onNative('a slow model is not asked faster than it answers', async () => {
  const port = await freePort();
  const model = await bound(port);
  const kSlow_ms = 1300, kSlowAnswers = 5;
  let asked = 0, answers = 0, queue = Promise.resolve();
  model.on('message', (bytes, from) => {
    ++asked;
    queue = queue.then(async () => {
      if (answers < kSlowAnswers) await new Promise((resolve) => setTimeout(resolve, kSlow_ms));
      ++answers;
      model.send(state(answers * 0.0025), from.port, from.address);
    });
  });
  const run = await fly(port, '--time-limit', '1');
  model.close();
  assert.match(run.said, /the flight model at \d+ is slow: no answer for 1000 ms/);
  assert.equal(run.said.match(/is slow/g).length, 1);
  assert.match(run.said, /time limit reached/);
  assert.ok(asked <= 400 + 3, `${asked} questions`);
});

test('a port that is taken is named', async () => {
  const port = await freePort();
  const taken = await bound(port + 1);
  const run = await fly(port);
  taken.close();
  assert.equal(run.status, 2);
  assert.equal(run.said, `fly: UDP port ${port + 1}: Address already in use\n`);
});

test('a model that is not there is waited for, and then reported', async () => {
  const port = await freePort();
  const run = await fly(port, '--fdm-wait', '1');
  assert.equal(run.status, 1);
  assert.match(run.said, new RegExp(`waiting for the flight model at ${port}`));
  assert.match(run.said, new RegExp(`not completed: the flight model at ${port}: no answer for 1 s`));
});

test('a model that falls silent or talks nonsense ends the flight with its reason', async () => {
  const words = { '-': /no answer for 10 s/, rubbish: /1000 answers that make no sense: expected a JSON object, found 'rubbish'/,
    '{"timestamp":"x"}': /answers that make no sense: timestamp: expected a number/ };
  for (const [word, says] of Object.entries(words)) {
    if (!native && word === '-') continue;
    const port = await freePort();
    const run = await withPeer([`${port}`, 'foam_trainer', word, '400'], () => fly(port));
    assert.equal(run.status, 1, run.said);
    assert.match(run.said, says);
    count(1 / 60);
  }
});

test('a model that starts later is waited for', async () => {
  const port = await freePort();
  const flight = fly(port, '--time-limit', '1', '--fdm-wait', '60');
  await new Promise((resolve) => setTimeout(resolve, 1500));
  const model = await bound(port);
  let time_s = 3;
  model.on('message', (bytes, from) => model.send(state(time_s += 0.0025), from.port, from.address));
  const run = await flight;
  model.close();
  count(1 / 60);
  assert.match(run.said, /waiting for the flight model/);
  assert.match(run.said, /time limit reached/);
});

onNative('a model that is stopped and started again goes on', async () => {
  const port = await freePort();
  let model = await bound(port);
  const answer = (bytes, from) => {
    if (++answers !== 300) return model.send(state(answers * 0.0025), from.port, from.address);
    model.close();  // this question gets no answer, and the next ones are refused
    setTimeout(async () => {
      model = await bound(port);
      model.on('message', answer);
    }, 1200);
  };
  let answers = 0;
  model.on('message', answer);
  const run = await fly(port, '--time-limit', '3');
  model.close();
  assert.match(run.said, /time limit reached/);
  assert.ok(answers > 1100, `${answers} answers`);
});

test('answers that make no sense are skipped, counted, and asked for again', async () => {
  const port = await freePort();
  const model = await bound(port);
  const nonsense = ['', 'rubbish', state(9).replace('[0,0,0]', '[NaN,0,0]'),
    state(9).replace('-9.8', '1e999'), state(9).replace('-9.8', '1e300'), '\u0000\u0001\u0002'];
  let asked = 0, time_s = 0;
  const numbers = [];
  model.on('message', (bytes, from) => {
    numbers.push(bytes.readUInt32LE(4));
    const text = ++asked % 20 === 0 && nonsense.length > 0 ? nonsense.pop() : state(time_s += 0.0025);
    model.send(text, from.port, from.address);
  });
  const run = await fly(port, '--time-limit', '1');
  model.close();
  count(1 / 60);
  assert.match(run.said, /time limit reached/);
  assert.match(run.said, /flight model +6 answers skipped: not understood/);
  assert.equal(summary().model_answers_skipped, 6);
  assert.deepEqual(numbers, numbers.map((_, i) => i + 1));  // asked again under a new number
});

onNative('a signal ends the wait for a model', async () => {
  const port = await freePort();
  const child = spawn(FLY, ['--native', '--fdm', `json:${port}`, '--fdm-wait', '10000', '--out', out]);
  let said = '';
  child.stdout.on('data', (text) => {
    said += text;
    if (/waiting for/.test(said)) child.kill('SIGTERM');
  });
  const [status, signal] = await once(child, 'close');
  assert.equal(signal, null);
  assert.equal(status, 1);
});

onNative('a server stops with the reason too', async () => {
  const port = await freePort();
  const run = await withPeer([`${port}`, 'foam_trainer', 'rubbish', '100'],
    () => fly(port, '--lock-step', '--listen', '0').then((r) => r));
  assert.match(run.said, /leave out --out/);
  const child = spawn(FLY, ['--native', '--fdm', `json:${port}`, '--serve', '--listen', '0', '--out', out]);
  let said = '';
  child.stderr.on('data', (text) => { said += text; });
  await withPeer([`${port}`, 'foam_trainer', 'rubbish', '100'], async () => {
    const [status] = await once(child, 'close');
    assert.equal(status, 1);
    assert.match(said, /fly: the flight model at \d+: 1000 answers that make no sense: expected a JSON object/);
  });
});
