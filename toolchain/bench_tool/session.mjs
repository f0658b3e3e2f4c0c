// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the steps: instruction, measurement, verdict, form. Results are on the disk after each part.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';

import { Refusal } from '../flash_tool/refusal.mjs';
import { NotDone, NotFitted, NotMeasured } from './errors.mjs';
import { formOf } from './form.mjs';
import { kFail, kNotDone, kNotFitted, kPass, verdictOfStep, verdictOn } from './limits.mjs';
import { Safety } from './safety.mjs';
import { saveState, writeWhole } from './state.mjs';
import { kSteps, stepsOn } from './steps/table.mjs';

const kFirst_ms = 5000, kVersion = 520;
const kMarks = { [kPass]: 'pass    ', [kFail]: 'FAIL    ', [kNotDone]: 'not done', [kNotFitted]: 'not fitted' };

export const formFile = (folder) => join(folder, 'form.html');

// The checkout's commit: of the tool, and of the image where it was flashed from here.
export function commitOf(root) {
  const { status, stdout } = spawnSync('git', ['-C', root, 'describe', '--always', '--dirty'], { encoding: 'utf8' });
  return status === 0 ? stdout.trim() : 'unknown';
}

export class Session {
  // `options`: { folder, port, board, telemetry }, `board`: the conversation with it
  constructor({ board, person, state, options, print, now = () => new Date() }) {
    Object.assign(this, { board, person, state, options, print, now });
    this.safety = new Safety(board, person, { restore: state.restore, save: () => this.save(), print });
    const wait = board.tick.bind(board);
    board.tick = async () => { this.safety.tick(); await wait(); };
  }

  save() {
    saveState(this.options.folder, this.state);
    writeWhole(formFile(this.options.folder), formOf(this.state, this.options.board));
  }

  // The first heartbeat and what the firmware says it is.
  async meet() {
    const beat = await this.board.next('HEARTBEAT', { within_ms: kFirst_ms });
    if (!beat) throw new Refusal(`no MAVLink from a board on ${this.options.port}: is the firmware on it (toolchain/flash), ` +
      'and is this its port and rate?', 1);
    if (beat.data.baseMode & 128) throw new Refusal('the board is armed: disarm it first', 1);
    const version = await this.board.next('AUTOPILOT_VERSION', { where: () => true,
      ask: () => this.board.send('COMMAND_LONG', { command: kVersion, _param1: 1 }) });
    const number = version?.data.flightSwVersion ?? 0;
    this.state.firmware = version ? `${number >>> 24}.${(number >>> 16) & 255}.${(number >>> 8) & 255}` : 'unknown';
    this.state.port = this.options.port;
    this.state.commit = this.options.commit;
    this.state.date = this.now().toISOString().slice(0, 16).replace('T', ' ');
  }

  async firstWords() {
    this.print(`Bench session of "${this.state.name}" (${this.options.board}) on ${this.options.port}; ` +
      `form: ${formFile(this.options.folder)}`);
    const words = 'the propeller is off';
    if (!await this.person.confirms('propeller', 'Before anything else: take the propeller off.', words))
      throw new Refusal(`nothing is done before "${words}" is typed`);
    const left = Object.keys(this.state.restore);
    if (left.length > 0) this.print(`An earlier session could not restore ${left.join(', ')}; that is done now.`);
    await this.atEnd();
  }

  // True when all steps of the protocol have passed.
  async run(numbers) {
    await this.meet();
    this.save();
    await this.firstWords();
    try {
      for (const step of stepsOn(this.options.board)) if (numbers.includes(step.number)) await this.step(step);
    } finally {
      await this.atEnd();
    }
    return kSteps.every(({ number }) => this.state.steps[number]?.verdict === kPass);
  }

  async atEnd() {
    for (const what of await this.safety.end()) {
      this.print(`NOT UNDONE: ${what}`);
      this.undone = true;
    }
  }

  async step(step) {
    const { parts } = step;
    const found = {};  // what a part leaves for the next ones
    const result = { verdict: kNotDone, at: this.now().toISOString(), firmware: this.state.firmware, parts: [], remarks: [] };
    this.print(`\nStep ${step.number}: ${step.title}\n  You need: ${step.tools}${step.note ? `\n  ${step.note}` : ''}`);
    this.state.steps[step.number] = result;
    try {
      for (const part of parts) await this.part(step, part, result, found);
    } finally {
      result.verdict = verdictOfStep(result.parts, parts.length);
      result.remarks.push(...this.person.remarks.splice(0));
      await this.atEnd();
      this.save();
      this.print(`Step ${step.number}: ${result.verdict}`);
    }
  }

  async part(step, part, result, found) {
    const record = { id: part.id, title: part.title, limit: part.limit.text, value: '', verdict: kNotDone };
    result.parts.push(record);
    try {
      Object.assign(record, verdictOn(part.limit, await part.measure({ ...this.context(), id: part.id, found })));
    } catch (error) {
      Object.assign(record, this.without(error));
      if (this.safety.armed) await this.atEnd();
    }
    this.print(`  ${kMarks[record.verdict]}  ${record.title}: ${record.value} (${record.limit})`);
    if (record.verdict === kFail) this.print(`            ${part.failed ?? step.failed}`);
    this.save();
  }

  without(error) {
    if (error instanceof NotMeasured) return { verdict: kFail, value: error.message };
    if (error instanceof NotDone) return { verdict: kNotDone, value: error.message };
    if (error instanceof NotFitted) return { verdict: kNotFitted, value: error.message };
    throw error;
  }

  context() {
    const { board, person, safety, options, print } = this;
    return { board, person, safety, options, print };
  }
}
