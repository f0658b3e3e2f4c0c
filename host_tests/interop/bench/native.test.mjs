// SPDX-License-Identifier: GPL-3.0-or-later
// Bench sessions with the natively compiled firmware: what a good board passes, where a bad one
// fails, and what is never done without being asked.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { stepsOf } from '../../../toolchain/bench_tool/options.mjs';
import { Stopped } from '../../../toolchain/bench_tool/errors.mjs';
import * as person from '../../support/bench_person.mjs';
import { order, withRig } from '../../support/bench_rig.mjs';

const kCalibrated = ['--calibrated'];
const good = { options: kCalibrated };
const failedParts = (rig, number) => rig.step(number).parts.filter(({ verdict }) => verdict === 'fail').map(({ id }) => id);

test('a good board passes what needs no restart, and the form shows it', withRig(good, async (rig) => {
  assert.equal(await rig.run(stepsOf('1,8-10,12'), { ...person.supply, ...person.sides, ...person.headings, ...person.air, ...person.receiver }), false,
    'the other steps are not done');
  for (const number of stepsOf('1,8-10,12')) rig.passes(number);
  const form = rig.form();
  assert.match(form, /not complete/);
  assert.match(form, /5 of 16/);
  assert.match(form, /5\.01 V/);
  assert.match(form, /signature/);
  assert.equal(rig.part('9.unplug').verdict, 'pass');
}));

test('GPS and telemetry', withRig(good, async (rig) => {
  await rig.run([13], person.links);
  rig.passes(13);
  assert.match(rig.part('13.gps_9600').value, /u-blox/);
}));

test('without the port of the radio its parts are not done, and so is the step', withRig(good, async (rig) => {
  await rig.run([13], { ...person.links, '13.loss': 'skip', '13.usb_1': 'skip' });
  assert.equal(rig.step(13).verdict, 'not done');
}));

test('two minutes of log without a gap; the mask of the logs is as before', withRig(good, async (rig) => {
  await rig.run([14], { '14.cuts': 'skip' });
  assert.equal(rig.part('14.gaps').verdict, 'pass', rig.part('14.gaps').value);
  assert.equal(rig.step(14).verdict, 'not done');
  assert.equal(await rig.board.parameter('LOG_BITMASK'), 16382);
}));

// ---- bad boards

const kBoots_ms = 2000;  // by then every sensor has been found

for (const [what, options, fault, steps, answers, bad] of [
  ['a silent barometer', kCalibrated, 'baro:lost 10000', [10], { ...person.air, '10.dips': 'skip', '10.syringe': 'skip' }, ['10.lift', '10.healthy']],
  ['noisy gyros', kCalibrated, 'imu:noisy 10000', [8], person.sides, ['8.noise']],
  ['a silent inertial sensor', kCalibrated, 'imu:lost 10000', [8], person.sides, ['8.on_its_back', '8.noise']],
  ['a compass that is upside down', [...kCalibrated, '--external-compass', '180,0,0'], null, [9], person.headings, ['9.east', '9.west']],
  ['a pitot sensor that drifts', kCalibrated, 'airspeed:noisy 10000', [10], person.air, ['10.dips']],
  ['a receiver of which one edge of fifty is missing', kCalibrated, 'radio:missed_edge 10000', [12], person.receiver, ['12.channel_']],
])
  test(`${what} fails in its step`, withRig({ options }, async (rig) => {
    await rig.vehicle.wait(kBoots_ms);
    if (fault) await rig.order(`fault ${fault}`);
    const faults_end = { '12.unplugged': 'skip', '12.ppm': 'skip', '9.unplug': 'skip' };
    await rig.run(steps, { ...answers, ...faults_end });
    assert.equal(rig.step(steps[0]).verdict, 'fail');
    const failed = failedParts(rig, steps[0]);
    for (const id of bad) assert.ok(failed.some((part) => part.startsWith(id)), `${id} is not among ${failed}`);
    assert.match(rig.form(), /class="verdict fail"/);
  }));

test('a meter that shows too much current, a wrong fuse and a person who sees a fault', withRig(good, async (rig) => {
  await rig.run([1, 2], { ...person.supply, ...person.fuses, '1.current': '480', '2.high': 'D0', '2.reboot': 'fail it smokes', '2.button': 'skip',
    '1.rail_5v': 'skip' });
  assert.deepEqual(failedParts(rig, 1), ['1.current']);
  assert.deepEqual(failedParts(rig, 2), ['2.high', '2.reboot']);
  assert.equal(rig.part('2.reboot').value, 'it smokes');
}));

// ---- the motor

const withoutRestarts = { ...person.outputs, '11.longest': 'skip' };

