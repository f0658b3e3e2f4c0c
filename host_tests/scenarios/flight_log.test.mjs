// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a flight of the first mission, held against what the simulator knows of that flight.
// FLY, LOG_TOOL and MISSION_TOOL name the programs.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readdirSync, readFileSync, rmSync, symlinkSync,
         writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { named, readLog } from '../support/bin.mjs';
import { embedded } from '../support/flight_document.mjs';

const kMetresPerDegree = 111_195;
let folder, image, records, truth;

const wrapped = (degrees) => degrees - 360 * Math.round(degrees / 360);
const tool = (...words) => execFileSync(process.env.LOG_TOOL, words, { encoding: 'utf8' });

function readCsv(path) {
  const [head, ...lines] = readFileSync(path, 'utf8').trimEnd().split('\n').map((line) => line.split(','));
  return lines.map((cells) => Object.fromEntries(head.map((name, i) => [name, cells[i]])));
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'flight-log-'));
  image = join(folder, 'flash.bin');
  execFileSync(process.env.FLY, ['--native', '--dataflash', image, '--wind', '5,320', '--gusts',
    '--out', join(folder, 'flight')], { stdio: 'ignore' });
  tool('extract', image, '-o', join(folder, 'log.bin'));
  records = readLog(readFileSync(join(folder, 'log.bin')));
  truth = readCsv(join(folder, 'flight', 'flight.csv')).map((row) =>
    Object.fromEntries(Object.entries(row).map(([name, cell]) => [name, cell === '' ? NaN : +cell])));
  for (let i = 1; i < truth.length; ++i)  // so that it can be halved between two samples
    truth[i].yaw_deg = truth[i - 1].yaw_deg + wrapped(truth[i].yaw_deg - truth[i - 1].yaw_deg);
});
after(() => rmSync(folder, { recursive: true }));

// The truth is sampled at 10 Hz; between two samples it is taken to run straight.
function at(time_s, name) {
  const i = Math.floor(time_s * 10) - 1, [a, b] = [truth[i], truth[i + 1]];
  if (!a || !b) return NaN;
  const part = (time_s - a.time_s) / (b.time_s - a.time_s);
  return a[name] + part * (b[name] - a[name]);
}

const flying = ({ TimeUS }) => at(TimeUS * 1e-6, 'height_m') > 3;

function spread(name, errorOf, most) {
  const errors = named(records, name).filter(flying).map((record) => Math.abs(errorOf(record, record.TimeUS * 1e-6)));
  assert.ok(errors.length > 1000, `${errors.length} ${name}`);
  const rms = Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length);
  console.log(`${name}: ${errors.length} records, RMS ${rms.toFixed(3)}, most ${Math.max(...errors).toFixed(3)}`);
  assert.ok(rms < most.rms, `RMS ${rms} of ${most.rms}`);
  assert.ok(Math.max(...errors) < most.peak, `${Math.max(...errors)} of ${most.peak}`);
}

test('roll, pitch and heading are where the airplane was', () => {
  spread('ATT', (att, time_s) => att.Roll - at(time_s, 'roll_deg'), { rms: 2, peak: 10 });
  spread('ATT', (att, time_s) => att.Pitch - at(time_s, 'pitch_deg'), { rms: 2, peak: 10 });
  spread('ATT', (att, time_s) => wrapped(att.Yaw - at(time_s, 'yaw_deg')), { rms: 5, peak: 15 });
});

test('the place is where the airplane was', () => {
  const north = (record, time_s) => (record.Lat - at(time_s, 'latitude_deg')) * kMetresPerDegree;
  const east = (record, time_s) => (record.Lng - at(time_s, 'longitude_deg')) * kMetresPerDegree * Math.cos(record.Lat * Math.PI / 180);
  spread('POS', north, { rms: 2.5, peak: 8 });
  spread('POS', east, { rms: 2.5, peak: 8 });
  spread('GPS', north, { rms: 4, peak: 10 });  // what the receiver knew was 0.2 s old
  spread('GPS', east, { rms: 4, peak: 10 });
  spread('POS', (pos, time_s) => pos.RelHomeAlt - at(time_s, 'height_m'), { rms: 1.5, peak: 5 });
  spread('CTUN', (ctun, time_s) => ctun.As - at(time_s, 'equivalent_airspeed_mps'), { rms: 1, peak: 4 });
});

