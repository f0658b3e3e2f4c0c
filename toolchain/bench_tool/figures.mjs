// SPDX-License-Identifier: GPL-3.0-or-later
// What is calculated of readings.
const kGravity_mss = 9.80665, kGas = 287.05, kKelvin = 273.15;
const kDegrees = 180 / Math.PI;

export const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

export function deviation(values) {
  const middle = mean(values);
  return Math.sqrt(mean(values.map((value) => (value - middle) ** 2)));
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

// Readings farther than `step` from the median of the five around them.
export function singleDips(values, step) {
  return values.filter((value, i) => {
    const around = values.slice(Math.max(0, i - 2), i + 3);
    return around.length === 5 && Math.abs(value - median(around)) > step;
  });
}

// Metres from one pressure up to another, both in Pa, in air of this temperature.
export const climb_m = (from_pa, to_pa, temperature_c) =>
  kGas * (temperature_c + kKelvin) / kGravity_mss * Math.log(from_pa / to_pa);

// -180..180
export const wrapped_deg = (angle_deg) => ((angle_deg % 360) + 540) % 360 - 180;

// Where the nose points from magnetic north, of the field in body axes and the attitude, as a
// tilt-compensated compass does. 0..360
export function heading_deg({ x, y, z }, roll_rad, pitch_rad) {
  const forward = x * Math.cos(pitch_rad) + Math.sin(pitch_rad) * (y * Math.sin(roll_rad) + z * Math.cos(roll_rad));
  const right = y * Math.cos(roll_rad) - z * Math.sin(roll_rad);
  return (Math.atan2(-right, forward) * kDegrees + 360) % 360;
}

export const degrees = (rad) => rad * kDegrees;
export const percentOff = (value, of) => 100 * (value - of) / of;
