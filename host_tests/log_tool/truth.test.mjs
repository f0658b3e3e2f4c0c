// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a flight of the first mission, held against what the simulator knows of that flight.
// FLY and LOG_TOOL name the programs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { named, readLog } from './bin.mjs';

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
  spread('NTUN', north, { rms: 2.5, peak: 8 });
  spread('NTUN', east, { rms: 2.5, peak: 8 });
  spread('GPS', north, { rms: 4, peak: 10 });  // what the receiver knew was 0.2 s old
  spread('GPS', east, { rms: 4, peak: 10 });
  spread('CTUN', (ctun, time_s) => ctun.Alt - at(time_s, 'height_m'), { rms: 1.5, peak: 5 });
  spread('CTUN', (ctun, time_s) => ctun.Aspd - at(time_s, 'equivalent_airspeed_mps'), { rms: 1, peak: 4 });
});

test('the gyros tell how the roll changes, and the accelerometer which way is down', () => {
  const imu = named(records, 'IMU').filter(flying);
  const lift = imu.reduce((sum, { AccZ }) => sum + AccZ, 0) / imu.length;
  assert.ok(lift < -9 && lift > -12, `${lift} m/s/s`);
  const turns = imu.map(({ TimeUS, GyrX }) => [GyrX * 180 / Math.PI,
    (at(TimeUS * 1e-6 + 0.1, 'roll_deg') - at(TimeUS * 1e-6 - 0.1, 'roll_deg')) / 0.2]);
  const mean = turns.reduce((sum, [gyro, truth]) => sum + Math.abs(gyro - truth), 0) / turns.length;
  assert.ok(mean < 8, `${mean} deg/s`);
});

test('pulses, modes, mission and the end of the flight are in it', () => {
  spread('RCOU', (rcou, time_s) => {
    const [before_us, after_us] = [at(time_s - 0.1, 'servo1_us'), at(time_s + 0.1, 'servo1_us')];
    const low = Math.min(before_us, at(time_s, 'servo1_us'), after_us), high = Math.max(before_us, at(time_s, 'servo1_us'), after_us);
    return Math.max(0, low - rcou.Ch1, rcou.Ch1 - high);
  }, { rms: 15, peak: 200 });
  assert.deepEqual(named(records, 'MODE').map(({ ModeNum }) => ModeNum).slice(-1), [10]);
  assert.deepEqual(named(records, 'EV').map(({ Id }) => Id), [10, 28, 18, 11], 'armed, off, down, disarmed');
  const commands = named(records, 'CMD');
  assert.equal(new Set(commands.map(({ CNum }) => CNum)).size, commands[0].CTot, 'every item');
  assert.ok(named(records, 'MSG').some(({ Message }) => Message === 'Throttle disarmed'));
  const parameters = new Map(named(records, 'PARM').map(({ Name, Value }) => [Name, Value]));
  assert.equal(parameters.get('WP_RADIUS'), 30);
  assert.equal(named(records, 'PM').at(-1).Drop, 0);
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

test('the report made of the log alone says what the simulator\'s says', () => {
  const page = join(folder, 'report.html');
  tool('report', image, '-o', page);
  const html = readFileSync(page, 'utf8');
  const summary = JSON.parse(readFileSync(join(folder, 'flight', 'summary.json'), 'utf8'));
  const told = (name) => +new RegExp(`<td>${name}</td><td[^>]*>([\\d.]+)`).exec(html)[1];
  for (const [name, truly, within] of [['Crosstrack, RMS', summary.crosstrack_rms_m, 0.5],
    ['Altitude, RMS', summary.altitude_rms_m, 0.5], ['Flight time', summary.flight_time_s, 20]]) {
    console.log(`${name}: logged ${told(name)}, truly ${truly}`);
    assert.ok(Math.abs(told(name) - truly) < within, name);
  }
  for (const word of ['mission completed', 'Ground track', 'mode AUTO', 'Control surfaces', 'as the airplane has logged it'])
    assert.ok(html.includes(word), word);
  assert.ok(!html.includes('truth'), 'a log does not know it');
});
