// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { withVehicle } from '../../support/vehicle.mjs';

test('beats soon after power-on and once a second, unasked', withVehicle({ booted: false }, async (vehicle) => {
  const bootloader_ms = process.env.FLY_BOARD === 'elf' ? 1165 : 0;
  const first = await vehicle.next('HEARTBEAT', { within_ms: bootloader_ms + 1000 });
  assert.ok(first, 'no heartbeat in the first second of the program');
  const after_ms = first.at_ms - bootloader_ms;
  assert.ok(after_ms <= 300, `the first heartbeat came after ${after_ms} ms`);
  assert.equal(first.version, 1);
  assert.equal(first.header.sysid, 1);
  assert.equal(first.header.compid, 1);
  assert.equal(first.data.type, 1);
  assert.equal(first.data.autopilot, 3);
  vehicle.all('HEARTBEAT');

  await vehicle.wait(10_000);

  const beats = vehicle.all('HEARTBEAT').length;
  assert.ok(beats === 10 || beats === 9, `${beats}`);  // the frames' clock may be 1 % slow
}));

test('says in the first seconds what it is', withVehicle({ booted: false }, async (vehicle) => {
  const { text } = await vehicle.expect('STATUSTEXT', { within_ms: 2000 });
  assert.match(text, /autopilot/);
}));

test('answers in the version it is spoken to', withVehicle({}, async (vehicle) => {
  vehicle.line.version = 2;
  vehicle.send('PING', { timeUsec: 5n, seq: 7, targetSystem: 0, targetComponent: 0 });
  const ping = await vehicle.next('PING');
  assert.equal(ping.version, 2);
  assert.equal(ping.data.seq, 7);
  vehicle.forget();
  const beat = await vehicle.next('HEARTBEAT', { within_ms: 1100 });
  assert.equal(beat.version, 2);
}));

test('both serial lines are links of their own', withVehicle({}, async (vehicle) => {
  const [telemetry, usb] = vehicle.lines;
  usb.version = 2;
  usb.send('PING', { timeUsec: 1n, seq: 3, targetSystem: 0, targetComponent: 0 });
  await vehicle.wait(1500);

  assert.ok(usb.inbox.some(({ name, version }) => name === 'PING' && version === 2));
  assert.ok(usb.inbox.some(({ name }) => name === 'HEARTBEAT'));
  assert.ok(!telemetry.inbox.some(({ name }) => name === 'PING'));
  assert.ok(telemetry.inbox.every(({ version }) => version === 1));
}));

test('with the factory wiring telemetry is on USART0', withVehicle(
  { options: ['--telemetry', 'uart0'] }, async (vehicle) => {
    vehicle.send('PING', { timeUsec: 1n, seq: 3, targetSystem: 0, targetComponent: 0 });
    await vehicle.expect('PING');
  }));

test('link0 changes its rate with the USB cable and goes on', withVehicle(
  { options: ['--telemetry', 'uart0'] }, async (vehicle) => {
    assert.equal(await vehicle.order('usb in'), 'ok');
    await vehicle.wait(200);
    vehicle.forget();
    await vehicle.expect('HEARTBEAT', { within_ms: 1100 });
    assert.equal(await vehicle.order('usb out'), 'ok');
    await vehicle.wait(200);
    vehicle.forget();
    await vehicle.expect('HEARTBEAT', { within_ms: 1100 });
  }));

test('noise between frames costs none of them', withVehicle({}, async (vehicle) => {
  await vehicle.wait(500);
  const noise = Buffer.from([0xfe, 37, 1, 2, 3, 73, 0xfd, 0xff, 0, 0xfe]);
  for (let seq = 1; seq <= 5; ++seq) {
    vehicle.line.socket.write(noise);
    vehicle.line.written += noise.length;
    vehicle.send('PING', { timeUsec: 1n, seq, targetSystem: 0, targetComponent: 0 });
  }
  // the first false start is known not to be a frame when as many bytes have come as it promised
  vehicle.send('HEARTBEAT', { type: 6, autopilot: 8, mavlinkVersion: 3 });
  vehicle.send('HEARTBEAT', { type: 6, autopilot: 8, mavlinkVersion: 3 });
  await vehicle.wait(500);
  assert.deepEqual(vehicle.all('PING').map(({ seq }) => seq), [1, 2, 3, 4, 5]);
}));

test('describes itself', withVehicle({}, async (vehicle) => {
  assert.equal(await vehicle.command(520), 0);
  const version = await vehicle.expect('AUTOPILOT_VERSION');
  assert.equal(Number(version.capabilities) & 8192, 8192);
  const { stdout } = spawnSync('git', ['log', '-1', '--abbrev=8', '--format=%h', '--', 'firmware', 'libraries', 'hal_avr'],
    { cwd: new URL('../../..', import.meta.url), encoding: 'utf8' });
  const commit = (stdout ?? '').trim().slice(0, 8).padEnd(8, '\0');  // without a history there is none
  assert.equal(String.fromCharCode(...version.flightCustomVersion), commit);
  assert.ok(version.boardVersion === 1 || version.boardVersion === 2, `board ${version.boardVersion}`);
  assert.equal(await vehicle.command(512, [300]), 0);
  assert.equal((await vehicle.expect('PROTOCOL_VERSION')).maxVersion, 200);
  assert.equal(await vehicle.command(31_000), 3);
}));
