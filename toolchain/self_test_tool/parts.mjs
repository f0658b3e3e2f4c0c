// SPDX-License-Identifier: GPL-3.0-or-later
// What a board's self-test must come to. A part has a title, the line of the report it is in, which
// figures of the line count, the limit all of them keep to, and what to do when one does not. Parts of a
// `group` are one row of the bench's form.
import { kFail, kPass, within } from '../bench_tool/limits.mjs';

export const kMissing = 'missing';
const kOutputs = [1, 2, 3, 4, 5, 6, 7, 8], kWidths_us = [800, 900, 1000];

const none = (unit, why) => within({ low: 0, high: 0, unit, digits: 0, why });
const count = (low, why) => within({ low, unit: '', digits: 0, why });

const inGroup = (group, parts) => parts.map((part) => ({ group, ...part }));
const kBus = 'A bad joint, a part that dies, or a bus that something else holds: the board must not fly.';
const kPins = 'The output\'s pin does not follow its timer: do not use this output, or the board.';

const inertial = [
  { title: 'inertial sensor: samples in 10 s', line: 'inertial', figures: ['samples'],
    limit: count(1950, 'one each 5 ms'), failed: kBus },
  { title: 'inertial sensor: bad reads and restarts', line: 'inertial', figures: ['bad', 'restarts'], limit: none('', 'none in 10 s'), failed: kBus },
];
const barometer = [
  { title: 'barometer: readings in 10 s', line: 'barometer', figures: ['readings'],
    limit: count(150, 'the slower of both boards\' barometers reads some 40 a second'), failed: kBus },
  { title: 'barometer: bad reads and restarts', line: 'barometer', figures: ['bad', 'restarts'], limit: none('', 'none in 10 s'), failed: kBus },
];
const compass = [
  { title: 'compass: answers of 100', line: 'compass', figures: ['right'],
    limit: within({ low: 100, high: 100, unit: '', digits: 0, why: 'its three bytes of identification, over I2C' }),
    failed: 'No compass, a bad cable, or pull-ups too weak for its length (docs/boards.md).' },
];

const outputs = kOutputs.flatMap((output) => [
  { title: `output ${output}: pulses off what was asked`, failed: kPins, limit: within({ low: -2, high: 2, unit: 'us', why: '1.5 us is how well the program sees an edge' }),
    lines: kWidths_us.map((width_us) => ({ line: `pulse ${output} asked ${width_us}`, figures: ['least', 'most'], less: width_us })) },
  { title: `output ${output}: period`, line: `period ${output}`, figures: ['least', 'most'], failed: kPins,
    limit: within({ low: 19900, high: 20100, unit: 'us', why: '50 a second, and 0.5 % of the crystal' }) },
]);

const eeprom = [
  { title: 'EEPROM: bad cells', line: 'eeprom', figures: ['bad'], limit: none('', 'four patterns read back'),
    failed: 'Cells are worn: parameters may change by themselves. The board must not fly.' },
  { title: 'EEPROM: cells tried', line: 'eeprom', figures: ['cells'], limit: count(4, 'what the firmware\'s map leaves free') },
];
const dataflash = [
  { title: 'DataFlash: bad bytes', line: 'dataflash', figures: ['bad'], limit: none('', 'four patterns read back'),
    failed: 'Logs and uploaded missions pass through them: a bad joint or chip.' },
  { title: 'DataFlash: pages', line: 'dataflash', figures: ['pages'], limit: count(4096, 'AT45DB161D has 4096, AT45DB321D 8192; 0: no chip answers'),
    failed: 'No chip: the board flies with LOG_BITMASK 0 only, and without logs.' },
];
const ram = [
  { title: 'RAM: bad bytes', line: 'ram', figures: ['bad'], limit: none('', 'two patterns read back'), failed: 'The processor is damaged.' },
  { title: 'RAM: bytes tried', line: 'ram', figures: ['bytes'], limit: count(2000, 'of 8192; the program has the rest') },
];

const supply = [
  { title: 'supply', line: 'supply', figures: ['mV least', 'most'], scale: 0.001, limit: within({ low: 4.3, high: 5.7, unit: 'V', digits: 2,
    why: 'USB\'s 4.75 to 5.25 V, seen by a band gap of 1.0 to 1.2 V (data sheet 31.8)' }),
    failed: 'Measure the 5 V rail: a cable or a regulator is bad.' },
];
const interrupts = [
  { title: 'held up by interrupts', line: 'interrupted', figures: ['us'], limit: within({ high: 150, unit: 'us', why: '40 us each, and three may come at once' }),
    failed: 'Something interrupts the processor that should not: noise on a receive or data-ready line.' },
];
const watchdog = [
  { title: 'silent over a restart by the watchdog', line: 'restart', figures: ['s'],
    limit: within({ high: 1.5, unit: 's', digits: 2, why: 'it bites after 0.125 s; the program waits 0.5 s before it speaks' }),
    failed: 'A program that hangs in the air would not begin again: replace the bootloader (docs/flashing.md).' },
];

export const kParts = [
  ...inGroup('supply', supply), ...inGroup('longest interrupt', interrupts), ...inGroup('inertial sensor', inertial),
  ...inGroup('barometer', barometer), ...inGroup('compass', compass), ...inGroup('PWM of outputs 1 to 8', outputs),
  ...inGroup('EEPROM', eeprom), ...inGroup('DataFlash', dataflash), ...inGroup('RAM', ram), ...inGroup('watchdog', watchdog),
];

// Every figure that a part needs, in its unit; undefined when one is missing.
function valuesOf({ line, figures, lines = [{ line, figures }], scale = 1 }, report) {
  const values = lines.flatMap(({ line: name, figures: wanted, less = 0 }) =>
    wanted.map((figure) => report.figures.get(name)?.[figure] * scale - less));
  return values.every(Number.isFinite) ? values : undefined;
}

export function shown(values, limit) {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return least === most ? limit.show(least) : `${limit.show(least)} to ${limit.show(most)}`;
}

// Each part with its verdict: pass, fail or missing.
export function verdicts(report) {
  return kParts.map((part) => {
    const values = valuesOf(part, report);
    if (values === undefined) return { ...part, verdict: kMissing, measured: 'not in the report' };
    return { ...part, values, measured: shown(values, part.limit), verdict: values.every(part.limit.has) ? kPass : kFail };
  });
}
