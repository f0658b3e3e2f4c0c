// SPDX-License-Identifier: GPL-3.0-or-later
// Step 15: restarts, at rest and in what the board takes for flight.
import { NotMeasured } from '../errors.mjs';
import { degrees, wrapped_deg } from '../figures.mjs';
import { within } from '../limits.mjs';
import { idOf } from '../mavlink.mjs';
import { attitude, firmwareHasOutputs, restart } from './readings.mjs';

const kFlying = 4;  // MAV_STATE_ACTIVE
const kAhrs = 0x200000, kRequest = 512, kRightWithin_s = 1.5;  // MAV_SYS_STATUS_AHRS
const kOff_deg = 5, kAligned_ms = 8000, kFlyingWithin_ms = 60_000;

// The largest difference of two attitudes, of a level board.
function off_deg(before, after) {
  return Math.max(...['roll_rad', 'pitch_rad', 'yaw_rad'].map((axis) => Math.abs(wrapped_deg(degrees(after[axis] - before[axis])))));
}
const shown = ({ roll_rad, pitch_rad, yaw_rad }) => [roll_rad, pitch_rad, yaw_rad].map((each) => degrees(each).toFixed(1)).join('/');
const limit = within({ high: kOff_deg, unit: '°', why: 'docs/restart.md: right within 5 degrees' });

const atRest = {
  id: '15.rest', title: 'attitude after a restart at rest, against that before', limit,
  measure: async (b) => {
    await b.board.wait(kAligned_ms);  // the step before may have restarted it
    const before = await attitude(b);
    await restart(b, () => b.person.action(b.id, 'The board lies level and is left alone. Press Enter, then the reset button.'));
    await b.board.wait(kAligned_ms);
    const after = await attitude(b);
    return { value: off_deg(before, after), note: `roll/pitch/yaw ${shown(before)}, then ${shown(after)}` };
  },
};

// The attitude before the silence, and the first one after it that the board calls right.
async function firstAttitude(b, begin) {
  await b.board.rate('ATTITUDE', 50);
  let last_ms = b.board.now_ms(), before, after, back_ms, right = false, after_s;
  const listener = ({ name, data, at_ms }) => {
    if (at_ms - last_ms > 150) back_ms ??= at_ms;
    last_ms = at_ms;
    if (name === 'SYS_STATUS' && back_ms !== undefined) right ||= (data.onboardControlSensorsHealth & kAhrs) !== 0;
    if (name !== 'ATTITUDE') return;
    const now = { roll_rad: data.roll, pitch_rad: data.pitch, yaw_rad: data.yaw };
    if (back_ms === undefined) before = now;
    else if (right && !after) {
      after = now;
      after_s = (at_ms - back_ms) / 1000;
    }
  };
  return b.board.listening(listener, async () => {
    await b.board.until(() => before, 2000);
    await begin();
    await b.board.until(() => back_ms, 30_000);
    for (let tries = 0; tries < 100 && back_ms !== undefined && !after; ++tries) {
      for (const message of ['SYS_STATUS', 'ATTITUDE']) b.board.send('COMMAND_LONG', { command: kRequest, _param1: idOf(message) });
      await b.board.until(() => after, 100);
    }
    if (!before || !after) throw new NotMeasured(back_ms === undefined ? 'the board was never silent' : 'no attitude came within 10 s of its return');
    return { before, after, after_s };
  });
}

const inFlight = {
  id: '15.brown_out', title: 'attitude after a cut of 0.2 s in "flight", against that before', limit,
  measure: async (b) => {
    await firmwareHasOutputs(b);
    await b.safety.confirmed('15.brown_out');
    b.safety.hold([1500, 1500, 1000, 1500]);
    await b.board.wait(700);
    await b.safety.arm('15.brown_out');
    await b.person.action(`${b.id}.fly`, 'The board now has to take itself for flying: 150 Pa in the pitot tube (the syringe, clamped), ' +
      'and 12 m higher than where it was armed, by stairs or by 145 Pa less in a closed box.');
    let status;
    await b.board.listening(({ name, data }) => { if (name === 'HEARTBEAT') status = data.systemStatus; },
      () => b.board.until(() => status === kFlying, kFlyingWithin_ms));
    if (status !== kFlying) throw new NotMeasured('it does not take itself for flying: system status is not ACTIVE');
    const { before, after, after_s } = await firstAttitude(b, () =>
      b.person.action(`${b.id}.cut`, 'Press Enter, then cut the supply for 0.2 s (a turntable shows errors of turning; at rest only those of the estimate).'));
    const resumed = await b.board.text(/Restarted|Started/, 3000, b.board.now_ms() - 3000);
    return { value: off_deg(before, after), ok: after_s <= kRightWithin_s,
      note: `roll/pitch/yaw ${shown(before)}, then ${shown(after)}, ${after_s.toFixed(2)} s after its first byte (limit ${kRightWithin_s}); ${resumed ?? 'no text'}` };
  },
};

export const restarts = {
  number: 15, title: 'Restarts', tools: 'a switch that cuts the supply for 0.2 s, the syringe; a turntable if there is one; PROPELLER OFF',
  failed: 'The bootloader\'s time (step 2), or a supply that returns too slowly.',
  parts: [atRest, inFlight],
};
