// SPDX-License-Identifier: GPL-3.0-or-later
// Bugs that were found and mended, as edits that put them back, and the invariants that then fail.
// All of them once passed every test.

const kOutputs = 'firmware/actuators/outputs.cpp', kEstimator = 'firmware/estimator/estimator.cpp';
const kLaunch = 'firmware/guidance/launch.cpp', kRestart = 'firmware/safety/restart.cpp';
const kRadio = 'firmware/sensors/radio.cpp', kSwitch = 'firmware/modes/mode_switch.cpp';
const kRequests = 'firmware/modes/mode_requests.cpp';

// { name, what, violates, edits }: `violates` are names of invariants, of which one is enough; an
// edit replaces `from`, which is in the file once.
export const kBugs = [
  {
    name: 'S1',
    what: 'disarmed, the motor turns by a parameter',
    violates: ['motor_idle_disarmed'],
    edits: [{
      file: kOutputs,
      from: '        return outputs.idle_us;',
      to: '        return throttlePulse_us(range(kThrottle - 1), core::Ratio::fromRaw(0));',
    }],
  },
  {
    name: 'S2',
    what: 'a reckoned speed counts as flight: the motor starts on the ground when the GPS is back',
    violates: ['motor_idle_standing'],
    edits: [
      { file: kEstimator, from: '    if (!vehicle.estimate.flying) return position.reckon(0, 0, 1);\n', to: '' },
      { file: kEstimator, from: 'reckoned && !to.flying ? 0 : airspeed_mps;', to: 'airspeed_mps;' },
      {
        file: kEstimator,
        from: '    return !position.reckoned() && measuredGroundSpeed_mps() > least_mps;',
        to: '    return vehicle.estimate.ground_speed_mps > least_mps;',
      },
      {
        file: kLaunch,
        from: '    if (seenToStand(ground_cm())) return false;\n',
        to: '    if (vehicle.gps.fix >= GpsFix::two_d && !vehicle.airspeed.healthy &&\n' +
          '        vehicle.estimate.ground_speed_mps >= kFlyingSpeed_mps)\n' +
          '        return true;\n' +
          '    if (seenToStand(ground_cm())) return false;\n',
      },
    ],
  },
  {
    name: 'S3',
    what: '"flying" ends in a head wind as fast as the airplane',
    violates: ['armed_in_the_air', 'restart_in_the_air'],
    edits: [{
      file: kEstimator,
      from: '    return slowThroughTheAir() + low + !turns() >= 2;',
      to: '    return slowThroughTheAir() + low + !turns() >= 0;',
    }],
  },
  {
    name: 'S4',
    what: 'the mode switch is obeyed before the restart in the air has decided, and nothing arms',
    violates: ['restart_in_the_air'],
    edits: [
      {
        file: kSwitch,
        from: 'if (mode_switch.settled == 0 || vehicle.resuming) return;',
        to: 'if (mode_switch.settled == 0) return;',
      },
      {
        file: kRequests,
        from: '{Granted::none, Granted::manual, Granted::without_sticks},  // pilot',
        to: '{Granted::any, Granted::manual, Granted::without_sticks},  // pilot',
      },
      {
        file: kRestart,
        from: '    if (vehicle.resuming) decideMode();\n' +
          '    if (vehicle.mode == Mode::initialising) return;\n',
        to: '    if (vehicle.mode == Mode::initialising) {\n' +
          '        if (vehicle.resuming) decideMode();\n' +
          '        return;\n' +
          '    }\n' +
          '    published.resuming = false;\n',
      },
    ],
  },
  {
    name: 'S5',
    what: "what the encoder makes of a lost receiver is obeyed as the pilot's mode switch",
    violates: ['mode_without_cause'],
    edits: [
      { file: kRadio, from: 'obeyed = reception.bad == 0 && !published.lost &&', to: 'obeyed = !published.lost &&' },
    ],
  },
  {
    name: 'S6',
    what: 'disarming leaves the record of a flight: the next start arms',
    violates: ['armed_by_itself'],
    edits: [{
      file: kRestart,
      from: '    if (!vehicle.armed) return forgetFlight();\n',
      to: '    if (!vehicle.armed) return;\n',
    }],
  },
];

const times = (text, part) => text.split(part).length - 1;

// The text with the edits of its file made; throws where one has no place, or more than one.
export function edited(text, file, edits) {
  return edits.filter((edit) => edit.file === file).reduce((before, { from, to }) => {
    if (times(before, from) !== 1) throw new Error(`${file}: ${times(before, from)} times: ${from.trim()}`);
    return before.replace(from, () => to);
  }, text);
}

export const filesOf = ({ edits }) => [...new Set(edits.map(({ file }) => file))];
