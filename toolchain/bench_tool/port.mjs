// SPDX-License-Identifier: GPL-3.0-or-later
// The way to the board: a serial port, or TCP to the simulator or a serial server. Either may go
// away, as a USB port does with the board's power, and is opened again when it is back.
import { execFileSync } from 'node:child_process';
import { close, constants, open, read, writeSync } from 'node:fs';
import { connect } from 'node:net';

import { checkPort } from '../flash_tool/port.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';

const kReopen_ms = 200, kPoll_ms = 4, kFirstWithin_ms = 3000;
const kRates = [9600, 19200, 38400, 57600, 115200];

// { kind: 'tcp', host, port } or { kind: 'serial', path, baud }.
export function addressOf(text, default_baud = 115200) {
  const tcp = /^tcp:([^:]+|\[[^\]]+\]):(\d+)$/.exec(text);
  if (tcp) {
    const port = Number(tcp[2]);
    if (port < 1 || port > 65535) throw new Refusal(`${text}: a TCP port is 1 to 65535`);
    return { kind: 'tcp', host: tcp[1].replace(/^\[|\]$/g, ''), port };
  }
  const serial = /^(\/[^:]+)(?::(\d+))?$/.exec(text);
  if (!serial) throw new Refusal(`${text} is no port: expected /dev/ttyACM0, /dev/ttyUSB0:57600 or tcp:HOST:PORT`);
  const baud = Number(serial[2] ?? default_baud);
  if (!kRates.includes(baud)) throw new Refusal(`${text}: the rate is one of ${kRates.join(', ')}`);
  return { kind: 'serial', path: serial[1], baud };
}

class Port {
  constructor(address) {
    this.address = address;
    this.connected = false;
    this.closed = false;
    this.early = [];  // came before anybody listened
    this.listener = (bytes) => this.early.push(Buffer.from(bytes));
  }
  // What came since the port was opened, and what comes from now on.
  onBytes(listener) {
    this.listener = listener;
    for (const bytes of this.early.splice(0)) listener(bytes);
  }
  up() { this.connected = true; }
  down() {
    if (!this.connected) return;
    this.connected = false;
    this.again();
  }
  again() {
    if (this.closed) return;
    this.timer = setTimeout(() => this.tryToOpen(), kReopen_ms);
    this.timer.unref();
  }
  close() {
    this.closed = true;
    this.connected = false;
    clearTimeout(this.timer);
    this.release();
  }
}

class TcpPort extends Port {
  canReset = false;
  tryToOpen() {
    const socket = connect(this.address.port, this.address.host).setNoDelay(true);
    this.socket = socket;
    socket.on('connect', () => this.up());
    socket.on('data', (bytes) => this.listener(bytes));
    socket.on('error', (error) => { this.reason = error.code; });
    socket.on('close', () => { if (this.connected) this.down(); else this.again(); });
  }
  write(bytes) { if (this.connected) this.socket.write(bytes); }
  release() { this.socket?.destroy(); }
}

// Read without waiting: a port that is pulled out must not leave a thread behind that waits for ever.
class SerialPort extends Port {
  canReset = true;
  tryToOpen() {
    open(this.address.path, constants.O_RDWR | constants.O_NOCTTY | constants.O_NONBLOCK, (error, fd) => {
      if (error || this.closed) {
        this.reason = error?.code;
        if (fd) close(fd, () => {});
        return this.again();
      }
      try {
        this.configure();
      } catch (problem) {
        this.reason = `${problem.stderr ?? problem.message}`.trim();
        close(fd, () => {});
        return this.again();
      }
      this.fd = fd;
      this.up();
      this.poll(fd);
    });
  }
  // hupcl: DTR falls when the port is closed and rises when it is opened, which resets the board.
  configure() {
    execFileSync('stty', ['-F', this.address.path, String(this.address.baud), 'raw', '-echo', '-echoe', '-echok',
                          '-crtscts', 'clocal', 'hupcl', 'min', '0', 'time', '0'], { stdio: ['ignore', 'ignore', 'pipe'] });
  }
  poll(fd) {
    const buffer = Buffer.alloc(4096);
    const again = () => { if (this.fd === fd) setTimeout(() => this.poll(fd), kPoll_ms).unref(); };
    read(fd, buffer, 0, buffer.length, null, (error, count) => {
      if (this.fd !== fd) return;
      if (error && error.code !== 'EAGAIN') return this.lose();
      if (count > 0) this.listener(buffer.subarray(0, count));
      again();
    });
  }
  lose() {
    this.release();
    this.down();
  }
  // Frees the port for another program; resume() opens it again, by which DTR rises.
  pause() {
    this.closed = true;
    this.connected = false;
    this.release();
  }
  async resume() {
    this.closed = false;
    this.tryToOpen();
    await opened(this);
  }
  write(bytes) {
    if (!this.connected) return;
    try {
      writeSync(this.fd, bytes);
    } catch (error) {
      if (error.code !== 'EAGAIN') this.lose();
    }
  }
  release() {
    if (this.fd === undefined) return;
    close(this.fd, () => {});
    this.fd = undefined;
  }
}

async function opened(port) {
  const until_ms = performance.now() + kFirstWithin_ms;
  while (!port.connected && performance.now() < until_ms) await new Promise((resolve) => { setTimeout(resolve, 20); });
  return port.connected;
}

// Opens it, or throws a Refusal with the reason; afterwards it comes back by itself.
export async function openPort(address) {
  if (address.kind === 'serial') checkPort(address.path);
  const port = address.kind === 'tcp' ? new TcpPort(address) : new SerialPort(address);
  port.tryToOpen();
  if (await opened(port)) return port;
  port.close();
  const where = address.kind === 'tcp' ? `${address.host}:${address.port}` : address.path;
  throw new Refusal(`${where} cannot be opened: ${port.reason ?? 'no answer'}`);
}

export const realClock = {
  now_ms: () => performance.now(),
  sleep: (time_ms) => new Promise((resolve) => { setTimeout(resolve, time_ms); }),
};
