// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink by npm node-mavlink (toolchain/node): messages to bytes, and bytes of a serial line, with
// whatever a bootloader or a cut leaves between the frames, to messages.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../node/package.json', import.meta.url));
const mappings = require('mavlink-mappings');
const { MavLinkProtocolV1, MavLinkProtocolV2 } = require('node-mavlink');
const { x25crc } = mappings;
const kMagic1 = 0xfe, kMagic2 = 0xfd, kStation = 255, kComponent = 190, kLongest = 280;

const dialects = [mappings.minimal, mappings.common, mappings.standard, mappings.ardupilotmega];
const registry = Object.assign({}, ...dialects.map((dialect) => dialect.REGISTRY));
const byName = Object.fromEntries(Object.values(registry).map((type) => [type.MSG_NAME, type]));
const protocols = { 1: new MavLinkProtocolV1(kStation, kComponent), 2: new MavLinkProtocolV2(kStation, kComponent) };

export const idOf = (name) => byName[name].MSG_ID;

// A frame of version 1, which every firmware for these boards understands; to the vehicle 1, 1.
export function frameOf(name, fields, sequence) {
  const message = Object.assign(new byName[name](), fields);
  if ('targetSystem' in message) message.targetSystem = 1;
  if ('targetComponent' in message) message.targetComponent = 1;
  return protocols[1].serialize(message, sequence & 255);
}

function sizeOf(bytes, at) {
  const v1 = bytes[at] === kMagic1;
  const signed = !v1 && (bytes[at + 2] & 1) !== 0;
  return bytes[at + 1] + (v1 ? 8 : 12) + (signed ? 13 : 0);
}

function decoded(frame) {
  const version = frame[0] === kMagic1 ? 1 : 2;
  const protocol = protocols[version];
  const header = protocol.header(frame);
  const type = registry[header.msgid];
  if (!type) return undefined;
  const signature = version === 2 && (frame[2] & 1) ? 13 : 0;
  const checked = signature ? frame.subarray(0, frame.length - signature) : frame;
  if (protocol.crc(checked) !== x25crc(checked, 1, 2, type.MAGIC_NUMBER)) return undefined;
  return { name: type.MSG_NAME, header, data: protocol.data(protocol.payload(checked), type) };
}

// Takes bytes as they come and gives whole messages; what is no frame is left out.
export class Splitter {
  #rest = Buffer.alloc(0);

  take(bytes) {
    this.#rest = Buffer.concat([this.#rest, bytes]);
    const messages = [];
    let at = 0;
    while (at < this.#rest.length) {
      if (this.#rest[at] !== kMagic1 && this.#rest[at] !== kMagic2) {
        ++at;
        continue;
      }
      if (at + 3 > this.#rest.length) break;
      const size = sizeOf(this.#rest, at);
      if (size <= kLongest && at + size > this.#rest.length) break;
      const message = size <= kLongest ? decoded(this.#rest.subarray(at, at + size)) : undefined;
      if (message) messages.push(message);
      at += message ? size : 1;
    }
    this.#rest = this.#rest.subarray(at);
    return messages;
  }
}