test('the gyros show how the roll changes, and the accelerometer which way is down', () => {
  const imu = named(records, 'IMU').filter(flying);
  const lift = imu.reduce((sum, { AccZ }) => sum + AccZ, 0) / imu.length;
  assert.ok(lift < -9 && lift > -12, `${lift} m/s/s`);
  const turns = imu.map(({ TimeUS, GyrX }) => [GyrX * 180 / Math.PI,
    (at(TimeUS * 1e-6 + 0.1, 'roll_deg') - at(TimeUS * 1e-6 - 0.1, 'roll_deg')) / 0.2]);
  const mean = turns.reduce((sum, [gyro, trueRate]) => sum + Math.abs(gyro - trueRate), 0) / turns.length;
  assert.ok(mean < 8, `${mean} deg/s`);
});

test('pulses, modes, mission and the end of the flight are in it', () => {
  spread('RCOU', (rcou, time_s) => {
    const [before_us, after_us] = [at(time_s - 0.1, 'servo1_us'), at(time_s + 0.1, 'servo1_us')];
    const low = Math.min(before_us, at(time_s, 'servo1_us'), after_us), high = Math.max(before_us, at(time_s, 'servo1_us'), after_us);
    return Math.max(0, low - rcou.C1, rcou.C1 - high);
  }, { rms: 15, peak: 200 });
  assert.deepEqual(named(records, 'MODE').map(({ ModeNum }) => ModeNum).slice(-1), [10]);
  assert.deepEqual(named(records, 'EV').map(({ Id }) => Id), [10, 28, 18, 11], 'armed, off, down, disarmed');
  const commands = named(records, 'CMD');
  assert.equal(new Set(commands.map(({ CNum }) => CNum)).size, commands[0].CTot, 'every item');
  assert.ok(named(records, 'MSG').some(({ Message }) => Message === 'Throttle disarmed'));
  const parameters = new Map(named(records, 'PARM').map(({ Name, Value }) => [Name, Value]));
  assert.equal(parameters.get('WP_RADIUS'), 30);
  assert.equal(named(records, 'PM').at(-1).LogDrop, 0);
  const gps = named(records, 'GPS');
  assert.ok(gps.every(({ GWk, GMS }, i) => GWk === 2317 && (i === 0 || GMS - gps[i - 1].GMS === 200)), 'each fix once');
});

test('the tool lists, summarises and tabulates it', () => {
  assert.match(tool('list', image), /^log 1  \d+ bytes in \d+ pages\n$/);
  assert.match(tool('summary', image), /height above home .* to \d+\.\d m\n/);
  tool('csv', image, '-o', join(folder, 'csv'));
  assert.ok(readdirSync(join(folder, 'csv')).includes('ATT.csv'));
  const rows = readCsv(join(folder, 'csv', 'ATT.csv'));
  const att = named(records, 'ATT');
  assert.equal(rows.length, att.length);
  assert.equal(+rows[500].Roll, att[500].Roll);
  assert.equal(tool('summary', join(folder, 'log.bin')), tool('summary', image));
});

test('the log begins with who wrote it and why the board started, before anything that happens', () => {
  const [first, second] = records.filter(({ name }) => ['MSG', 'ERR', 'EV', 'MODE'].includes(name));
  assert.match(first.Message, /^ArduPilotMega autopilot/);
  assert.deepEqual([second.name, second.Subsys], ['ERR', 19]);
});

// The names are ArduPilot's (LogStructure.h): a viewer shows "deg" for d times what 0 multiplies by.
test('every field has its unit and its multiplier, which agrees with the letter of its format', () => {
  const units = new Map(named(records, 'UNIT').map(({ Id, Label }) => [String.fromCharCode(Id), Label]));
  const multipliers = new Map(named(records, 'MULT').map(({ Id, Mult }) => [String.fromCharCode(Id), Mult]));
  assert.deepEqual([...multipliers], [['-', 0], ['0', 1], ['A', 0.1], ['B', 0.01], ['C', 0.001], ['F', 1e-6], ['G', 1e-7]]);
  assert.deepEqual(['s', 'd', 'n', 'D', 'G', '#', '-'].map((id) => units.get(id)),
    ['s', 'deg', 'm/s', 'deglatitude', 'Gauss', 'instance', '']);
  const formats = new Map(named(records, 'FMT').map((format) => [format.Type, format]));
  const of = named(records, 'FMTU');
  assert.deepEqual(of.map(({ FmtType }) => FmtType), [...formats.keys()], 'each format once');
  const own = { c: 'B', C: 'B', e: 'B', E: 'B', L: 'G' };
  for (const { FmtType, UnitIds, MultIds } of of) {
    const { Name, Format } = formats.get(FmtType);
    assert.deepEqual([UnitIds.length, MultIds.length], [Format.length, Format.length], Name);
    for (const [i, letter] of [...Format].entries()) {
      assert.ok(units.has(UnitIds[i]), `${Name}: unit ${UnitIds[i]}`);
      assert.ok(multipliers.has(MultIds[i]), `${Name}: multiplier ${MultIds[i]}`);
      if (own[letter]) assert.equal(MultIds[i], own[letter], `${Name}, field ${i + 1}`);
    }
  }
  const ofType = (name) => of.find(({ FmtType }) => formats.get(FmtType).Name === name);
  assert.deepEqual([ofType('ATT').UnitIds, ofType('ATT').MultIds], ['sddddhh', 'FBBBBBB']);
});

