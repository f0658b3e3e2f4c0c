// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink FTP as ground stations use it to get all parameters at once: the order of requests is
// that of MAVProxy's mavftp module and of QGroundControl's FTPManager.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withVehicle } from '../../support/vehicle.mjs';

const kTerminate = 1, kReset = 2, kList = 3, kOpen = 4, kRead = 5, kWrite = 7, kBurst = 15;
const kAck = 128, kNak = 129;
const kInvalidSession = 4, kNoSessions = 5, kEof = 6, kUnknownCommand = 7, kNotFound = 10;
const kFile = '@PARAM/param.pck', kMaxData = 82;

class Ftp {
  constructor(vehicle, line = vehicle.line) {
    this.vehicle = vehicle;
    this.line = line;
    this.line.version = 2;
    this.session = 0;
    this.sequence = 0;
  }

  send(opcode, { offset = 0, size = 0, data = '', session = this.session } = {}) {
    const payload = Buffer.alloc(251);
    payload.writeUInt16LE(this.sequence, 0);
    payload[2] = session;
    payload[3] = opcode;
    payload[4] = data.length || size;
    payload.writeUInt32LE(offset, 8);
    payload.write(data, 12, 'latin1');
    this.line.send('FILE_TRANSFER_PROTOCOL', { targetNetwork: 0, payload: [...payload] });
    return this.sequence;
  }

  async answer(options) {
    const { data, header } = await this.message(options);
    assert.equal(header.sysid, 1);
    assert.deepEqual([data.targetSystem, data.targetComponent], [255, 190]);
    const payload = Buffer.from(data.payload);
    const answer = { sequence: payload.readUInt16LE(0), session: payload[2], opcode: payload[3], size: payload[4],
      requested: payload[5], complete: payload[6], offset: payload.readUInt32LE(8) };
    answer.data = payload.subarray(12, 12 + answer.size);
    return answer;
  }

  async message({ within_ms = 2000 } = {}) {
    const until_ms = this.vehicle.now_ms + within_ms;
    for (;;) {
      const at = this.line.inbox.findIndex(({ name }) => name === 'FILE_TRANSFER_PROTOCOL');
      if (at >= 0) return this.line.inbox.splice(at, 1)[0];
      assert.ok(this.vehicle.now_ms < until_ms, 'no answer');
      await this.vehicle.advance(20);
    }
  }

  async ask(opcode, options = {}) {
    const asked = this.send(opcode, options);
    const answer = await this.answer();
    this.sequence = (answer.sequence + 1) & 0xffff;
    assert.equal(answer.sequence, asked + 1);
    assert.equal(answer.requested, opcode);
    return answer;
  }

  async refused(error, opcode, options) {
    const { opcode: answered, data } = await this.ask(opcode, options);
    assert.equal(answered, kNak);
    assert.deepEqual([...data], [error]);
  }

  async open(path = kFile) {
    const { opcode, data } = await this.ask(kOpen, { data: path });
    assert.equal(opcode, kAck);
    return data.readUInt32LE(0);
  }

  // The whole file; `lost(n)`: the n-th message does not arrive, and is asked for by ReadFile.
  async download(path = kFile, size = 80, lost = () => false) {
    assert.equal((await this.ask(kReset)).opcode, kAck);
    const file = Buffer.alloc(await this.open(path));
    const missing = [];
    let asked = this.send(kBurst, { size });
    let at = 0;
    for (let n = 0;; ++n) {
      const part = await this.answer();
      assert.equal(part.sequence, (asked + 1 + n) & 0xffff);
      assert.equal(part.requested, kBurst);
      if (part.opcode === kNak) {
        assert.deepEqual([...part.data], [kEof]);
        this.sequence = part.sequence + 1;
        break;
      }
      assert.equal(part.offset, at);
      at += part.size;
      if (lost(n)) missing.push({ offset: part.offset, size: part.size });
      else part.data.copy(file, part.offset);
    }
    assert.equal(at, file.length, 'the size in the answer to OpenFileRO');
    for (const { offset, size: gap } of missing) {
      const part = await this.ask(kRead, { offset, size: gap });
      assert.deepEqual([part.opcode, part.offset, part.size], [kAck, offset, gap]);
      part.data.copy(file, offset);
    }
    assert.equal((await this.ask(kTerminate)).opcode, kAck);
    return file;
  }
}

// As pymavlink's param_ftp and QGroundControl's ParameterManager read it.
function decode(file) {
  const [magic, count, total] = [0, 2, 4].map((at) => file.readUInt16LE(at));
  assert.equal(magic, 0x671b);
  assert.equal(count, total);
  const found = [];
  let name = '';
  for (let at = 6; at < file.length;) {
    const type = file[at] & 15, common = file[at + 1] & 15, letters = (file[at + 1] >> 4) + 1;
    name = name.slice(0, common) + file.toString('latin1', at + 2, at + 2 + letters);
    at += 2 + letters;
    const [width, value] = { 1: [1, () => file.readInt8(at)], 2: [2, () => file.readInt16LE(at)],
      3: [4, () => file.readInt32LE(at)], 4: [4, () => file.readFloatLE(at)] }[type];
    found.push({ name, type, value: value() });
    at += width;
  }
  assert.equal(found.length, count);
  return found;
}

