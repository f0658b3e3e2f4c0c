// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withVehicle } from './vehicle.mjs';

const modes = { manual: 0, stabilize: 2, fbwa: 5, automatic: 10, rtl: 11, loiter: 12 };

const inMode = (mode) => ({ within_ms: 1200, where: ({ customMode }) => customMode === mode });

test('changes mode by command and by SET_MODE', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  assert.equal(await vehicle.command(176, [1, modes.fbwa]), 0);
  await vehicle.expect('HEARTBEAT', inMode(modes.fbwa));
  vehicle.send('SET_MODE', { baseMode: 1, customMode: modes.stabilize });
  assert.equal((await vehicle.expect('COMMAND_ACK')).result, 0);
  await vehicle.expect('HEARTBEAT', inMode(modes.stabilize));
  assert.notEqual(await vehicle.command(176, [1, 99]), 0);
}));

test('AUTO without a mission is refused and the reason told', withVehicle({}, async (vehicle) => {
  await vehicle.wait(2000);
  vehicle.forget();
  assert.notEqual(await vehicle.command(300), 0);
  await vehicle.expect('STATUSTEXT', { where: ({ text }) => text.length > 0 });
}));

test('arming before the sensors are ready is refused and the reason told',
  withVehicle({}, async (vehicle) => {
    assert.equal(await vehicle.command(400, [1]), 4);
    const { text } = await vehicle.expect('STATUSTEXT', { where: (data) => /PreArm/.test(data.text) });
    assert.match(text, /^PreArm: .+/);
  }));

test('arms when ready, says so in the heartbeat, and disarms', withVehicle({}, async (vehicle) => {
  const armed = (wanted) => ({ within_ms: 2000, where: ({ baseMode }) => ((baseMode & 128) !== 0) === wanted });
  let result = 4;
  for (let tries = 0; tries < 60 && result !== 0; ++tries) {
    await vehicle.wait(1000);
    result = await vehicle.command(400, [1]);
  }
  assert.equal(result, 0, 'never ready in a minute');
  vehicle.forget();
  await vehicle.expect('HEARTBEAT', armed(true));
  assert.equal(await vehicle.command(410), 0);
  const home = await vehicle.expect('HOME_POSITION');
  assert.ok(Math.abs(home.latitude - 473_977_000) < 2000, `${home.latitude}`);
  assert.equal(await vehicle.command(246, [1]), 1, 'a reboot while armed');
  assert.equal(await vehicle.command(400, [0]), 0);
  vehicle.forget();
  await vehicle.expect('HEARTBEAT', armed(false));
}));

test('the ground station can take the place of the receiver', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 3, reqMessageRate: 10, startStop: 1 });
  const sticks = Object.fromEntries([1, 2, 3, 4, 5, 6, 7, 8].map((i) => [`chan${i}Raw`, 65_535]));
  vehicle.send('RC_CHANNELS_OVERRIDE', { ...sticks, chan1Raw: 1234 });
  await vehicle.expect('RC_CHANNELS_RAW', { where: ({ chan1Raw }) => chan1Raw === 1234 });
  vehicle.send('RC_CHANNELS_OVERRIDE', { ...sticks, chan1Raw: 0 });
  await vehicle.expect('RC_CHANNELS_RAW', { where: ({ chan1Raw }) => Math.abs(chan1Raw - 1500) < 20 });
}));
