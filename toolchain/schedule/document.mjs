// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the schedule in docs/architecture.md from the table kTasks of firmware/app/tasks.cpp.
//   node toolchain/schedule/document.mjs           writes
//   node toolchain/schedule/document.mjs --check   exit 1 when what is there differs
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { taskRows } from './task_rows.mjs';

const root = new URL('../../', import.meta.url);
const read = (path) => readFileSync(new URL(path, root), 'utf8');
const kDocument = 'docs/architecture.md';

const remarks = {
  runInertial: 'the gyro and accelerometer samples since the last frame, zeros taken off',
  runRadio: 'pulses of the receiver, or overrides of the ground station, to stick positions; radio lost',
  runAttitude: 'roll, pitch and rates from the gyros',
  alignAttitude: 'the first attitude matrix, from the accelerometers at rest',
  rotateDcm: 'the attitude matrix by what the gyros have summed up, all angles',
  orthonormalizeMatrix: 'both rows of the matrix to length one and square to each other',
  pointYaw: 'yaw by the matrix; in between it goes on by its rate',
  gatherPressure: 'sums up the readings of the barometer',
  propagateMotion: 'acceleration over ground carries place, speed and height on',
  fusePressure: 'the mean pressure to the height',
  publishSpeeds: 'ground speed, course, airspeed',
  reckonPosition: 'without fixes the nose and the wind show where it goes',
  checkEstimate: 'height and velocity are numbers, or begin again',
  updateFlying: 'whether the airplane flies or stands',
  fuseFixAttitude: 'the newest fix to the attitude',
  fuseFixPosition: 'the newest fix to place and speed',
  fuseFixWind: 'the newest fix to the wind',
  fuseFixHeight: 'the newest fix to the height, and whether the barometer fits it',
  learnGpsDelay: 'by how much fixes are older than their receiver is known for, from turns',
  fuseCompass: 'the newest compass field to the heading',
  fuseAirspeed: 'holds the attitude by the airspeed while there are no fixes',
  runMode: 'the work of the present flight mode: sticks to demands',
  runAttitudeControl: 'demanded bank and pitch to surfaces; autotune listens here',
  runOutputs: 'surfaces to servo pulses, written to the timers; resets the hang timer',
  runBarometer: 'steps the barometer',
  runGps: 'received bytes to fixes; also between frames',
  runSpeedScaling: 'effect of the surfaces at this airspeed, rates of a coordinated turn, axes that oscillate',
  runRollGains: 'gains of the roll loop, when a parameter has changed; else its fastest rate',
  runPitchGains: 'gains of the pitch loop, when a parameter has changed',
  runControlLimits: 'limits of bank and pitch, the mix of the rudder, when a parameter has changed',
  runInertialSettings: 'scales, offsets and trim of the accelerometers, when a parameter has changed',
  runLateralGains: 'gains of the path along legs and circles',
  runTargetBearing: 'bearing to the target, for the ground station',
  runNavBearing: 'bearing that is demanded, for the ground station',
  runCompassLearning: 'compares compass readings, learns the offsets',
  telemetrySend: 'per link: what has become due; long transfers and commands go on',
  runGuidance: 'the demanded path to a bank, and the height and speed that belong to it',
  runSpeedHeight: 'height and speed to pitch and throttle (total energy)',
  runLog: 'begins and ends logs, writes the records that are due',
  runRestart: 'keeps the fast record for a restart in the air; carries one on',
  runCompass: 'steps the compass, takes the offsets off',
  runAirspeed: 'pressure of the pitot sensor to airspeed',
  missionCatchUp: 'the next part of a long pass of the mission engine',
  runInverted: 'whether the airplane is to fly upside down',
  runStall: 'whether the wing has stalled, and how far it is out of it',
  runFence: 'whether the fence is crossed, and what follows',
  missionRun: 'one pass of the mission engine in AUTO; uploads and checks in the background',
  runModeSwitch: 'the mode switch and the other switches of the transmitter',
  runAuxSwitches: 'switches with a function of their own, `RC5_OPTION` to `RC8_OPTION`',
  runEvents: 'the output that a mission repeats',
  reportVariables: 'parameters that a mission sends and that could not be sent at once',
  runCamera: 'ends the pulse of the shutter, begins the next one by distance',
  runFlaps: 'position of the flaps by switch or airspeed',
  runFailsafe: 'which causes hold, which transition follows',
  runArming: 'checks before arming, arming by the stick, disarming after landing',
  runBattery: 'voltage, current, consumption, supply of the board',
  tuneStep: 'in AUTOTUNE sets the next gain of what has been found',
  parametersRun: 'stores parameters that wait for it',
  rallyFollow: 'the parameter RALLY_TOTAL',
  runLights: 'lamps',
  dataflashStep: 'steps the DataFlash',
  measureLoad: 'load of the processor in the last second',
  runDeclination: 'magnetic declination of the place; in flight whether the compass is turned',
  runRestartSlowly: 'keeps the slow record for a restart in the air',
};