async function parameterList(vehicle) {
  vehicle.send('PARAM_REQUEST_LIST');
  const values = [await vehicle.expect('PARAM_VALUE')];
  while (values.length < values[0].paramCount) values.push(await vehicle.expect('PARAM_VALUE', { within_ms: 3000 }));
  return values.map(({ paramId, paramType, paramValue }) =>
    ({ name: paramId, type: { 2: 1, 4: 2, 6: 3, 9: 4 }[paramType], value: paramValue }));
}

test('the file has the parameters of the list, and comes in less than half of its time', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const ftp = new Ftp(vehicle);
  const began_ms = vehicle.now_ms;
  const listed = await parameterList(vehicle);
  const listed_ms = vehicle.now_ms - began_ms;
  const opened_ms = vehicle.now_ms;
  const file = await ftp.download();
  const took_ms = vehicle.now_ms - opened_ms;
  assert.deepEqual(decode(file), listed);
  const wire_ms = Math.ceil(file.length / 80) * (12 + 15 + 80) * 10 / 57.6;
  console.log(`${listed.length} parameters, ${file.length} bytes in ${took_ms} ms; the line alone takes ${
    Math.round(wire_ms)}, PARAM_REQUEST_LIST ${listed_ms}`);
  assert.ok(took_ms < wire_ms * 1.25 + 150, `${took_ms} ms`);
  assert.ok(took_ms < listed_ms / 2, `${took_ms} of ${listed_ms} ms`);
}));

test('beside all streams no frame is late, and the values are those in force', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const ftp = new Ftp(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 0, reqMessageRate: 4, startStop: 1 });
  vehicle.send('PARAM_SET', { paramId: 'WP_RADIUS', paramValue: 42, paramType: 9 });
  await vehicle.expect('PARAM_VALUE');
  const found = decode(await ftp.download(`${kFile}?withdefaults=1`, 239));
  assert.equal(found.find(({ name }) => name === 'WP_RADIUS').value, 42);
  assert.equal((await vehicle.expect('SYS_STATUS', { within_ms: 3000 })).errorsCount2, 0, 'late frames');
  await vehicle.expect('HEARTBEAT', { within_ms: 1500 });
}));

test('what was lost is read again, in any order', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const ftp = new Ftp(vehicle);
  const whole = await ftp.download();
  assert.deepEqual(await ftp.download(kFile, 80, (n) => n % 3 === 1), whole);
  const size = await ftp.open();
  for (const offset of [2000, 7, size - 3, 1000]) {
    const part = await ftp.ask(kRead, { offset, size: 50 });
    assert.deepEqual([part.opcode, part.offset], [kAck, offset]);
    assert.deepEqual(part.data, whole.subarray(offset, offset + 50));
  }
  const part = await ftp.ask(kRead, { offset: 0, size: 239 });
  assert.equal(part.size, kMaxData, 'what fits');
  await ftp.refused(kEof, kRead, { offset: size, size: 80 });
  await ftp.refused(kEof, kRead, { offset: 0x10000, size: 80 });
}));

test('what there is not is refused with the reason', withVehicle({}, async (vehicle) => {
  const ftp = new Ftp(vehicle);
  await ftp.refused(kInvalidSession, kRead, { offset: 0, size: 80 });
  for (const path of ['@PARAM/param.pc', '@PARAM/param.pckx', '@SYS/tasks.txt', '/APM/LOGS/1.BIN', ''])
    await ftp.refused(kNotFound, kOpen, { data: path });
  await ftp.open();
  await ftp.refused(kInvalidSession, kRead, { session: 3, size: 80 });
  await ftp.refused(kUnknownCommand, kWrite, { data: 'abc' });
  await ftp.refused(kUnknownCommand, kList, { data: '/' });
  await ftp.ask(kTerminate);
  await ftp.refused(kInvalidSession, kBurst, { size: 80 });
}));

test('one ground station at a time, each on its own link', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const [first, second] = vehicle.lines.map((line) => new Ftp(vehicle, line));
  await first.open();
  first.send(kBurst, { size: 80 });
  await vehicle.wait(100);
  await second.refused(kNoSessions, kOpen, { data: kFile });
  await second.refused(kInvalidSession, kRead, { size: 80 });
  assert.equal((await second.ask(kReset)).opcode, kAck);
  await vehicle.wait(1500);
  const parts = first.line.inbox.filter(({ name }) => name === 'FILE_TRANSFER_PROTOCOL');
  assert.ok(parts.length > 30, 'nobody else ends it');
  assert.equal(decode(await second.download()).length > 200, true);
}));
