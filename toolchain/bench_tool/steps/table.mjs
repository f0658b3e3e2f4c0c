// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol: 16 steps of parts. A part has a title, a limit, and `measure`, which asks the person
// and the board; `failed` is what to do when it does not come to the limit. `apm1` of a step or a
// part has what is otherwise there; a part that is `only` one board's is left out on the other.
import { flash, fuses, wrongImage } from './image.mjs';
import { links, receiver } from './links.mjs';
import { memory } from './memory.mjs';
import { outputs } from './outputs.mjs';
import { restarts } from './restarts.mjs';
import { selfTest } from './self_test.mjs';
import { air, compass, inertial } from './sensors.mjs';
import { coldStarts, load, supply, supplyMeasured } from './supply.mjs';

export const kSteps = [supply, fuses, flash, wrongImage, coldStarts, load, supplyMeasured, inertial, compass, air, outputs,
  receiver, links, memory, restarts, selfTest];

const as = (board) => (each) => ({ ...each, ...each[board] });
const isOn = (board) => ({ only = board }) => only === board;

export const stepsOn = (board) => kSteps.map(as(board)).map((step) => ({ ...step, parts: step.parts.filter(isOn(board)).map(as(board)) }));
