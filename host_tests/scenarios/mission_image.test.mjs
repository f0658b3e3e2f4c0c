// SPDX-License-Identifier: GPL-3.0-or-later
// Images that the mission tool has made, in the natively compiled board: it boots with the mission,
// and flies it to the end without an upload. FLY and MISSION_TOOL name the programs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { withVehicle } from '../support/vehicle.mjs';

const folder = mkdtempSync(join(tmpdir(), 'mission-tool-'));
after(() => rmSync(folder, { recursive: true }));

const firstFlight = new URL('../../simulator/missions/first_flight.waypoints', import.meta.url);
const apm1 = `APM 1.0
0x10 0 48800 473977000 85456000    # home
0x16 15 4500 0 0
0x10 30 6000 474012499 85436971
0x20 3 0 0 0                       # beside the waypoint before it
0x82 5 1900 0 0
0x10 30 6000 473992838 85496849
0x10 30 4000 473953325 85422171
0x10 30 3000 473927969 85435763
0x10 30 2500 473938120 85476841
0x15 0 0 473977000 85456000
`;

function compiled(mission) {
  const image = join(folder, 'image.bin');
  rmSync(image, { force: true });
  execFileSync(process.env.MISSION_TOOL, ['compile', mission, '-o', image],
    { stdio: ['ignore', 'ignore', 'pipe'] });
  return image;
}

async function arm(vehicle) {
  for (let tries = 0; tries < 90; ++tries) {
    await vehicle.wait(1000);
    vehicle.forget();
    if ((await vehicle.command(400, [1])) === 0) return;
  }
  assert.fail('never ready to arm');
}

// The items in the order in which they were reached; ends when the airplane has disarmed itself.
async function fly(vehicle) {
  const reached = [];
  await arm(vehicle);
  assert.equal(await vehicle.command(176, [1, 10]), 0, 'AUTO');
  for (let second = 0; second < 900; ++second) {
    await vehicle.wait(1000);
    for (const { seq } of vehicle.all('MISSION_ITEM_REACHED'))
      if (seq !== reached.at(-1)) reached.push(seq);
    const beats = vehicle.all('HEARTBEAT');
    vehicle.forget();
    if (beats.length > 0 && (beats.at(-1).baseMode & 128) === 0) return reached;
  }
  return assert.fail(`not landed; reached ${reached}`);
}

async function stored(vehicle) {
  vehicle.send('MISSION_REQUEST_LIST');
  return (await vehicle.expect('MISSION_COUNT')).count;
}

const flights = [
  ['a waypoint file', () => firstFlight.pathname, 16, [1, 2, 4, 5, 8, 10, 11, 12, 13, 14, 15]],
  ['the APM 1.0 text form', () => {
    const file = join(folder, 'apm1.txt');
    writeFileSync(file, apm1);
    return file;
  }, 10, [1, 2, 5, 6, 7, 8, 9]],
];
for (const [what, file, count, navs] of flights)
  test(`the image of ${what} is flown to the end`, async () => {
    const options = ['--eeprom', compiled(file())];
    await withVehicle({ options }, async (vehicle) => {
      assert.equal(await stored(vehicle), count);
      assert.deepEqual(await fly(vehicle), navs);
    })();
  });
