// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the tables of docs/mavlink.md from the tables of firmware/gcs.
//   node toolchain/mavlink/document.mjs           writes
//   node toolchain/mavlink/document.mjs --check   exit 1 when what is there differs
import { readFileSync, writeFileSync } from 'node:fs';
import { enums, messages } from './definitions.mjs';

const root = new URL('../../', import.meta.url);
const read = (path) => readFileSync(new URL(path, root), 'utf8');

const spelled = new Map(messages().map(({ name, id }) => [name.replaceAll('_', '').toLowerCase(), { name, id }]));
const message = (struct) => {
  const found = spelled.get(struct.toLowerCase());
  if (!found) throw new Error(`no message is spelled ${struct}`);
  return found;
};
const table = (head, rows) =>
  [head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n');

const parameters = { raw_sensors: '`SRn_RAW_SENS`', extended_status: '`SRn_EXT_STAT`',
  rc_channels: '`SRn_RC_CHAN`', raw_controller: '`SRn_RAW_CTRL`', position: '`SRn_POSITION`',
  extra1: '`SRn_EXTRA1`', extra2: '`SRn_EXTRA2`', extra3: '`SRn_EXTRA3`',
  always: 'once a second, always', on_request: 'when asked for, or when it happens',
  extended_slowly: 'once a second, unless `SRn_EXT_STAT` is 0',
  extra3_slowly: 'once a second, unless `SRn_EXTRA3` is 0' };

function sent() {
  const rows = [...read('firmware/gcs/streams.cpp')
    .matchAll(/row<mavlink::(\w+)>\(Stream::(\w+)\)/g)];
  return table(['id', 'message', 'rate'], rows.map(([, struct, stream]) =>
    [message(struct).id, message(struct).name, parameters[stream]]));
}

// What a sender gets for it. What has no answer by MAVLink's definition says so.
const answers = {
  HEARTBEAT: 'none; from `SYSID_MYGCS` it is the ground station\'s sign of life',
  PING: '`PING` with the sender as its target, when it asks (target 0)',
  TIMESYNC: '`TIMESYNC` with both times, when it asks (`tc1` 0)',
  RADIO_STATUS: 'none; the streams keep to what the modem\'s buffer can take',
  RADIO: 'none; as `RADIO_STATUS`',
  RC_CHANNELS_OVERRIDE: 'none; `RC_CHANNELS` has the channels in force',
  MANUAL_CONTROL: 'none; `RC_CHANNELS` has the channels in force',
  SET_POSITION_TARGET_LOCAL_NED: 'none when flown, a text when not',
  SET_POSITION_TARGET_GLOBAL_INT: 'none when flown, a text when not',
  SET_ATTITUDE_TARGET: 'a text: it is not flown',
  SETUP_SIGNING: 'a text: stored, cleared or refused and why',
  REQUEST_DATA_STREAM: 'the streams themselves',
  SET_MODE: '`COMMAND_ACK` of command 11',
  COMMAND_LONG: '`COMMAND_ACK`',
  COMMAND_INT: '`COMMAND_ACK`',
  COMMAND_ACK: 'none; it says that a side is in place for the calibration of the accelerometers',
  AUTOPILOT_VERSION_REQUEST: '`AUTOPILOT_VERSION`',
  PARAM_REQUEST_LIST: 'every `PARAM_VALUE`',
  PARAM_REQUEST_READ: '`PARAM_VALUE`; none when there is no such parameter',
  PARAM_SET: '`PARAM_VALUE` with the value in force; a text when that is another, or there is no such parameter',
  MISSION_REQUEST_LIST: '`MISSION_COUNT`',
  MISSION_REQUEST_PARTIAL_LIST: '`MISSION_COUNT`, or the item when it is one',
  MISSION_REQUEST: '`MISSION_ITEM`, or `MISSION_ACK` with what is wrong',
  MISSION_REQUEST_INT: '`MISSION_ITEM_INT`, or `MISSION_ACK` with what is wrong',
  MISSION_COUNT: '`MISSION_REQUEST_INT` of the first item, or `MISSION_ACK` with what is wrong',
  MISSION_WRITE_PARTIAL_LIST: '`MISSION_REQUEST_INT` of the first item, or `MISSION_ACK` with what is wrong',
  MISSION_ITEM: '`MISSION_REQUEST` of the next or `MISSION_ACK`; refused also by a text with the item\'s number',
  MISSION_ITEM_INT: '`MISSION_REQUEST_INT` of the next or `MISSION_ACK`; refused also by a text with the item\'s number',
  MISSION_ACK: 'none; it ends a download',
  MISSION_CLEAR_ALL: '`MISSION_ACK`',
  MISSION_SET_CURRENT: '`MISSION_CURRENT` when it is set, a text when not',
  FENCE_POINT: 'a text: points come as mission items',
  FENCE_FETCH_POINT: 'a text: points come as mission items',
  RALLY_POINT: 'a text: points come as mission items',
  RALLY_FETCH_POINT: 'a text: points come as mission items',
  FILE_TRANSFER_PROTOCOL: '`FILE_TRANSFER_PROTOCOL` with what was asked for, or the reason why not',
  LOG_REQUEST_LIST: '`LOG_ENTRY` of each',
  LOG_REQUEST_DATA: '`LOG_DATA`; a text while armed',
  LOG_ERASE: 'a text when it begins and when it has ended, or why it does not',
  LOG_REQUEST_END: 'none',
};
const late = { refuseMission: '`MISSION_ACK`: ERROR', refuseParamSet: 'a text', refuseSetupSigning: 'a text' };

function understood() {
  const rows = [...read('firmware/gcs/incoming.cpp').matchAll(/to(?:All|Us)<mavlink::(\w+)>\((?:on|refuse)\w+(?:, (\w+))?\)/g)]
    .map(([, struct, refuse]) => ({ ...message(struct), refuse })).sort((a, b) => a.id - b.id);
  return table(['id', 'message', 'answered by', 'when the memory was busy for a second'], rows.map(({ id, name, refuse }) => {
    if (!answers[name]) throw new Error(`how ${name} is answered is not said`);
    if (refuse && !late[refuse]) throw new Error(`what ${refuse} sends is not said`);
    return [id, name, answers[name], late[refuse] ?? ''];
  }));
}

const remarks = {
  do_set_mode: 'p1 = 1: p2 is the mode\'s number; or the older base modes',
  do_set_standard_mode: 'p1 = MAV_STANDARD_MODE: 3 CRUISE, 4 FBWB, 5 RTL, 6 AUTO, 8 TAKEOFF; DENIED the others',
  do_change_speed: 'p1 = 0 airspeed, 1 ground speed (AUTO and GUIDED), p2 m/s within `ARSPD_FBW_MIN`..`_MAX`, p3 throttle; -1 leaves it',
  do_set_home: 'p1 = 1: here; else p5, p6, p7. In flight the airplane stays where it is',
  nav_land: 'as DO_LAND_START',
  nav_takeoff: 'enters TAKEOFF: p7 m above home, or in the frame of COMMAND_INT (0: `TKOFF_ALT`), p1 the nose\'s least pitch in ° (0: `TKOFF_LVL_PITCH`)',
  do_flighttermination: 'p1 = 1 with `AFS_TERM_ACTION` 42: motor off, surfaces at their ends, until a restart; else DENIED with a text',
  do_aux_function: 'p1 = RCn_OPTION of ArduPlane, p2 = 0 low, 1 middle, 2 high. Modes (high enters, low goes back to the mode switch): 4 RTL, 16 AUTO, 51 MANUAL, 52 ACRO, 55 GUIDED, 56 LOITER, 68 STABILIZE, 72 CIRCLE, 77 TAKEOFF, 92 FBWA, 150 CRUISE. Low or high: 11 fence, 28 relay, 43 inverted, 153 arm; high: 9 takes a picture. UNSUPPORTED the others',
  do_autotune_enable: 'p1 = 1: AUTOTUNE, 0: from it to FBWA',
  do_send_banner: 'a text: what this is',
  guided_change_speed: 'GUIDED: p1 = 0 airspeed, 1 ground speed, p2 m/s; p3, the acceleration, is not used',
  guided_change_altitude: 'GUIDED: p7 m, by COMMAND_INT in its frame; p3, the rate, is not used',
  guided_change_heading: 'GUIDED: p1 = 0 (course over ground; others are DENIED), p2 degrees: straight on along it until another target; p3, the acceleration, is not used',
  do_set_relay: 'p1 = 0, p2 = 0 or 1',
  do_repeat_relay: 'p1 = 0, p2 times, p3 seconds each',
  do_set_servo: 'p1 = output 5..8, p2 µs',
  do_repeat_servo: 'p1 = output 5..8, p2 µs, p3 times, p4 seconds each',
  do_change_altitude: 'p1 m in frame p2 (global or relative); in modes that hold a height, but not in AUTO',
  do_land_start: 'AUTO goes on at the mission\'s nearest `DO_LAND_START`; DENIED when it has none',
  do_go_around: 'breaks off AUTO\'s landing; p1: the height above home to climb to first',
  do_digicam_control: 'takes a picture',
  do_set_cam_trigg_dist: 'p1 = metres from picture to picture, 0: no more',
  do_inverted_flight: 'p1 = 1 upside down, 0 upright; until the mode changes',
  do_reposition: 'GUIDED: p2 bit 0 enters it, p1 > 0 ground speed, p3 > 0 radius with p4 = 1 to the left; what is NaN stays as it is',
  do_fence_enable: 'p1 = 1 on, 0 off, 2 the floor off; DENIED without a fence that is fit',
  do_set_mission_current: 'p1 = item, -1 the present one; p2 = 1: jumps count anew',
  preflight_calibration: 'p1 = 1 gyros, p2 = 1 compass, p3 = 1 barometer and airspeed, p4 = 1 the sticks\' middle, p5 = 1 six sides, 2 this is level, 4 accelerometers\' offsets: [preflight.md](preflight.md); disarmed, DENIED in flight',
  do_start_mag_cal: 'as PREFLIGHT_CALIBRATION with p2 = 1; MAG_CAL_PROGRESS, MAG_CAL_REPORT',
  do_accept_mag_cal: 'nothing left to do: what fits has been stored',
  do_cancel_mag_cal: 'calls off any calibration',
  accelcal_vehicle_pos: 'p1 = the side on which it lies now, as it was asked for by the same command',
  preflight_set_sensor_offsets: 'p1 = 2: the compass\'s, p2..p4 mgauss',
  preflight_storage: 'p1 = 1: accepts damaged parameters as they are; p1 = 2: resets the parameters, with p2 = 2 erases the missions as well; not armed',
  preflight_reboot_shutdown: 'p1 = 1: restart, 3: the same, for the bootloader; not armed, unless p6 = 20190226 over USB: [security.md](security.md)',
  mission_start: 'p1 = p2 = 0: all of it',
  component_arm_disarm: 'p1 = 1 arm, 0 disarm; p2 = 2989 / 21196: without the checks, over USB: [security.md](security.md)',
  run_prearm_checks: 'FAILED and a text when one fails',
  get_message_interval: 'p1 = message',
  set_message_interval: 'p1 = message, p2 = µs, 0 as its stream, -1 never',
  request_message: 'p1 = message, one of those above; of AVAILABLE_MODES p2 = the mode\'s index, 0: all of them',
};

function commands() {
  const numbers = Object.fromEntries(enums().find(({ name }) => name === 'MavCmd').entries
    .map(({ key, value }) => [key.toLowerCase(), value]));
  const rows = [...read('firmware/gcs/commands.cpp').matchAll(/\{MavCmd::(\w+),/g)];
  return table(['id', 'command', ''], rows.map(([, key]) =>
    [numbers[key], key.toUpperCase(), remarks[key] ?? '']));
}

const before = read('docs/mavlink.md');
let after = before;
for (const [name, text] of Object.entries({ sent: sent(), understood: understood(), commands: commands() })) {
  const place = new RegExp(`(<!-- ${name}: .*? -->\\n)[^]*?(<!-- end -->)`);
  if (!place.test(after)) throw new Error(`docs/mavlink.md has no place for ${name}`);
  after = after.replace(place, (_, begin, end) => `${begin}${text}\n${end}`);
}
if (!process.argv.includes('--check')) {
  writeFileSync(new URL('docs/mavlink.md', root), after);
} else if (after !== before) {
  console.error('docs/mavlink.md is not what toolchain/mavlink/document.mjs writes');
  process.exitCode = 1;
}
