// SPDX-License-Identifier: GPL-3.0-or-later
// The script of docs/scripting.md, taken out of the document and run as its reader would. Between it
// and the vehicle stands a server that lets emulated time pass while the script runs.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { withVehicle } from '../../support/vehicle.mjs';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const kStep_ms = 20, kAtMost_ms = 240_000;
const onNative = process.env.FLY_BOARD === 'elf' ? test.skip : test;

function scriptOfDocument() {
  const [, script] = /```js\n([^]*?)```/.exec(readFileSync(join(root, 'docs/scripting.md'), 'utf8'));
  const folder = mkdtempSync(join(tmpdir(), 'script-'));
  symlinkSync(join(root, 'toolchain/node/node_modules'), join(folder, 'node_modules'));
  const file = join(folder, 'flight.mjs');
  writeFileSync(file, script);
  return file;
}

// What comes from one end goes to the other.
function bridge(client, line) {
  client.on('error', () => {});
  line.socket.on('data', (bytes) => client.write(bytes));
  client.on('data', (bytes) => {
    line.written += bytes.length;
    line.socket.write(bytes);
  });
}

const moment = () => new Promise((resolve) => { setTimeout(resolve, 1); });

onNative('the script of the document takes off, goes to its place and comes back', withVehicle({ booted: false },
  async (vehicle) => {
    const server = createServer((client) => bridge(client, vehicle.line)).listen(0, '127.0.0.1');
    await once(server, 'listening');
    const script = spawn('node', [scriptOfDocument(), `127.0.0.1:${server.address().port}`]);
    let said = '', ended = false;
    for (const stream of [script.stdout, script.stderr]) stream.on('data', (text) => { said += text; });
    script.on('close', () => { ended = true; });
    while (!ended && vehicle.now_ms < kAtMost_ms) {
      await vehicle.advance(kStep_ms);
      vehicle.forget();
      await moment();
    }
    script.kill();
    server.close();
    assert.match(said, /armed[^]*50 m high[^]*there[^]*home again\n$/);
    const { altitude_m } = JSON.parse(await vehicle.order('state'));
    assert.ok(altitude_m > 488 + 30, `${altitude_m} m above the sea`);
  }));
