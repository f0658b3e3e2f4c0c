// SPDX-License-Identifier: GPL-3.0-or-later
// npm node-mavlink, the independent implementation the tests hold ours against.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../toolchain/node/package.json', import.meta.url));
export const nodeMavlink = require('node-mavlink');
const { minimal, common, standard, ardupilotmega } = require('mavlink-mappings');

export const registry = { ...minimal.REGISTRY, ...common.REGISTRY, ...standard.REGISTRY,
  ...ardupilotmega.REGISTRY };
export const messages = Object.fromEntries(
  Object.values(registry).map((type) => [type.MSG_NAME, type]));

export const enums = { ...minimal, ...common, ...standard, ...ardupilotmega };
