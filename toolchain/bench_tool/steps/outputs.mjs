// SPDX-License-Identifier: GPL-3.0-or-later
// Step 11: the servo outputs, and the only place but step 15 where the motor's output may rise.
import { NotMeasured } from '../errors.mjs';
import { median } from '../figures.mjs';
import { within } from '../limits.mjs';
import { field, firmwareHasOutputs, restart } from './readings.mjs';

const kReboot = 246, kSetServo = 183, kSetMode = 176, kManual = 0;
const kMotor = 3, kSafe_us = 1100, kSettle_ms = 700, kRestarts = 10;
const kWidth_us = { unit: 'us', low: 500, high: 3000 };
const kMiddle = [1500, 1500, 1000, 1500];

export const outputNow_us = async (board, output) =>
  median(field(await board.collect('SERVO_OUTPUT_RAW', 600, 20), `servo${output}Raw`));

// What the oscilloscope reads, against what the board reports to send.
async function compared({ board, person }, id, output, wanted_us) {
  await board.wait(kSettle_ms);
  const sent_us = await outputNow_us(board, output);
  if (Math.abs(sent_us - wanted_us) > 60)
    throw new NotMeasured(`output ${output} is at ${sent_us} us instead of about ${wanted_us}: its range, reversal or function`);
  const read_us = await person.number(`${id}.${wanted_us}`, `Output ${output}, about ${wanted_us} us: measure the pulse.`, kWidth_us);
  return { read_us, sent_us, off_us: read_us - sent_us };
}
const worstOf = (all) => {
  const worst = all.reduce((a, b) => (Math.abs(b.off_us) > Math.abs(a.off_us) ? b : a));
  return { value: worst.off_us, note: all.map(({ read_us, sent_us }) => `${read_us}/${sent_us}`).join(', ') };
};
const kExact = { low: -1, high: 1, unit: 'us', why: 'the timers count half microseconds; read over sent' };

// The whole range for the time of the part; Safety restores what it was.
async function widen({ safety }, output) {
  await safety.change(`RC${output}_MIN`, 1000);
  await safety.change(`RC${output}_MAX`, 2000);
}

// Outputs 1, 2 and 4 follow the sticks in MANUAL, which the ground station holds.
const stickOutput = (output) => ({
  id: `11.output_${output}`, title: `output ${output}: read against sent`, limit: within(kExact),
  measure: async (b) => {
    await firmwareHasOutputs(b);
    await b.person.action(b.id, `The oscilloscope at output ${output}. This program holds the sticks meanwhile: switch the transmitter off.`);
    await widen(b, output);
    await b.safety.change('ARMING_RUDDER', 0);  // full right rudder and a closed throttle would arm
    await b.board.mustAccept(kSetMode, [1, kManual], 'mode MANUAL');
    const all = [];
    for (const wanted_us of [1000, 1500, 2000]) {
      const sticks = [...kMiddle];
      sticks[output - 1] = wanted_us;
      b.safety.hold(sticks);
      all.push(await compared(b, b.id, output, wanted_us));
    }
    return worstOf(all);
  },
  failed: 'RCn_TRIM, RCn_REV and ELEVON_OUTPUT at their defaults? Else the chip\'s crystal: compare it by the 50 Hz.',
});
// Outputs 5 to 8 go where a command sends them, while RCn_FUNCTION is 0.
const commandOutput = (output) => ({
  id: `11.output_${output}`, title: `output ${output}: read against sent`, limit: within(kExact),
  measure: async (b) => {
    await b.person.action(b.id, `The oscilloscope at output ${output}.`);
    const all = [];
    for (const wanted_us of [1000, 1500, 2000]) {
      await b.board.mustAccept(kSetServo, [output, wanted_us], `output ${output} to ${wanted_us} us`);
      all.push(await compared(b, b.id, output, wanted_us));
    }
    await b.board.mustAccept(kSetServo, [output, 1500], `output ${output} to its middle`);
    return worstOf(all);
  },
});

