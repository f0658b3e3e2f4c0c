// SPDX-License-Identifier: GPL-3.0-or-later
// Why a part of a step has no number, and why a session ends early.

// The part fails: what should have been measured did not come.
export class NotMeasured extends Error {}

// The part is not done: the person left it out, or it cannot be done with this port.
export class NotDone extends Error {}

// The airplane has no such thing; the step can pass without it.
export class NotFitted extends Error {}

// Ctrl-C, "quit", or the end of the input.
export class Stopped extends Error {
  constructor() {
    super('stopped');
  }
}
