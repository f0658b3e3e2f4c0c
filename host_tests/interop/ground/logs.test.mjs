// SPDX-License-Identifier: GPL-3.0-or-later
// Flight logs as ground stations get them: list, download, gaps asked for again, erase. Over USB.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { named, readLog } from '../../support/bin.mjs';
import { upload, wholePlan } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kTelemetry = 0, kUsb = 1, kArm = 400, kForce = 21196, kAll = 0xffffffff, kChunk = 90;

async function list(vehicle) {
  vehicle.send('LOG_REQUEST_LIST', { start: 0, end: 0xffff });
  const entries = [];
  for (;;) {
    const entry = await vehicle.expect('LOG_ENTRY', { within_ms: 3000 });
    if (entry.numLogs === 0) return entries;
    entries.push(entry);
    if (entry.id === entry.lastLogNum) return entries;
  }
}

// MAVProxy's way: all of it, until a part that is not full.
async function download(vehicle, { id, size }) {
  vehicle.send('LOG_REQUEST_DATA', { id, ofs: 0, count: kAll });
  const bytes = Buffer.alloc(size);
  for (let got = 0;;) {
    const part = await vehicle.expect('LOG_DATA', { within_ms: 3000 });
    assert.equal(part.id, id);
    assert.equal(part.ofs, got, 'nothing is left out and nothing twice');
    Buffer.from(part.data.slice(0, part.count)).copy(bytes, part.ofs);
    got += part.count;
    if (part.count < kChunk) {
      assert.equal(got, size, 'the size in the list');
      return bytes;
    }
  }
}

// A frame of MAVLink 1 has 97 bytes and 8 around them.
function assertUsesLine(size, took_ms, rate_kbaud) {
  const line_ms = (size / kChunk) * (97 + 8) * 10 / rate_kbaud;
  console.log(`${size} bytes in ${took_ms} ms; the line alone takes ${Math.round(line_ms)}`);
  assert.ok(took_ms < line_ms / 0.95, `${took_ms} ms`);
}

async function makeLog(vehicle, time_ms) {
  assert.equal(await vehicle.command(kArm, [1, kForce]), 0);
  await vehicle.wait(time_ms);
  assert.equal(await vehicle.command(kArm, [0, kForce]), 0);
  await vehicle.wait(300);
}

test('a board that has never flown has no logs', withVehicle({ line: kUsb }, async (vehicle) => {
  assert.deepEqual(await list(vehicle), []);
  vehicle.send('LOG_REQUEST_DATA', { id: 1, ofs: 0, count: kAll });
  assert.equal((await vehicle.expect('LOG_DATA')).count, 0);
}));

test('a log is downloaded at the speed of the line beside heartbeats, whole and without a late frame',
  withVehicle({ line: kUsb }, async (vehicle) => {
    await vehicle.wait(4000);
    await makeLog(vehicle, 12_000);
    const entries = await list(vehicle);
    assert.deepEqual(entries.map(({ id }) => id), [1]);
    const kBegan_s = Date.UTC(2024, 5, 3, 10) / 1000;  // the simulator's beginning of time
    assert.ok(Math.abs(entries[0].timeUtc - kBegan_s - 4) < 3, `begun ${entries[0].timeUtc - kBegan_s} s after start`);
    vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 10, reqMessageRate: 8, startStop: 1 });
    await vehicle.wait(1000);
    vehicle.forget();
    const began_ms = vehicle.now_ms;
    const bytes = await download(vehicle, entries[0]);
    const took_ms = vehicle.now_ms - began_ms;
    assertUsesLine(bytes.length, took_ms, 115.2);
    const attitudes = vehicle.line.inbox.filter(({ name }) => name === 'ATTITUDE').length;
    assert.ok(Math.abs(attitudes - 2 * took_ms / 1000) < 3, `${attitudes} ATTITUDE of 8 Hz, a quarter of which is left`);
    const beats = vehicle.line.inbox.filter(({ name }) => name === 'HEARTBEAT').length;
    assert.ok(beats >= Math.floor(took_ms / 1000) - 1, `${beats} heartbeats in ${took_ms} ms`);

    const records = readLog(bytes);
    assert.equal(records[0].name, 'FMT');
    assert.equal(records[0].Name, 'FMT');
    for (const name of ['PARM', 'MODE', 'MSG', 'ATT', 'GPS', 'CTUN', 'NTUN', 'IMU', 'MAG', 'BARO', 'BAT', 'POWR', 'POS', 'RCIN', 'RCOU', 'PM', 'EV'])
      assert.ok(named(records, name).length > 0, name);
    const times = records.filter(({ TimeUS }) => TimeUS !== undefined).map(({ TimeUS }) => TimeUS);
    assert.ok(times.every((time, i) => i === 0 || time >= times[i - 1]), 'in the order of time');
    const att = named(records, 'ATT');
    assert.ok(Math.abs(att.length - 120) < 15, `${att.length} ATT in 12 s`);
    assert.ok(named(records, 'MSG').some(({ Message }) => Message.includes('Plane')));
    assert.deepEqual(named(records, 'EV').map(({ Id }) => Id), [10, 11], 'armed, disarmed');
    assert.equal(named(records, 'PM').at(-1).LogDrop, 0, 'no record was lost');
    vehicle.send('LOG_REQUEST_END', {});
    vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 2, reqMessageRate: 2, startStop: 1 });
    assert.equal((await vehicle.expect('SYS_STATUS', { within_ms: 2000 })).errorsCount2, 0, 'late frames');
  }));

