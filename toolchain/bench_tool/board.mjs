// SPDX-License-Identifier: GPL-3.0-or-later
// A conversation with the board: messages as they come, commands with their answers, parameters,
// samples over a time. `clock` may be a simulator's; then time passes only while something waits.
import { NotMeasured, Stopped } from './errors.mjs';
import { frameOf, idOf, Splitter } from './mavlink.mjs';

const kTick_ms = 20, kBeat_ms = 1000, kAnswer_ms = 1500, kTries = 3, kTextsKept = 500;
const kVehicle = 1;
const kSetInterval = 511;

export const kResults = ['accepted', 'temporarily rejected', 'denied', 'unsupported', 'failed', 'in progress'];

export class Board {
  #listeners = new Set();
  #splitter = new Splitter();
  #sequence = 0;
  #beat_ms = -Infinity;

  constructor(port, clock) {
    this.port = port;
    this.clock = clock;
    this.texts = [];
    this.lost = 0;  // frames by their sequence numbers
    this.received = 0;
    this.heard_ms = -Infinity;
    this.stopping = false;
    port.onBytes((bytes) => this.#take(bytes));
  }

  #take(bytes) {
    for (const message of this.#splitter.take(bytes)) {
      if (message.header.sysid !== kVehicle || message.header.compid !== kVehicle) continue;
      this.#count(message.header.seq);
      this.heard_ms = this.clock.now_ms();
      const heard = { ...message, at_ms: this.heard_ms };
      if (heard.name === 'STATUSTEXT') this.#keep(heard);
      for (const listener of this.#listeners) listener(heard);
    }
  }
  #count(sequence) {
    if (this.expected !== undefined) this.lost += (sequence - this.expected) & 255;
    this.expected = (sequence + 1) & 255;
    ++this.received;
  }
  #keep({ data, at_ms }) {
    this.texts.push({ text: data.text.replace(/\0.*/s, ''), at_ms });
    if (this.texts.length > kTextsKept) this.texts.shift();
  }

  now_ms() { return this.clock.now_ms(); }
  send(name, fields = {}) { this.port.write(frameOf(name, fields, this.#sequence++)); }

  // The ground station's heartbeat: without one the vehicle would see its ground station lost.
  beat() {
    if (this.now_ms() - this.#beat_ms < kBeat_ms) return;
    this.#beat_ms = this.now_ms();
    this.send('HEARTBEAT', { type: 6, autopilot: 8, mavlinkVersion: 3 });
  }
  async tick() {
    if (this.stopping) throw new Stopped();
    this.beat();
    await this.clock.sleep(kTick_ms);
  }
  async wait(time_ms) {
    const until_ms = this.now_ms() + time_ms;
    while (this.now_ms() < until_ms) await this.tick();
  }
  // Until `done` returns something; undefined when the time is over.
  async until(done, within_ms) {
    const until_ms = this.now_ms() + within_ms;
    for (;;) {
      const found = done();
      if (found !== undefined && found !== false) return found;
      if (this.now_ms() >= until_ms) return undefined;
      await this.tick();
    }
  }
  always(listener) { this.#listeners.add(listener); }
  // What `body` gives while `listener` hears every message.
  async listening(listener, body) {
    this.#listeners.add(listener);
    try {
      return await body();
    } finally {
      this.#listeners.delete(listener);
    }
  }

  // The next message of this name from now on.
  async next(name, { within_ms = kAnswer_ms, where = () => true, ask = () => {} } = {}) {
    let found;
    const listener = (heard) => { if (!found && heard.name === name && where(heard.data)) found = heard; };
    return this.listening(listener, () => {
      ask();
      return this.until(() => found, within_ms);
    });
  }
  async command(command, parameters = []) {
    const fields = { command, confirmation: 0 };
    for (let i = 0; i < 7; ++i) fields[`_param${i + 1}`] = parameters[i] ?? 0;
    for (let tries = 0; tries < kTries; ++tries) {
      const answer = await this.next('COMMAND_ACK', { where: (data) => data.command === command,
        ask: () => this.send('COMMAND_LONG', { ...fields, confirmation: tries }) });
      if (answer) return answer.data.result;
    }
    throw new NotMeasured(`the board does not answer command ${command}`);
  }
  async mustAccept(command, parameters, what) {
    const result = await this.command(command, parameters);
    if (result !== 0) throw new NotMeasured(`${what}: ${kResults[result] ?? result}${this.reasonOf()}`);
  }
  // The board's last text, which is the reason of a refusal.
  reasonOf() {
    const last = this.texts.at(-1);
    return last && this.now_ms() - last.at_ms < 2000 ? ` (${last.text})` : '';
  }

  async parameter(paramId) {
    return this.#parameterAfter(paramId, () =>
      this.send('PARAM_REQUEST_READ', { paramId, paramIndex: -1 }));
  }
  async setParameter(paramId, paramValue) {
    const now = await this.#parameterAfter(paramId, () =>
      this.send('PARAM_SET', { paramId, paramValue, paramType: 9 }));
    if (now !== paramValue) throw new NotMeasured(`${paramId} is ${now} and not ${paramValue}, as asked${this.reasonOf()}`);
  }
  async #parameterAfter(paramId, ask) {
    for (let tries = 0; tries < kTries; ++tries) {
      const answer = await this.next('PARAM_VALUE', { where: (data) => data.paramId.replace(/\0.*/s, '') === paramId, ask });
      if (answer) return answer.data.paramValue;
    }
    throw new NotMeasured(`the board does not answer for parameter ${paramId}`);
  }

  // From the next start on the message comes as its stream does again.
  async rate(name, rate_hz) {
    await this.mustAccept(kSetInterval, [idOf(name), rate_hz > 0 ? Math.round(1e6 / rate_hz) : 0], `${name} at ${rate_hz} Hz`);
  }
  // All messages of this name within the time: [{ data, at_ms }].
  async collect(name, time_ms, rate_hz) {
    await this.rate(name, rate_hz);
    const found = [];
    try {
      await this.listening((heard) => { if (heard.name === name) found.push(heard); }, () => this.wait(time_ms));
    } finally {
      if (!this.stopping) await this.rate(name, 0);
    }
    const least = 0.5 * time_ms / 1000 * rate_hz;
    if (found.length < least)
      throw new NotMeasured(`${found.length} of ${Math.round(2 * least)} ${name} came in ${time_ms / 1000} s`);
    return found;
  }
  // The first text since `since_ms` that fits; undefined when none comes in time.
  async text(pattern, within_ms, since_ms = this.now_ms()) {
    return this.until(() => this.texts.find(({ text, at_ms }) => at_ms >= since_ms && pattern.test(text))?.text, within_ms);
  }
}
