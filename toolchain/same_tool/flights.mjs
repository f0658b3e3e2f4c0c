// SPDX-License-Identifier: GPL-3.0-or-later
// The flights that two versions are compared by. Each has a name, what it is about, and
// `fly(places)`, which resolves when the flight is over and throws FlightFailed when it was not the
// flight it is meant to be. Missions are this tree's for both versions.
import { spawn } from 'node:child_process';
import { copyFileSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { fenceCount, fenceItem } from './mavlink.mjs';
import { Board, FlightFailed } from './lock_step.mjs';

const kTimeout_ms = 120_000;
const kHome = { latitude_deg: 47.3977, longitude_deg: 8.5456 };  // of the missions
const kManual = 0, kCircle = 1, kStabilize = 2, kTraining = 3, kAcro = 4, kFbwa = 5, kFbwb = 6, kCruise = 7,
  kAuto = 10, kRtl = 11, kLoiter = 12, kGuided = 15;

function run(program, words) {
  const child = spawn(program, words, { stdio: ['ignore', 'pipe', 'pipe'], timeout: kTimeout_ms });
  let output = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (bytes) => { output += bytes; });
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (status, signal) => {
      if (status === 0) return resolve();
      const lines = output.trim().split('\n');
      const why = lines.find((line) => /^(fly|mission_tool|not completed):/.test(line)) ?? lines.at(-1);
      return reject(new FlightFailed(`status ${status ?? signal}: ${why}`));
    });
  });
}

const memories = (folder) => ['--eeprom', join(folder, 'eeprom.bin'), '--dataflash', join(folder, 'log.bin')];

// A mission flown by fly's own script to its landing.
const scripted = (mission, ...options) => ({ host, missions, folder }) =>
  run(join(host, 'fly'), [join(missions, mission), '--native', '--out', folder, ...memories(folder), ...options]);

// A flight that a script of this tool directs, in lock step; `options` are fly's.
async function inLockStep({ host, folder }, options, script) {
  const board = await Board.start(join(host, 'fly'), [...memories(folder), ...options]);
  const timer = setTimeout(() => board.giveUp(`no end within ${kTimeout_ms / 1000} s`), kTimeout_ms);
  try {
    await script(board);
  } finally {
    clearTimeout(timer);
    await board.stop();
    for (const [name, contents] of board.recorded()) writeFileSync(join(folder, name), contents);
  }
}

// The mission is in the EEPROM that the version's own tool has made.
const directed = (mission, options, script) => async (places) => {
  await run(join(places.host, 'mission_tool'),
    ['compile', join(places.missions, mission), '-o', join(places.folder, 'eeprom.bin')]);
  await inLockStep(places, options, script);
};

const kSticks = [1500, 1500, 1550, 1500, 1500, 1500, 1500, 1425];

// Hands on the sticks where the mode wants them: bank, climb, let go.
async function everyMode(board) {
  await board.takeOff();
  await board.wait(20);
  await board.sticks(...kSticks);
  for (const mode of [kFbwa, kFbwb, kCruise, kStabilize, kTraining]) {
    await board.enter(mode);
    await board.wait(2);
    await board.sticks(1650, 1500, 1600, 1500, ...kSticks.slice(4));
    await board.wait(2);
    await board.sticks(1500, 1540, 1600, 1520, ...kSticks.slice(4));
    await board.wait(4);
    await board.sticks(...kSticks);
  }
  for (const mode of [kAcro, kManual]) {  // nothing keeps it level: briefly, and FBWA recovers it
    await board.enter(mode);
    await board.sticks(1560, 1520, 1600, 1500, ...kSticks.slice(4));
    await board.wait(1);
    await board.sticks(...kSticks);
    await board.enter(kFbwa);
    await board.wait(5);
  }
  for (const mode of [kCircle, kLoiter, kGuided, kRtl, kAuto]) {
    await board.enter(mode);
    await board.wait(20);
  }
}

// A square of 4 km around its point of return, which is home. The vehicle asks for one after the other.
async function sendFence(board) {
  const kReturnPoint = 5000, kCorner = 5001;  // MAV_CMD_NAV_FENCE_
  const points = [[0, 0], [1, 1], [1, -1], [-1, -1], [-1, 1]];
  board.send(fenceCount(points.length));
  await board.wait(0.5);
  for (const [index, [north, east]] of points.entries()) {
    board.send(fenceItem(index, index === 0 ? kReturnPoint : kCorner, points.length - 1,
      kHome.latitude_deg + 0.018 * north, kHome.longitude_deg + 0.027 * east));
    await board.wait(0.5);
  }
}

