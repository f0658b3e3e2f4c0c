// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink FTP as ground stations use it to get all parameters at once.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decode, figures, Ftp, kAck, kBurst, kEof, kFile, kInvalidSession, kList, kMaxData, kNoSessions, kNotFound, kOpen, kRead, kReset,
  kTerminate, kUnknownCommand, kWrite } from '../../support/ftp_client.mjs';
import { withVehicle } from '../../support/vehicle.mjs';

// What the chip has no part in is tried natively alone: its emulated minutes are counted.
const notOfTheChip = { skip: process.env.FLY_BOARD === 'elf' };

async function parameterList(vehicle) {
  vehicle.send('PARAM_REQUEST_LIST');
  const values = [await vehicle.expect('PARAM_VALUE')];
  while (values.length < values[0].paramCount) values.push(await vehicle.expect('PARAM_VALUE', { within_ms: 3000 }));
  return values.map(({ paramId, paramType, paramValue }) =>
    ({ name: paramId, type: { 2: 1, 4: 2, 6: 3, 9: 4 }[paramType], value: paramValue }));
}

test('the file has the parameters of the list, and comes in less than half of its time', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const ftp = new Ftp(vehicle);
  const began_ms = vehicle.now_ms;
  const listed = await parameterList(vehicle);
  const listed_ms = vehicle.now_ms - began_ms;
  const opened_ms = vehicle.now_ms;
  const file = await ftp.download();
  const took_ms = vehicle.now_ms - opened_ms;
  assert.deepEqual(decode(file), listed);
  const wire_ms = Math.ceil(file.length / 80) * (12 + 15 + 80) * 10 / 57.6;
  console.log(`${listed.length} parameters, ${file.length} bytes in ${took_ms} ms; the line alone takes ${
    Math.round(wire_ms)}, PARAM_REQUEST_LIST ${listed_ms}`);
  assert.ok(took_ms < wire_ms * 1.25 + 150, `${took_ms} ms`);
  assert.ok(took_ms < listed_ms / 2, `${took_ms} of ${listed_ms} ms`);
}));

test('beside all streams no frame is late, and the values are those in force', withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const ftp = new Ftp(vehicle);
  vehicle.send('REQUEST_DATA_STREAM', { reqStreamId: 0, reqMessageRate: 4, startStop: 1 });
  vehicle.send('PARAM_SET', { paramId: 'WP_RADIUS', paramValue: 42, paramType: 9 });
  await vehicle.expect('PARAM_VALUE');
  const found = decode(await ftp.download(`${kFile}?withdefaults=1`, 239));
  assert.equal(found.find(({ name }) => name === 'WP_RADIUS').value, 42);
  assert.equal((await vehicle.expect('SYS_STATUS', { within_ms: 3000 })).errorsCount2, 0, 'late frames');
  await vehicle.expect('HEARTBEAT', { within_ms: 1500 });
}));

test('what was lost is read again, in any order', notOfTheChip, withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const ftp = new Ftp(vehicle);
  const whole = await ftp.download();
  assert.deepEqual(await ftp.download(kFile, 80, (n) => n % 3 === 1), whole);
  const size = await ftp.open();
  for (const offset of [2000, 7, size - 3, 1000]) {
    const part = await ftp.ask(kRead, { offset, size: 50 });
    assert.deepEqual([part.opcode, part.offset], [kAck, offset]);
    assert.deepEqual(part.data, whole.subarray(offset, offset + 50));
  }
  const part = await ftp.ask(kRead, { offset: 0, size: 239 });
  assert.equal(part.size, kMaxData, 'what fits');
  await ftp.refused(kEof, kRead, { offset: size, size: 80 });
  await ftp.refused(kEof, kRead, { offset: 0x10000, size: 80 });
}));

test('what there is not is refused with the reason', notOfTheChip, withVehicle({}, async (vehicle) => {
  const ftp = new Ftp(vehicle);
  await ftp.refused(kInvalidSession, kRead, { offset: 0, size: 80 });
  for (const path of ['@PARAM/param.pc', '@PARAM/param.pckx', '@SYS/threads.txt', '/APM/LOGS/1.BIN', ''])
    await ftp.refused(kNotFound, kOpen, { data: path });
  await ftp.open();
  await ftp.refused(kInvalidSession, kRead, { session: 3, size: 80 });
  await ftp.refused(kUnknownCommand, kWrite, { data: 'abc' });
  await ftp.refused(kUnknownCommand, kList, { data: '/' });
  await ftp.ask(kTerminate);
  await ftp.refused(kInvalidSession, kBurst, { size: 80 });
}));

test('the figures of the firmware are read as text', withVehicle({}, async (vehicle) => {
  await vehicle.wait(2000);
  const ftp = new Ftp(vehicle);
  const tasks = figures(await ftp.download('@SYS/tasks.txt'));
  assert.ok(Object.keys(tasks).length > 50);
  for (const [name, [longest_us, budget_us]] of Object.entries(tasks))  // with the interrupts, a budget is without
    assert.ok(budget_us > 0 && longest_us <= budget_us + 300, `${name}: ${longest_us} of ${budget_us} us`);
  if (process.env.FLY_BOARD === 'elf') {
    assert.ok(tasks.runInertial[0] > 300 && tasks.runGuidance[0] > 10, `${tasks.runInertial}, ${tasks.runGuidance}`);
    const [free] = figures(await ftp.download('@SYS/memory.txt', 239))['free below stack'];
    assert.ok(free > 2000 && free < 4000, `${free} bytes`);
  }
  ftp.line.socket.write('neither');
  ftp.line.written += 7;
  const errors = figures(await ftp.download('@SYS/errors.txt', 239));
  assert.deepEqual(Object.keys(errors).slice(0, 3), ['late frames', 'log records lost', 'texts lost']);
  for (const [name, [count]] of Object.entries(errors)) assert.equal(count, 0, name);
}));

test('one ground station at a time, each on its own link', notOfTheChip, withVehicle({}, async (vehicle) => {
  await vehicle.wait(1000);
  const [first, second] = vehicle.lines.map((line) => new Ftp(vehicle, line));
  await first.open();
  first.send(kBurst, { size: 80 });
  await vehicle.wait(100);
  await second.refused(kNoSessions, kOpen, { data: kFile });
  await second.refused(kInvalidSession, kRead, { size: 80 });
  assert.equal((await second.ask(kReset)).opcode, kAck);
  await vehicle.wait(1500);
  const parts = first.line.inbox.filter(({ name }) => name === 'FILE_TRANSFER_PROTOCOL');
  assert.ok(parts.length > 30, 'nobody else ends it');
  assert.equal(decode(await second.download()).length > 200, true);
}));
