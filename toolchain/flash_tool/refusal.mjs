// SPDX-License-Identifier: GPL-3.0-or-later
// Why nothing more is done, as one line for the user. Status 2: what was asked for cannot be done
// as asked; 1: it was tried and failed.
export class Refusal extends Error {
  constructor(message, status = 2) {
    super(message);
    this.status = status;
  }
}
