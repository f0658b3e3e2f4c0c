// SPDX-License-Identifier: GPL-3.0-or-later
// Take-off buttons. QGroundControl chooses the mode TAKEOFF and arms; MAVSDK arms and then sends
// MAV_CMD_NAV_TAKEOFF, and waits for EXTENDED_SYS_STATE to be in the air.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { armWhenReady, distance_m, flies, home, setParameter } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kTakeoff = 13, kDoSetMode = 176, kNavTakeoff = 22, kArm = 400;
const kOnGround = 1, kInAir = 2, kTakingOff = 3;

const landed = async (vehicle) => {
  vehicle.all('EXTENDED_SYS_STATE');
  return (await vehicle.expect('EXTENDED_SYS_STATE', { within_ms: 1500 })).landedState;
};

async function circles(vehicle, height_m) {
  await flies(vehicle, 40, ({ relativeAlt }) => relativeAlt > 1000 * (height_m - 3));
  await vehicle.wait(15_000);
  const begin = await flies(vehicle, 1, () => true);
  for (let look = 0; look < 10; ++look) {
    await vehicle.wait(3000);
    const at = await flies(vehicle, 1, () => true);
    assert.ok(Math.abs(at.relativeAlt / 1000 - height_m) < 5, `${at.relativeAlt} mm high`);
    assert.ok(distance_m({ x: begin.lat, y: begin.lon }, at) < 160, 'does not stay there');
    assert.ok(distance_m(home, at) < 700, 'flies away');
  }
}

test('the mode, then armed', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 0, reqMessageRate: 2, startStop: 1 });
  assert.equal(await setParameter(vehicle, 'TKOFF_ALT', 40), 40);
  await vehicle.wait(25_000);
  assert.equal(await vehicle.command(kDoSetMode, [1, kTakeoff]), 0);
  await vehicle.wait(5000);
  assert.equal(await landed(vehicle), kOnGround);
  await armWhenReady(vehicle);
  await flies(vehicle, 20, ({ relativeAlt }) => relativeAlt > 10_000);
  assert.equal(await landed(vehicle), kTakingOff);
  await circles(vehicle, 40);
  assert.equal(await landed(vehicle), kInAir);
  assert.equal((await vehicle.expect('HEARTBEAT')).customMode, kTakeoff);
}));

test('armed, then the command', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 0, reqMessageRate: 2, startStop: 1 });
  await armWhenReady(vehicle);
  await vehicle.wait(2000);
  assert.equal(await vehicle.command(kNavTakeoff, [100, 0, 0, 0, 0, 0, 55]), 2, 'too steep');
  assert.equal(await vehicle.command(kNavTakeoff, [0, 0, 0, NaN, NaN, NaN, 55]), 0);
  await circles(vehicle, 55);
  assert.equal(await landed(vehicle), kInAir);
  assert.equal(await vehicle.command(kArm, [0]), 4, 'in the air');
}));

test('before there is a position it is put off, with the reason', withVehicle({}, async (vehicle) => {
  assert.equal(await vehicle.command(kNavTakeoff, [15]), 1, 'no position');
  assert.match((await vehicle.expect('STATUSTEXT', { where: ({ text }) => /position/.test(text) })).text,
    /^Circling needs a position/);
  assert.equal(await vehicle.command(kNavTakeoff, [15, 0, 0, 0, 0, 0, 55]), 1, 'no home');
  assert.equal(await vehicle.command(kDoSetMode, [1, kTakeoff]), 1);
  assert.equal(await vehicle.command(kNavTakeoff, [100]), 2, 'too steep, whatever the position');
  await vehicle.wait(25_000);
  assert.equal(await vehicle.command(kNavTakeoff, [15]), 0, 'to TKOFF_ALT, once it is armed');
  vehicle.forget();
  assert.equal((await vehicle.expect('HEARTBEAT', { within_ms: 1500 })).customMode, kTakeoff);
}));
