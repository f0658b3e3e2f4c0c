// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulator measures where a real board is compared with it. Tests hold these numbers to
// the simulator: bench.session and bench.image in toolchain/cmake/interop_tests.cmake.
export const kLoadReference_pct = { apm1: 19.6, apm2: 18.4 };

// Noise of RAW_IMU of a board that lies still, one standard deviation of the worst axis.
export const kGyroNoise_mrads = 2, kAccelNoise_mg = 5;
