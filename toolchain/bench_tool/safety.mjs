// SPDX-License-Identifier: GPL-3.0-or-later
// What must not be left behind: an armed board, sticks held by this program, changed parameters.
// The motor's output may rise only behind three confirmations, typed in full.
import { NotDone, NotMeasured } from './errors.mjs';

const kArm = 400, kWithoutChecks = 2989, kDisarmAtOnce = 21196, kSetMode = 176;
const kManual = 0, kArmedFlag = 128, kSticks_ms = 500;
export const kConfirmations = [
  ['propeller', 'The motor\'s output will rise in this step. Is the propeller off the motor?', 'the propeller is off'],
  ['people', 'Is nobody, and nothing loose, near the motor, and is it fixed?', 'nobody is near the motor'],
  ['motor', 'The last question: it begins at once.', 'run the motor'],
];

export class Safety {
  constructor(board, person, { restore, save, print }) {
    this.board = board;
    this.person = person;
    this.restore = restore;  // parameters by name, as they were; also on the disk
    this.save = save;
    this.print = print;
    this.armed = false;
    this.sticks = null;
    board.always(({ name, data }) => this.watch(name, data));
  }

  // Armed by something else, as a pilot's rudder: disarmed at once, and the part has failed.
  watch(name, { baseMode }) {
    if (name !== 'HEARTBEAT' || this.armed || !(baseMode & kArmedFlag)) return;
    this.armed = this.surprised = true;
  }

  // Throws NotDone unless all three are given; each time anew.
  async confirmed(step) {
    for (const [id, text, words] of kConfirmations) {
      if (!await this.person.confirms(`${step}.confirm_${id}`, text, words))
        throw new NotDone('not confirmed: the motor stays off');
    }
    this.allowed = step;
  }

  // The sticks as the ground station holds them; 0: that channel is the receiver's.
  hold(sticks) {
    this.sticks = sticks;
    this.sendSticks();
  }
  sendSticks() {
    if (!this.sticks) return;
    this.sent_ms = this.board.now_ms();
    const fields = {};
    for (let i = 0; i < 8; ++i) fields[`chan${i + 1}Raw`] = this.sticks[i] ?? 65535;
    this.board.send('RC_CHANNELS_OVERRIDE', fields);
  }
  // In each tick of the board's waiting: the vehicle forgets sticks after 3 s.
  tick() {
    if (this.surprised && this.armed) {
      this.surprised = false;
      throw new NotMeasured('the board was armed, and not by this program');
    }
    if (this.sticks && this.board.now_ms() - this.sent_ms > kSticks_ms) this.sendSticks();
  }

  async arm(step) {
    if (this.allowed !== step) throw new Error('arming without confirmation');
    this.allowed = undefined;
    await this.board.mustAccept(kSetMode, [1, kManual], 'mode MANUAL');
    this.armed = true;  // from before the command on: its answer may be lost
    await this.board.mustAccept(kArm, [1, kWithoutChecks], 'arming');
  }
  async disarm() {
    await this.board.mustAccept(kArm, [0, kDisarmAtOnce], 'disarming');
    this.armed = false;
  }
  async change(name, value) {
    if (!(name in this.restore)) {
      this.restore[name] = await this.board.parameter(name);
      this.save();
    }
    await this.board.setParameter(name, value);
  }
  async putBack() {
    for (const [name, value] of Object.entries(this.restore)) {
      await this.board.setParameter(name, value);
      delete this.restore[name];
      this.save();
    }
  }

  // At the end of each step and of the session, however it ends: what could not be undone.
  async end() {
    const left = [];
    this.board.stopping = this.surprised = false;
    const within = async (undo, what) => {
      try {
        await undo();
      } catch (error) {
        if (!(error instanceof NotMeasured)) throw error;
        left.push(`${what()} (${error.message})`);
      }
    };
    if (this.armed) {
      await within(() => this.disarm(), () => 'THE BOARD MAY BE ARMED: take its power away');
      if (!this.armed) this.print('  disarmed');
    }
    if (this.sticks) {
      this.hold(Array(8).fill(0));
      this.sticks = null;
    }
    const names = Object.keys(this.restore);
    if (names.length > 0) {
      await within(() => this.putBack(), () => `set ${Object.entries(this.restore).map(([name, value]) => `${name} to ${value}`).join(', ')}`);
      if (Object.keys(this.restore).length === 0) this.print(`  restored: ${names.join(', ')}`);
    }
    return left;
  }
}
