// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { test } from 'node:test';

import { addressOf, openPort, realClock } from '../../../../toolchain/bench_tool/port.mjs';

test('what a board says before anybody listens is not lost, and comes before what follows', async () => {
  const server = createServer((socket) => {
    socket.write('first ');
    server.socket = socket;
  }).listen(0, '127.0.0.1');
  await once(server, 'listening');
  const port = await openPort(addressOf(`tcp:127.0.0.1:${server.address().port}`));
  try {
    await realClock.sleep(100);
    let heard = '';
    port.onBytes((bytes) => { heard += bytes; });
    assert.equal(heard, 'first ');
    server.socket.write('second');
    while (heard !== 'first second') await realClock.sleep(5);
  } finally {
    port.close();
    server.close();
  }
});