// Each record of one name with that of another that was written nearest to it.
function pairs(name, other, within_us) {
  const others = named(records, other).filter(flying);
  return named(records, name).filter(flying).map((record) =>
    [record, others.find(({ TimeUS }) => Math.abs(TimeUS - record.TimeUS) < within_us)]).filter(([, near]) => near);
}
const rms = (values) => Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);

// 45 degrees are all of a surface, which is 400 us of its servo.
test('the terms of a loop add up to the deflection of its surface', () => {
  for (const [name, output] of [['PIDR', 'C1'], ['PIDP', 'C2']]) {
    const both = pairs(name, 'RCOU', 45_000);
    assert.ok(both.length > 150, `${both.length} ${name}`);
    const mean = (of) => both.reduce((sum, pair) => sum + of(pair), 0) / both.length;
    const deflection = ([{ P, I, D, FF }]) => P + I + D + FF, pulse = ([, outputs]) => outputs[output];
    const [x, y] = [mean(deflection), mean(pulse)];
    const covariance = (a, b) => mean((pair) => (a(pair) - (a === pulse ? y : x)) * (b(pair) - (b === pulse ? y : x)));
    const slope = covariance(deflection, pulse) / covariance(deflection, deflection);
    const alike = covariance(deflection, pulse) / Math.sqrt(covariance(deflection, deflection) * covariance(pulse, pulse));
    console.log(`${name}: ${slope.toFixed(2)} us for a degree, alike by ${alike.toFixed(3)}`);
    assert.ok(Math.abs(slope) > 7.5 && Math.abs(slope) < 9.5 && Math.abs(alike) > 0.85, name);
  }
});

test('the rate of a loop is what the gyro measures, a moment before or after', () => {
  const both = pairs('PIDR', 'IMU', 45_000), errors = both.map(([pid, imu]) => pid.Act - imu.GyrX * 180 / Math.PI);
  const turning = rms(both.map(([pid]) => pid.Act));
  console.log(`PIDR.Act: RMS ${turning.toFixed(2)} deg/s, ${rms(errors).toFixed(2)} from the gyro's`);
  assert.ok(errors.length > 150 && rms(errors) < 0.7 * turning, `${errors.length} with ${rms(errors)} deg/s`);
});

test('the yaw loop damps: its rudder turns against what the turn does not ask for', () => {
  const yaw = named(records, 'PIDY').filter(flying), gyro = pairs('PIDY', 'IMU', 45_000);
  assert.ok(yaw.length > 100, `${yaw.length} PIDY`);
  const errors = gyro.map(([pid, imu]) => pid.Act - imu.GyrZ * 180 / Math.PI);
  assert.ok(rms(errors) < 0.7 * rms(gyro.map(([pid]) => pid.Act)), `${rms(errors)} deg/s`);
  const swings = yaw.filter(({ Act, Tar }) => Math.abs(Act - Tar) > 1);
  const against = swings.filter(({ Act, Tar, D }) => (Act - Tar) * D < 0);
  console.log(`PIDY: ${against.length} of ${swings.length} swings are damped`);
  assert.ok(swings.length > 20 && against.length > 0.7 * swings.length);
});

test('TECS has the height that is flown and speeds that are held', () => {
  const both = pairs('TECS', 'POS', 110_000);
  assert.ok(both.length > 400, `${both.length} TECS`);
  assert.ok(rms(both.map(([tecs, pos]) => tecs.h - pos.RelHomeAlt)) < 0.3);
  assert.ok(rms(both.map(([tecs]) => tecs.sp - tecs.spdem)) < 1.5);
  assert.ok(named(records, 'TECS').every(({ th }) => th >= 0 && th <= 1));
});

