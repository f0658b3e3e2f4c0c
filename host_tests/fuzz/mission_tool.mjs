// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes into a reader of the mission tool, from missions of both sets as a beginning.
//   node fuzz.mjs PROGRAM waypoints|plan|records|image|eeprom
import { readFileSync } from 'node:fs';
import { fuzz } from './libfuzzer.mjs';

const [program, reader] = process.argv.slice(2);
const missions = new URL('../../simulator/missions/', import.meta.url);
const linesOf = (name) => readFileSync(new URL(name, missions), 'utf8').split('\n')
  .map((line) => line.replace(/ *#.*/, '')).filter((line) => line !== '');

// Pieces of a long mission, each a mission of its own: a seed as long as all of it is seldom hit.
function pieces([head, home, ...rest], size, renumbered) {
  const found = [];
  for (let at = 0; at < rest.length; at += size) {
    const items = [home, ...rest.slice(at, at + size)];
    const lines = renumbered ? items.map((line, i) => line.replace(/^\d+/, i)) : items;
    found.push(Buffer.from(`${[head, ...lines].join('\n')}\n`));
  }
  return found;
}

const hex = (text) => Buffer.from(text.replaceAll(' ', ''), 'hex');
const north15 = '10 01 1e 70170000 2028051c 00b4c404', north14 = '10 01 1e 701700 2028051c 00b4c404';
const repeat15 = 'b8 00 06 6c070000 03000000 04000000', jump14 = 'b1 00 01 000000 02000000 00000000';
const simple = (command, params) =>
  `{"type":"SimpleItem","command":${command},"doJumpId":1,"frame":3,"params":[${params}]}`;
const plan = (item, fence) => Buffer.from(`{"fileType":"Plan","version":1,"mission":{"version":2,
"plannedHomePosition":[47,8,400],"items":[${item}]},"geoFence":${fence},
"rallyPoints":{"version":2,"points":[[47,8,70]]}}`);
const readers = {
  waypoints: { longest: 400,
    seeds: pieces(linesOf('every_command_2.waypoints'), 4, true) },
  plan: { longest: 1500, seeds: [
    plan(simple(16, '0,0,0,null,47.1,8,60'), '{"version":2}'),
    plan(`{"type":"ComplexItem","complexItemType":"survey","TransectStyleComplexItem":{"Items":[${
      simple(177, '1,2,0,0,0,0,0')}]}}`, '{"version":2,"circles":[{"circle":{"center":[1,2],"radius":9}}]}'),
    plan('{"type":"ComplexItem","complexItemType":"fwLandingPattern","version":2,"landCoordinate":[47,8,0],'
      + '"landingApproachCoordinate":[47,8,9],"loiterRadius":9}',
    '{"version":2,"breachReturn":[1,2],"polygons":[{"inclusion":true,"polygon":[[1,2],[3,4],[5,6]]}]}')] },
  records: { longest: 400, seeds: [
    ...pieces(linesOf('every_command_1.txt'), 4, false),
    Buffer.from('APM 2.0\n0x10 0 0 40000 470000000 80000000\n0x72 2 9 1 50 77\n')] },
  image: { longest: 130, seeds: [
    hex(`00 ${north15} ${repeat15}`), hex(`02 ${north15} ${north15}`),
    Buffer.from(':020000040000FA\n:0401000010011E70C8\n:00000001FF\n')] },
  eeprom: { longest: 300, seeds: [
    hex(`00 ${north14} ${north14}`), hex(`01 ${north14} ${north14} ${jump14}`),
    hex('80 0800 0102030405060708090a0b0c'), hex('80 0500 0102030405060708090a0b0c')] },
};
// A file comes from its owner, not from a stranger on the radio, and each execution writes and reads
// the mission in all its forms: fewer of them.
fuzz({ program, name: `mission_tool ${reader}`, environment: { FUZZ_READER: reader }, runs: 30_000,
  ...readers[reader] });
