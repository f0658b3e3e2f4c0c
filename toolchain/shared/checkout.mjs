// SPDX-License-Identifier: GPL-3.0-or-later
// Checkouts for tools that try other sources than the user's: git worktrees below build/. The
// user's own files and index stay as they are.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

// It could not be tried; one line for the user.
export class NotTried extends Error {}

const kNobody = { GIT_AUTHOR_NAME: 'same', GIT_AUTHOR_EMAIL: 'same@localhost', GIT_AUTHOR_DATE: '@0 +0000',
  GIT_COMMITTER_NAME: 'same', GIT_COMMITTER_EMAIL: 'same@localhost', GIT_COMMITTER_DATE: '@0 +0000' };

function git(folder, words, env = {}) {
  const { status, stdout, stderr, error } = spawnSync('git', ['-C', folder, ...words],
    { encoding: 'utf8', env: { ...process.env, ...env }, maxBuffer: 1 << 28 });
  if (status === 0) return stdout.trim();
  if (error) throw new NotTried(`git cannot be run: ${error.code}`);
  throw new NotTried(stderr.trim().split('\n').at(-1));
}

// { words, commit, tree } of what a user calls a commit.
export function commitNamed(root, name) {
  git(root, ['rev-parse', '--git-dir']);  // without git, or outside a repository, it says so
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

function runs(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return error.code === 'EPERM';
  }
}

// Two runs at once would change each other's checkouts: the second one is refused.
export function beAlone(folder) {
  const lock = join(folder, 'lock');
  mkdirSync(folder, { recursive: true });
  if (existsSync(lock)) {
    const pid = Number(readFileSync(lock, 'utf8'));
    if (pid > 0 && runs(pid)) throw new NotTried(`process ${pid} works in ${folder}; wait for its end`);
    rmSync(lock, { force: true });
  }
  try {
    writeFileSync(lock, `${process.pid}\n`, { flag: 'wx' });
  } catch (error) {
    throw new NotTried(`${lock}: cannot be written: ${error.code}`);
  }
  process.on('exit', () => rmSync(lock, { force: true }));
}

// Makes `folder` a checkout of the commit, or moves it there; files of both have their old times.
export function checkOut(root, folder, commit) {
  if (existsSync(join(folder, '.git'))) {
    git(folder, ['checkout', '--quiet', '--force', '--detach', commit]);
    git(folder, ['clean', '--quiet', '--force', '-d']);
    return;
  }
  rmSync(folder, { recursive: true, force: true });
  git(root, ['worktree', 'prune']);
  git(root, ['worktree', 'add', '--detach', '--force', folder, commit]);
}

// Whatever compiler cache there is serves every checkout below `folder`.
export function compilerCache(folder) {
  if (spawnSync('ccache', ['--version']).status !== 0) return process.env;
  return { CMAKE_C_COMPILER_LAUNCHER: 'ccache', CMAKE_CXX_COMPILER_LAUNCHER: 'ccache', CCACHE_BASEDIR: folder,
    CCACHE_NOHASHDIR: '1', CCACHE_SLOPPINESS: 'pch_defines,time_macros', ...process.env };
}
