// SPDX-License-Identifier: GPL-3.0-or-later
// Versions of the sources, each built in a git worktree of its own below build/same/. There are few
// of these and they are used again: one that has the wanted files is taken as it is, another one is
// moved to them, so that only what differs is compiled.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

// It could not be tried; one line for the user.
export class NotTried extends Error {}

const kSlots = ['1', '2', '3'];
const kTargets = ['fly', 'mission_tool'];
const kNobody = { GIT_AUTHOR_NAME: 'same', GIT_AUTHOR_EMAIL: 'same@localhost', GIT_AUTHOR_DATE: '@0 +0000',
  GIT_COMMITTER_NAME: 'same', GIT_COMMITTER_EMAIL: 'same@localhost', GIT_COMMITTER_DATE: '@0 +0000' };

function git(folder, words, env = {}) {
  const { status, stdout, stderr, error } = spawnSync('git', ['-C', folder, ...words],
    { encoding: 'utf8', env: { ...process.env, ...env }, maxBuffer: 1 << 28 });
  if (status === 0) return stdout.trim();
  throw new NotTried(error?.message ?? stderr.trim().split('\n').at(-1));
}

// { words, commit, tree } of what a user calls a commit.
export function commitNamed(root, name) {
  let commit;
  try {
    commit = git(root, ['rev-parse', '--verify', '--quiet', '--end-of-options', `${name}^{commit}`]);
  } catch {
    throw new NotTried(`there is no commit ${name}`);
  }
  return { words: `${name} (${commit.slice(0, 10)})`, commit, tree: git(root, ['rev-parse', `${commit}^{tree}`]) };
}

// The working tree with what is not committed, as a commit that nothing refers to. It is made with
// an index of its own: the user's index and files stay as they are.
export function workingTree(root, folder) {
  mkdirSync(folder, { recursive: true });
  const index = join(folder, 'index');
  rmSync(index, { force: true });
  const env = { ...kNobody, GIT_INDEX_FILE: index };
  git(root, ['read-tree', 'HEAD'], env);
  git(root, ['add', '--all'], env);
  const tree = git(root, ['write-tree'], env);
  const commit = git(root, ['commit-tree', tree, '-p', 'HEAD', '-m', 'working tree'], env);
  rmSync(index, { force: true });
  return { words: 'the working tree', commit, tree };
}

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

function checkOut(root, slot, { commit }) {
  rmSync(markOf(slot), { force: true });
  if (!existsSync(join(slot, '.git'))) {
    rmSync(slot, { recursive: true, force: true });
    git(root, ['worktree', 'prune']);
    git(root, ['worktree', 'add', '--detach', '--force', slot, commit]);
    return;
  }
  git(slot, ['checkout', '--quiet', '--force', '--detach', commit]);
  git(slot, ['clean', '--quiet', '--force', '-d']);
}

// Whatever compiler cache there is serves every slot.
function environment(folder) {
  if (spawnSync('ccache', ['--version']).status !== 0) return process.env;
  return { CMAKE_C_COMPILER_LAUNCHER: 'ccache', CMAKE_CXX_COMPILER_LAUNCHER: 'ccache', CCACHE_BASEDIR: folder,
    CCACHE_NOHASHDIR: '1', CCACHE_SLOPPINESS: 'pch_defines,time_macros', ...process.env };
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
    checkOut(root, slot.path, version);
    compile(slot.path, version, environment(folder));
    writeFileSync(markOf(slot.path), `${version.tree}\n`);
  }
  return { host: join(slot.path, 'build/host'), reused: slot.tree === version.tree };
}
