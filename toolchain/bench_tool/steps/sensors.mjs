// SPDX-License-Identifier: GPL-3.0-or-later
// Steps 8, 9 and 10: inertial sensor, compass, barometer and pitot sensor.
import { NotMeasured } from '../errors.mjs';
import { climb_m, deviation, heading_deg, mean, percentOff, singleDips, wrapped_deg } from '../figures.mjs';
import { holds, within } from '../limits.mjs';
import { kAccelNoise_mg, kGyroNoise_mrads } from '../reference.mjs';
import { attitude, field } from './readings.mjs';

const kGravity_mss = 9.81, kOthers_mss = 2, kRate_mrads = 300;
const kMag = 4;  // MAV_SYS_STATUS_SENSOR_3D_MAG
const kAxes = ['x', 'y', 'z'];

async function acceleration_mss(board) {
  const samples = await board.collect('RAW_IMU', 2000, 20);
  return kAxes.map((axis) => mean(field(samples, `${axis}acc`)) * kGravity_mss / 1000);
}

// What the axis reads at rest on this side: the ground pushes up.
const side = (name, instruction, axis, sign) => ({
  id: `8.${name}`, title: `${name.replaceAll('_', ' ')}: ${kAxes[axis]}`,
  limit: within({ low: sign * kGravity_mss - 1, high: sign * kGravity_mss + 1, unit: 'm/s²', digits: 2,
    why: 'sign and axis; 1 m/s² is a hand\'s 15° and an uncalibrated sensor' }),
  measure: async ({ board, person, id }) => {
    await person.action(id, `${instruction} and hold it.`);
    const all_mss = await acceleration_mss(board);
    const others_mss = all_mss.filter((_, i) => i !== axis);
    return { value: all_mss[axis], ok: others_mss.every((each) => Math.abs(each) < kOthers_mss),
      note: `others ${others_mss.map((each) => each.toFixed(2)).join(', ')} (limit ±${kOthers_mss})` };
  },
});

const rate = (name, instruction, axis) => ({
  id: `8.${name}`, title: `${name.replaceAll('_', ' ')}: rate about ${axis}`,
  limit: within({ low: kRate_mrads, unit: 'mrad/s', digits: 0, why: 'positive: right wing down, nose up, nose right' }),
  measure: async ({ board, person, id }) => {
    await person.action(id, `Press Enter, then ${instruction} within three seconds.`);
    const samples = await board.collect('RAW_IMU', 4000, 50);
    const sums = kAxes.map((each) => mean(field(samples, `${each}gyro`)));
    const at = kAxes.indexOf(axis);
    const values = field(samples, `${axis}gyro`);
    const most = values.reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a));
    return { value: most, ok: sums.every((sum) => Math.abs(sum) <= Math.abs(sums[at])), note: 'largest; the other axes turn less' };
  },
});

export const inertial = {
  number: 8, title: 'Inertial sensor', tools: 'a right angle, hands',
  failed: 'An axis or a sign is wrong: another sensor, a board built in the wrong way round, or the other board\'s image. Do not fly.',
  apm1: { note: 'An ADXL335 is far off before it is calibrated: six sides (docs/preflight.md) first.' },
  parts: [
    side('level', 'Lay the board level', 2, -1), side('on_its_back', 'Turn it on its back', 2, 1),
    side('left_wing_down', 'Stand it on its left side', 1, 1), side('right_wing_down', 'Stand it on its right side', 1, -1),
    side('nose_down', 'Stand it on its nose', 0, -1), side('nose_up', 'Stand it on its tail', 0, 1),
    rate('roll_right', 'roll it to the right by 90°', 'x'), rate('pitch_up', 'raise its nose by 90°', 'y'),
    rate('turn_right', 'turn it, level, to the right by 90°', 'z'),
    { id: '8.noise', title: 'noise of the gyros at rest',
      limit: within({ high: 2 * kGyroNoise_mrads, unit: 'mrad/s', digits: 1, why: 'twice the simulator\'s; a broken solder joint or a supply shows here' }),
      measure: async ({ board, person, id }) => {
        await person.action(id, 'Lay it level and do not touch the table.');
        const samples = await board.collect('RAW_IMU', 10_000, 50);
        const worst = (kind) => Math.max(...kAxes.map((axis) => deviation(field(samples, `${axis}${kind}`))));
        const silent = worst('gyro') === 0 && worst('acc') === 0;
        return { value: worst('gyro'), ok: !silent && worst('acc') <= 2 * kAccelNoise_mg,
          note: silent ? 'no reading changes: the sensor is silent'
            : `accelerometers ${worst('acc').toFixed(1)} mg (limit ${2 * kAccelNoise_mg})` };
      } },
  ],
};