// What changes from one sample to the next is the vibration: the propeller's, along the nose.
test('VIBE is the root of the mean square of what shakes the accelerometer', () => {
  const imu = named(records, 'IMU').filter(flying), vibe = named(records, 'VIBE').filter(flying);
  const shaken = rms(imu.slice(1).map(({ AccX }, i) => (AccX - imu[i].AccX) / Math.SQRT2));
  const logged = rms(vibe.map(({ VibeX }) => VibeX));
  console.log(`VibeX ${logged.toFixed(3)} m/s/s, by the samples ${shaken.toFixed(3)}`);
  assert.ok(logged > 0.7 * shaken && logged < 1.2 * shaken, `${logged} of ${shaken} m/s/s`);
  assert.equal(vibe.at(-1).Clip, 0, 'nothing knocked against it');
});

test('AHR2 is the attitude and the place of ATT and POS, ARSP the measured airspeed', () => {
  assert.ok(rms(pairs('AHR2', 'ATT', 60_000).map(([ahr2, att]) => ahr2.Pitch - att.Pitch)) < 3);
  assert.ok(rms(pairs('AHR2', 'POS', 110_000).map(([ahr2, pos]) => (ahr2.Lat - pos.Lat) * kMetresPerDegree)) < 2);
  const speeds = pairs('ARSP', 'CTUN', 110_000);
  assert.ok(speeds.length > 200 && rms(speeds.map(([arsp, ctun]) => arsp.Airspeed - ctun.As)) < 1.5);
});

// ---- the graphs that viewers come with

// What keeps a field out of this log, so that a graph of it does not draw.
const kAbsent = [
  [/^(IMU|VIBE|GPS|BARO|MAG|GPA)\[[1-9]\]|^(IMU[23]|GPS2|GPA2|BAR[23]|MAG[23])\./, 'a second sensor of a kind'],
  [/^(NKF\d|XKF\d|XKY\d|EKF\d)\b/, 'an extended Kalman filter'],
  [/^(RCOU|RCIN)\.C(9|1\d)$/, 'more than eight channels'],
  [/^SIM\./, "ArduPilot's simulator"],
  [/^(QTUN|QPOS|PSC.|PIQ.|RATE|CTRL|PIDA|STER|ADAP)\./, 'a copter, a quadplane or a rover'],
  [/^(OF|ROF|RFND(\[0\])?|TERR)\./, 'optical flow, a rangefinder or terrain'],
  [/^(RCOU\.Ch\d+|TECS\.sp_dem|NTUN\.WpDist|VIBE\.Clip[012]|PID.\.Des|AETR\.SS[xyz]|ACC1\..*)$/, 'a name that ArduPlane had or has given up'],
  [/^GPA(\[0\])?\./, "the receiver's own accuracy"],
  [/^RAD\./, "the telemetry radio's figures"],
  [/^PID.\.(Dmod|SRate)$/, 'a limiter of oscillations'],
  [/^PIDS\./, 'a loop of its own for steering on the ground'],
  [/^AETR\./, 'demands before the mixer'],
  [/^IMU\[\d\]\.T$/, 'the temperature of the inertial sensor'],
];

// "IMU[0].GyrX" is a field of IMU where IMU has an instance field.
function fieldsIn(log) {
  const formats = new Map(named(log, 'FMT').map((format) => [format.Type, format])), fields = new Set();
  for (const { FmtType, UnitIds } of named(log, 'FMTU')) {
    const { Name, Columns } = formats.get(FmtType);
    if (named(log, Name).length === 0) continue;  // a viewer does not offer what no record fills
    for (const column of Columns.split(',')) {
      fields.add(`${Name}.${column}`);
      if (UnitIds.includes('#')) fields.add(`${Name}[0].${column}`);
    }
  }
  return fields;
}

