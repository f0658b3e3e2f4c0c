// SPDX-License-Identifier: GPL-3.0-or-later
// A client of MAVLink FTP for a vehicle of vehicle.mjs: the order of requests is that of MAVProxy's
// mavftp module, of QGroundControl's FTPManager and of Mission Planner's MAVFtp.
import assert from 'node:assert/strict';

export const kTerminate = 1, kReset = 2, kList = 3, kOpen = 4, kRead = 5, kWrite = 7, kBurst = 15;
export const kAck = 128, kNak = 129;
export const kInvalidSession = 4, kNoSessions = 5, kEof = 6, kUnknownCommand = 7, kNotFound = 10;
export const kFile = '@PARAM/param.pck', kMaxData = 110;

export class Ftp {
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
    const asked = this.send(kBurst, { size });
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

// A file of lines of a name, a value and a task's budget.
export const figures = (file) => Object.fromEntries(file.toString('latin1').trimEnd().split('\n').map((line) =>
  [line.slice(0, 18).trimEnd(), line.slice(18).trim().split(/ +/).map(Number)]));

// As pymavlink's param_ftp and QGroundControl's ParameterManager read it.
export function decode(file) {
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
