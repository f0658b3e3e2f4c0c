// SPDX-License-Identifier: GPL-3.0-or-later
// The person at the board: confirms that the propeller is off, and may end the test at any time.
import { createInterface } from 'node:readline';

import { Refusal } from '../flash_tool/refusal.mjs';

// Waits for Enter. The terminal stays as it is, so that Ctrl-C ends the program: nothing is written yet.
export async function waitForEnter(input, output) {
  output.write('Enter when it is so, Ctrl-C to leave: ');
  const lines = createInterface({ input, terminal: false });
  const confirmed = await new Promise((resolve) => {
    lines.once('line', () => resolve(true));
    lines.once('close', () => resolve(false));
  });
  lines.close();
  if (!confirmed) throw new Refusal('not confirmed; nothing was written', 1);
}

// From here on neither a signal nor an output that went away ends the program, as the board may be without its
// firmware: `stopped` is true after one, for the test to end itself. `release` ends that.
export function watchStops({ signals = process, outputs = [process.stdout, process.stderr], say }) {
  const names = ['SIGINT', 'SIGTERM', 'SIGHUP'];
  const state = { stopped: false };
  const onSignal = () => {
    if (state.stopped) say('wait: the board gets its firmware back');
    state.stopped = true;
  };
  for (const signal of names) signals.on(signal, onSignal);
  const onLost = () => { state.stopped = true; };
  const before = outputs.map((output) => output.listeners('error'));
  for (const output of outputs) output.removeAllListeners('error').on('error', onLost);
  state.release = () => {
    for (const signal of names) signals.off(signal, onSignal);
    for (const [i, output] of outputs.entries()) {
      output.off('error', onLost);
      for (const listener of before[i]) output.on('error', listener);
    }
  };
  return state;
}
