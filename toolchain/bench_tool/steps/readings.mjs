// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements that several steps make. Each is given { board, person, safety, options, print, id }.
import { NotDone, NotMeasured } from '../errors.mjs';
import { median } from '../figures.mjs';
import { idOf } from '../mavlink.mjs';

const kGone_ms = 150, kRestart_ms = 70, kAskAgain_ms = 100, kFast_hz = 50;
const kSetInterval = 511, kGyro = 1;  // MAV_SYS_STATUS_SENSOR_3D_GYRO
const kCause = /^(Started|Restarted) /;

// A reading of a meter that can show `low` to `high`.
export const meter = (text, range) => ({ person, id }) => person.number(id, text, range);

export const fields = (samples, ...names) => samples.map(({ data }) => names.map((name) => data[name]));
export const field = (samples, name) => samples.map(({ data }) => data[name]);

// After the action that `begin` asks for: the longest silence, the first heartbeat after it, and
// the text that gives the cause of the restart.
export async function restart({ board }, begin, within_ms = 60_000) {
  if (board.port.connected) await board.rate('ATTITUDE', kFast_hz);
  let before_ms = board.now_ms(), silence = { from_ms: before_ms, to_ms: before_ms }, beat_ms;
  const listener = ({ name, at_ms }) => {
    if (at_ms - before_ms > silence.to_ms - silence.from_ms) {
      silence = { from_ms: before_ms, to_ms: at_ms };
      beat_ms = undefined;
    }
    before_ms = at_ms;
    if (name === 'HEARTBEAT') beat_ms ??= at_ms;
  };
  return board.listening(listener, async () => {
    const since_ms = board.now_ms();
    await begin();
    const text = await board.text(kCause, within_ms, since_ms);
    const silent_ms = silence.to_ms - silence.from_ms;
    if (!text) throw new NotMeasured(`no text of a restart within ${within_ms / 1000} s` +
      `${board.port.connected ? '' : '; the port is gone'}`);
    if (silent_ms < kRestart_ms) throw new NotMeasured('it reported a restart without having been silent');
    await board.until(() => beat_ms, 2000);
    return { text, silent_s: silent_ms / 1000, up_ms: silence.to_ms, beat_ms };
  });
}

const ask = (board, name, rate_hz) => board.send('COMMAND_LONG',
  { command: kSetInterval, _param1: idOf(name), _param2: 1e6 / rate_hz });

// Of a start from no power: seconds from the program's beginning to the first heartbeat, to the
// first plausible inertial sample, and to gyros that are calibrated.
export async function coldStart({ board }, begin, within_ms = 60_000) {
  const times = { began_ms: Infinity };
  let asked_ms = -Infinity, silent_since_ms = board.now_ms(), gone = false;
  const hears = {
    HEARTBEAT: ({ at_ms }) => { times.beat_ms ??= at_ms; },
    RAW_IMU: ({ data, at_ms }) => {
      const age_ms = Number(data.timeUsec) / 1000;
      times.began_ms = Math.min(times.began_ms, at_ms - age_ms);
      const length_mg = Math.hypot(data.xacc, data.yacc, data.zacc);
      if (length_mg > 800 && length_mg < 1200) times.sample_s ??= age_ms / 1000;
    },
    SYS_STATUS: ({ data, at_ms }) => { if (data.onboardControlSensorsHealth & kGyro) times.ready_ms ??= at_ms; },
  };
  const listener = (heard) => {
    gone ||= heard.at_ms - silent_since_ms > kGone_ms;
    silent_since_ms = heard.at_ms;
    if (gone) hears[heard.name]?.(heard);
  };
  if (board.port.connected) await board.rate('ATTITUDE', kFast_hz);
  silent_since_ms = board.now_ms();
  const ended = await board.listening(listener, async () => begin().then(() => board.until(() => {
    if (gone && board.now_ms() - asked_ms > kAskAgain_ms) {
      asked_ms = board.now_ms();
      for (const name of ['RAW_IMU', 'SYS_STATUS']) ask(board, name, kFast_hz);
    }
    return times.beat_ms !== undefined && times.sample_s !== undefined && times.ready_ms !== undefined;
  }, within_ms)));
  if (!gone) throw new NotMeasured(`the board was never silent within ${within_ms / 1000} s`);
  if (!ended) {
    const missing = { beat_ms: 'a heartbeat', sample_s: 'an inertial sample of 1 g', ready_ms: 'calibrated gyros' };
    throw new NotMeasured(`without ${Object.keys(missing).filter((key) => times[key] === undefined).map((key) => missing[key]).join(', ')}`);
  }
  return { beat_s: (times.beat_ms - times.began_ms) / 1000, sample_s: times.sample_s, ready_s: (times.ready_ms - times.began_ms) / 1000 };
}

// An APM 1's encoder connects inputs 1 to 4 with outputs 1 to 4 by itself: from 1800 us of channel 8
// on, until it falls below 1600 us. The firmware sees nothing of it, so no report of the outputs would.
const kSwitch = 8, kLetsGo_us = 1600, kNoPulse_us = 2300;
export async function firmwareHasOutputs({ board, options }) {
  if (options.board !== 'apm1') return;
  const switch_us = median(field(await board.collect('RC_CHANNELS', 500, 20), `chan${kSwitch}Raw`));
  if (switch_us > kLetsGo_us && switch_us < kNoPulse_us)
    throw new NotDone(`channel ${kSwitch} is at ${switch_us} us: from 1800 us on the receiver, not the firmware, has outputs 1 to 4; ` +
      `bring it below ${kLetsGo_us} us`);
}

export async function attitude({ board }, time_ms = 1000) {
  const last = (await board.collect('ATTITUDE', time_ms, 10)).at(-1).data;
  return { roll_rad: last.roll, pitch_rad: last.pitch, yaw_rad: last.yaw };
}
