// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a fuzzer of the ground link from a corpus of real frames as npm node-mavlink writes them.
//   node run.mjs PROGRAM parser|conversation|signing
//   node run.mjs PROGRAM handler MESSAGE_STRUCT
import { readFileSync } from 'node:fs';
import { messages, nodeMavlink } from '../support/node_mavlink.mjs';
import { fuzz } from './libfuzzer.mjs';

const [program, kind, struct] = process.argv.slice(2);
const known = JSON.parse(readFileSync(
  new URL('../../toolchain/mavlink/messages.json', import.meta.url), 'utf8')).messages
  .map((name) => messages[name]).sort((a, b) => a.MSG_ID - b.MSG_ID);
const protocols = [new nodeMavlink.MavLinkProtocolV1(255, 190), new nodeMavlink.MavLinkProtocolV2(255, 190)];

// Values a ground station sends; the fuzzer finds the others.
const usual = { targetSystem: 1, targetComponent: 1, count: 3, seq: 1, command: 16, frame: 3,
  paramIndex: -1, paramId: 'TRIM_ARSPD_CM', paramValue: 1300, reqMessageRate: 4, startStop: 1,
  autocontinue: 1, txbuf: 40, _param1: 1, z: 100 };

function filled(type, empty) {
  const message = new type();
  for (const field of type.FIELDS) {
    const kindOf = field.type.replace('[]', '');
    const zero = kindOf.endsWith('64_t') ? 0n : kindOf === 'char' ? '' : 0;
    const fits = field.name in usual && !(usual[field.name] < 0 && kindOf.startsWith('u'));
    const value = !empty && fits ? usual[field.name] : zero;
    message[field.name] = field.length && kindOf !== 'char' ? Array(field.length).fill(value) : value;
  }
  if ('targetSystem' in message) message.targetSystem = message.targetComponent = 1;
  return message;
}

const frames = (type) => protocols.filter((_, v) => v === 1 || type.MSG_ID < 256)
  .flatMap((protocol) => [false, true].map((empty) => protocol.serialize(filled(type, empty), 0)));
const payload = (frame) => (frame[0] === 0xfd ? frame.subarray(10, 10 + frame[1]) : frame.subarray(6, 6 + frame[1]));

function seeds() {
  if (kind === 'parser')  // for the vehicle's parser, and behind a zero for the peer's
    return known.flatMap(frames).flatMap((frame) => [frame, Buffer.concat([Buffer.of(0), frame])]);
  if (kind === 'signing') {  // with a key that is not the vehicle's
    const signer = new nodeMavlink.MavLinkProtocolV2(255, 190, nodeMavlink.MavLinkProtocolV2.IFLAG_SIGNED);
    return known.map((type) => signer.sign(signer.serialize(filled(type, false), 0), 1, Buffer.alloc(32, 7), Date.UTC(2026, 0, 1)));
  }
  if (kind === 'handler')
    return frames(subject).flatMap((frame) => [0x10, 0xb7].map((how) =>
      Buffer.concat([Buffer.from([how | (frame[0] === 0xfd ? 8 : 0)]), payload(frame)])));
  const step = (name) => {
    const at = known.findIndex((type) => type.MSG_NAME === name);
    const body = payload(protocols[1].serialize(filled(known[at], false), 0));
    return Buffer.concat([Buffer.from([at, body.length]), body]);
  };
  const upload = ['MISSION_COUNT', 'MISSION_ITEM_INT', 'MISSION_ITEM', 'MISSION_REQUEST_LIST',
    'MISSION_REQUEST_INT', 'MISSION_SET_CURRENT', 'MISSION_CLEAR_ALL'].map(step);
  return [Buffer.concat(upload), ...known.map(({ MSG_NAME }) => Buffer.concat([step(MSG_NAME), step(MSG_NAME)]))];
}

const spelled = (name) => name.replaceAll('_', '').toLowerCase();
const subject = known.find(({ MSG_NAME }) => spelled(MSG_NAME) === struct?.toLowerCase());
const name = kind === 'handler' ? subject.MSG_NAME : kind;
const lengths = { parser: 120, conversation: 120, signing: 160, handler: 64 };
fuzz({ program, name, seeds: seeds(), longest: lengths[kind],
  environment: { FUZZ_MESSAGE: `${subject?.MSG_ID}` } });
