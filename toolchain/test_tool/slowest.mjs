// SPDX-License-Identifier: GPL-3.0-or-later
// Watches what ctest prints, and puts the ten slowest tests before its summary.
const kShown = 10;

export class Slowest {
  constructor() { this.times = []; }

  // The line, with what is to be shown before it.
  withSummary(line) {
    const test = /Test +#\d+: (\S+) \.*.* ([\d.]+) sec/.exec(line);
    if (test) this.times.push({ name: test[1], seconds: Number(test[2]) });
    return /^\d+% tests passed/.test(line) ? [...this.table(), line] : [line];
  }
  table() {
    const sum = this.times.reduce((all, { seconds }) => all + seconds, 0);
    const rows = [...this.times].sort((a, b) => b.seconds - a.seconds).slice(0, kShown);
    return [`The slowest of ${this.times.length} tests, which took ${sum.toFixed(0)} s together:`,
      ...rows.map(({ name, seconds }) => `${seconds.toFixed(1).padStart(8)} s  ${name}`), ''];
  }
}
