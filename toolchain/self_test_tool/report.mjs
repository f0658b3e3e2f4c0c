// SPDX-License-Identifier: GPL-3.0-or-later
// The text that a board's self-test sends (hal_avr/self_test/), line by line, as figures by name.
const kNumber = /^\d+(\.\d+)?$/, kName = /^[a-zA-Z]+$/;
const kNames = ['supply', 'interrupted', 'inertial', 'barometer', 'compass', 'pulse', 'period', 'eeprom', 'dataflash', 'ram'];
const kNamedByNumbers = { pulse: 3, period: 1 };  // "pulse 1 asked 900": so many words behind the first

// What follows the name: words before numbers name them, "least 4987 most 5004"; a unit goes with the first.
function figuresOf(words) {
  const figures = {};
  let name = [];
  for (const word of words) {
    if (kName.test(word)) name.push(word);
    else {
      if (name.length === 0 || !kNumber.test(word)) return undefined;
      figures[name.join(' ')] = Number(word);
      name = [];
    }
  }
  return name.length === 0 ? figures : undefined;
}

export class Report {
  #rest = '';
  #waits_ms;  // since when, for the watchdog
  constructor() {
    this.begins = 0;  // how often the board has begun
    this.clear();
  }
  clear() {
    this.figures = new Map();
    this.unknown = [];  // lines that are not understood
    this.ended = false;
    this.board = this.last = this.#waits_ms = undefined;
  }
  // Bytes as they come. A board that begins anew, as one does whose port is opened, drops what it said before;
  // but for the restart by its watchdog, which is a part of the test.
  take(bytes, now_ms) {
    this.#rest += bytes.toString('latin1');
    const lines = this.#rest.split(/\r?\n/);
    this.#rest = lines.pop();
    for (const line of lines) if (line.trim() !== '') this.#line(line.trim().replace(/[^ -~]/g, '?'), now_ms);
  }
  // What a reset has torn stands before "self test of" in the same line.
  #line(line, now_ms) {
    const board = /self test of (APM [12])$/.exec(line)?.[1];
    const cause = /^started by (\w+)$/.exec(line)?.[1];
    if (board) this.#begin(board);
    else if (cause) this.#started(cause, now_ms);
    else if (line === 'watchdog waits') this.#waits_ms = now_ms;
    else if (line === 'end') this.ended = true;
    else if (!this.#keep(line.split(/\s+/))) this.unknown.push(line);
    this.last = line;
  }
  #begin(board) {
    ++this.begins;
    if (this.#waits_ms === undefined) this.clear();
    this.board = board;
  }
  #started(cause, now_ms) {
    if (this.#waits_ms === undefined) return;
    if (cause === 'watchdog') this.figures.set('restart', { s: (now_ms - this.#waits_ms) / 1000 });
    else {
      const { board } = this;
      this.clear();
      this.board = board;
    }
    this.#waits_ms = undefined;
  }
  #keep([first, ...words]) {
    if (!kNames.includes(first)) return false;
    const behind = kNamedByNumbers[first] ?? 0;
    const figures = figuresOf(words.slice(behind));
    if (figures === undefined || Object.keys(figures).length === 0) return false;
    this.figures.set([first, ...words.slice(0, behind)].join(' '), figures);
    return true;
  }
}
