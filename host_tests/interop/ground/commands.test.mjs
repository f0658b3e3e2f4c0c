// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { armWhenReady, distance_m, flies, said, setParameter, takeOff } from './points.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

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

test('lists its modes, all or one, and is in the one it says', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  await vehicle.wait(1000);
  vehicle.forget();
  assert.equal(await vehicle.command(512, [435, 0]), 0);
  await vehicle.wait(1500);
  const heard = vehicle.line.inbox.filter(({ name }) => name === 'AVAILABLE_MODES').map(({ data }) => data);
  assert.deepEqual(heard.map(({ modeIndex }) => modeIndex), heard.map((_, i) => i + 1));
  assert.equal(heard.length, heard[0].numberModes);
  const auto = heard.find(({ customMode }) => customMode === modes.automatic);
  assert.deepEqual([auto.modeName, auto.standardMode, auto.properties], ['AUTO', 6, 4]);

  vehicle.forget();
  const { modeIndex } = heard.find(({ modeName }) => modeName === 'CRUISE');
  assert.equal(await vehicle.command(512, [435, modeIndex]), 0);
  const cruise = await vehicle.expect('AVAILABLE_MODES');
  assert.equal(cruise.modeIndex, modeIndex);
  assert.equal(await vehicle.command(512, [435, heard.length + 1]), 2);

  assert.equal(await vehicle.command(262, [cruise.standardMode]), 0);
  assert.equal(await vehicle.command(512, [436]), 0);
  const current = await vehicle.expect('CURRENT_MODE');
  assert.deepEqual([current.customMode, current.standardMode], [cruise.customMode, cruise.standardMode]);
}));

// The buttons of Mission Planner's page "Aux Function".
test('does what a switch of the transmitter would', withVehicle({}, async (vehicle) => {
  const kAux = 218, kLow = 0, kHigh = 2, kFbwaFunction = 92, kRelayFunction = 28;
  await vehicle.wait(1500);
  const before = (await vehicle.expect('HEARTBEAT')).customMode;
  assert.equal(await vehicle.command(kAux, [kFbwaFunction, kHigh]), 0);
  await vehicle.expect('HEARTBEAT', inMode(modes.fbwa));
  assert.equal(await vehicle.command(kAux, [kFbwaFunction, kLow]), 0);
  await vehicle.expect('HEARTBEAT', inMode(before));
  assert.equal(await vehicle.command(kAux, [kRelayFunction, kHigh]), 0);
  assert.equal(await vehicle.command(kAux, [201, kHigh]), 3);
}));

test('AUTO without a mission is refused with the reason', withVehicle({}, async (vehicle) => {
  await vehicle.wait(2000);
  vehicle.forget();
  assert.notEqual(await vehicle.command(300), 0);
  await vehicle.expect('STATUSTEXT', { where: ({ text }) => text.length > 0 });
}));

test('arming before the sensors are ready is refused with the reason',
  withVehicle({}, async (vehicle) => {
    assert.equal(await vehicle.command(400, [1]), 4);
    const { text } = await vehicle.expect('STATUSTEXT', { where: (data) => /PreArm/.test(data.text) });
    assert.match(text, /^PreArm: .+/);
  }));