test('the telemetry line is used as well beside a stream', withVehicle({ line: kUsb }, async (vehicle) => {
  await vehicle.wait(4000);
  await makeLog(vehicle, 3500);
  vehicle.line = vehicle.lines[kTelemetry];
  const [entry] = await list(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 10, reqMessageRate: 4, startStop: 1 });
  await vehicle.wait(500);
  const began_ms = vehicle.now_ms;
  const bytes = await download(vehicle, entry);
  assertUsesLine(bytes.length, vehicle.now_ms - began_ms, 57.6);
}));

test('the log has the ids of what is stored, again when a list becomes another one',
  withVehicle({ line: kUsb }, async (vehicle) => {
    vehicle.line.version = 2;
    await vehicle.wait(4000);
    assert.equal(await vehicle.command(kArm, [1, kForce]), 0);
    await vehicle.wait(3000);
    assert.equal(await upload(vehicle, wholePlan), 0);
    vehicle.send('MISSION_REQUEST_LIST', { missionType: 0 });
    const { opaqueId } = await vehicle.expect('MISSION_COUNT');
    assert.notEqual(opaqueId, 0);
    assert.equal(await upload(vehicle, [], 0), 0);
    await vehicle.wait(1000);
    assert.equal(await vehicle.command(kArm, [0, kForce]), 0);
    await vehicle.wait(300);
    const [entry] = await list(vehicle);
    const lists = named(readLog(await download(vehicle, entry)), 'LIST');
    assert.deepEqual(lists.map(({ Mission, Fence, Rally }) => [Mission, Fence, Rally]),
      [[0, 0, 0], [opaqueId, 0, 0], [0, 0, 0]]);
  }));

test('parts are had by asking, also past the end; while armed there are none',
  withVehicle({ line: kUsb }, async (vehicle) => {
    await vehicle.wait(4000);
    await makeLog(vehicle, 3000);
    await makeLog(vehicle, 3000);
    const [, entry] = await list(vehicle);
    assert.equal(entry.id, 2);
    const bytes = await download(vehicle, entry);
    for (const [ofs, count, expected] of [[0, 90, 90], [1234, 500, 500], [entry.size - 50, kAll, 50], [entry.size, 90, 0], [entry.size + 1000, 90, 0]]) {
      vehicle.send('LOG_REQUEST_DATA', { id: 2, ofs, count });
      const got = [];
      while (got.length < expected || expected === 0) {
        const part = await vehicle.expect('LOG_DATA');
        assert.equal(part.ofs, ofs + got.length);
        got.push(...part.data.slice(0, part.count));
        if (part.count < kChunk) break;
      }
      assert.deepEqual(Buffer.from(got), bytes.subarray(ofs, ofs + expected), `${count} from ${ofs}`);
      await vehicle.wait(100);
      assert.equal(vehicle.all('LOG_DATA').length, 0, 'and nothing more');
    }
    assert.equal(await vehicle.command(kArm, [1, kForce]), 0);
    vehicle.send('LOG_REQUEST_DATA', { id: 1, ofs: 0, count: kAll });
    assert.equal((await vehicle.expect('LOG_DATA')).count, 0);
    assert.equal((await list(vehicle)).length >= 2, true, 'the list is sent in the air too');
  }));

test('a flood of requests on both lines and an erase do not hurt', withVehicle({ line: kUsb }, async (vehicle) => {
  await vehicle.wait(4000);
  await makeLog(vehicle, 2000);
  for (let i = 0; i < 20; ++i) {
    vehicle.lines[i % 2].send('LOG_REQUEST_DATA', { id: i % 3, ofs: 100 * i, count: kAll });
    vehicle.lines[(i + 1) % 2].send('LOG_REQUEST_LIST', { start: i % 4, end: 7 });
    await vehicle.wait(40);
  }
  vehicle.send('LOG_REQUEST_END', {});
  await vehicle.wait(500);
  vehicle.forget();
  vehicle.send('LOG_ERASE', {});
  assert.equal((await vehicle.expect('STATUSTEXT', { within_ms: 2000 })).text.replace(/\0.*/s, ''), 'Erasing logs');
  await vehicle.wait(200);
  assert.deepEqual(await list(vehicle), [], 'what is being erased is no log any more');
  vehicle.forget();
  await makeLog(vehicle, 1500);
  const entries = await list(vehicle);
  readLog(await download(vehicle, entries.at(-1)));
}));

