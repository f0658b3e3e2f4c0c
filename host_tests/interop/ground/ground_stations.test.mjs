// SPDX-License-Identifier: GPL-3.0-or-later
// What QGroundControl and Mission Planner say when they connect, in their order (QGroundControl's
// InitialConnectStateMachine, Mission Planner's MAVLinkInterface.OpenBg and MainV2), each step when
// the one before is answered: nothing they ask for stays without an answer.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertSame, download, fence, kFence, kRally, rally, upload, wholePlan as plan } from './points.mjs';
import { decode, Ftp, kFile } from '../../support/ftp_client.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

const kAccepted = 0, kUnsupported = 3;
const kRequestMessage = 512, kSetInterval = 511, kGetHome = 410, kCapabilities = 520, kBanner = 42_428;
const kAutopilotVersion = 148, kAvailableModes = 435, kComponentInformation = 395, kComponentMetadata = 397, kHome = 242;
const kFtp = 32n, kFenceItems = 16_384n, kRallyItems = 32_768n;
const square = fence(300), places = rally([0, 100, 50]);

const beat = (vehicle) => vehicle.send('HEARTBEAT', { type: 6, autopilot: 8, mavlinkVersion: 3 });

async function loaded(vehicle) {
  vehicle.line.version = 2;
  assert.equal(await upload(vehicle, plan), 0);
  assert.equal(await upload(vehicle, square, kFence), 0);
  assert.equal(await upload(vehicle, places, kRally), 0);
  vehicle.forget();
}

// Who sees the capability asks for the file, and for the list when that fails.
async function parameterFile(vehicle, size) {
  const parameters = decode(await new Ftp(vehicle).download(kFile, size));
  assert.ok(parameters.some(({ name, value }) => name === 'SYSID_MYGCS' && value === 255));
}

async function allParameters(vehicle) {
  vehicle.send('PARAM_REQUEST_LIST');
  const seen = new Set();
  let count = 1;
  while (seen.size < count) {
    const { paramIndex, paramCount } = await vehicle.expect('PARAM_VALUE');
    seen.add(paramIndex);
    count = paramCount;
  }
}

test('QGroundControl connects: version, modes, metadata, parameters, mission, fence, rally points',
  withVehicle({}, async (vehicle) => {
    await loaded(vehicle);
    beat(vehicle);
    assert.equal(await vehicle.command(kRequestMessage, [kAutopilotVersion]), kAccepted);
    const { capabilities } = await vehicle.expect('AUTOPILOT_VERSION');
    assert.ok(BigInt(capabilities) & kFenceItems && BigInt(capabilities) & kRallyItems, 'it is asked for both');
    assert.ok(BigInt(capabilities) & kFtp, 'it is asked for the file of parameters');
    for (let index = 1, count = 1; index <= count; ++index) {
      assert.equal(await vehicle.command(kRequestMessage, [kAvailableModes, index]), kAccepted);
      const { numberModes, modeIndex } = await vehicle.expect('AVAILABLE_MODES');
      assert.equal(modeIndex, index);
      count = numberModes;
    }
    for (const metadata of [kComponentMetadata, kComponentInformation])
      assert.equal(await vehicle.command(kRequestMessage, [metadata]), kUnsupported);
    await parameterFile(vehicle, 239);
    await allParameters(vehicle);
    assertSame(await download(vehicle), plan);
    assertSame(await download(vehicle, kFence), square);
    assertSame(await download(vehicle, kRally), places);
  }));

test('QGroundControl then asks for home and for its streams', withVehicle({}, async (vehicle) => {
  await vehicle.wait(8000);  // until there is a fix
  vehicle.forget();
  beat(vehicle);
  assert.equal(await vehicle.command(kRequestMessage, [kHome]), kAccepted);
  await vehicle.expect('HOME_POSITION');
  for (const [id, name] of [[30, 'ATTITUDE'], [33, 'GLOBAL_POSITION_INT'], [74, 'VFR_HUD']]) {
    assert.equal(await vehicle.command(kSetInterval, [id, 200_000]), kAccepted);
    await vehicle.expect(name);
  }
}));

test('Mission Planner connects: version, banner, parameters, streams, home, mission', withVehicle({}, async (vehicle) => {
  await loaded(vehicle);
  beat(vehicle);
  vehicle.send('STATUSTEXT', { severity: 6, text: 'Mission Planner 1.3.82' });
  await vehicle.expect('HEARTBEAT', { within_ms: 1500 });
  assert.equal(await vehicle.command(kCapabilities, [1]), kAccepted);
  const { capabilities } = await vehicle.expect('AUTOPILOT_VERSION');
  assert.ok(BigInt(capabilities) & kFtp, 'it is asked for the file of parameters');
  vehicle.forget();
  assert.equal(await vehicle.command(kBanner), kAccepted);
  await vehicle.expect('STATUSTEXT');
  await parameterFile(vehicle, 110);
  await allParameters(vehicle);
  vehicle.forget();
  // status, position, attitude, sensors, inputs, as its settings have them
  for (const [stream, rate, name] of [[2, 2, 'SYS_STATUS'], [6, 2, 'GLOBAL_POSITION_INT'], [10, 4, 'ATTITUDE'], [11, 4, 'VFR_HUD'],
    [1, 2, 'RAW_IMU'], [3, 2, 'RC_CHANNELS']]) {
    vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: stream, reqMessageRate: rate, startStop: 1 });
    await vehicle.expect(name);
  }
  assert.equal(await vehicle.command(kGetHome), kAccepted);
  assertSame(await download(vehicle), plan);
}));