const kFenceEnable = 207;

// Radio lost until RTL, the ground station lost until RTL, the fence crossed upwards.
async function failsafes(board) {
  await sendFence(board);
  await board.takeOff();
  await board.wait(15);
  await board.sticks(...kSticks);
  for (const [name, value] of [['FS_SHORT_ACTN', 1], ['FS_LONG_ACTN', 1], ['FS_LONG_TIMEOUT', 4]])
    await board.set(name, value);
  await board.transmitterOff();
  await board.inMode(kCircle, 6);
  await board.inMode(kRtl, 12);
  await board.wait(10);
  await board.sticks(...kSticks);
  await board.set('FS_GCS_ENABL', 1);
  await board.enter(kLoiter);
  await board.wait(5);
  board.silent = true;
  await board.inMode(kRtl, 20);
  board.silent = false;
  await board.wait(5);
  await board.set('FS_GCS_ENABL', 0);
  await board.enter(kLoiter);
  await board.set('FENCE_ACTION', 1);
  await board.set('FENCE_MAXALT', 20);
  await board.command(kFenceEnable, 1);
  await board.inMode(kGuided, 6);
  await board.wait(10);
}

// The mission itself enters LOITER on its way, and goes on when it is back in AUTO.
async function throughItsLoiter(board) {
  await board.takeOff();
  await board.inMode(kLoiter, 400);
  await board.wait(20);
  await board.enter(kAuto);
  await board.landed(400);
}

async function flyToTheLanding(board) {
  await board.takeOff();
  await board.landed(700);
}

export const kFlights = [
  { name: 'calm', what: 'the first mission in calm air, all streams on USB too',
    fly: scripted('first_flight.waypoints', '--seed', '1', '--usb') },
  { name: 'wind', what: 'the first mission in wind and gusts, telemetry on USART0',
    fly: scripted('first_flight.waypoints', '--seed', '2', '--wind', '5,320', '--gusts', '--telemetry', 'uart0') },
  { name: 'commands_2', what: 'every CONDITION and DO of the newer command set',
    fly: scripted('every_command_2.waypoints', '--seed', '3', '--wind', '3,200') },
  { name: 'commands_1', what: 'every CONDITION and DO of the older command set, from the EEPROM',
    fly: directed('every_command_1.txt', ['--seed', '4', '--wind', '3,100'], throughItsLoiter) },
  { name: 'sensors', what: 'GPS, barometer, airspeed, compass and gyroscopes fail in turn',
    fly: scripted('first_flight.waypoints', '--seed', '5', '--wind', '3,90', '--fault', 'gps:lost@60-90',
      '--fault', 'baro:nonsense@110-130', '--fault', 'airspeed:stuck@150-180', '--fault', 'compass:lost@200',
      '--fault', 'imu:stuck@230-230.5') },
  { name: 'radio', what: 'the radio is lost and comes back: short failsafe, then the mission again',
    fly: ({ folder, ...places }) => {
      writeFileSync(join(folder, 'same.param'), 'FS_SHORT_ACTN,1\nFS_LONG_TIMEOUT,20\n');
      return scripted('first_flight.waypoints', '--seed', '6', '--gps', 'nmea', '--fault', 'radio:lost@70-80',
        '--param', join(folder, 'same.param'))({ folder, ...places });
    } },
  { name: 'wing', what: 'the flying wing on the tour of boxes, in gusts',
    fly: scripted('box_600.waypoints', '--airplane', 'flying_wing', '--seed', '7', '--wind', '4,200', '--gusts') },
  { name: 'modes', what: 'the modes in turn, CIRCLE and LOITER among them, with sticks',
    fly: directed('first_flight.waypoints', ['--seed', '8', '--wind', '4,320', '--gusts'], everyMode) },
  { name: 'failsafes', what: 'radio lost until RTL, ground station lost, the fence crossed',
    fly: directed('first_flight.waypoints', ['--seed', '9', '--wind', '3,320'], failsafes) },
  { name: 'restart', what: 'switched off after a flight, then on again: mission, parameters and log kept',
    fly: async (places) => {
      const first = join(places.folder, 'first');
      mkdirSync(first);
      await scripted('first_flight.waypoints', '--seed', '10')({ ...places, folder: first });
      for (const name of ['eeprom.bin', 'log.bin']) copyFileSync(join(first, name), join(places.folder, name));
      await inLockStep(places, ['--seed', '11', '--wind', '3,250'], flyToTheLanding);
    } },
];