async function magneticHeading_deg(b) {
  const { roll_rad, pitch_rad } = await attitude(b);
  const samples = await b.board.collect('RAW_IMU', 2000, 20);
  const [x, y, z] = kAxes.map((axis) => mean(field(samples, `${axis}mag`)));
  if (Math.hypot(x, y, z) < 50) throw new NotMeasured(`the compass measures no field (${Math.hypot(x, y, z).toFixed(0)} mG)`);
  return heading_deg({ x, y, z }, roll_rad, pitch_rad);
}
const points = (name, direction, wanted_deg, how = 'level') => ({
  id: `9.${name}`, title: `nose to magnetic ${direction}, ${how}`,
  limit: within({ low: -10, high: 10, unit: '° off', why: 'a hand compass\'s 3° and what calibration leaves; a wrong side or turn is 45° and more' }),
  measure: async (b) => {
    await b.person.action(b.id, `Point the nose to magnetic ${direction} by a hand compass, ${how}; away from iron, 1 m from the bench supply.`);
    await b.board.wait(1500);
    const found_deg = await magneticHeading_deg(b);
    return { value: wrapped_deg(found_deg - wanted_deg), note: `heading ${found_deg.toFixed(0)}°` };
  },
});
const healthy = (board, bit) => async (wanted, within_ms) => {
  await board.rate('SYS_STATUS', 10);
  let now, now_ms;
  const listener = ({ name, data, at_ms }) => {
    if (name !== 'SYS_STATUS') return;
    now = (data.onboardControlSensorsHealth & bit) !== 0;
    now_ms = at_ms;
  };
  const began_ms = board.now_ms();
  const came = await board.listening(listener, () => board.until(() => now === wanted, within_ms));
  return came ? (now_ms - began_ms) / 1000 : undefined;
};

export const compass = {
  number: 9, title: 'Compass', tools: 'a hand compass, a place without iron',
  failed: 'Mirrored or turned: COMPASS_EXTERNAL and COMPASS_ORIENT (docs/boards.md). Off by a little: calibrate (docs/preflight.md).',
  parts: [
    points('north', 'north', 0), points('east', 'east', 90), points('south', 'south', 180), points('west', 'west', 270),
    points('rolled', 'north', 0, 'rolled 45° to the right'),
    { id: '9.unplug', title: 'an external compass that was unplugged is back',
      limit: within({ high: 3, unit: 's', digits: 1, why: 'the driver looks for it again each second' }),
      measure: async ({ board, person, id }) => {
        const until = healthy(board, kMag);
        await person.action(id, 'Press Enter, then unplug the compass (on the board: none).');
        if (await until(false, 30_000) === undefined) throw new NotMeasured('it is still called healthy 30 s later');
        await person.action(id, 'Plug it in again in the moment in which you press Enter.');
        const back_s = await until(true, 10_000);
        if (back_s === undefined) throw new NotMeasured('it did not come back within 10 s');
        return back_s;
      } },
  ],
};

