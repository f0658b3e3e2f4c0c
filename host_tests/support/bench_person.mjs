// SPDX-License-Identifier: GPL-3.0-or-later
// A person at the bench who does everything as asked with a simulated board.
import { order, turnTo } from './bench_rig.mjs';

const kDeclination_deg = 3.67;  // simulator/world.hpp
const turn = (rates) => order(`turn ${rates}`);
const scope = (output) => async (rig) => JSON.parse(await rig.order('servos'))[output - 1].toFixed(1);
const fault = (what) => order(`fault ${what}`);
const compass = (roll, heading) => turnTo(roll, 0, heading + kDeclination_deg);
const kSticks = [1100, 1200, 1300, 1400, 1500, 1600, 1700, 1800];
const sticks = (pulses, answer = '') => async (rig) => {
  await rig.order(`sticks ${pulses.join(' ')}`);
  await rig.vehicle.wait(500);
  return answer;
};
const kOutputs = [1, 2, 3, 4, 5, 6, 7, 8];
const from = (entries) => Object.fromEntries(entries);

export const confirmations = (step) => ({
  [`${step}.confirm_propeller`]: 'the propeller is off', [`${step}.confirm_people`]: 'nobody is near the motor',
  [`${step}.confirm_motor`]: 'run the motor' });

export const supply = { '1.current': '180', '1.rail_5v': '5,01 V', '1.rail_3v3': '3.3' };
export const fuses = { '2.low': 'FF', '2.high': '0xd8', '2.extended': 'FD', '2.button': order('reset') };
export const starts = { '5.quick': fault('supply:cut 0.5'), '5.slow': fault('supply:sag_0v_2000ms 2.5') };
export const volts = {
  '7.at_4.6': order('fault supply:sag_4.6v 5', '4.6'),
  '7.at_5.0': async (rig) => { await rig.order('fault none'); await rig.vehicle.wait(1500); return '5.0'; },
  '7.at_5.4': order('supply 5.4', '5.4'),
  '7.brown_out': async (rig) => {
    await rig.order('supply 5');
    await rig.order('fault supply:sag_4v 0.3');
    await rig.vehicle.wait(200);
    return order('reset')(rig);
  },
  '7.button': async (rig) => {
    await rig.order('fault supply:sag_4.6v 2');
    await rig.vehicle.wait(1000);
    return order('reset')(rig);
  } };
export const sides = {
  '8.level': turnTo(0, 0, 0), '8.on_its_back': turnTo(180, 0, 0), '8.left_wing_down': turnTo(-90, 0, 0),
  '8.right_wing_down': turnTo(90, 0, 0), '8.nose_down': turnTo(0, -90, 0), '8.nose_up': turnTo(0, 90, 0),
  '8.roll_right': turn('60 0 0'), '8.pitch_up': turn('0 60 0'), '8.turn_right': turn('0 0 60'), '8.noise': turnTo(0, 0, 0) };
export const headings = {
  '9.north': compass(0, 0), '9.east': compass(0, 90), '9.south': compass(0, 180), '9.west': compass(0, 270),
  '9.rolled': compass(45, 0),
  '9.unplug': (rig) => { rig.unplugged = !rig.unplugged; return order(rig.unplugged ? 'fault compass:lost 1000' : 'fault none')(rig); } };
export const air = { '10.lift': (rig) => { rig.height_m = rig.height_m === 0 ? 1 : 0; return order(`lift ${rig.height_m}`)(rig); },
  '10.syringe': order('blow 28.57', '500') };
export const outputs = {
  ...from([1, 4, 6, 8].map((output) => [`11.rate_${output}`, '50.0 Hz'])),
  ...from(kOutputs.flatMap((output) => [1000, 1500, 2000].map((us) => [`11.output_${output}.${us}`, scope(output)]))),
  ...from([1100, 1500, 1900].map((us) => [`11.motor.${us}`, scope(3)])),
  '11.longest.read': '2001', ...confirmations('11.motor') };
// An oscilloscope that keeps the longest pulse of output 1 over the restarts.
export const longest = {
  '11.longest': (rig) => { rig.pulses = []; return ''; },
  '11.longest.usb': async (rig) => {
    for (let i = 0; i < 5; ++i) {
      await rig.order('reset');
      await rig.board.wait(3000);
      for (const way of ['out', 'in']) {
        await rig.order(`usb ${way}`);
        await rig.board.wait(200);
      }
    }
    return '';
  },
  '11.longest.read': (rig) => {
    const read = Math.max(...rig.pulses).toFixed(0);
    rig.seen = rig.pulses;
    rig.pulses = undefined;
    return read;
  } };
export const receiver = {
  ...from(kOutputs.map((number) => [`12.channel_${number}`, sticks(kSticks, String(kSticks[number - 1]))])),
  '12.off': order('sticks off'), '12.on': sticks(kOutputs.map(() => 1500)),
  '12.unplugged': fault('radio:silent 15'), '12.ppm': async (rig) => { await rig.vehicle.wait(15_000); return ''; } };
export const links = {
  '13.gps_9600': order('gps ublox 9600'), '13.gps_38400': order('gps ublox 38400'),
  '13.usb_1': order('usb out'), '13.usb_2': order('usb in'), '13.usb_3': order('usb out'), '13.usb_4': order('usb in') };
export const cuts = { '14.cuts': fault('supply:cut 0.5') };
// 1.5 V is what a capacitor holds: the memory survives.
export const flight = { '15.rest': order('reset'), ...confirmations('15.brown_out'),
  '15.brown_out.fly': async (rig) => { await rig.order('blow 16'); return order('lift 15')(rig); },
  '15.brown_out.cut': fault('supply:sag_1.5v 0.2') };