const period = (output, only) => ({
  id: `11.rate_${output}`, only, title: `output ${output}: rate`,
  limit: within({ low: 49.75, high: 50.25, unit: 'Hz', digits: 2, why: '0.5 %, the board\'s resonator' }),
  measure: async (b) => {
    await firmwareHasOutputs(b);
    return b.person.number(b.id, `The oscilloscope at output ${output}: read the rate of its pulses.`, { unit: 'Hz', low: 1, high: 1000 });
  },
});

async function highest_us(board, output, time_ms) {
  return Math.max(...field(await board.collect('SERVO_OUTPUT_RAW', time_ms, 20), `servo${output}Raw`));
}
const disarmed = (id, title, instruction) => ({
  id, title, limit: within({ high: kSafe_us, unit: 'us', digits: 0, why: 'docs/preflight.md: never above 1,100 us while disarmed' }),
  measure: async (b) => {
    await firmwareHasOutputs(b);
    await b.person.action(b.id, instruction);
    return highest_us(b.board, kMotor, 5000);
  },
  failed: 'RC3_MIN and RC3_REV; take the power away before anything else.',
});

// Watchdog, USB and button while somebody looks at the longest pulse.
const longest = {
  id: '11.longest', title: 'longest pulse over restarts', limit: within({ high: 2300, unit: 'us', digits: 0, why: 'a pulse cut short or merged is a servo at its stop' }),
  measure: async (b) => {
    await firmwareHasOutputs(b);
    await b.person.action(b.id, 'The oscilloscope at output 1 keeps the longest pulse (infinite persistence, or a trigger on pulses ' +
      `above 2300 us). ${kRestarts} restarts by command follow.`);
    for (let i = 0; i < kRestarts; ++i) {
      await restart(b, () => b.board.mustAccept(kReboot, [1], 'restart'), 10_000);
      await b.board.wait(1000);
    }
    await b.person.action(`${b.id}.usb`, 'Press the reset button five times, and plug USB in and out five times.');
    return b.person.number(`${b.id}.read`, 'The longest pulse that was seen:', { unit: 'us', low: 500, high: 30_000 });
  },
};

const motor = {
  id: '11.motor', title: `output ${kMotor}, armed: read against sent`, limit: within(kExact),
  measure: async (b) => {
    await firmwareHasOutputs(b);
    await b.safety.confirmed('11.motor');
    const low_us = await b.board.parameter('RC3_MIN'), high_us = await b.board.parameter('RC3_MAX');
    b.safety.hold([1500, 1500, low_us, 1500]);
    await b.board.wait(kSettle_ms);
    await b.safety.arm('11.motor');
    const all = [];
    for (const wanted_us of [low_us, Math.round((low_us + high_us) / 2), high_us, low_us]) {
      b.safety.hold([1500, 1500, wanted_us, 1500]);
      all.push(await compared(b, b.id, kMotor, wanted_us));
    }
    await b.safety.disarm();
    const after_us = await highest_us(b.board, kMotor, 2000);
    const result = worstOf(all);
    return { ...result, ok: after_us <= kSafe_us, note: `${result.note}; disarmed ${after_us} (limit ${kSafe_us})` };
  },
};

export const outputs = {
  number: 11, title: 'Servo outputs', tools: 'an oscilloscope; for the last part a speed controller with its motor fixed, PROPELLER OFF',
  failed: 'Compare with another output and another probe first.',
  apm1: { note: 'Hold channel 8 below 1600 us all the time: above 1800 us the receiver has outputs 1 to 4, the motor\'s too, armed or not.' },
  parts: [
    disarmed('11.disarmed', 'motor\'s output while disarmed', 'The board lies still and disarmed, the transmitter\'s throttle up.'),
    period(1), period(4), period(6), period(8, 'apm1'),  // one of each timer
    ...[1, 2, 4].map(stickOutput), ...[5, 6, 7, 8].map(commandOutput),
    longest,
    disarmed('11.controller', 'motor\'s output with the speed controller plugged in', 'Plug the speed controller in, its motor without a propeller, ' +
      'and switch it on: the motor has to stand (else answer: fail).'),
    motor,
  ],
};
