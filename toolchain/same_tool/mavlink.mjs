// SPDX-License-Identifier: GPL-3.0-or-later
// As much of MAVLink as directing a flight needs, without npm packages: frames of version 1 are
// written, or of version 2 where a message needs its extensions; both are cut out of a stream.
// Layouts, ids and the CRC's extra bytes are those of MAVLink's common.xml and ardupilotmega.xml.
const kMagic1 = 0xfe, kMagic2 = 0xfd;
const kSystem = 255, kComponent = 190;  // a ground station's
const kHeartbeat = 0, kStatusText = 253;

function crcOf(bytes) {
  let crc = 0xffff;
  for (const byte of bytes) {
    let mixed = byte ^ (crc & 0xff);
    mixed = (mixed ^ (mixed << 4)) & 0xff;
    crc = (crc >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4);
  }
  return crc & 0xffff;
}

export function frame({ id, extra, payload, extended }, sequence) {
  const from = [sequence & 255, kSystem, kComponent];
  const head = extended ? [payload.length, 0, 0, ...from, id, 0, 0] : [payload.length, ...from, id];
  const crc = crcOf([...head, ...payload, extra]);
  return Buffer.from([extended ? kMagic2 : kMagic1, ...head, ...payload, crc & 255, crc >> 8]);
}

const float = (value) => {
  const bytes = Buffer.alloc(4);
  bytes.writeFloatLE(value);
  return [...bytes];
};
const degreesE7 = (degrees) => {
  const bytes = Buffer.alloc(4);
  bytes.writeInt32LE(Math.round(degrees * 1e7));
  return [...bytes];
};
const to = [1, 1];  // the vehicle's system and component

export const heartbeat = () => ({ id: kHeartbeat, extra: 50, payload: [0, 0, 0, 0, 6, 8, 0, 4, 3] });
export const commandLong = (command, parameters) => ({ id: 76, extra: 152,
  payload: [...Array.from({ length: 7 }, (_, i) => float(parameters[i] ?? 0)).flat(),
    command & 255, command >> 8, ...to, 0] });
export const paramSet = (name, value) => ({ id: 23, extra: 168,
  payload: [...float(value), ...to, ...Buffer.from(name.padEnd(16, '\0')), 9] });
export const requestAllStreams = (rate_hz) => ({ id: 66, extra: 148,
  payload: [rate_hz & 255, rate_hz >> 8, ...to, 0, 1] });
const kFenceType = 1;  // MAV_MISSION_TYPE, an extension of these two
export const fenceCount = (count) => ({ id: 44, extra: 221, extended: true,
  payload: [count & 255, count >> 8, ...to, kFenceType] });
export const fenceItem = (index, command, corners, latitude_deg, longitude_deg) => ({ id: 73, extra: 38, extended: true,
  payload: [...float(corners), ...float(0), ...float(0), ...float(0), ...degreesE7(latitude_deg), ...degreesE7(longitude_deg),
    ...float(0), index & 255, index >> 8, command & 255, command >> 8, ...to, 0, 0, 1, kFenceType] });

// The whole frames at the beginning of `bytes`, and how many bytes they take. What is no frame ends
// the list.
export function framesIn(bytes) {
  const frames = [];
  let at = 0;
  while (at + 12 <= bytes.length) {
    const version = { [kMagic1]: 1, [kMagic2]: 2 }[bytes[at]];
    if (!version) break;
    const head = version === 1 ? 6 : 10;
    const signed = version === 2 && (bytes[at + 2] & 1) ? 13 : 0;
    const end = at + head + bytes[at + 1] + 2 + signed;
    if (end > bytes.length) break;
    const id = version === 1 ? bytes[at + 5] : bytes.readUIntLE(at + 7, 3);
    frames.push({ at, id, payload: bytes.subarray(at + head, at + head + bytes[at + 1]) });
    at = end;
  }
  return { frames, taken: at };
}

// Of a HEARTBEAT; version 2 leaves trailing zeros out, but never these two.
export function modeOf({ id, payload }) {
  if (id !== kHeartbeat || payload.length < 7) return undefined;
  return { mode: payload.readUInt32LE(0), armed: (payload[6] & 128) !== 0 };
}

export function textOf({ id, payload }) {
  if (id !== kStatusText) return undefined;
  return payload.subarray(1, 51).toString('latin1').replace(/\0.*$/s, '');
}
