// SPDX-License-Identifier: GPL-3.0-or-later
// What a good APM 2 says.
const kOutputs = [1, 2, 3, 4, 5, 6, 7, 8];

export const kBegin = ['self test of APM 2', 'started by external'];
export const kLines = [
  'supply mV least 4987 most 5004 readings 200',
  'interrupted us 53.5',
  'inertial samples 2000 bad 0 restarts 0',
  'barometer readings 800 bad 0 restarts 0',
  'compass asked 100 right 100',
  ...kOutputs.flatMap((output) => [
    `pulse ${output} asked 800 least 799.5 most 800.5`,
    `pulse ${output} asked 900 least 899.0 most 900.5`,
    `pulse ${output} asked 1000 least 1000.0 most 1001.0`,
    `period ${output} least 19999.0 most 20001.0`,
  ]),
  'eeprom cells 8 bad 0',
  'dataflash pages 8192 bytes 528 bad 0',
  'ram bytes 6336 bad 0',
];
export const kEnd = ['watchdog waits', 'self test of APM 2', 'started by watchdog', 'end'];
