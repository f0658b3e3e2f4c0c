// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/self_test as a user runs it, over TCP with the image of the self-test on an emulated board: a good one
// passes, and each thing that is wrong with another fails its part. A good APM 2 is in session.test.mjs, step 16.
// FLY names the simulator's program, SELF_TEST_apm1 and SELF_TEST_apm2 the images.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const kProgram = fileURLToPath(new URL('../../../toolchain/self_test_tool/main.mjs', import.meta.url));

// { status, out, parts }: of a board with these options of the simulator.
async function tested(board, options = []) {
  const fly = spawn(process.env.FLY, ['--serve', '--bench', '--no-http', '--board', board, '--firmware', process.env[`SELF_TEST_${board}`],
    '--listen', '0', ...options], { stdio: ['ignore', 'pipe', 'inherit'] });
  try {
    const [said] = await once(fly.stdout, 'data');
    const [, usb] = [...said.toString().matchAll(/ on(?: TCP port)? (\d+)/g)].map((match) => match[1]);
    const file = join(mkdtempSync(join(tmpdir(), 'self-test-')), 'figures.json');
    const tool = spawn(process.execPath, [kProgram, `tcp:127.0.0.1:${usb}`, '--board', board, '--yes', '--out', file]);
    let out = '';
    for (const stream of [tool.stdout, tool.stderr]) stream.on('data', (chunk) => { out += chunk; });
    const [status] = await once(tool, 'close');
    return { status, out, ...JSON.parse(readFileSync(file, 'utf8')) };
  } finally {
    fly.kill();
    await once(fly, 'exit');
  }
}
const notPassed = ({ parts }) => parts.filter(({ verdict }) => verdict !== 'pass').map(({ title }) => title);

test('a good APM 1 passes', { concurrency: true }, async () => {
  const { status, out, passed, parts } = await tested('apm1');
  assert.equal(status, 0, out);
  assert.equal(passed, true);
  assert.match(out, /The board passes its self-test\./);
  assert.equal(parts.length, 30);
});

test('a board with worn cells, a silent barometer, a lost compass and no DataFlash fails these parts alone', { concurrency: true }, async () => {
  const result = await tested('apm2', ['--worn-eeprom', '4096', '--no-dataflash', '--fault', 'baro:lost@0', '--fault', 'compass:lost@0']);
  assert.equal(result.status, 1, result.out);
  assert.deepEqual(notPassed(result), ['barometer: readings in 10 s', 'barometer: bad reads and restarts',
    'compass: answers of 100', 'EEPROM: bad cells', 'DataFlash: pages']);
  assert.match(result.out, /DOES NOT PASS/);
});
