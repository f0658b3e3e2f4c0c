// SPDX-License-Identifier: GPL-3.0-or-later
// A bad radio between the ground station and one line of the vehicle: bytes are lost, flipped and
// doubled both ways, and now and then nothing comes through for two seconds. Seeded.
import { messages, nodeMavlink, registry, x25crc } from '../../support/node_mavlink.mjs';

const { MavLinkProtocolV1, MavLinkProtocolV2 } = nodeMavlink;
const protocols = { 0xfe: new MavLinkProtocolV1(255, 190), 0xfd: new MavLinkProtocolV2(255, 190) };
const lost = 0.005, flipped = 0.005, doubled = 0.005, stall_ms = 2000, between_ms = [10_000, 40_000];

function generator(seed) {  // mulberry32
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

class Way {
  constructor(seed) {
    this.random = generator(seed);
    this.held = Buffer.alloc(0);
    this.counts = { bytes: 0, lost: 0, flipped: 0, doubled: 0, stalls: 0 };
    this.plan(0);
  }

  plan(now_ms) {
    this.stall_at_ms = now_ms + between_ms[0] + this.random() * (between_ms[1] - between_ms[0]);
  }

  // What comes out at the other end now.
  through(bytes, now_ms) {
    this.held = Buffer.concat([this.held, this.damage(bytes)]);
    if (now_ms >= this.stall_at_ms + stall_ms) {
      ++this.counts.stalls;
      this.plan(now_ms);
    } else if (now_ms >= this.stall_at_ms) {
      return Buffer.alloc(0);
    }
    const out = this.held;
    this.held = Buffer.alloc(0);
    return out;
  }

  damage(bytes) {
    const out = [];
    for (const byte of bytes) {
      const dice = this.random();
      ++this.counts.bytes;
      if (dice < lost) {
        ++this.counts.lost;
      } else if (dice < lost + flipped) {
        ++this.counts.flipped;
        out.push(byte ^ (1 << Math.floor(this.random() * 8)));
      } else if (dice < lost + flipped + doubled) {
        ++this.counts.doubled;
        out.push(byte, byte);
      } else {
        out.push(byte);
      }
    }
    return Buffer.from(out);
  }
}

// A frame at the beginning of `bytes`: its size, 0 when there is none, undefined when it is not all there.
function frameSize(bytes) {
  const protocol = protocols[bytes[0]];
  if (!protocol) return 0;
  const overhead = bytes[0] === 0xfe ? 8 : 12;
  if (bytes.length < overhead) return undefined;
  const size = overhead + bytes[1];
  if (bytes.length < size) return undefined;
  const frame = bytes.subarray(0, size);
  const type = registry[protocol.header(frame).msgid];
  return type && protocol.crc(frame) === x25crc(frame, 1, 2, type.MAGIC_NUMBER) ? size : 0;
}

// From now on `line` is a bad one. What it did to the bytes is in line.up and line.down.
export function makeNoisy(vehicle, line, seed) {
  line.up = new Way(2 * seed + 1);
  line.down = new Way(2 * seed + 2);
  let heard = Buffer.alloc(0);

  const write = (bytes) => {
    line.written += bytes.length;
    if (bytes.length > 0) line.socket.write(bytes);
  };
  line.send = (name, fields = {}) => {
    const message = Object.assign(new messages[name](), fields);
    if ('targetSystem' in message) message.targetSystem = message.targetComponent = 1;
    const frame = protocols[line.version === 1 ? 0xfe : 0xfd].serialize(message, line.sequence++ & 255);
    write(line.up.through(frame, vehicle.now_ms));
  };
  const advance = vehicle.advance.bind(vehicle);
  vehicle.advance = (time_ms) => {
    write(line.up.through(Buffer.alloc(0), vehicle.now_ms));
    return advance(time_ms);
  };
  line.takeFrame = () => {
    heard = Buffer.concat([heard, line.down.through(line.waiting, vehicle.now_ms)]);
    line.waiting = Buffer.alloc(0);
    while (heard.length > 0) {
      const size = frameSize(heard);
      if (size === undefined) break;
      if (size > 0) take(heard.subarray(0, size));
      heard = heard.subarray(Math.max(size, 1));
    }
    return false;
  };
  const take = (frame) => {
    const protocol = protocols[frame[0]];
    const header = protocol.header(frame);
    const type = registry[header.msgid];
    line.inbox.push({ name: type.MSG_NAME, version: frame[0] === 0xfe ? 1 : 2, at_ms: vehicle.now_ms, header,
      data: protocol.data(protocol.payload(frame), type) });
  };
}
