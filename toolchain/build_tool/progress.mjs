// SPDX-License-Identifier: GPL-3.0-or-later
// One line about builds that run at once: steps done of all, and about how long it will take. On
// a terminal the line is rewritten; elsewhere there is a new one twice a minute.
const kLine_ms = 30_000, kRewrite_ms = 200;

export function timeLeft(elapsed_ms, done, total) {
  const left_s = (elapsed_ms / 1000) * (total - done) / Math.max(done, 1);
  if (left_s < 60) return 'less than a minute';
  return `about ${Math.round(left_s / 60)} min`;
}

export class Progress {
  constructor(steps, { out = process.stderr, now = Date.now } = {}) {
    this.steps = new Map([...steps].map(([tree, total]) => [tree, { done: 0, total }]));
    this.out = out;
    this.now = now;
    this.begun = this.shown = now();
    const { total } = this.sum();
    if (total > 0) out.write(`building: ${total} steps\n`);
  }
  sum() {
    const all = [...this.steps.values()];
    const of = (key) => all.reduce((sum, step) => sum + step[key], 0);
    return { done: of('done'), total: of('total') };
  }
  update(tree, done, total) {
    this.steps.set(tree, { done, total });
    const wait = this.out.isTTY ? kRewrite_ms : kLine_ms;
    if (this.now() - this.shown < wait) return;
    this.shown = this.now();
    const sum = this.sum();
    const text = `building: ${sum.done}/${sum.total}, ${timeLeft(this.now() - this.begun, sum.done, sum.total)} left`;
    this.out.write(this.out.isTTY ? `\r${text}\x1b[K` : `${text}\n`);
  }
  clear() { if (this.out.isTTY) this.out.write('\r\x1b[K'); }
  end() {
    this.clear();
    const { total } = this.sum();
    if (total > 0) this.out.write(`built: ${total} steps in ${Math.round((this.now() - this.begun) / 1000)} s\n`);
  }
}
