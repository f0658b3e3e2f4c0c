// SPDX-License-Identifier: GPL-3.0-or-later
// Bench sessions with the image on the emulated chip in which something is wrong; session.test.mjs
// has the good board.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import * as person from '../../support/bench_person.mjs';
import { withRig } from '../../support/bench_rig.mjs';

const good = { options: ['--calibrated'] };

test('cold starts: as many as were made are counted', withRig(good, async (rig) => {
  let quick = 0;
  await rig.run([5], { ...person.starts, '5.quick': (each) => (++quick > 3 ? 'skip' : person.starts['5.quick'](each)),
    '5.slow': 'skip' });
  assert.equal(rig.step(5).verdict, 'not done');
  assert.equal(rig.part('5.quick').value, '3 of 20 starts were made');
  assert.equal(rig.printed.filter((line) => /heartbeat 0\.\d\d s, sample 0\.\d\d s/.test(line)).length, 3);
}));

test('a start without the inertial sensor fails cold starts', withRig(good, async (rig) => {
  await rig.run([5], { '5.quick': async (each) => {
    await each.order('fault imu:lost 1000');
    return person.starts['5.quick'](each);
  }, '5.slow': 'skip' });
  assert.match(rig.part('5.quick').value, /start 1 of 20: without an inertial sample/);
  assert.equal(rig.step(5).verdict, 'fail');
}));

test('a bootloader that loops over a watchdog\'s reset fails step 2', withRig({ options: ['--bootloader', 'looping'], violates: true }, async (rig) => {
  await rig.run([2], { ...person.fuses, '2.button': 'skip' });
  assert.equal(rig.part('2.reboot').verdict, 'fail');
}));

test('the other board\'s image is recognised', withRig({ options: ['--firmware', process.env.OTHER_IMAGE] }, async (rig) => {
  const right = 'fail the simulator cannot be flashed';
  await rig.run([4], { '4.outputs': async (each) => String(JSON.parse(await each.order('servos')).filter((us) => us > 0).length),
    '4.back': right });
  for (const id of ['4.text', '4.arming', '4.outputs']) assert.equal(rig.part(id).verdict, 'pass', `${id}: ${rig.part(id).value}`);
  assert.equal(rig.step(4).verdict, 'fail', 'the right image was not put back');
}));

// ---- the APM 1 where it is not an APM 2; its whole session is bench.session_apm1

test('an APM 1 restarts without its loader, has the load of the simulator, and its barometer passes', withRig({ ...good, board: 'apm1' }, async (rig) => {
  await rig.run([2, 6, 10], { ...person.fuses, ...person.air, '10.dips': 'skip' });
  for (const number of [2, 6]) rig.passes(number);
  for (const id of ['10.lift', '10.syringe', '10.healthy']) assert.equal(rig.part(id).verdict, 'pass', `${id}: ${rig.part(id).value}`);
  assert.equal(rig.part('2.reboot').limit, 'at most 0.5 s');
}));

test('an APM 1 has its compass back in time, though the barometer is on the same bus', withRig({ ...good, board: 'apm1' }, async (rig) => {
  const skipped = Object.fromEntries(Object.keys(person.headings).map((id) => [id, 'skip']));
  await rig.run([9], { ...skipped, '9.unplug': person.headings['9.unplug'] });
  assert.equal(rig.part('9.unplug').verdict, 'pass', rig.part('9.unplug').value);
}));

for (const [switch_us, verdict] of [[1900, 'not done'], [1500, 'pass']])
  test(`at ${switch_us} us of channel 8 the motor's output of a disarmed APM 1 is ${verdict}`, withRig({ ...good, board: 'apm1' }, async (rig) => {
    await rig.order(`sticks 1500 1500 1100 1500 1500 1500 1500 ${switch_us}`);
    await rig.vehicle.wait(3000);
    await rig.run([11], { '*': 'skip', '11.disarmed': '', ...person.confirmations('11.motor') });
    assert.equal(rig.part('11.disarmed').verdict, verdict, rig.part('11.disarmed').value);
    assert.equal(rig.asked.some((id) => ['11.disarmed', '11.controller', '11.motor.confirm_motor'].includes(id)), verdict === 'pass');
  }));
