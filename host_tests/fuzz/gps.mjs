// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the fuzzer of the GPS driver from messages of every receiver, each for a receiver of any
// kind and for one of its own.
//   node gps.mjs PROGRAM
import { fuzz } from './libfuzzer.mjs';

function sums(bytes) {
  let a = 0, b = 0;
  for (const byte of bytes) b = (b + (a = (a + byte) & 255)) & 255;
  return [a, b];
}
function ubx(of, id, length, fill = 0) {
  const body = [of, id, length, 0, ...Array(length).fill(fill)];
  return Buffer.from([0xb5, 0x62, ...body, ...sums(body)]);
}
function mtk(first) {
  const payload = Buffer.alloc(33);
  payload[0] = 32;
  [47397700, 8545600, 48800, 1500, 9000].forEach((value, i) => payload.writeInt32LE(value, 1 + 4 * i));
  payload.set([9, 3], 21);
  payload.writeUInt32LE(30624, 23);
  payload.writeUInt32LE(10000000, 27);
  return Buffer.from([first, 0xdd, ...payload, ...sums(payload)]);
}
function nmea(body) {
  const sum = [...Buffer.from(body)].reduce((x, byte) => x ^ byte, 0);
  return Buffer.from(`$${body}*${sum.toString(16).toUpperCase().padStart(2, '0')}\r\n`);
}

const twice = (...messages) => Buffer.concat([...messages, ...messages]);
const sentences = twice(nmea('GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,'),
  nmea('GPRMC,123519,A,4807.038,N,01131.000,E,22.4,84.4,230324,3.1,W'));
const seeds = [
  [2, twice(ubx(1, 3, 16, 1), ubx(1, 2, 28, 1), ubx(1, 18, 36, 1))],
  [2, twice(ubx(1, 6, 52, 1), ubx(1, 7, 84, 1))], [2, twice(ubx(6, 36, 36), ubx(5, 1, 2))],
  [3, twice(mtk(0xd0))], [4, twice(mtk(0xd1))], [5, sentences],
  [5, twice(nmea('GNGSA,A,2,1,2,3,,,,,,,,,,3.0,2.0,2.2'))],
].flatMap(([type, bytes]) => [type - 1, 0, 0xf0].map((how) => Buffer.concat([Buffer.of(how), bytes])));

fuzz({ program: process.argv[2], name: 'gps', seeds, longest: 200 });
