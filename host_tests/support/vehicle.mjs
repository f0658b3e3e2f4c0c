// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated vehicle as a ground station meets it: MAVLink over TCP, written and read by npm
// node-mavlink. Emulated time passes only while a test waits (fly --lock-step), so that every
// time in these tests is the vehicle's own and none is the computer's.
// FLY names the program, FLY_BOARD is `native` or `elf`, MINUTES a file for the emulated minutes.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { appendFileSync, mkdirSync } from 'node:fs';
import { connect } from 'node:net';
import { dirname } from 'node:path';
import { messages, nodeMavlink, registry, x25crc } from './node_mavlink.mjs';

const { MavLinkPacketSignature, MavLinkProtocolV1, MavLinkProtocolV2 } = nodeMavlink;
const stations = { 1: new MavLinkProtocolV1(255, 190), 2: new MavLinkProtocolV2(255, 190) };
const kStep_ms = 20;
const kTelemetry = 0;

async function open(port) {
  const socket = connect(port, '127.0.0.1').setNoDelay(true);
  await once(socket, 'connect');
  socket.on('error', () => {});  // the program is gone; its close event reports that
  return socket;
}

// One serial line of the vehicle.
class Line {
  constructor(socket, clock) {
    this.socket = socket;
    this.clock = clock;
    this.written = 0;
    this.read = 0;
    this.waiting = Buffer.alloc(0);
    this.inbox = [];
    this.sequence = 0;
    this.version = 1;
    socket.on('data', (bytes) => {
      this.read += bytes.length;
      this.waiting = Buffer.concat([this.waiting, bytes]);
      this.arrived?.();
    });
  }

  async await(count) {
    while (this.read < count)
      await Promise.race([new Promise((resolve) => { this.arrived = resolve; }), this.clock.gone]);
    while (this.waiting.length > 0 && this.takeFrame());
  }

  // The vehicle's bytes are frames, one after the other, and nothing else.
  takeFrame() {
    const v1 = this.waiting[0] === MavLinkProtocolV1.START_BYTE;
    assert.ok(v1 || this.waiting[0] === MavLinkProtocolV2.START_BYTE,
      `0x${this.waiting[0].toString(16)} is no beginning of a frame`);
    const protocol = stations[v1 ? 1 : 2];
    const size = this.waiting[1] + (v1 ? 8 : 12);
    const isSigned = !v1 && (this.waiting[2] & MavLinkProtocolV2.IFLAG_SIGNED) !== 0;
    const whole = size + (isSigned ? MavLinkPacketSignature.SIGNATURE_LENGTH : 0);
    if (this.waiting.length < 3 || this.waiting.length < whole) return false;
    const frame = this.waiting.subarray(0, size);
    const signature = isSigned ? new MavLinkPacketSignature(this.waiting.subarray(0, whole)) : null;
    this.waiting = this.waiting.subarray(whole);
    const header = protocol.header(frame);
    const type = registry[header.msgid];
    assert.ok(type, `message ${header.msgid} is unknown to the client`);
    assert.equal(protocol.crc(frame), x25crc(frame, 1, 2, type.MAGIC_NUMBER), type.MSG_NAME);
    this.inbox.push({ name: type.MSG_NAME, version: v1 ? 1 : 2, at_ms: this.clock.now_ms, header, signature,
      data: protocol.data(protocol.payload(frame), type) });
    return true;
  }

  send(name, fields = {}) {
    const message = Object.assign(new messages[name](), fields);
    if ('targetSystem' in message && fields.targetSystem === undefined) message.targetSystem = 1;
    if ('targetComponent' in message && fields.targetComponent === undefined)
      message.targetComponent = 1;
    const bytes = stations[this.version].serialize(message, this.sequence++ & 255);
    this.written += bytes.length;
    this.socket.write(bytes);
  }
}

