// SPDX-License-Identifier: GPL-3.0-or-later
// One line about builds that run at once: steps done of all, and about how long it will take. On
// a terminal the line is rewritten; elsewhere there is one after a few seconds (ninja's first
// counts are those of the search for new files) and then a new one twice a minute.
const kFirst_ms = 3000, kLine_ms = 30_000, kRewrite_ms = 200;

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
    this.begun = now();
    this.next = this.begun + (out.isTTY ? 0 : kFirst_ms);
  }
  sum() {
    const all = [...this.steps.values()];
    const of = (key) => all.reduce((sum, step) => sum + step[key], 0);
    return { done: of('done'), total: of('total') };
  }
  update(tree, done, total) {
    this.steps.set(tree, { done, total });
    if (this.now() < this.next) return;
    this.next = this.now() + (this.out.isTTY ? kRewrite_ms : kLine_ms);
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
