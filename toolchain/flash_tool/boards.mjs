// SPDX-License-Identifier: GPL-3.0-or-later
// What avrdude must know of a board. Both carry an ATmega2560 whose bootloader speaks STK500v2 at
// 115,200 baud; avrdude's "wiring" is that protocol with the reset through DTR before it.
const kAtmega2560 = { chip: 'ATmega2560', part: 'm2560', programmer: 'wiring', baud: 115200 };

export const boards = {
  apm1: { name: 'APM 1', folder: 'apm1', ...kAtmega2560 },
  apm2: { name: 'APM 2', folder: 'apm2', ...kAtmega2560 },
};

export const kBootloader = 0x3e000;  // the top 8 KiB of flash, HFUSE 0xD8
export const kEepromSize = 4096;