test('the predefined graphs of viewers draw, but those of what this airplane has not', () => {
  const fields = fieldsIn(records);
  const graphs = readFileSync(new URL('viewer_graphs.txt', import.meta.url), 'utf8').trimEnd().split('\n')
    .filter((line) => !line.startsWith('#')).map((line) => line.split(': '));
  const reasons = new Map();
  let drawn = 0;
  for (const [name, expression] of graphs) {
    const missing = expression.split(' ').filter((field) => !fields.has(field));
    if (missing.length === 0) ++drawn;
    for (const field of missing)
      assert.ok(kAbsent.some(([which]) => which.test(field)), `${name}: ${field} is not logged`);
    if (missing.length === 0) continue;
    const [, reason] = kAbsent.find(([which]) => missing.some((field) => which.test(field)));
    reasons.set(reason, (reasons.get(reason) ?? 0) + 1);
  }
  for (const field of fields)
    assert.ok(!kAbsent.some(([which]) => which.test(field)), `${field} is logged`);
  console.log(`${drawn} of ${graphs.length} graphs draw; not`);
  for (const [reason, count] of [...reasons].sort(([, a], [, b]) => b - a)) console.log(`${String(count).padStart(5)}  ${reason}`);
  assert.ok(graphs.length >= 270, `${graphs.length} graphs`);
  assert.ok(drawn >= 56, `${drawn} of them draw`);
});

// As `toolchain/mission show` has it, and the board in MISSION_CURRENT.
test('the log says which mission is flown', () => {
  const mission = fileURLToPath(new URL('../../simulator/missions/first_flight.waypoints', import.meta.url));
  const shown = execFileSync(process.env.MISSION_TOOL, ['show', mission], { encoding: 'utf8' });
  const id = +/, id (\d+)/.exec(shown)[1];
  assert.deepEqual(named(records, 'LIST').map(({ Mission, Fence, Rally }) => [Mission, Fence, Rally]), [[id, 0, 0]]);
  assert.match(tool('summary', image), new RegExp(`\\d s  LIST  mission id ${id}, fence 0, rally points 0\n`));
});

test('modes, events and errors are shown by their names', () => {
  const summary = tool('summary', image);
  for (const line of ['MODE  AUTO', 'EV    armed', 'EV    in the air', 'EV    on the ground', 'EV    disarmed',
    'ERR   CPU: started by the supply', 'MSG   Throttle disarmed'])
    assert.match(summary, new RegExp(`\\d s  ${line}\n`));
});

// A log of these records: [type, name, fields, labels, bytes of each record].
function binLog(...kinds) {
  const head = (type) => [0xA3, 0x95, type];
  const text = (letters, size) => [...Buffer.from(letters), ...Array(size - letters.length).fill(0)];
  const format = ([type, name, fields, labels, ...rows]) => [...head(128), type,
    3 + rows[0].length, ...text(name, 4), ...text(fields, 16), ...text(labels, 64)];
  return Buffer.from([...kinds.flatMap(format),
    ...kinds.flatMap(([type, , , , ...rows]) => rows.flatMap((row) => [...head(type), ...row]))]);
}
const time = Array(8).fill(0);
const banner = [1, 'MSG', 'QZ', 'TimeUS,Message',
  [...time, ...Buffer.from('ArduPilotMega autopilot V0.1 (Plane)'.padEnd(64, '\0'))]];

test('every error of this firmware has the name that its manual gives it', () => {
  const manual = (name) => readFileSync(new URL(`../../docs/${name}.md`, import.meta.url), 'utf8');
  const cells = (name) => manual(name).split('\n').filter((line) => line.startsWith('| '))
    .map((line) => line.split('|').slice(1, -1).map((cell) => cell.trim()));
  const failsafes = cells('failsafes').map((row) => [row[5], row[2]])
    .filter(([err, text]) => /^\d+, \d+$/.test(err ?? '') && text !== '')
    .map(([err, text]) => [...err.split(', ').map(Number), text.replaceAll('"', '')]);
  const restarts = cells('restart').filter((row) => row.length === 4 && /^\d+$/.test(row[0]))
    .map(([code, , text]) => [19, +code, text.replace(/, task N$/, '')]);
  assert.ok(failsafes.length >= 12 && restarts.length === 7, `${failsafes.length} and ${restarts.length} rows`);
  for (const [subsystem, code, text] of [...failsafes, ...restarts]) {
    const path = join(folder, 'errors.bin');
    writeFileSync(path, binLog(banner, [2, 'ERR', 'QBB', 'TimeUS,Subsys,ECode', [...time, subsystem, code]]));
    const shown = /ERR +[A-Z_]+: (.*)/.exec(tool('summary', path))?.[1] ?? '';
    assert.equal(shown.toLowerCase(), text.toLowerCase());
  }
});

