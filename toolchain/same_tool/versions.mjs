// SPDX-License-Identifier: GPL-3.0-or-later
// Versions of the sources, each built in a git worktree of its own below build/same/. There are few
// of these and they are used again: one that has the wanted files is taken as it is, another one is
// moved to them, so that only what differs is compiled.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { NotTried, checkOut, compilerCache } from '../shared/checkout.mjs';

const kSlots = ['1', '2', '3'];
const kTargets = ['fly', 'mission_tool'];
const markOf = (slot) => `${slot}.tree`;

// Which of the slots a version gets: the one that has its files, or the one longest not used.
export function chosenSlot(slots, tree, taken) {
  const free = slots.filter(({ path }) => !taken.includes(path));
  return free.find((slot) => slot.tree === tree) ?? free.sort((a, b) => a.used - b.used)[0];
}

function slotsIn(folder) {
  return kSlots.map((name) => {
    const path = join(folder, name), mark = markOf(path);
    if (!existsSync(mark)) return { path, tree: '', used: existsSync(path) ? 1 : 2 };
    return { path, tree: readFileSync(mark, 'utf8').trim(), used: statSync(mark).mtimeMs };
  });
}

function compile(slot, { words }, env) {
  const log = `${slot}.log`;
  const run = (program, options) => {
    const { status, stdout, stderr, error } = spawnSync(program, options,
      { cwd: slot, encoding: 'utf8', env, maxBuffer: 1 << 28 });
    writeFileSync(log, `${stdout ?? ''}${stderr ?? ''}`, { flag: 'a' });
    if (status !== 0) throw new NotTried(`${words} could not be built${error ? `: ${error.message}` : ''}; see ${log}`);
  };
  rmSync(log, { force: true });
  if (!existsSync(join(slot, 'build/host/build.ninja'))) run('cmake', ['--preset', 'host', '-DTESTS=OFF']);
  run('cmake', ['--build', 'build/host', '--target', ...kTargets]);
}

// Checks the version out and builds it; the folder of its programs. `taken`: slots in use.
export function built(root, folder, version, taken) {
  mkdirSync(folder, { recursive: true });
  const slot = chosenSlot(slotsIn(folder), version.tree, taken);
  taken.push(slot.path);
  if (slot.tree === version.tree) {
    utimesSync(markOf(slot.path), new Date(), new Date());
  } else {
    rmSync(markOf(slot.path), { force: true });
    checkOut(root, slot.path, version.commit);
    compile(slot.path, version, compilerCache(folder));
    writeFileSync(markOf(slot.path), `${version.tree}\n`);
  }
  return { host: join(slot.path, 'build/host'), reused: slot.tree === version.tree };
}