function* headers() {
  for (const room of readdirSync(new URL('firmware/', root)))
    for (const name of readdirSync(new URL(`firmware/${room}/`, root)))
      if (name.endsWith('.hpp')) yield `firmware/${room}/${name}`;
}

// The header that declares each task; what none declares is of tasks.cpp itself.
function declaredIn(names) {
  const found = new Map();
  for (const path of headers()) {
    const text = read(path);
    for (const name of names) if (text.includes(`\nvoid ${name}();`)) found.set(name, path);
  }
  return (name) => found.get(name) ?? 'firmware/app/tasks.cpp';
}

// A constant of the sources: kName = NUMBER.
export function constant(source, name) {
  const value = new RegExp(`\\b${name} = (\\d+)[,;]`).exec(source)?.[1];
  if (value === undefined) throw new Error(`the value of ${name} cannot be read`);
  return Number(value);
}

// Frames after which the table is where it began: the least common multiple of the periods.
export function hyperPeriod(rows) {
  const divisor = (a, b) => (b === 0 ? a : divisor(b, a % b));
  return rows.reduce((all, { period }) => all / divisor(all, period) * period, 1);
}

// The budgets of each of the first `frames` frames, summed up.
export const frameLoads = (rows, frames) => Array.from({ length: frames }, (_, frame) =>
  rows.filter(({ period, phase }) => frame % period === phase)
    .reduce((sum, { budget_us }) => sum + budget_us, 0));

export function schedule(source, scheduler) {
  const rows = taskRows(source);
  const unexplained = rows.filter(({ name }) => !(name in remarks)).map(({ name }) => name);
  if (unexplained.length > 0) throw new Error(`toolchain/schedule/document.mjs has no remark for ${unexplained}`);
  const gone = Object.keys(remarks).filter((name) => !rows.some((row) => row.name === name));
  if (gone.length > 0) throw new Error(`toolchain/schedule/document.mjs explains ${gone}, which is no task`);
  const frame_us = constant(source, 'kFrame_us');
  const header = declaredIn(rows.map(({ name }) => name));
  const cells = rows.map(({ number, name, tier, period, phase, budget_us }) => [number + 1, `\`${name}\``,
    1e6 / frame_us / period, phase, tier, budget_us, `\`${header(name)}\``, remarks[name]]);
  const table = [['task', 'function', 'Hz', 'phase', 'tier', 'budget, us', 'in', 'what it does'],
    Array(8).fill('---'), ...cells].map((row) => `| ${row.join(' | ')} |`).join('\n');
  const fast_us = frameLoads(rows.filter(({ tier }) => tier === 'fast'), 1)[0];
  const loads = frameLoads(rows, hyperPeriod(rows));
  const fullest = loads.indexOf(Math.max(...loads));
  const slowPatience = constant(scheduler, 'kSlowPatience');
  const mean_us = Math.round(loads.reduce((a, b) => a + b) / loads.length);
  return `${table}

By their budgets the fast tier takes ${fast_us} us of each frame of ${frame_us} us. The fullest of ${loads.length} frames
is number ${fullest} with ${loads[fullest]} us, the mean is ${mean_us} us.

How many frames a row that is due waits at most (a fast one never; ${slowPatience} frames are ${slowPatience * frame_us / 1e6} s while frames keep to ${frame_us / 1000} ms):

| tier | normal | after one lost frame | worst case |
| --- | --- | --- | --- |
| medium | 0 | ${constant(source, 'kMediumCatchesUp')} | ${constant(scheduler, 'kMediumPatience')} |
| slow | 0 | ${constant(source, 'kSlowCatchesUp')} | ${slowPatience} |`;
}

export function written(document, text) {
  const place = /(<!-- schedule: .*? -->\n)[^]*?(<!-- end -->)/;
  if (!place.test(document)) throw new Error(`${kDocument} has no place for the schedule`);
  return document.replace(place, (_, begin, end) => `${begin}${text}\n${end}`);
}

if (process.argv[1]?.endsWith('schedule/document.mjs')) {
  try {
    const before = read(kDocument);
    const after = written(before, schedule(read('firmware/app/tasks.cpp'), read('libraries/scheduler/scheduler.hpp')));
    if (!process.argv.includes('--check')) writeFileSync(new URL(kDocument, root), after);
    else if (after !== before) throw new Error(`${kDocument} is not what this script writes`);
  } catch (error) {
    console.error(`schedule: ${error.message}`);
    process.exitCode = 1;
  }
}
