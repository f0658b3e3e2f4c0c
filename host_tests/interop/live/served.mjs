// SPDX-License-Identifier: GPL-3.0-or-later
// A served flight as its page meets it: events in, commands out, all over HTTP.
// FLY names the program, FLY_BOARD is `native` or `elf`.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync } from 'node:fs';
import { request } from 'node:http';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const { FLY, FLY_BOARD } = process.env;
const kPatience_ms = 60_000;

// One listener of GET /live: what it was sent, by the events' names.
export class Stream {
  constructor(port) {
    this.got = { flight: [], samples: [], event: [], band: [], status: [] };
    this.waiting = '';
    this.asked = request({ port, host: '127.0.0.1', path: '/live' }, (response) => {
      assert.equal(response.headers['content-type'], 'text/event-stream');
      response.setEncoding('utf8').on('data', (text) => this.take(text));
    });
    this.asked.on('error', () => {});
    this.asked.end();
  }
  take(text) {
    const parts = (this.waiting + text).split('\n\n');
    this.waiting = parts.pop();
    for (const part of parts) {
      const name = /^event: (.*)$/m.exec(part)?.[1];
      if (name) this.got[name].push(JSON.parse(/^data: (.*)$/m.exec(part)[1]));
    }
    this.arrived?.();
  }
  // The first of these that fits, of those that came or will come.
  async until(name, where = () => true, what = name) {
    const end = Date.now() + kPatience_ms;
    for (;;) {
      const found = this.got[name].find(where);
      if (found) return found;
      assert.ok(Date.now() < end, `${what} did not come; last: ${JSON.stringify(this.got[name].at(-1))}`);
      await Promise.race([new Promise((resolve) => { this.arrived = resolve; }),
        new Promise((resolve) => { setTimeout(resolve, 500); })]);
    }
  }
  forget() { for (const list of Object.values(this.got)) list.length = 0; }
  get last() { return this.got.samples.at(-1); }
  close() { this.asked.destroy(); }
}

export class Served {
  static async start(words = ['--serve', '--listen', '0']) {
    const served = new Served();
    const board = FLY_BOARD === 'elf' ? [] : ['--native'];
    served.out = mkdtempSync(join(tmpdir(), 'live-'));
    served.said = '';
    const env = { ...process.env, DISPLAY: '', WAYLAND_DISPLAY: '' };  // nothing is opened
    served.program = spawn(FLY, [...board, ...words, '--out', served.out], { env });
    served.gone = once(served.program, 'close').then(([status]) => status);
    for (const stream of [served.program.stdout, served.program.stderr])
      stream.setEncoding('utf8').on('data', (text) => { served.said += text; });
    while (!/http:\/\/127\.0\.0\.1:\d+/.test(served.said))
      await Promise.race([once(served.program.stdout, 'data'), served.gone.then(() => assert.fail(served.said))]);
    served.port = +/http:\/\/127\.0\.0\.1:(\d+)/.exec(served.said)[1];
    served.telemetry = +(/TCP port (\d+)/.exec(served.said)?.[1] ?? 0);
    served.stream = new Stream(served.port);
    return served;
  }
  ask(path, { method = 'GET', headers = {}, body } = {}) {
    return new Promise((resolve, reject) => {
      const asked = request({ port: this.port, host: '127.0.0.1', path, method, headers }, (response) => {
        let text = '';
        response.setEncoding('utf8').on('data', (part) => { text += part; })
          .on('end', () => resolve({ status: response.statusCode, headers: response.headers, text }));
      });
      asked.on('error', reject);
      asked.end(body);
    });
  }
  async post(body) {
    const headers = { 'Content-Type': 'application/json' };
    const { status, text } = await this.ask('/command', { method: 'POST', body, headers });
    return { status, ...JSON.parse(text) };
  }
  do(order) { return this.post(JSON.stringify(order)); }
  async must(order) {
    const answer = await this.do(order);
    assert.ok(answer.ok, `${JSON.stringify(order)}: ${answer.text}`);
    return answer.text;
  }
  async armWhenReady() {
    for (let tries = 0; tries < 60; ++tries) {
      if ((await this.do({ do: 'arm' })).ok) return;
      await new Promise((resolve) => { setTimeout(resolve, 50); });
    }
    assert.fail(`never ready: ${this.said}`);
  }
  async says(pattern) {
    for (const end = Date.now() + kPatience_ms; !pattern.test(this.said);) {
      assert.ok(Date.now() < end, `${pattern} was not said`);
      await new Promise((resolve) => { setTimeout(resolve, 20); });
    }
  }
  // Bytes that are no request of node's own.
  async raw(bytes) {
    const socket = connect(this.port, '127.0.0.1');
    await once(socket, 'connect');
    socket.write(bytes);
    let text = '';
    socket.on('data', (part) => { text += part; }).on('error', () => {});
    await once(socket, 'close');
    return text;
  }
  async stop() {
    this.stream.close();
    this.program.kill('SIGINT');
    return this.gone;
  }
  clean() {
    this.program.kill('SIGKILL');
    this.stream.close();
    rmSync(this.out, { recursive: true, force: true });
  }
}

export const withServed = (body, words) => async () => {
  const served = await Served.start(words);
  try {
    await body(served);
  } catch (error) {
    error.message += `\n${served.said}`;
    throw error;
  } finally {
    served.clean();
  }
};
