// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/mission rehearse flies a mission in calm air and in wind; and what show has estimated
// of time and charge is near what the simulated flight takes. MISSION_TOOL names the program.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

const folder = mkdtempSync(join(tmpdir(), 'mission-rehearsal-'));
after(() => rmSync(folder, { recursive: true }));

const missionNamed = (name) => new URL(`../../simulator/missions/${name}`, import.meta.url).pathname;
const tool = (...words) => spawnSync(process.env.MISSION_TOOL, words, { encoding: 'utf8' });

// Of a flight's report: seconds from the first two metres of height to the landing, and mAh till the end.
function flown(report) {
  const { flight_time_s: time_s } = JSON.parse(readFileSync(join(report, 'summary.json'), 'utf8'));
  const [head, ...rows] = readFileSync(join(report, 'flight.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  const at = (row, name) => Number(row[head.indexOf(name)]);
  const begin = rows.findIndex((row) => at(row, 'height_m') > 2);
  let used_mah = 0;
  for (let i = begin + 1; i < rows.length; ++i)
    used_mah += at(rows[i], 'motor_current_a') * (at(rows[i], 'time_s') - at(rows[i - 1], 'time_s')) / 3.6;
  return { time_s, used_mah };
}

// By the board's own texts.
function assertPointsStored(report) {
  const texts = readFileSync(join(report, 'summary.json'), 'utf8');
  assert.match(texts, /Fence stored: 5 points/);
  assert.match(texts, /Rally stored: 1 points/);
  assert.doesNotMatch(texts, /[Bb]reach/);
}

function estimated(words) {
  const { stdout, status } = tool('show', ...words);
  assert.equal(status, 0);
  const [, minutes, seconds, used_mah] = /km in (\d+):(\d+) min, (\d+) mAh/.exec(stdout);
  return { time_s: 60 * Number(minutes) + Number(seconds), used_mah: Number(used_mah) };
}

// The estimate leaves out what turns against a wind save.
function assertNear(found, expected, what, most) {
  const ratio = found / expected;
  assert.ok(ratio > 0.98 && ratio < most, `${what}: ${found} estimated, ${expected} flown`);
}

for (const airplane of ['foam_trainer', 'trainer_6kg', 'flying_wing'])
  for (const mission of ['first_flight.waypoints', 'box_600.waypoints', 'survey.plan'])
    test(`${mission} with the ${airplane}: both flights, and near the estimate`, () => {
      const out = join(folder, `${airplane}.${mission}`), words = [missionNamed(mission), '--airplane', airplane];
      const { stdout, status } = tool('rehearse', ...words, '--wind', '5,300', '-o', out);
      assert.equal(status, 0, stdout);
      assert.match(stdout, /\ncalm air: mission completed\n/);
      assert.match(stdout, /\n5\.0 m\/s from 300, gusts of 1 m\/s: mission completed\n/);
      for (const [name, wind, most] of [['calm', '0', 1.08], ['wind', '5,300', 1.17]]) {
        assert.ok(stdout.includes(`${out}/${name}/report.html`) && existsSync(join(out, name, 'report.html')));
        const found = estimated([...words, '--wind', wind]), expected = flown(join(out, name));
        assertNear(found.time_s, expected.time_s, `${name}, seconds`, most);
        assertNear(found.used_mah, expected.used_mah, `${name}, mAh`, most);
      }
    });

test('the fence and the rally points of a plan are uploaded', () => {
  const out = join(folder, 'plan');
  assert.equal(tool('rehearse', missionNamed('survey.plan'), '--wind', '0', '-o', out).status, 0);
  const { events } = JSON.parse(readFileSync(join(out, 'calm/summary.json'), 'utf8'));
  const said = events.map(({ text }) => text);
  assert.ok(said.includes('fence uploaded') && said.includes('rally points uploaded'), said.join());
  assert.ok(!existsSync(join(out, 'wind')), 'no second flight without wind');
});

test('a plan of a survey and a corridor is flown within its fence', () => {
  const plan = missionNamed('corridor.plan'), out = join(folder, 'corridor');
  const kinds = JSON.parse(readFileSync(plan, 'utf8')).mission.items.map(({ complexItemType }) => complexItemType).filter(Boolean);
  assert.deepEqual(kinds, ['survey', 'CorridorScan', 'fwLandingPattern']);
  const { stdout, status } = tool('rehearse', plan, '--wind', '5,300', '-o', out);
  assert.equal(status, 0, stdout);
  for (const name of ['calm', 'wind']) assertPointsStored(join(out, name));
});

test('fence and rally points from files of Mission Planner are uploaded', () => {
  const plan = missionNamed('survey.plan'), fen = join(folder, 'f.fen'), ral = join(folder, 'r.ral'), out = join(folder, 'points');
  for (const file of [fen, ral]) assert.equal(tool('convert', plan, '-o', file).status, 0);
  assert.equal(tool('rehearse', missionNamed('first_flight.waypoints'), '--fence', fen, '--rally', ral, '--wind', '0', '-o', out).status, 0);
  assertPointsStored(join(out, 'calm'));
});

// `script` runs it on a terminal, which stays until the page is open.
test('in a terminal with a display the report of the flight in wind is opened', () => {
  const bin = join(folder, 'bin'), opened = join(folder, 'opened'), out = join(folder, 'shown'), log = join(folder, 'typescript');
  mkdirSync(bin);
  writeFileSync(join(bin, 'xdg-open'), `#!/bin/sh\necho "$1" > '${opened}.part' && mv '${opened}.part' '${opened}'\n`, { mode: 0o755 });
  const env = { ...process.env, PATH: `${bin}:${process.env.PATH}`, DISPLAY: ':9' };
  const words = `rehearse ${missionNamed('first_flight.waypoints')} -o ${out}`;
  assert.equal(spawnSync(process.env.MISSION_TOOL, words.split(' '), { env }).status, 0);
  assert.ok(!existsSync(opened), 'not where its output goes elsewhere');
  const command = `${process.env.MISSION_TOOL} ${words} && timeout 20 sh -c 'until [ -e ${opened} ]; do sleep 0.1; done'`;
  assert.equal(spawnSync('script', ['-qec', command, log], { env, stdio: 'ignore' }).status, 0);
  assert.equal(readFileSync(opened, 'utf8').trim(), join(out, 'wind/report.html'));
});

test('a flight of more than 20 minutes has the time it takes', () => {
  const file = join(folder, 'long.waypoints'), out = join(folder, 'long');
  const lines = readFileSync(missionNamed('box_600.waypoints'), 'utf8').trim().split('\n');
  const home = lines[1], rest = lines.slice(2);
  rest.splice(8, 0, '0\t0\t3\t177\t3\t3\t0\t0\t0\t0\t0\t1');  // three times more from item 3 on
  writeFileSync(file, `${[lines[0], home, ...rest.map((line, i) => line.replace(/^\d+/, i + 1))].join('\n')}\n`);
  const { stdout, status } = tool('rehearse', file, '--wind', '0', '-o', out);
  const { emulated_s } = JSON.parse(readFileSync(join(out, 'calm/summary.json'), 'utf8'));
  assert.ok(emulated_s > 1200, `${emulated_s} s, ${stdout}`);
  assert.equal(status, 0, stdout);
});

test('an image is flown with its board\'s parameters', () => {
  const image = join(folder, 'board.bin'), out = join(folder, 'image');
  assert.equal(tool('compile', missionNamed('first_flight.waypoints'), '-o', image).status, 0);
  const { stdout, status } = tool('rehearse', image, '--onto', image, '--wind', '0', '-o', out);
  assert.equal(status, 0, stdout);
  assert.ok(existsSync(join(out, 'calm/eeprom.bin')));
});

// SET_INDEX leaves out item 5 and works the relay beside item 6 till that is reached.
const first = `APM 1.0
0x10 0  48800 473977000 85456000   # 0 home
0x16 15 4500  0         0          # 1 TAKEOFF
0x40 14 0     0         0          # 2 CRUISE_AIRSPEED
0x10 30 6000  474012499 85436971   # 3 WAYPOINT
0x75 0  6     0         0          # 4 SET_INDEX
0x10 30 6000  474200000 85436971   # 5 WAYPOINT
0x10 30 6000  473978072 85437099   # 6 WAYPOINT
0x81 1  0     0         0          # 7 SET_RELAY
0x20 2  0     0         0          # 8 DELAY
0x81 0  0     0         0          # 9 SET_RELAY
0x75 0  7     0         0          # 10 SET_INDEX
0x10 30 4000  473953325 85422171   # 11 WAYPOINT
0x10 30 3000  473927969 85435763   # 12 WAYPOINT
0x10 30 2500  473938120 85476841   # 13 WAYPOINT
0x15 0  0     473977000 85456000   # 14 LAND
`;

for (const onto of [false, true])
  test(`a mission of the 1.0 set is flown ${onto ? "on a board's image" : 'with the airplane\'s parameters'}`, () => {
    const file = join(folder, 'first.txt'), out = join(folder, `first.${onto}`), image = join(folder, 'onto.bin');
    writeFileSync(file, first);
    assert.equal(tool('compile', missionNamed('first_flight.waypoints'), '-o', image).status, 0);
    const words = onto ? ['--onto', image] : [];
    const { stdout, status } = tool('rehearse', file, '--wind', '5,300', ...words, '-o', out);
    assert.equal(status, 0, stdout);
    assert.match(stdout, /\ncalm air: mission completed\n/);
    assert.match(stdout, /\n5\.0 m\/s from 300, gusts of 1 m\/s: mission completed\n/);
    const { events } = JSON.parse(readFileSync(join(out, 'calm/summary.json'), 'utf8'));
    assert.ok(!events.some(({ text }) => text === 'mission uploaded'));
    if (onto) return;
    for (const [name, wind, most] of [['calm', '0', 1.08], ['wind', '5,300', 1.17]]) {
      const found = estimated([file, '--wind', wind]), expected = flown(join(out, name));
      assertNear(found.time_s, expected.time_s, `${name}, seconds`, most);
      assertNear(found.used_mah, expected.used_mah, `${name}, mAh`, most);
    }
  });

test('what a mission of the 1.0 set does not reach, and what leaves AUTO, is reported', () => {
  const file = join(folder, 'leaves.txt'), out = join(folder, 'leaves');
  writeFileSync(file, first.replace('0x81 1  0 ', '0x30 11 0 '));  // RTL beside item 6
  const { stdout, status } = tool('rehearse', file, '--wind', '0', '-o', out);
  assert.equal(status, 1);
  assert.match(stdout, /calm air: not completed: time limit reached after item 6\n/);
});

test('what is not completed, not flown or refused is reported as such', () => {
  const out = join(folder, 'wrong'), file = join(folder, 'm.waypoints');
  const home = 'QGC WPL 110\n0 1 0 16 0 0 0 0 47.3977 8.5456 488 1\n1 0 3 22 15 0 0 0 0 0 40 1\n';
  const write = (lines) => {
    writeFileSync(file, home + lines);
    return tool('rehearse', file, '--wind', '0', '-o', out);
  };
  const open = write('2 0 3 16 0 0 0 0 47.4 8.5456 60 1\n');
  assert.equal(open.status, 1);
  assert.match(open.stdout, /calm air: not completed: /);
  const refused = write('2 0 3 601 0 0 0 0 47.4 8.5456 60 1\n');
  assert.equal(refused.status, 1);
  assert.match(refused.stderr, /m\.waypoints:4:7: expected a command of the APM 2\.0 set/);
  assert.equal(refused.stdout, '');
});
