// SPDX-License-Identifier: GPL-3.0-or-later
// A board that flies in lock step (fly --lock-step; the protocol is in simulator/ground/server.hpp)
// and a pilot with transmitter and ground station, whose every act has its emulated time. What the
// board sends is kept byte for byte, where the airplane is ten times a second.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { connect } from 'node:net';

import { commandLong, frame, framesIn, heartbeat, modeOf, paramSet, requestAllStreams } from './mavlink.mjs';

const kStep_ms = 100, kBeat_ms = 1000;
const kArm = 400, kSetMode = 176, kCustomMode = 1;
const kReady_s = 120, kAccepted = 0, kAck = 77;

// A flight that did not do what its script is about.
export class FlightFailed extends Error {}

async function open(port) {
  const socket = connect(port, '127.0.0.1').setNoDelay(true);
  await once(socket, 'connect');
  socket.on('error', () => {});  // the program has ended; whoever waits is informed by its exit
  return socket;
}

// What comes from a serial line, and what of it is not yet read.
class Line {
  constructor(socket) {
    this.socket = socket;
    this.written = 0;
    this.chunks = [];
    this.received = 0;
    this.rest = Buffer.alloc(0);
    socket.on('data', (bytes) => {
      this.chunks.push(bytes);
      this.received += bytes.length;
      this.rest = Buffer.concat([this.rest, bytes]);
      this.arrived?.();
    });
  }
  async hasReceived(count, gone) {
    while (this.received < count)
      await Promise.race([new Promise((resolve) => { this.arrived = resolve; }), gone]);
  }
  frames() {
    const { frames, taken } = framesIn(this.rest);
    this.rest = this.rest.subarray(taken);
    return frames;
  }
}

export class Board {
  static async start(program, words) {
    const board = new Board();
    board.process = spawn(program, ['--native', '--lock-step', '--listen', '0', ...words],
      { stdio: ['ignore', 'pipe', 'pipe'] });
    board.complaint = '';
    board.process.stderr.on('data', (bytes) => { board.complaint += bytes; });
    board.ended = once(board.process, 'close');
    board.gone = board.ended.then(() => {
      throw new FlightFailed(`fly has ended: ${board.complaint.trim().split('\n')[0]}`);
    });
    board.gone.catch(() => {});
    const [words_of_fly] = await Promise.race([once(board.process.stdout, 'data'), board.gone]);
    const ports = [...String(words_of_fly).matchAll(/ on(?: TCP port)? (\d+)/g)].map((match) => Number(match[1]));
    if (ports.length !== 3) throw new FlightFailed(`fly named no three ports: ${words_of_fly}`);
    board.lines = [new Line(await open(ports[0])), new Line(await open(ports[1]))];
    board.control = await open(ports[2]);
    board.now_ms = board.next_beat_ms = 0;
    board.sequence = 0;
    board.silent = false;
    board.mode = board.armed = undefined;
    board.answers = new Map();
    board.rows = [];
    return board;
  }

  async order(words) {
    this.control.write(`${words}\n`);
    let answer = '';
    while (!answer.endsWith('\n'))
      answer += (await Promise.race([once(this.control, 'data'), this.gone]))[0];
    if (answer.startsWith('error')) throw new FlightFailed(answer.trim());
    return answer.trim();
  }

  send(message) {
    const bytes = frame(message, this.sequence++);
    this.lines[0].written += bytes.length;
    this.lines[0].socket.write(bytes);
  }

  async step() {
    if (!this.silent && this.now_ms >= this.next_beat_ms) {
      this.next_beat_ms = this.now_ms + kBeat_ms;
      this.send(heartbeat());
    }
    const written = this.lines.map((line) => line.written);
    const [, time, ...sent] = (await this.order(`advance ${kStep_ms} ${written.join(' ')}`)).split(' ').map(Number);
    this.now_ms = time;
    for (const [i, line] of this.lines.entries()) await line.hasReceived(sent[i], this.gone);
    for (const each of this.lines[0].frames()) this.take(each);
    this.lines[1].frames();
    this.rows.push(JSON.parse(await this.order('state')));
    if (this.rows.at(-1).crashed) throw new FlightFailed(`crashed at ${this.now_ms / 1000} s`);
  }
  take(message) {
    const beat = modeOf(message);
    if (beat) ({ mode: this.mode, armed: this.armed } = beat);
    if (message.id !== kAck) return;
    const [low = 0, high = 0, result = 0] = message.payload;  // version 2 leaves trailing zeros out
    this.answers.set(low + 256 * high, result);
  }

  async wait(seconds) {
    const until_ms = this.now_ms + seconds * 1000;
    while (this.now_ms < until_ms) await this.step();
  }
  async until(what, seconds, done) {
    const until_ms = this.now_ms + seconds * 1000;
    while (!done()) {
      if (this.now_ms >= until_ms)
        throw new FlightFailed(`${what} did not come within ${seconds} s, in mode ${this.mode}`);
      await this.step();
    }
  }

  sticks(...pulses_us) { return this.order(`sticks ${pulses_us.join(' ')}`); }
  transmitterOff() { return this.order('sticks off'); }
  set(name, value) {
    this.send(paramSet(name, value));
    return this.wait(0.5);
  }
  command(number, ...parameters) {
    this.send(commandLong(number, parameters));
    return this.wait(0.5);
  }
  async enter(mode) {
    await this.command(kSetMode, kCustomMode, mode);
    await this.until(`mode ${mode}`, 3, () => this.mode === mode);
  }
  inMode(mode, within_s) { return this.until(`mode ${mode}`, within_s, () => this.mode === mode); }

  // Streams on, armed as soon as the checks let it, in AUTO and thrown.
  async takeOff() {
    await this.until('a heartbeat', 10, () => this.mode !== undefined);
    this.send(requestAllStreams(10));
    for (const end_ms = this.now_ms + kReady_s * 1000; !this.armed; await this.wait(1)) {
      if (this.now_ms > end_ms) throw new FlightFailed(`not armed within ${kReady_s} s`);
      this.send(commandLong(kArm, [1]));
    }
    if (this.answers.get(kArm) !== kAccepted) throw new FlightFailed('arming was not acknowledged');
    await this.enter(10);
    await this.order('launch');
    await this.until('the air', 60, () => !this.rows.at(-1).on_ground && this.rows.at(-1).height_m > 20);
  }
  landed(within_s) { return this.until('the end of the flight', within_s, () => !this.armed); }

  // Whoever waits for the program fails with these words.
  giveUp(why) {
    this.complaint = why;
    this.process.kill('SIGKILL');
  }

  // Ends the program, which then writes its memories.
  async stop() {
    this.process.kill('SIGTERM');
    await this.ended;
    for (const line of this.lines) line.socket.destroy();
    this.control.destroy();
  }

  // File name to contents.
  recorded() {
    const names = Object.keys(this.rows[0] ?? {});
    const table = [names.join(','), ...this.rows.map((row) => names.map((name) => row[name]).join(','))];
    return new Map([['flight.csv', `${table.join('\n')}\n`],
      ['telemetry.bin', Buffer.concat(this.lines[0].chunks)], ['usb.bin', Buffer.concat(this.lines[1].chunks)]]);
  }
}
