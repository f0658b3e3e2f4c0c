// SPDX-License-Identifier: GPL-3.0-or-later
// The copy of the sources in which mutations are tried, and its unit tests: which of them depend on
// a file, how one is built, and how it ends. What runs can be stopped.
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';

import { NotTried } from '../shared/checkout.mjs';

const kGrace_s = 10, kTimes = 10;  // a test may take ten times as long as without a mutation
const kShort_s = 1, kLong_s = 5;

export class Interrupted extends Error {}

// With everything it has started.
function kill(child) {
  try {
    process.kill(-child.pid, 'SIGKILL');
  } catch { /* it has ended */ }
}

export class Runner {
  constructor(tree, env) {
    this.tree = tree;
    this.host = join(tree, 'build/host');
    this.env = env;
    this.children = new Set();
  }
  stop() {
    this.stopped = true;
    for (const child of this.children) kill(child);
  }
  // { status, output, late, seconds }
  async run(program, words, { cwd = this.tree, limit_s, env = {} } = {}) {
    if (this.stopped) throw new Interrupted();
    const begun = Date.now();
    const child = spawn(program, words,
      { cwd, env: { ...this.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'], detached: true });
    this.children.add(child);
    let output = '', late = false;
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (bytes) => { output += bytes; });
    const timer = limit_s && setTimeout(() => { late = true; kill(child); }, limit_s * 1000);
    const status = await new Promise((ended, reject) => {
      child.on('error', (error) => reject(new NotTried(`${program}: ${error.message}`)));
      child.on('close', ended);
    });
    clearTimeout(timer);
    this.children.delete(child);
    if (this.stopped) throw new Interrupted();
    return { status, output, late, seconds: (Date.now() - begun) / 1000 };
  }
  async must(program, words) {
    const { status, output } = await this.run(program, words);
    if (status === 0) return output;
    const lines = output.trim().split('\n');
    const why = lines.find((line) => /error:/i.test(line)) ?? lines.at(-1);
    throw new NotTried(`without any mutation ${program} fails in ${this.host}: ${why}`);
  }
  async configure() {
    if (existsSync(join(this.host, 'build.ninja'))) return;
    await this.must('cmake', ['--preset', 'host', '-DTESTS=ON']);
  }
  async builds(...targets) {
    return (await this.run('ninja', ['-C', this.host, ...targets])).status === 0;
  }
  mustBuild(...targets) { return this.must('ninja', ['-C', this.host, ...targets]); }
  // A program of this tree, or one that is named with its folder.
  test(name, limit_s, words = [], env = {}) {
    return this.run(resolve(this.host, name), ['--gtest_brief=1', '--gtest_fail_fast', ...words],
      { cwd: this.host, limit_s, env });
  }
  hashOf(name) {
    return createHash('sha256').update(readFileSync(join(this.host, name))).digest('hex');
  }
}

// Of what ctest lists, the names of the quick unit tests that need no file but their program.
export function unitPrograms({ tests }, host) {
  return tests.filter(({ name, properties = [] }) => {
    const of = (key) => properties.find((property) => property.name === key)?.value ?? [];
    const needs = of('REQUIRED_FILES');
    return of('LABELS').includes('quick') && of('LABELS').includes('unit') &&
      needs.length === 1 && needs[0] === join(host, name);
  }).map(({ name }) => name);
}

// What ninja -t deps prints in a folder: the objects that were made with the file, by an #include
// too. A compiler cache makes paths relative to that folder.
export function objectsWith(deps, file, folder) {
  const found = [];
  let object;
  for (const line of deps.split('\n')) {
    if (/^\S.*: #deps/.test(line)) object = line.slice(0, line.indexOf(': #deps'));
    else if (line && resolve(folder, line.trim()) === file) found.push(object);
  }
  return found;
}

// A header is known to the build only by what was compiled with it.
async function dependents(runner, candidates, file) {
  const path = join(runner.tree, file);
  let wanted = [path];
  if (!file.endsWith('.cpp')) {
    await runner.mustBuild(...candidates);
    wanted = objectsWith(await runner.must('ninja', ['-C', runner.host, '-t', 'deps']), path, runner.host);
  }
  const found = [];
  for (const name of candidates) {
    const inputs = new Set((await runner.must('ninja', ['-C', runner.host, '-t', 'inputs', name])).split('\n'));
    if (wanted.some((each) => inputs.has(each))) found.push(name);
  }
  return found;
}

const ownProgram = (file) => {
  const folder = basename(dirname(file));
  return file.startsWith('firmware/') ? `firmware_${folder}_test` : `${folder}_test`;
};

// The tests of FILE_test.cpp, as a filter for its program; undefined when there are none.
export function filterOf(text) {
  const suites = [...text.matchAll(/^TEST(?:_[FP])?\(\s*(\w+),/gm)].map(([, suite]) => suite);
  return suites.length > 0
    ? `--gtest_filter=${[...new Set(suites)].flatMap((suite) => [`${suite}.*`, `*/${suite}.*`]).join(':')}`
    : undefined;
}

// Tests of the file's own folder first, then the quick ones. What takes long is run only when it is
// the file's own, and then the tests of the file itself come before the whole of it.
export function inOrder(programs, file, filter) {
  const own = ownProgram(file);
  const rank = ({ name }) => (name === own ? 0 : 1);
  const few = programs.filter(({ name, seconds }) => name === own || seconds < kLong_s);
  const ordered = (few.length > 0 ? few : programs).sort((a, b) => rank(a) - rank(b) || a.seconds - b.seconds);
  const [first] = ordered;
  return filter && first?.name === own && first.seconds > kShort_s
    ? [{ ...first, words: [filter] }, ...ordered] : ordered;
}

function mirrorOf(tree, file) {
  const path = join(tree, 'host_tests/unit', file.replace(/\.(cpp|hpp)$/, '_test.cpp'));
  return existsSync(path) ? filterOf(readFileSync(path, 'utf8')) : undefined;
}

// Built and run as they are: file to [{ name, seconds, limit_s }], in the order to try them.
export async function prepared(runner, files) {
  const list = JSON.parse(await runner.must('ctest', ['--test-dir', runner.host, '-C', 'long', '--show-only=json-v1']));
  const candidates = unitPrograms(list, runner.host), known = new Map(), ready = new Map();
  for (const file of files) {
    const names = await dependents(runner, candidates, file);
    if (names.length === 0) throw new NotTried(`no quick unit test depends on ${file}`);
    await runner.mustBuild(...names);
    for (const name of names.filter((each) => !known.has(each))) {
      const { status, seconds } = await runner.test(name);
      if (status !== 0) throw new NotTried(`without any mutation ${name} fails`);
      known.set(name, { name, seconds, limit_s: kTimes * seconds + kGrace_s });
    }
    ready.set(file, inOrder(names.map((name) => known.get(name)), file, mirrorOf(runner.tree, file)));
  }
  return ready;
}
