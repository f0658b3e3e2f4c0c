// SPDX-License-Identifier: GPL-3.0-or-later
// Steps 2, 3 and 4: fuses, bootloader, flashing, and an image that is the other board's.
import { NotDone } from '../errors.mjs';
import { equals, holds, within } from '../limits.mjs';
import { meter, restart } from './readings.mjs';
import { runTool } from './tool.mjs';

const kReboot = 246, kPrearm = 401;
const kWrong = /^Wrong board: for an APM [12]/;
const kRead = 'avrdude -c usbasp -p m2560 -U lfuse:r:-:h -U hfuse:r:-:h -U efuse:r:-:h';

const fuse = (id, name, value) => ({
  id, title: `${name} fuse`, limit: equals(value, 'docs/flashing.md'),
  measure: ({ person, id: question }) => person.byte(question, `With an ISP programmer at the ATmega2560: ${kRead}\n  The ${name} fuse:`),
});

export const fuses = {
  number: 2, title: 'Fuses and bootloader', tools: 'an ISP programmer (without one: skip), the reset button',
  failed: 'docs/flashing.md restores fuses and bootloader.',
  parts: [
    fuse('2.low', 'low', '0xFF'), fuse('2.high', 'high', '0xD8'), fuse('2.extended', 'extended', '0xFD'),
    { id: '2.reboot', title: 'silent over a restart by the watchdog',
      limit: within({ high: 1.5, unit: 's', digits: 2, why: '65 ms of the fuses and 0.3 s of the firmware; a loader that waits adds seconds, one that loops never ends' }),
      measure: async (b) => {
        await b.person.action(b.id, 'The board is restarted by command.');
        const { silent_s, text } = await restart(b, () => b.board.mustAccept(kReboot, [1], 'restart'), 10_000);
        return { value: silent_s, note: text };
      },
      apm1: { title: 'silent over a restart by command',
        limit: within({ high: 0.5, unit: 's', digits: 2, why: '0.3 s of the firmware, which begins again at address 0; the loader has no part in it (docs/restart.md)' }),
        failed: 'The loader came in between, or the board was reset: is this the image of an APM 1?' },
      failed: 'The loader does not leave a watchdog\'s reset at once: a restart in the air would last as long. Replace it (docs/flashing.md).' },
    { id: '2.button', title: 'silent over a reset by the button, without USB',
      limit: within({ high: 5, unit: 's', digits: 2, why: 'a brown-out in the air costs the same; 1.5 s with the loader of the APM 2; less 0.3 s it is BRD_LOADER_MS' }),
      measure: async (b) => {
        const { silent_s, text } = await restart(b, () => b.person.action(b.id,
          'Connected through the telemetry socket and without USB, press Enter, then the reset button.'));
        return { value: silent_s, note: text };
      },
      apm1: { limit: within({ high: 5, unit: 's', digits: 2, why: 'a brown-out in the air costs the same; 1.4 s with the usual loader; less 0.3 s it is BRD_LOADER_MS' }) } },
  ],
};

async function flashed(b, image) {
  const { flash: simulated } = b.options;
  const status = await runTool(b, 'flash', ['--board', image], simulated && ((path) => simulated(path, image)));
  return { ok: status === 0, note: `toolchain/flash ended with status ${status}` };
}
const flashes = (id, title, which) => ({
  id, title, limit: holds('written and verified', 'avrdude reads everything back'),
  measure: async (b) => {
    await b.person.action(b.id, 'The image is written through the bootloader. Power by USB, nothing on the telemetry socket.');
    return flashed(b, which(b.options.board));
  },
});
const other = (board) => (board === 'apm1' ? 'apm2' : 'apm1');

export const flash = {
  number: 3, title: 'Flashing over USB', tools: 'the USB cable that goes to the field',
  failed: 'docs/flashing.md, "When it does not work".',
  parts: [
    flashes('3.flash', 'image written', (board) => board),
    { id: '3.dtr', title: 'opening the port resets the board', limit: holds('it restarts', 'its USB chip pulls RESET by DTR'),
      measure: async (b) => {
        if (!b.board.port.canReset) throw new NotDone('TCP has no DTR');
        const { text, silent_s } = await restart(b, async () => { b.board.port.pause(); await b.board.port.resume(); }, 15_000);
        return { ok: true, note: `${text}; silent for ${silent_s.toFixed(1)} s` };
      } },
  ],
};

export const wrongImage = {
  number: 4, title: 'The other board\'s image', tools: 'an oscilloscope or a logic analyser',
  failed: 'The image would drive a motor from an aileron\'s output: do not use this board.',
  parts: [
    { id: '4.flash', title: 'the wrong image is on the board', limit: holds('written', 'the chips are the same, nothing prevents it'),
      measure: async (b) => {
        if (b.board.port.canReset) return flashes('', '', other).measure(b);
        await b.person.action(b.id, `Put the image of ${other(b.options.board)} on the board and start it.`);
        return { ok: true, note: 'by hand' };
      } },
    { id: '4.text', title: 'it reports the wrong board', limit: holds('"Wrong board" within 12 s', 'docs/preflight.md: every 5 s over USB'),
      measure: async ({ board }) => {
        const text = await board.text(kWrong, 12_000);
        return { ok: text !== undefined, note: text ?? 'no such text' };
      } },
    { id: '4.arming', title: 'the checks before arming fail', limit: holds('the checks fail', 'docs/preflight.md'),
      measure: async ({ board }) => {
        const result = await board.command(kPrearm);
        return { ok: result === 4, note: `result ${result}` };
      } },
    { id: '4.outputs', title: 'outputs with pulses', limit: within({ low: 0, high: 0, unit: '', digits: 0, why: 'no output is driven before the board is known' }),
      measure: meter('Look at outputs 1 to 8 one after the other. How many have pulses?', { unit: 'outputs', low: 0, high: 8 }) },
    { id: '4.back', title: 'the right image is on the board again', limit: holds('no "Wrong board" within 12 s', 'docs/preflight.md'),
      measure: async (b) => {
        if (b.board.port.canReset) await flashes('', '', (board) => board).measure(b);
        else await b.person.action(b.id, `Put the image of ${b.options.board} back and start it.`);
        const text = await b.board.text(kWrong, 12_000);
        return { ok: text === undefined && b.board.now_ms() - b.board.heard_ms < 3000, note: text ?? 'none' };
      } },
  ],
};
