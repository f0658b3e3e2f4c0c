// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a board so far, session.json in the folder of its form. A file that cannot be used
// is left as it is.
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { Refusal } from '../flash_tool/refusal.mjs';

const kKind = 'bench session', kVersion = 1;
const kVerdicts = ['pass', 'fail', 'not done'];

export const stateFile = (folder) => join(folder, 'session.json');

function wrongIn(state) {
  if (state === null || typeof state !== 'object' || state.kind !== kKind) return 'is no session of this tool';
  if (state.version !== kVersion) return `is of version ${state.version}, this tool writes ${kVersion}`;
  const steps = state.steps;
  if (steps === null || typeof steps !== 'object') return 'has no steps';
  const bad = Object.entries(steps).find(([number, step]) => !/^\d+$/.test(number) ||
    !kVerdicts.includes(step?.verdict) || !Array.isArray(step.parts));
  if (bad) return `has a step ${bad[0]} that cannot be read`;
  if (typeof state.restore !== 'object' || state.restore === null) return 'does not say what is to be restored';
  return null;
}

export function loadState(folder, { board, name }) {
  const path = stateFile(folder);
  const advice = 'move it away, or give another folder with --out; nothing was changed';
  if (!existsSync(path)) return { kind: kKind, version: kVersion, board, name, steps: {}, restore: {} };
  let state;
  try {
    state = JSON.parse(readFileSync(path, 'utf8'));
  } catch (error) {
    throw new Refusal(`${path} cannot be read (${error.code ?? 'it is no whole JSON'}): ${advice}`);
  }
  const wrong = wrongIn(state);
  if (wrong) throw new Refusal(`${path} ${wrong}: ${advice}`);
  if (state.board !== board || state.name !== name)
    throw new Refusal(`${path} is of the board "${state.name}" (${state.board}), not of "${name}" (${board}): ${advice}`);
  return state;
}

// Whole or not at all.
export function writeWhole(path, text) {
  try {
    writeFileSync(`${path}.new`, text);
    renameSync(`${path}.new`, path);
  } catch (error) {
    throw new Refusal(`${path} cannot be written: ${error.code}`, 1);
  }
}

export function makeFolder(folder) {
  try {
    mkdirSync(folder, { recursive: true });
  } catch (error) {
    throw new Refusal(`${folder} cannot be made: ${error.code}`);
  }
}

export const saveState = (folder, state) => writeWhole(stateFile(folder), `${JSON.stringify(state, null, 1)}\n`);
