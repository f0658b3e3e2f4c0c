// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/bench as a user runs it, over TCP with the simulator in real time: its exit status,
// what it leaves behind, Ctrl-C in the middle. FLY names the simulator's program.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const kProgram = fileURLToPath(new URL('../../../toolchain/bench_tool/main.mjs', import.meta.url));
const newFolder = () => mkdtempSync(join(tmpdir(), 'bench-program-'));

// The simulator's USB line; `body` gets what stands for the port.
async function withBoard(body) {
  const fly = spawn(process.env.FLY, ['--serve', '--native', '--bench', '--calibrated', '--listen', '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
  try {
    const [said] = await once(fly.stdout, 'data');
    const [, usb] = [...said.toString().matchAll(/ on(?: TCP port)? (\d+)/g)].map((match) => match[1]);
    await body(`tcp:127.0.0.1:${usb}`);
  } finally {
    fly.kill();
    await once(fly, 'exit');
  }
}

function start(words) {
  const child = spawn(process.execPath, [kProgram, ...words], { stdio: ['pipe', 'pipe', 'pipe'] });
  let out = '';
  const hear = (chunk) => { out += chunk; };
  child.stdout.on('data', hear);
  child.stderr.on('data', hear);
  const ended = once(child, 'close').then(([status]) => ({ status, out }));
  const until = async (pattern) => {
    for (let i = 0; i < 1000 && !pattern.test(out); ++i) await new Promise((resolve) => { setTimeout(resolve, 20); });
    assert.match(out, pattern);
  };
  return { child, ended, until, type: (line) => child.stdin.write(`${line}\n`) };
}
const run = (...words) => start(words).ended;

function answersIn(folder, answers) {
  const path = join(folder, 'answers.json');
  writeFileSync(path, JSON.stringify(answers));
  return path;
}
const kSupply = { propeller: 'the propeller is off', '1.current': '210 mA', '1.rail_5v': 5, '1.rail_3v3': '3.31' };

test('scripted answers: steps, form, the list, and a resumption', () => withBoard(async (port) => {
  const folder = newFolder(), out = join(folder, 'form');
  const words = [port, '--board', 'apm2', '--name', 'seven', '--out', out, '--answers', answersIn(folder, kSupply)];
  const first = await run(...words, '--step', '1');
  assert.equal(first.status, 1, first.out);
  assert.match(first.out, /Step 1: pass/);
  const form = readFileSync(join(out, 'form.html'), 'utf8');
  assert.match(form, /<dd>seven<\/dd>/);
  assert.match(form, /0\.1\.0/);
  assert.match((await run(...words, '--list')).out, /^ 1 {2}pass {6}Supply\n 2 {2}not done/);

  const second = await run(...words);  // what is left: its first question has no answer
  assert.equal(second.status, 2);
  assert.match(second.out, /Step 2: Fuses/);
  assert.doesNotMatch(second.out, /Step 1:/);
  assert.match(second.out, /has no answer to 2\.low/);
}));

test('Ctrl-C while outputs are moved: sticks are let go, parameters restored, status 130, resumable', () => withBoard(async (port) => {
  const folder = newFolder();
  const session = start([port, '--board', 'apm2', '--out', folder, '--step', '11']);
  await session.until(/type "the propeller is off"/);
  session.type('the propeller is off');
  for (const line of ['', '50', '50', '50', '']) session.type(line);
  await session.until(/Output 1, about 1000 us/);
  session.child.kill('SIGINT');
  const { status, out } = await session.ended;
  assert.equal(status, 130, out);
  assert.match(out, /restored: RC1_MIN, RC1_MAX, ARMING_RUDDER/);
  assert.match(out, /Stopped; the same command resumes/);
  const state = JSON.parse(readFileSync(join(folder, 'session.json'), 'utf8'));
  assert.deepEqual(state.restore, {});
  assert.equal(state.steps[11].verdict, 'not done');
  assert.match((await run(port, '--board', 'apm2', '--out', folder, '--list')).out, /11 {2}not done/);
}));

test('a person who ends the input has stopped', () => withBoard(async (port) => {
  const session = start([port, '--board', 'apm2', '--out', newFolder()]);
  session.child.stdin.end('the propeller is off\n210\n');
  const { status, out } = await session.ended;
  assert.equal(status, 1);
  assert.match(out, /pass {6}current[^]*Stopped/);
}));

test('no board, no MAVLink, and files that are not ours', async () => {
  const folder = newFolder();
  const refused = async (words, status, pattern) => {
    const ended = await run(...words);
    assert.equal(ended.status, status, ended.out);
    assert.match(ended.out, pattern);
    assert.equal(ended.out.trim().split('\n').filter((line) => line.startsWith('bench:')).length, 1);
  };
  const to = ['--board', 'apm2', '--name', 'x', '--out', folder];
  await refused(['tcp:127.0.0.1:9', ...to], 2, /127\.0\.0\.1:9 cannot be opened: ECONNREFUSED/);
  await refused(['/dev/none', ...to], 2, /there is no port \/dev\/none/);
  const file = answersIn(newFolder(), {});
  await refused([file, ...to], 2, /answers\.json is no serial port/);
  for (const [text, why] of [['{"kind": "bench ses', /no whole JSON/], ['{"kind": 1}', /no session of this tool/],
    ['{"kind":"bench session","version":1,"board":"apm1","name":"y","steps":{},"restore":{}}', /of the board "y"/]]) {
    writeFileSync(join(folder, 'session.json'), text);
    await refused(['tcp:127.0.0.1:9', ...to], 2, why);
    assert.equal(readFileSync(join(folder, 'session.json'), 'utf8'), text, 'it stays as it was');
  }
  assert.ok(!existsSync(join(folder, 'form.html')));
});