test('arms when ready, says so in the heartbeat, and disarms', withVehicle({}, async (vehicle) => {
  const armed = (wanted) => ({ within_ms: 2000, where: ({ baseMode }) => ((baseMode & 128) !== 0) === wanted });
  await armWhenReady(vehicle);
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

test('what it cannot do is answered', withVehicle({}, async (vehicle) => {
  const cases = [[22, [15], 1], [21, [], 1], [185, [1], 2], [207, [1], 2], [208, [2], 3], [191, [30], 1], [189, [], 1], [206, [-1], 2],
    [31_000, [], 3], [300, [3, 5], 2], [183, [3, 1500], 2], [183, [6, 3000], 2], [181, [1, 1], 2],
    [178, [0, 90, -1], 2], [179, [0], 2], [192, [-1, 0, 0, 0, 47.4, 8.5, 500], 1], [241, [], 3],
    [246, [2], 2], [400, [7], 2], [511, [30, -7], 2], [512, [9999], 3]];
  for (const [command, parameters, result] of cases)
    assert.equal(await vehicle.command(command, parameters), result, `${command} [${parameters}]`);
}));

test('moves a servo and the relay', withVehicle({}, async (vehicle) => {
  await vehicle.wait(500);  // until the mode switch has been read: a change of mode takes the servo back
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 3, reqMessageRate: 10, startStop: 1 });
  assert.equal(await vehicle.command(183, [6, 1780]), 0);
  await vehicle.expect('SERVO_OUTPUT_RAW', { where: ({ servo6Raw }) => servo6Raw === 1780 });
  assert.equal(await vehicle.command(184, [7, 1900, 2, 1]), 0);
  await vehicle.expect('SERVO_OUTPUT_RAW', { where: ({ servo7Raw }) => servo7Raw === 1900 });
  await vehicle.expect('SERVO_OUTPUT_RAW', { where: ({ servo7Raw }) => servo7Raw === 1500 });
  assert.equal(await vehicle.command(181, [0, 1]), 0);
  assert.equal(await vehicle.command(182, [0, 2, 1]), 0);
}));

test('calibrates: in progress, then done', withVehicle({}, async (vehicle) => {
  await vehicle.wait(6000);
  assert.equal(await vehicle.command(241, [1, 0, 1]), 5);
  const done = await vehicle.expect('COMMAND_ACK',
    { within_ms: 15_000, where: ({ command, result }) => command === 241 && result !== 5 });
  assert.equal(done.result, 0);
}));

test('takes the way it stands for level', withVehicle({}, async (vehicle) => {
  const trim = async (name) => {
    vehicle.send('PARAM_REQUEST_READ', { paramId: name, paramIndex: -1 });
    return (await vehicle.expect('PARAM_VALUE', { where: ({ paramId }) => paramId === name })).paramValue;
  };
  const level = async () => {
    vehicle.forget();
    return vehicle.expect('ATTITUDE');
  };
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 10, reqMessageRate: 10, startStop: 1 });
  vehicle.send('PARAM_SET', { paramId: 'AHRS_TRIM_X', paramValue: 0.08, paramType: 9 });
  vehicle.send('PARAM_SET', { paramId: 'AHRS_TRIM_Y', paramValue: -0.06, paramType: 9 });
  await vehicle.wait(20_000);
  const { roll, pitch } = await level();
  assert.ok(Math.abs(roll) > 0.03 && Math.abs(pitch) > 0.02, `${roll} ${pitch}: leans as commanded`);
  assert.equal(await vehicle.command(241, [0, 0, 0, 0, 2]), 0);
  const x = await trim('AHRS_TRIM_X'), y = await trim('AHRS_TRIM_Y');
  assert.ok(Math.abs(x - (0.08 + roll)) < 0.002 && Math.abs(x) < 0.05, `roll ${roll}, now ${x}`);
  assert.ok(Math.abs(y - (-0.06 + pitch)) < 0.002 && Math.abs(y) < 0.04, `pitch ${pitch}, now ${y}`);
}));

test('the ground station can take the place of the receiver', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 3, reqMessageRate: 10, startStop: 1 });
  const sticks = Object.fromEntries([1, 2, 3, 4, 5, 6, 7, 8].map((i) => [`chan${i}Raw`, 65_535]));
  vehicle.send('RC_CHANNELS_OVERRIDE', { ...sticks, chan1Raw: 1234 });
  await vehicle.expect('RC_CHANNELS_RAW', { where: ({ chan1Raw }) => chan1Raw === 1234 });
  vehicle.send('RC_CHANNELS_OVERRIDE', { ...sticks, chan1Raw: 0 });
  await vehicle.expect('RC_CHANNELS_RAW', { where: ({ chan1Raw }) => Math.abs(chan1Raw - 1500) < 20 });
  const released = 32_767;
  vehicle.send('MANUAL_CONTROL', { target: 1, x: 1000, y: -500, z: released, r: released });
  await vehicle.expect('RC_CHANNELS_RAW',
    { where: ({ chan1Raw, chan2Raw }) => chan1Raw === 1300 && chan2Raw === 1100 });
}));

test('a flight is terminated where its owner has allowed it, and comes down there', withVehicle({}, async (vehicle) => {
  const kTerminate = 185, kDenied = 2, kFlightTermination = 8;
  await takeOff(vehicle);
  assert.equal(await vehicle.command(kTerminate, [1]), kDenied);
  await said(vehicle, /Terminate refused: AFS_TERM_ACTION/);
  assert.equal(await setParameter(vehicle, 'AFS_TERM_ACTION', 42), 0, 'no stranger grants himself that');
  const [telemetry, usb] = vehicle.lines;
  vehicle.line = usb;
  assert.equal(await setParameter(vehicle, 'AFS_TERM_ACTION', 42), 42);
  vehicle.line = telemetry;
  const there = await flies(vehicle, 40, ({ relativeAlt }) => relativeAlt > 30_000);
  assert.equal(await vehicle.command(kTerminate, [1]), 0);
  await said(vehicle, /Flight terminated/);
  vehicle.forget();
  const heart = await vehicle.expect('HEARTBEAT', { within_ms: 1500 });
  assert.deepEqual([heart.systemStatus, heart.baseMode & 128], [kFlightTermination, 0]);
  assert.notEqual(await vehicle.command(176, [1, modes.rtl]), 0, 'no mode takes over');
  assert.equal(await vehicle.command(400, [1]), 4);
  await said(vehicle, /PreArm: flight terminated/);
  const down = await flies(vehicle, 30, ({ relativeAlt }) => relativeAlt < 1000);
  assert.ok(distance_m({ x: there.lat, y: there.lon }, down) < 200, 'it flew on');
}));
