// SPDX-License-Identifier: GPL-3.0-or-later
// How npm is fetched where there is none, from a registry of this computer's own.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const program = join(dirname(fileURLToPath(import.meta.url)), '../../../../toolchain/shared/npm.mjs');
const folder = mkdtempSync(join(tmpdir(), 'npm-'));
after(() => rmSync(folder, { recursive: true }));

// { status, said, asked } with a registry that answers so
async function fetched(to, answer) {
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(request.url);
    response.shouldKeepAlive = false;  // an open connection keeps the program some seconds
    answer(response);
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  const child = spawn(process.execPath, [program, to], { env: { ...process.env, npm_config_registry: `http://127.0.0.1:${server.address().port}` } });
  let said = '';
  child.stderr.on('data', (bytes) => { said += bytes; });
  const status = await new Promise((resolve) => { child.on('close', resolve); });
  server.close();
  return { status, said, asked };
}

test('what is not the version that was checked is refused, and nothing is left', async () => {
  const to = join(folder, 'wrong');
  const { status, said, asked } = await fetched(to, (response) => response.end('another package'));
  assert.equal(status, 1);
  assert.match(said, /^npm could not be fetched \(npm-\d+\.\d+\.\d+\.tgz is not what it should be\); install it yourself/);
  assert.match(asked[0], /^\/npm\/-\/npm-\d+\.\d+\.\d+\.tgz$/);
  assert.ok(!existsSync(to));
});

test('a registry that has none is named', async () => {
  const { status, said } = await fetched(join(folder, 'none'), (response) => response.writeHead(404).end());
  assert.equal(status, 1);
  assert.match(said, /http:\/\/127\.0\.0\.1:\d+\/npm\/-\/npm-.*status 404/);
});

test('one that is there is not fetched again', async () => {
  const to = join(folder, 'there');
  mkdirSync(join(to, 'package/bin'), { recursive: true });
  writeFileSync(join(to, 'package/bin/npm-cli.js'), '');
  const { status, asked } = await fetched(to, (response) => response.end());
  assert.deepEqual([status, asked], [0, []]);
});