export class Vehicle {
  static async start({ options = [], line = kTelemetry } = {}) {
    const vehicle = new Vehicle();
    const board = process.env.FLY_BOARD === 'elf' ? [] : ['--native'];
    vehicle.program = spawn(process.env.FLY, ['--lock-step', '--listen', '0', ...board, ...options],
      { stdio: ['ignore', 'pipe', 'inherit'] });
    const [reported] = await once(vehicle.program.stdout, 'data');
    const ports = [...reported.toString().matchAll(/ on(?: TCP port)? (\d+)/g)].map((match) => +match[1]);
    assert.equal(ports.length, 3, reported.toString());
    vehicle.gone = once(vehicle.program, 'exit').then(() => { throw new Error('fly has ended'); });
    vehicle.gone.catch(() => {});
    vehicle.now_ms = 0;
    vehicle.lines = [];
    for (const port of ports.slice(0, 2)) vehicle.lines.push(new Line(await open(port), vehicle));
    vehicle.control = await open(ports[2]);
    vehicle.line = vehicle.lines[line];
    return vehicle;
  }

  // behind a bootloader that listens for a second
  async boot() {
    await this.expect('HEARTBEAT', { within_ms: 2500 });
    await this.wait(2 * kStep_ms);
    this.forget();
  }

  async stop() {
    this.countMinutes();
    this.program.kill();
    await this.gone.catch(() => {});
    for (const line of this.lines) line.socket.destroy();
    this.control.destroy();
    assert.equal(this.program.exitCode, 0, 'it violated an invariant, or did not end by itself');
  }

  // What the image may take of emulated time is counted over all tests.
  countMinutes() {
    if (!process.env.MINUTES) return;
    mkdirSync(dirname(process.env.MINUTES), { recursive: true });
    appendFileSync(process.env.MINUTES, `${this.now_ms / 60000}\n`);
  }

  async order(text) {
    this.control.write(`${text}\n`);
    let answer = '';
    while (!answer.endsWith('\n'))
      answer += (await Promise.race([once(this.control, 'data'), this.gone]))[0];
    return answer.trim();
  }

  async advance(time_ms) {
    const [telemetry, usb] = this.lines;
    const answer = await this.order(`advance ${time_ms} ${telemetry.written} ${usb.written}`);
    const match = /^at (\d+) (\d+) (\d+)$/.exec(answer);
    assert.ok(match, answer);
    this.now_ms = +match[1];
    await telemetry.await(+match[2]);
    await usb.await(+match[3]);
  }

  async wait(time_ms) {
    const until_ms = this.now_ms + time_ms;
    while (this.now_ms < until_ms) await this.advance(Math.min(kStep_ms, until_ms - this.now_ms));
  }

  send(name, fields) {
    this.line.send(name, fields);
  }

  forget() {
    for (const line of this.lines) line.inbox.length = 0;
  }

  // The next message of one of these names for which `where` holds; those before it stay.
  async next(names, { within_ms = 1000, where = () => true } = {}) {
    const wanted = [names].flat();
    const until_ms = this.now_ms + within_ms;
    for (;;) {
      const at = this.line.inbox.findIndex(({ name, data }) => wanted.includes(name) && where(data));
      if (at >= 0) return this.line.inbox.splice(at, 1)[0];
      if (this.now_ms >= until_ms) return undefined;
      await this.advance(kStep_ms);
    }
  }

  // The same, but it must come.
  async expect(names, options) {
    const message = await this.next(names, options);
    assert.ok(message, `no ${names} came`);
    return message.data;
  }

  // All messages of this name heard so far.
  all(name) {
    const found = this.line.inbox.filter((message) => message.name === name);
    this.line.inbox = this.line.inbox.filter((message) => message.name !== name);
    return found.map(({ data }) => data);
  }

  async command(command, parameters = []) {
    const fields = { command, confirmation: 0 };
    for (let i = 0; i < 7; ++i) fields[`_param${i + 1}`] = parameters[i] ?? 0;
    this.send('COMMAND_LONG', fields);
    const ack = await this.expect('COMMAND_ACK', { where: (data) => data.command === command });
    return ack.result;
  }
}

// A test with a vehicle of its own, whatever becomes of it; `booted`: both its lines are open.
export const withVehicle = ({ booted = true, ...options }, body) => async () => {
  const vehicle = await Vehicle.start(options);
  try {
    if (booted) await vehicle.boot();
    await body(vehicle);
  } finally {
    await vehicle.stop();
  }
};