async function pressure_pa(board) {
  const samples = await board.collect('SCALED_PRESSURE', 3000, 20);
  return { pressure_pa: 100 * mean(field(samples, 'pressAbs')), temperature_c: mean(field(samples, 'temperature')) / 100 };
}
const kDip_pa = 50, kPitot_ms = 300_000, kPitot_hz = 50;

export const air = {
  number: 10, title: 'Barometer and pitot sensor', tools: 'a ruler of 1 m, a syringe with a tube and a manometer (or a water column)',
  failed: 'docs/boards.md, "The pitot sensor"; cover the barometer with foam, keep sun and draught away.',
  apm1: { note: 'Have 5.0 V at the pitot sensor: its span follows them, the converter\'s 3.3 V do not. Above 0.8 kPa an MPXV7002DP is past the converter\'s range.' },
  parts: [
    { id: '10.lift', title: 'lifted by 1 m', limit: within({ low: 0.8, high: 1.2, unit: 'm', digits: 2, why: 'the MS5611\'s resolution is 10 cm (DA5611-01BA03)' }),
      apm1: { limit: within({ low: 0.5, high: 1.5, unit: 'm', digits: 2,
        why: 'the BMP085\'s own arithmetic is 1.5 Pa (13 cm) off, otherwise at each temperature (BST-BMP085-DS000, figure 3)' }) },
      measure: async ({ board, person, id }) => {
        await person.action(id, 'Lay the board on the table, doors and windows closed.');
        const before = await pressure_pa(board);
        await person.action(id, 'Lift it by 1.00 m and hold it there.');
        const after = await pressure_pa(board);
        return climb_m(before.pressure_pa, after.pressure_pa, before.temperature_c);
      } },
    { id: '10.dips', title: 'single readings of the pitot that stand out, in five minutes',
      limit: within({ high: 0, unit: 'readings', digits: 0, why: `farther than ${kDip_pa} Pa from the five around: 9 m/s at rest; the ADC mixes channels up` }),
      measure: async ({ board, person, id }) => {
        await person.action(id, 'Cover the pitot tube and leave it for five minutes.');
        const values_pa = field(await board.collect('SCALED_PRESSURE', kPitot_ms, kPitot_hz), 'pressDiff').map((each) => 100 * each);
        const found = singleDips(values_pa, kDip_pa);
        return { value: found.length, ok: values_pa.length > 0.9 * kPitot_ms / 1000 * kPitot_hz,
          note: `of ${values_pa.length}; mean ${mean(values_pa).toFixed(1)} Pa, noise ${deviation(values_pa).toFixed(1)} Pa` };
      } },
    { id: '10.syringe', title: 'pressure on the tube',
      limit: within({ low: -5, high: 5, unit: '%', why: 'MPXV7002DP: 2.5 % of the span; 5 % of pressure are 2.5 % of airspeed' }),
      apm1: { failed: 'The supply at the sensor is not 5.0 V? At 5.3 V 6 % too much is right (docs/boards.md, "APM 1: what to know").' },
      measure: async ({ board, person, id }) => {
        const true_pa = await person.number(id, 'Press about 500 Pa (51 mm of water) into the tube with the syringe and hold it.',
          { unit: 'Pa', low: 100, high: 2000 });
        await board.wait(1500);  // its low-pass filter
        const board_pa = 100 * mean(field(await board.collect('SCALED_PRESSURE', 2000, 20), 'pressDiff'));
        return { value: percentOff(board_pa, true_pa), note: `board ${board_pa.toFixed(0)} Pa, manometer ${true_pa.toFixed(0)} Pa` };
      } },
    { id: '10.healthy', title: 'both are healthy', limit: holds('healthy', 'SYS_STATUS'),
      measure: async ({ board }) => {
        const health = (await board.collect('SYS_STATUS', 1500, 4)).at(-1).data.onboardControlSensorsHealth;
        return { ok: (health & 8) !== 0 && (health & 16) !== 0, note: `barometer ${health & 8 ? 'yes' : 'no'}, pitot ${health & 16 ? 'yes' : 'no'}` };
      } },
  ],
};