test('the errors of another firmware have ArduPilot\'s names', () => {
  const path = join(folder, 'other.bin');
  writeFileSync(path, binLog([2, 'ERR', 'QBB', 'TimeUS,Subsys,ECode', [...time, 11, 2], [...time, 5, 1],
    [...time, 5, 0], [...time, 99, 9]], [3, 'EV', 'QB', 'TimeUS,Id', [...time, 200]],
  [4, 'MODE', 'QMB', 'TimeUS,Mode,ModeNum', [...time, 24, 24]]));
  const shown = tool('summary', path).split('\n').filter((line) => / s  /.test(line)).map((line) => line.slice(14));
  assert.deepEqual(shown, ['ERR   GPS: glitch', 'ERR   FAILSAFE_RADIO: failsafe occurred',
    'ERR   FAILSAFE_RADIO: resolved', 'ERR   subsystem 99: code 9', 'EV    event 200', 'MODE  THERMAL']);
});

test('no name in a log leads out of the folder, and no byte of it reaches the terminal', () => {
  const path = join(folder, 'evil.bin'), out = join(folder, 'evil', 'inner');
  const row = [...time, ...Buffer.from('\x1b[2J'.padEnd(64, '\0'))];
  writeFileSync(path, binLog(banner, ...['../x', '/x', 'a b', '\x1b[m', '.'].map((name, i) =>
    [10 + i, name, 'QZ', 'TimeUS,Message', row]), [20, 'MSG', 'QZ', 'TimeUS,Message', row]));
  tool('csv', path, '-o', out);
  assert.deepEqual(readdirSync(join(folder, 'evil')), ['inner']);
  assert.deepEqual(readdirSync(out), ['MSG.csv']);
  const summary = tool('summary', path);
  assert.ok(!summary.includes('\x1b'), summary);
  assert.match(summary, /MSG   \?\[2J/);
  assert.match(summary, /no record +\d+ bytes/);
});

test('a log on its own can be listed too', () => {
  assert.match(tool('list', join(folder, 'log.bin')),
    new RegExp(`^one log  \\d+ bytes, ${records.length} records\n$`));
});

test('what cannot be written or read is one line and a failure', () => {
  const run = (words, stdout = 'pipe') => spawnSync(process.env.LOG_TOOL, words, { encoding: 'utf8', stdio: ['ignore', stdout, 'pipe'] });
  symlinkSync('/dev/full', join(folder, 'full.bin'));
  writeFileSync(join(folder, 'empty.bin'), '');
  for (const [words, says] of [
    [['extract', image, '-o', join(folder, 'full.bin')], /full\.bin: cannot be written: No space left on device/],
    [['report', image, '-o', folder], /cannot be written: Is a directory/],
    [['csv', image, '-o', image], /flash\.bin: cannot be written/],
    [['summary', join(folder, 'empty.bin')], /empty\.bin: the file is empty/],
    [['summary', folder], /cannot be read/]]) {
    const { status, stderr } = run(words);
    assert.equal(status, 2, stderr);
    assert.match(stderr, says);
    assert.equal(stderr.trimEnd().split('\n').length, 1, stderr);
  }
  const full = openSync('/dev/full', 'w');
  const { status, stderr } = run(['summary', image], full);
  closeSync(full);
  assert.equal(status, 1);
  assert.match(stderr, /^log: the standard output cannot be written/);
});

test('the report made of the log alone says what the simulator\'s says', () => {
  const page = join(folder, 'report.html');
  tool('report', image, '-o', page);
  const document = embedded(page);
  const summary = JSON.parse(readFileSync(join(folder, 'flight', 'summary.json'), 'utf8'));
  const shown = (name) => document.deviations.find((each) => each.name === name).value;
  for (const [name, truly, within] of [['Crosstrack, RMS', summary.crosstrack_rms_m, 0.5],
    ['Altitude, RMS', summary.altitude_rms_m, 0.5], ['Flight time', summary.flight_time_s, 20]]) {
    console.log(`${name}: logged ${shown(name)}, truly ${truly}`);
    assert.ok(Math.abs(shown(name) - truly) < within, name);
  }
  assert.match(document.title, /^flash\.bin · ArduPilotMega autopilot V/);
  assert.deepEqual([document.kind, document.verdict], ['log', { good: true, text: 'flown and disarmed' }]);
  assert.ok(document.bands.some(({ name }) => name === 'AUTO') && document.events.some(({ text }) => text === 'mode AUTO'));
  assert.ok(document.series.some(({ group }) => group === 'servos'));
  assert.ok(!document.series.some(({ kind }) => kind === 'truth'), 'a log does not know it');
});