test('with three confirmations the outputs are measured, the motor\'s too, and everything is put back', withRig(good, async (rig) => {
  rig.watching = true;
  await rig.run([11], withoutRestarts);
  assert.deepEqual(rig.step(11).parts.filter(({ verdict }) => verdict !== 'pass').map(({ id }) => id), ['11.longest']);
  assert.ok(rig.motor_us > 1850, `the motor's pulse was ${rig.motor_us}`);
  for (const [name, value] of [['RC1_MIN', 1100], ['RC1_MAX', 1900], ['ARMING_RUDDER', 1]])
    assert.equal(await rig.board.parameter(name), value, name);
  assert.deepEqual(rig.state.restore, {});
  assert.equal((await rig.board.next('HEARTBEAT', { within_ms: 2000 })).data.baseMode & 128, 0);
}));

for (const [id, answer] of [['11.motor.confirm_propeller', 'yes'], ['11.motor.confirm_people', 'nobody'], ['11.motor.confirm_motor', '']])
  test(`without ${id} the motor's pulse never rises`, withRig(good, async (rig) => {
    rig.watching = true;
    await rig.run([11], { ...withoutRestarts, [id]: answer });
    assert.equal(rig.part('11.motor').verdict, 'not done');
    assert.ok(rig.motor_us > 900 && rig.motor_us <= 1100, `the motor's pulse was ${rig.motor_us}`);
    assert.ok(!rig.board.texts.some(({ text }) => /^Arm/.test(text)));
  }));

test('nothing is asked before the propeller is off', withRig(good, async (rig) => {
  await assert.rejects(rig.run([11], { propeller: 'yes' }), /nothing is done before "the propeller is off"/);
  assert.deepEqual(rig.asked, ['propeller']);
}));

// A pilot's rudder in the middle of a step.
test('what is armed by somebody else is disarmed, and the part fails', withRig(good, async (rig) => {
  await rig.run([12], { ...person.receiver, '12.channel_1': async (each) => {
    await each.vehicle.wait(6000);  // what arming needs is there
    await each.order('sticks 1500 1500 1100 1900 1500 1500 1500 1800');
    await each.vehicle.wait(6000);
    return '1500';
  } });
  assert.match(rig.part('12.channel_1').value, /armed, and not by this program/);
  assert.ok(rig.printed.includes('  disarmed'));
}));

// ---- ends and resumptions

test('a session that is stopped in the armed part disarms and restores, and resumes at what is left', withRig(good, async (rig) => {
  const stops = (each) => { each.board.stopping = true; return scopeOf(each); };
  const scopeOf = async (each) => JSON.parse(await each.order('servos'))[2].toFixed(1);
  await assert.rejects(rig.run([1, 11, 12], { ...person.supply, ...withoutRestarts, '11.motor.1500': stops }), Stopped);
  assert.equal((await rig.board.next('HEARTBEAT', { within_ms: 2000 })).data.baseMode & 128, 0, 'disarmed');
  assert.equal(await rig.board.parameter('RC1_MIN'), 1100);
  assert.equal(rig.step(1).verdict, 'pass');
  assert.equal(rig.step(11).verdict, 'not done');
  assert.equal(rig.step(12), undefined);

  rig.asked.length = 0;
  await rig.run([12], person.receiver);
  rig.passes(12);
  assert.equal(rig.step(1).verdict, 'pass', 'what was measured before stays');
}));

test('what a session that was killed has left is restored by the next one', withRig(good, async (rig) => {
  await assert.rejects(rig.run([14], { '14.gaps': async (each) => {
    const { safety } = each.session;
    await safety.change('LOG_BITMASK', 81918);
    safety.end = () => Promise.resolve([]);  // as if it were killed here
    throw new Stopped();
  } }), Stopped);
  assert.equal(await rig.board.parameter('LOG_BITMASK'), 81918);
  await rig.run([1], person.supply);
  assert.equal(await rig.board.parameter('LOG_BITMASK'), 16382);
  assert.ok(rig.printed.some((line) => /could not restore LOG_BITMASK/.test(line)));
}));

test('a board that falls silent fails the part and what could not be undone is said', withRig(good, async (rig) => {
  await rig.run([14], { '14.cuts': 'skip', '14.gaps': async (each) => {
    const { safety, board } = each.session;
    await safety.change('LOG_BITMASK', 81918);
    board.port.write = () => {};
    return order('usb in')(each);
  } });
  assert.equal(rig.part('14.gaps').verdict, 'fail');
  assert.ok(rig.printed.some((line) => /NOT UNDONE: set LOG_BITMASK to 16382/.test(line)), rig.printed.join('\n'));
  assert.deepEqual(rig.state.restore, { LOG_BITMASK: 16382 }, 'and is kept for the next session');
}));
