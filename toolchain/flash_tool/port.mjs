// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a serial port can be used, and what to do when it cannot. avrdude itself goes on for ever
// without its port, and happily shares one with a ground station.
import { accessSync, constants, readdirSync, readFileSync, readlinkSync, realpathSync,
         statSync } from 'node:fs';
import { userInfo } from 'node:os';

import { Refusal } from './refusal.mjs';

const list = (folder) => {
  try {
    return readdirSync(folder);
  } catch {
    return [];  // not there, or another user's
  }
};

// Asks the running system; the tests ask a made-up one.
export const system = {
  ports: () => list('/dev').filter((name) => /^tty(ACM|USB)\d+$/.test(name)).sort()
      .map((name) => `/dev/${name}`),
  isSerial: (port) => statSync(port).isCharacterDevice(),  // throws when missing
  mayUse: (port) => {
    try {
      accessSync(port, constants.R_OK | constants.W_OK);
      return true;
    } catch {
      return false;
    }
  },
  user: () => userInfo().username,
  // Other programs that have it open: [{ pid, name }], as far as this user may see.
  holders: (port) => {
    const path = realpathSync(port);
    const holds = (pid) => list(`/proc/${pid}/fd`).some((fd) => {
      try {
        return readlinkSync(`/proc/${pid}/fd/${fd}`) === path;
      } catch {
        return false;  // closed meanwhile
      }
    });
    const nameOf = (pid) => {
      try {
        return readFileSync(`/proc/${pid}/comm`, 'utf8').trim();
      } catch {
        return 'a program';
      }
    };
    return list('/proc').filter((name) => /^\d+$/.test(name) && Number(name) !== process.pid)
        .filter(holds).map((pid) => ({ pid: Number(pid), name: nameOf(pid) }));
  },
};

function whatThereIs(ask) {
  const ports = ask.ports();
  return ports.length > 0
      ? `there are ${ports.join(', ')}`
      : 'there is no USB serial port at all: is the cable in, and one that carries data?';
}

// Throws a Refusal that says what to do.
export function checkPort(port, ask = system) {
  let serial;
  try {
    serial = ask.isSerial(port);
  } catch {
    throw new Refusal(`there is no port ${port}; ${whatThereIs(ask)}`);
  }
  if (!serial) throw new Refusal(`${port} is no serial port; ${whatThereIs(ask)}`);
  if (!ask.mayUse(port))
    throw new Refusal(`${port} may not be used by ${ask.user()}: run ` +
                      `'sudo usermod -aG dialout ${ask.user()}', log out and in again`);
  const holders = ask.holders(port);
  if (holders.length > 0)
    throw new Refusal(`${port} is in use by ` +
                      holders.map(({ name, pid }) => `${name} (process ${pid})`).join(', ') +
                      ': close it and try again');
}
