// SPDX-License-Identifier: GPL-3.0-or-later
// Steps 1, 5, 6 and 7: what the board draws, how it starts, how much time it needs, and whether it
// knows its own supply.
import { NotDone, NotMeasured } from '../errors.mjs';
import { mean, percentOff } from '../figures.mjs';
import { holds, within } from '../limits.mjs';
import { kLoadReference_pct } from '../reference.mjs';
import { coldStart, field, meter, restart } from './readings.mjs';

const kVolts = { unit: 'V', low: 0, high: 20 };
const rail = (id, title, volts, where) => ({
  id, title,
  limit: within({ low: Number((volts * 0.97).toFixed(2)), high: Number((volts * 1.03).toFixed(2)), unit: 'V', digits: 2,
    why: 'the regulators\' 2 % and a meter\'s 1 %' }),
  measure: meter(`Measure ${where} against ground.`, kVolts),
});

// No measurement of such a board is published. Data sheets, supply currents typical and at most, mA: ATmega2560 at 16 MHz
// and 5 V 20 and 28, of which Idle takes a third; ATmega328P 10 and 18; FT232RL 15; gyros IDG-500 and ISZ-500 12; the
// other sensors 3; AT45DB161D 0.03 in standby, 15 when written; lamps up to 20 each, of which five may be on.
const kApm1Parts = 'data sheets of its parts: 40 mA with the chip in Idle and one lamp, at most 100, and five lamps of 20; ' +
  'a short takes more, a dead part less';

export const supply = {
  number: 1, title: 'Supply', tools: 'a supply of 5.0 V with a current limit of 0.5 A, a multimeter',
  failed: 'Off at once. Too much current or a rail too low is a short or a broken regulator: look for a warm part.',
  parts: [
    { id: '1.current', title: 'current, nothing plugged in',
      limit: within({ low: 150, high: 300, unit: 'mA', digits: 0, why: 'chip, sensors and lamps; a short takes more, a dead part less' }),
      apm1: { limit: within({ low: 40, high: 200, unit: 'mA', digits: 0, why: kApm1Parts }) },
      measure: meter('Unplug receiver, GPS, radio and servos. Set 5.0 V at the outputs\' rail and read the current. USB is a ' +
        'second supply: read it where nothing but this one feeds the board.', { unit: 'mA', low: 0, high: 3000 }) },
    rail('1.rail_5v', '5 V rail', 5, 'the 5 V of an input\'s connector'),
    { ...rail('1.rail_3v3', '3.3 V rail', 3.3, 'the 3.3 V of the I2C or GPS connector, of the regulator where there is none'),
      failed: 'On early APM 2.5 this regulator dies of a GPS or radio plugged in under power: the board must not fly.',
      apm1: { failed: 'Gyros, accelerometers and pitot are measured against this rail: all of them are wrong with it.' } },
  ],
};

const kSampleWithin_s = 1, kReadyWithin_s = 5;
const starts = (id, title, count, how) => ({
  id, title: `${count} ${title}`,
  limit: within({ high: 1, unit: 's', digits: 2, why: '0.3 s of the firmware (docs/restart.md), the rest is the sensors\' own start' }),
  measure: async (b) => {
    const all = [];
    for (let i = 1; i <= count; ++i) {
      const begin = () => b.person.action(b.id, `Start ${i} of ${count}: press Enter, then ${how}. Keep the board still.`);
      const start = await coldStart(b, begin).catch((error) => {
        if (error instanceof NotDone) throw new NotDone(`${all.length} of ${count} starts were made`);
        if (error instanceof NotMeasured) throw new NotMeasured(`start ${i} of ${count}: ${error.message}`);
        throw error;
      });
      all.push(start);
      b.print(`  heartbeat ${start.beat_s.toFixed(2)} s, sample ${start.sample_s.toFixed(2)} s, gyros ready ${start.ready_s.toFixed(1)} s`);
    }
    const worst = (key) => Math.max(...all.map((each) => each[key]));
    return { value: worst('beat_s'), ok: worst('sample_s') <= kSampleWithin_s && worst('ready_s') <= kReadyWithin_s,
      note: `slowest of ${count}; inertial sample ${worst('sample_s').toFixed(2)} s (limit ${kSampleWithin_s}), ` +
        `gyros ready ${worst('ready_s').toFixed(1)} s (limit ${kReadyWithin_s})` };
  },
});

export const coldStarts = {
  number: 5, title: 'Cold starts', tools: 'a switch in the supply; a supply that can rise slowly',
  failed: 'Note the number of the start. One start of twenty that fails is a board that will fail in the field.',
  parts: [
    starts('5.quick', 'starts by a switch', 20, 'take the power away for two seconds and give it back (USB feeds the board too: ' +
      'connect through the telemetry socket, or pull the USB cable)'),
    starts('5.slow', 'starts on a slow ramp', 5, 'turn the supply down to 0 and up to 5.0 V within about two seconds'),
  ],
};

export const load = {
  number: 6, title: 'Processor load', tools: 'nothing',
  failed: 'More than in the simulator: something interrupts the chip that nobody asked for (the ADC in sleep, a floating input).',
  parts: [{
    id: '6.load', title: 'load above the simulator\'s, standing still',
    limit: within({ low: -2, high: 2, unit: '%', why: 'of the frames\' time; the simulator counts the same image\'s cycles' }),
    measure: async ({ board, person, options, id }) => {
      await person.action(id, 'Leave the board still and disarmed, receiver and GPS plugged in.');
      const load_pct = mean(field(await board.collect('SYS_STATUS', 10_000, 2), 'load')) / 10;
      const reference_pct = kLoadReference_pct[options.board];
      return { value: load_pct - reference_pct, note: `${load_pct.toFixed(1)} %, simulator ${reference_pct.toFixed(1)} %` };
    },
  }],
};

const volts = (set_v) => ({
  id: `7.at_${set_v.toFixed(1)}`, title: `board voltage at ${set_v.toFixed(1)} V`,
  limit: within({ low: -5, high: 5, unit: '%', why: 'the chip\'s band gap is 1.0 to 1.2 V (ATmega2560 data sheet 31.5); beyond 5 % brown-outs are missed' }),
  measure: async ({ board, person, id }) => {
    const true_v = await person.number(id, `Set the supply to ${set_v.toFixed(1)} V (USB's 5 V disconnected), measure the 5 V rail.`, kVolts);
    const board_v = mean(field(await board.collect('POWER_STATUS', 3000, 4), 'Vcc')) / 1000;
    return { value: percentOff(board_v, true_v), note: `board ${board_v.toFixed(2)} V, meter ${true_v.toFixed(2)} V` };
  },
});
const cause = (id, title, what, expected, instruction) => ({
  id, title, limit: holds(what, 'docs/restart.md: the supply decides between brown-out and button'),
  measure: async (b) => {
    const { text } = await restart(b, () => b.person.action(b.id, `${instruction} Press Enter first.`));
    return { ok: expected.test(text), note: text };
  },
});

export const supplyMeasured = {
  number: 7, title: 'The board\'s own voltmeter', tools: 'an adjustable supply, a multimeter',
  failed: 'The reference of this chip is off: check it against a second meter. A brown-out in flight would be misread.',
  parts: [volts(4.6), volts(5.0), volts(5.4),
    cause('7.brown_out', 'a brown-out is known', 'reported as brown-out', /^Restarted after a brown-out/,
      'Let the supply dip to 4.0 V for 0.3 s, and press the reset button within it.'),
    cause('7.button', 'a button at 4.6 V is none', 'not reported as brown-out', /^Started by/,
      'Set 4.6 V and press the reset button.')],
};
