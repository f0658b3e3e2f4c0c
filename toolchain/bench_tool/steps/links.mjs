// SPDX-License-Identifier: GPL-3.0-or-later
// Steps 12 and 13: receiver, GPS, telemetry.
import { Board } from '../board.mjs';
import { NotDone, NotMeasured } from '../errors.mjs';
import { deviation, mean } from '../figures.mjs';
import { holds, within } from '../limits.mjs';
import { openPort } from '../port.mjs';
import { field } from './readings.mjs';

const kReceiver = 0x10000;  // MAV_SYS_STATUS_SENSOR_RC_RECEIVER
const kThrottle = 3, kLow_us = 975;

const channel = (number) => ({
  id: `12.channel_${number}`, title: `channel ${number}: board against generator`,
  limit: within({ low: -2, high: 2, unit: 'us', why: 'the encoder counts 0.5 us and times by interrupts' }),
  measure: async ({ board, person, id }) => {
    const true_us = await person.number(id, `A servo tester at input ${number} (the receiver's output through a counter does as well): its pulse.`,
      { unit: 'us', low: 900, high: 2100 });
    const values = field(await board.collect('RC_CHANNELS', 3000, 20), `chan${number}Raw`);
    return { value: mean(values) - true_us, note: `${mean(values).toFixed(1)} us, jitter ${deviation(values).toFixed(1)}` };
  },
});

// A lost receiver: unhealthy, or the encoder's failsafe values with the throttle low.
async function lost({ board }, within_ms) {
  await board.rate('SYS_STATUS', 10);
  await board.rate('RC_CHANNELS', 10);
  let how;
  const listener = ({ name, data }) => {
    if (name === 'SYS_STATUS' && !(data.onboardControlSensorsHealth & kReceiver)) how ??= 'the receiver counts as lost';
    if (name === 'RC_CHANNELS' && data[`chan${kThrottle}Raw`] < kLow_us) how ??= `throttle at ${data[`chan${kThrottle}Raw`]} us`;
  };
  const began_ms = board.now_ms();
  if (!await board.listening(listener, () => board.until(() => how, within_ms))) throw new NotMeasured(`nothing was noticed within ${within_ms / 1000} s`);
  return { value: (board.now_ms() - began_ms) / 1000, note: how };
}
const loses = (id, title, instruction) => ({
  id, title, limit: within({ high: 10, unit: 's', digits: 1, why: 'from Enter on, so with the hand\'s time; docs/failsafes.md' }),
  measure: async (b) => {
    await b.person.action(b.id, `Throttle in the middle. Press Enter, then ${instruction}.`);
    return lost(b, 30_000);
  },
  failed: 'The receiver holds the last sticks: set its failsafe to no pulses or to throttle below 950 us.',
});

export const receiver = {
  number: 12, title: 'Receiver', tools: 'a servo tester with a display, or the transmitter and a counter',
  failed: 'Wiring of that channel; the encoder\'s firmware (docs/boards.md).',
  apm1: { note: 'Unplug the speed controller: above 1800 us of channel 8 input 3 goes straight to output 3, armed or not.' },
  parts: [
    ...[1, 2, 3, 4, 5, 6, 7, 8].map(channel),
    loses('12.off', 'transmitter off is noticed', 'switch the transmitter off'),
    { id: '12.on', title: 'transmitter on again', limit: holds('healthy within 10 s', 'docs/failsafes.md'),
      measure: async ({ board, person, id }) => {
        await person.action(id, 'Switch the transmitter on again, throttle in the middle.');
        await board.rate('SYS_STATUS', 10);
        await board.rate('RC_CHANNELS', 10);
        let good, throttle_us = 0;
        await board.listening(({ name, data }) => {
          if (name === 'SYS_STATUS') good = (data.onboardControlSensorsHealth & kReceiver) !== 0;
          if (name === 'RC_CHANNELS') throttle_us = data[`chan${kThrottle}Raw`];
        }, () => board.until(() => good && throttle_us > kLow_us, 10_000));
        return { ok: good === true && throttle_us > kLow_us, note: `throttle ${throttle_us} us` };
      } },
    loses('12.unplugged', 'a receiver that is unplugged is noticed', 'unplug the receiver'),
    { id: '12.ppm', title: 'PPM-sum passed through', limit: holds('eight channels in their order', 'docs/boards.md'),
      measure: async ({ board, person, id }) => {
        await person.action(id, 'PPM-sum at input 1, inputs 2 and 3 bridged, power off and on (no such receiver: none). Move the sticks to their middles.');
        const last = (await board.collect('RC_CHANNELS', 2000, 10)).at(-1).data;
        const widths = [1, 2, 3, 4, 5, 6, 7, 8].map((number) => last[`chan${number}Raw`]);
        return { ok: widths.every((width) => width >= 900 && width <= 2100), note: widths.join(' ') };
      } },
  ],
};

