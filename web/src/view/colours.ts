// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of modes, and of heights from low to high.
import { colour } from '../dom';

// By what flies: the autopilot on its mission, on its own, with the pilot, the pilot alone.
const kModes: Record<string, number> = {
  AUTO: 0, TAKEOFF: 0, AUTOLAND: 0, FBWA: 1, FBWB: 1, CRUISE: 1, LOITER: 3, CIRCLE: 3, GUIDED: 4, RTL: 5, AUTOTUNE: 2,
  STABILIZE: 2, TRAINING: 2, ACRO: 2, MANUAL: 6, INITIALISING: 6,
};

export const modeColour = (mode: string): string => colour(`m${kModes[mode] ?? 6}`);

export const kRamp = ['#3b4cc0', '#3f7fd8', '#2fa5c7', '#2bb58a', '#7bbf4a', '#c9b832', '#ef9632', '#e8602c', '#c9252b'];

export const rampColour = (share: number): string =>
  kRamp[Math.min(Math.max(Math.floor(share * kRamp.length), 0), kRamp.length - 1)];
