// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and times as they are shown.

export function clock(time_s: number): string {
  if (!Number.isFinite(time_s)) return '–';
  const tenths = Math.round(Math.abs(time_s) * 10);
  const [minutes, rest] = [Math.floor(tenths / 600), tenths % 600];
  return `${time_s < 0 ? '−' : ''}${minutes}:${String(Math.floor(rest / 10)).padStart(2, '0')}.${rest % 10}`;
}

const kDecimals: Record<string, number> = {
  'µs': 0, '%': 1, 'mAh': 0, '°': 1, 'm': 1, 'm/s': 1, 'V': 2, 'A': 1, 's': 1, 'g': 2, 'B': 0, '': 0, '/s': 0,
};

export function shown(value: number, unit: string): string {
  if (!Number.isFinite(value)) return '–';
  return `${value.toFixed(kDecimals[unit] ?? 2)}${unit === '°' || unit === '' ? unit : ` ${unit}`}`;
}