const kFound = /^GPS: .+ at \d+/;
const found = (id, baud) => ({
  id, title: `GPS that talks at ${baud} baud`, limit: within({ high: 20, unit: 's', digits: 1, why: 'all rates together take 9.4 s (docs/boards.md)' }),
  measure: async ({ board, person, id: question }) => {
    const since_ms = board.now_ms();
    await person.action(question, `Plug a GPS in that talks at ${baud} baud at power-on (u-center, "Revert to default" for 9600), and press Enter.`);
    const from_ms = board.now_ms();
    const text = await board.text(kFound, 25_000, since_ms);
    if (!text) throw new NotMeasured('no "GPS: ..." within 25 s');
    const fix = (await board.collect('GPS_RAW_INT', 1500, 4)).at(-1).data;
    return { value: Math.max(0, board.texts.findLast((each) => kFound.test(each.text)).at_ms - from_ms) / 1000,
      note: `${text}, fix ${fix.fixType}, ${fix.satellitesVisible} satellites` };
  },
  failed: 'TX and RX crossed? Its lamp? docs/boards.md, "The GPS".',
});

// The radio's port, for as long as `body` needs it.
async function withTelemetry({ board, options }, body) {
  if (!options.telemetry) throw new NotDone('needs --telemetry PORT');
  const port = await (options.openTelemetry ?? openPort)(options.telemetry);
  const radio = new Board(port, board.clock);
  try {
    return await body(radio);
  } finally {
    port.close();
  }
}

const kMinute_ms = 60_000, kUsbChanges = 4;

export const links = {
  number: 13, title: 'GPS and telemetry', tools: 'the GPS, the telemetry radio pair on a second port of this computer',
  failed: 'docs/boards.md, "Telemetry": rate on both sides, the jumper under the board.',
  apm1: { failed: 'docs/boards.md, "Telemetry": rate on both sides, TX to RX and RX to TX.' },
  parts: [
    found('13.gps_9600', 9600), found('13.gps_38400', 38_400),
    { id: '13.loss', title: 'frames lost by the radio in a minute',
      limit: within({ high: 0, unit: 'frames', digits: 0, why: 'at 1 m nothing gets lost but by a wrong rate or a full buffer' }),
      measure: async (b) => {
        await b.person.action(b.id, 'Both radios on, a metre apart.');
        return withTelemetry(b, async (radio) => {
          if (!await radio.next('HEARTBEAT', { within_ms: 5000 })) throw new NotMeasured('no heartbeat by the radio');
          radio.lost = radio.received = 0;
          await radio.wait(kMinute_ms);
          return { value: radio.lost, ok: radio.received >= 55, note: `of ${radio.received}` };
        });
      } },
    { id: '13.usb', title: 'telemetry while USB is plugged and pulled',
      limit: within({ high: 3, unit: 's', digits: 1, why: 'longest time without a heartbeat; the port changes its rate within 0.1 s' }),
      apm1: { limit: within({ high: 3, unit: 's', digits: 1, why: 'longest time without a heartbeat; the radio has a port of its own' }),
        failed: 'Nothing but the supply joins this port and USB: look at the 5 V while USB goes.' },
      measure: async (b) => withTelemetry(b, async (radio) => {
        let last_ms = radio.now_ms(), longest_ms = 0;
        const listener = ({ name, at_ms }) => {
          if (name !== 'HEARTBEAT') return;
          longest_ms = Math.max(longest_ms, at_ms - last_ms);
          last_ms = at_ms;
        };
        return radio.listening(listener, async () => {
          for (let i = 1; i <= kUsbChanges; ++i) {
            await b.person.action(`${b.id}_${i}`, i % 2 === 1 ? 'Pull USB out (the board is fed by its own supply).' : 'Plug USB in.');
            await radio.wait(4000);
          }
          return { value: Math.max(longest_ms, radio.now_ms() - last_ms) / 1000 };
        });
      }),
      failed: 'With the factory\'s wiring USB and telemetry share one port: the radio is silent while USB is in. docs/boards.md.' },
  ],
};