// A chip full of logs of 500 pages, the newest ending at page `end` of the ring, by the words of
// docs/log.md and not by the firmware's own code.
function fullChip(end) {
  const kPages = 8192, kSize = 528, kFirst = 16, kRing = kPages - kFirst, kUsed = 516;
  const image = Buffer.alloc(kPages * kSize, 0xff);
  for (let place = 0; place < kRing; ++place) {
    const index = place <= end ? place + kRing : place;  // the ring has gone round once
    const page = image.subarray((kFirst + place) * kSize, (kFirst + place + 1) * kSize);
    page.fill(index & 0xff, 12);
    page.writeUInt16LE(1 + Math.floor(index / 500), 0);
    page.writeUInt32LE((index % 500) * kUsed, 2);
    page.writeUInt16LE(kUsed, 6);
    page.writeUInt16LE(crc(page.subarray(12)), 8);
    page.writeUInt16LE(crc(page.subarray(0, 10)), 10);
  }
  return { image, last: 1 + Math.floor((end + kRing) / 500), first: 1 + Math.floor((end + 2) / 500) };
}

// CRC-16/MCRF4XX
function crc(bytes) {
  let sum = 0xffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let i = 0; i < 8; ++i) sum = sum & 1 ? (sum >> 1) ^ 0x8408 : sum >> 1;
  }
  return sum;
}

async function withImage(image, body) {
  const folder = mkdtempSync(join(tmpdir(), 'flight-logs-'));
  try {
    const path = join(folder, 'flash.bin');
    if (image) writeFileSync(path, image);
    await body(['--dataflash', path]);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

for (const end of [0, 4711, 8175])
  test(`a full chip's logs are known at the first heartbeat, and the next goes on at page ${end} of the ring`, async () => {
    const { image, last, first } = fullChip(end);
    await withImage(image, (options) => withVehicle({ line: kUsb, options }, async (vehicle) => {
      const entries = await list(vehicle);
      assert.equal(entries[0].id, first);
      assert.equal(entries[0].numLogs, last - first + 1);
      assert.deepEqual(entries.map(({ id }) => id), Array.from({ length: last - first + 1 }, (_, i) => first + i));
      assert.equal(entries[2].size, 500 * 516, 'of a whole one');
      await vehicle.wait(4000);
      await makeLog(vehicle, 2000);
      const now = await list(vehicle);
      assert.equal(now.at(-1).id, last + 1);
      const records = readLog(await download(vehicle, now.at(-1)));
      assert.equal(named(records, 'PM').at(-1).LogDrop, 0);
    })());
  });

test('logs outlast the power; a bit of LOG_BITMASK has one from the start on', async () => {
  await withImage(null, async (options) => {
    await withVehicle({ line: kUsb, options }, async (vehicle) => {
      await vehicle.wait(4000);
      await makeLog(vehicle, 1000);
      vehicle.send('PARAM_SET', { paramId: 'LOG_BITMASK', paramValue: 16382 + 65536, paramType: 6 });
      await vehicle.wait(3000);
      // the log being written ends while one is read, and the next begins after that
      const [first, second] = await list(vehicle);
      assert.equal(second.id, 2);
      readLog(await download(vehicle, first));
      await vehicle.wait(1000);
      const ended = await list(vehicle);
      await vehicle.wait(1000);
      assert.deepEqual(await list(vehicle), ended, 'none is written meanwhile');
      const att = named(readLog(await download(vehicle, ended[1])), 'ATT');
      assert.ok(att.length > 15, `${att.length} ATT without arming`);
      vehicle.send('LOG_REQUEST_END', {});
      await vehicle.wait(2000);
      assert.equal((await list(vehicle)).at(-1).id, 3);
    })();
    await withVehicle({ line: kUsb, options }, async (vehicle) => {
      await vehicle.wait(500);
      const entries = await list(vehicle);
      assert.deepEqual(entries.map(({ id }) => id), [1, 2, 3], 'what was in the buffer is gone, the stored pages are not');
      readLog(await download(vehicle, entries[1]));
      readLog(await download(vehicle, entries[2]));
    })();
  });
});
