// SPDX-License-Identifier: GPL-3.0-or-later
// A bootloader on a pseudo-terminal, the command that flashes it, and files for both.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
export const newFolder = () => mkdtempSync(join(tmpdir(), 'flash-'));

const hexLine = (address, type, bytes) => {
  const fields = [bytes.length, (address >> 8) & 255, address & 255, type, ...bytes];
  const sum = fields.reduce((total, byte) => total + byte, 0);
  return ':' + [...fields, -sum & 255].map((byte) => byte.toString(16).padStart(2, '0')).join('')
      .toUpperCase() + '\n';
};

// Intel hex of `bytes` from `begin` on.
export function intelHex(bytes, begin = 0) {
  let text = '', high = 0;
  for (let i = 0; i < bytes.length; i += 16) {
    const at = begin + i;
    if (at >> 16 !== high) {
      high = at >> 16;
      text += hexLine(0, 4, [high >> 8, high & 255]);
    }
    text += hexLine(at & 0xffff, 0, [...bytes.subarray(i, i + 16)]);
  }
  return text + hexLine(0, 1, []);
}

// Bytes that repeat nowhere nearby and are never zero.
export const noise = (count, seed = 1) => {
  let state = seed;
  return Buffer.from(Array.from({ length: count }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return 1 + state % 251;
  }));
};

export function fileOf(name, contents, folder = newFolder()) {
  const path = join(folder, name);
  writeFileSync(path, contents);
  return path;
}

// Runs a program to its end.
export function run(program, words, options = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, words, options);
    let out = '', said = '';
    child.stdout.on('data', (chunk) => { out += chunk; });
    child.stderr.on('data', (chunk) => { said += chunk; });
    child.on('error', reject);
    child.on('close', (status) => resolve({ status, out, said, last: said.trim().split('\n').at(-1) }));
  });
}

export const flash = (...words) => run(process.execPath, [join(root, 'toolchain/flash_tool/main.mjs'), ...words]);

// A bootloader with these faults behind `port`; end() gives its memories and what it was asked.
export async function startBoard(...faults) {
  const folder = newFolder();
  const peer = spawn(process.env.BOOTLOADER_PEER, [folder, ...faults],
                     { stdio: ['pipe', 'pipe', 'inherit'] });
  const closed = new Promise((resolve) => { peer.on('close', resolve); });
  const port = await new Promise((resolve) => {
    peer.stdout.once('data', (line) => resolve(`${line}`.trim()));
  });
  const left = (name) => readFileSync(join(folder, name));
  return {
    port,
    end: async () => {
      peer.stdin.end();
      await closed;
      return { flash: left('flash.bin'), eeprom: left('eeprom.bin'),
               conversation: `${left('conversation.txt')}`.trim().split('\n') };
    },
  };
}
