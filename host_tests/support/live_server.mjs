// SPDX-License-Identifier: GPL-3.0-or-later
// A server of a live flight that replays a flight document, ten times as fast, and answers commands
// as a simulator would that does what it is asked. It records them in `commands`.
import { createServer } from 'node:http';

import { decoded } from './flight_document.mjs';

const kEvery_ms = 10, kSampled_s = 0.1;

const kOffers = { modes: ['MANUAL', 'FBWA', 'AUTO'], faults: ['baro:lost', 'gps:lost', 'gps:stuck'] };
const empty = (document) => ({ ...document, kind: 'live', offers: kOffers, verdict: undefined, times: [[]], events: [], bands: [], deviations: [],
  tables: [], series: document.series.map((each) => ({ ...each, time: 0, values: [] })) });

function sampler(document) {
  const times = document.times.map(decoded);
  const all = document.series.map((each) => ({ key: each.kind ? `${each.name}:${each.kind}` : each.name,
    times: times[each.time], values: decoded(each.values), at: 0 }));
  return (time_s) => Object.fromEntries(all.map((each) => {
    while (each.times[each.at + 1] <= time_s) ++each.at;
    return [each.key, Number.isFinite(each.values[each.at]) ? each.values[each.at] : null];
  }));
}

class Replay {
  constructor(document, response, state) {
    Object.assign(this, { document, response, state, time_s: 20, sample: sampler(document) });
    this.send('flight', empty(document));
    this.timer = setInterval(() => this.tick(), kEvery_ms);
    response.on('close', () => clearInterval(this.timer));
  }
  send(name, data) { this.response.write(`event: ${name}\ndata: ${JSON.stringify(data)}\n\n`); }
  tick() {
    const { document, state } = this, before_s = this.time_s;
    this.status();
    if (state.paused) return;
    this.time_s += kSampled_s;
    this.send('samples', { time_s: this.time_s, values: this.sample(this.time_s) });
    const now = (time_s) => time_s > before_s && time_s <= this.time_s;
    for (const event of document.events) if (now(event.time_s)) this.send('event', event);
    for (const band of document.bands) {
      if (now(band.from_s) || (before_s === 20 && band.from_s <= 20 && band.to_s > 20)) this.send('band', { ...band, to_s: undefined });
      if (now(band.to_s)) this.send('band', band);
    }
  }
  status() {
    const { armed, mode, paused } = this.state;
    const text = JSON.stringify({ armed, mode, item: 2, speed: 10, times: 10, paused, clients: 1 });
    if (text === this.said) return;
    this.said = text;
    this.send('status', JSON.parse(text));
  }
}

const kAnswers = {
  arm: (state) => { state.armed = true; return 'armed'; },
  disarm: (state) => { state.armed = false; return 'disarmed'; },
  pause: (state) => { state.paused = true; return 'paused'; },
  resume: (state) => { state.paused = false; return 'goes on'; },
  mode: (state, { mode }) => { state.mode = mode; return `mode ${mode}`; },
};

// { url, commands, state, close() }; `page` is the text of GET /.
export async function liveServer(page, document) {
  const state = { armed: false, mode: 'FBWA', paused: false }, commands = [];
  const server = createServer((request, response) => {
    if (request.url === '/') return void response.writeHead(200, { 'Content-Type': 'text/html' }).end(page);
    if (request.url === '/live') {
      response.writeHead(200, { 'Content-Type': 'text/event-stream', 'Cache-Control': 'no-cache' });
      return void new Replay(document, response, state);
    }
    if (request.url !== '/command' || request.method !== 'POST') return void response.writeHead(404).end();
    let body = '';
    request.on('data', (bytes) => { body += bytes; });
    request.on('end', () => {
      const command = JSON.parse(body), answer = kAnswers[command.do];
      commands.push(command);
      response.writeHead(200, { 'Content-Type': 'application/json' });
      response.end(JSON.stringify(answer ? { ok: true, text: answer(state, command) } : { ok: true, text: `done: ${command.do}` }));
    });
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  return { url: `http://127.0.0.1:${server.address().port}/`, commands, state,
    close: () => { server.closeAllConnections(); server.close(); } };
}
