// SPDX-License-Identifier: GPL-3.0-or-later
// A bench session with a simulated board in lock step, and a person who does with it what is asked.
// FLY names the program, FLY_BOARD is `native` or `elf`, MINUTES a file for the emulated minutes.
// `images`: the files of an image for each board, with which its bootloader can be reached.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { Board } from '../../toolchain/bench_tool/board.mjs';
import { Person } from '../../toolchain/bench_tool/person.mjs';
import { Session } from '../../toolchain/bench_tool/session.mjs';
import { loadState } from '../../toolchain/bench_tool/state.mjs';
import { writeFigures } from '../../toolchain/self_test_tool/figures_file.mjs';
import { selfTest } from '../../toolchain/self_test_tool/run.mjs';
import { Vehicle } from './vehicle.mjs';

const kUsb = 1;
const kFlashed_ms = 1000;  // far less than avrdude takes, and long enough for the last words to pass

// A serial line of the vehicle as the port of a session.
class LinePort {
  connected = true;
  constructor(vehicle, line, canReset = false) {
    this.vehicle = vehicle;
    this.line = line;
    this.canReset = canReset;
    this.address = { path: 'the simulated USB port' };
  }
  pause() { this.connected = false; }
  // DTR rises.
  async resume() {
    assert.equal(await this.vehicle.order('reset'), 'ok');
    this.connected = true;
  }
  // Every byte goes to the session while the port is open; the vehicle's own reader counts them only.
  onBytes(listener) {
    this.line.takeFrame = () => {
      if (this.connected) listener(this.line.waiting);
      this.line.waiting = Buffer.alloc(0);
      return false;
    };
  }
  write(bytes) {
    this.line.written += bytes.length;
    this.line.socket.write(bytes);
  }
  close() {}
}

export class Rig {
  static async start({ options = [], board = 'apm2', images, folder = mkdtempSync(join(tmpdir(), 'bench-')) } = {}) {
    const rig = new Rig();
    rig.folder = folder;
    rig.printed = [];
    rig.asked = [];
    rig.vehicle = await Vehicle.start({ options: ['--bench', ...(board === 'apm2' ? [] : ['--board', board]), ...options] });
    // A cut of the supply ends a frame anywhere: the lines that no session reads are not taken apart.
    for (const line of rig.vehicle.lines.filter((each) => each !== rig.vehicle.lines[kUsb])) new LinePort(rig.vehicle, line).onBytes(() => {});
    const clock = { now_ms: () => rig.vehicle.now_ms, sleep: (time_ms) => rig.sleep(time_ms) };
    rig.board = new Board(new LinePort(rig.vehicle, rig.vehicle.lines[kUsb], images !== undefined), clock);
    rig.images = images;
    rig.motor_us = 0;
    rig.kind = board;
    rig.clock = clock;
    return rig;
  }
  // The highest pulse of the motor's pin over all the time.
  async sleep(time_ms) {
    await this.vehicle.wait(time_ms);
    if (this.pulses) this.pulses.push(JSON.parse(await this.order('servos'))[0]);
    if (this.watching) this.motor_us = Math.max(this.motor_us, JSON.parse(await this.order('servos'))[2]);
  }
  async order(text) {
    const answer = await this.vehicle.order(text);
    assert.ok(!answer.startsWith('error'), `${text}: ${answer}`);
    return answer;
  }
  // `answers`: by question, a text or what gives one (and does what was asked); others are done
  // without a word, `propeller` is confirmed.
  async run(steps, answers = {}, name = 'test') {
    const state = loadState(this.folder, { board: this.kind, name });
    const all = { propeller: 'the propeller is off', ...answers };
    const person = new Person(async (id, question) => {
      this.asked.push(id);
      const answer = all[id] ?? all['*'] ?? '';
      return typeof answer === 'function' ? answer(this, question) : answer;
    }, (line) => this.printed.push(line));
    person.scripted = true;
    this.session = new Session({ board: this.board, person, state, print: (line) => this.printed.push(line),
      now: () => new Date(Date.UTC(2026, 0, 2, 3, 4)),
      options: { folder: this.folder, port: 'simulator', board: this.kind, commit: 'abc', telemetry: 'line 0',
        flash: async (_, image) => this.flash(image), selfTest: (_, kind, file) => this.selfTest(kind, file),
        openTelemetry: () => new LinePort(this.vehicle, this.vehicle.lines[0]) } });
    this.state = state;
    return this.session.run(steps);
  }
  async flash(image) {
    await this.order(`flash ${this.images[image]}`);
    await this.vehicle.wait(kFlashed_ms);
    return 0;
  }
  // What toolchain/self_test does at a serial port, on the vehicle's line in lock step.
  async selfTest(board, file) {
    const line = this.vehicle.lines[kUsb], session = line.takeFrame;
    const open = async () => Object.assign(new LinePort(this.vehicle, line, true), { close: () => { line.takeFrame = session; } });
    const device = { flashes: true, open, flash: (program) => this.flash(program === 'firmware' ? board : program) };
    const outcome = await selfTest({ board, device, clock: this.clock, print: (text) => this.printed.push(text) });
    writeFigures(file, outcome);
    return outcome.passed ? 0 : 1;
  }
  step(number) { return this.state.steps[number]; }
  part(id) { return this.step(id.split('.')[0]).parts.find((part) => part.id === id); }
  form() { return readFileSync(join(this.folder, 'form.html'), 'utf8'); }
  passes(number) {
    const step = this.step(number);
    assert.equal(step.verdict, 'pass', JSON.stringify(step.parts.filter(({ verdict }) => verdict !== 'pass'), null, 1));
  }
}

export const withRig = (options, body) => async () => {
  const rig = await Rig.start(options);
  try {
    await body(rig);
  } catch (error) {
    console.log(rig.printed.join('\n'));
    throw error;
  } finally {
    await rig.vehicle.stop().catch((error) => { if (!options.violates) throw error; });
  }
};

// The person's hands.
export const order = (text, answer = '') => async (rig) => { await rig.order(text); return answer; };
export const turnTo = (roll, pitch, yaw, wait_ms = 2500) => async (rig) => {
  await rig.order(`turn-to ${roll} ${pitch} ${yaw}`);
  await rig.vehicle.wait(wait_ms);
  return '';
};
