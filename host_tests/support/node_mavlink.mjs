// SPDX-License-Identifier: GPL-3.0-or-later
// npm node-mavlink, the independent implementation the tests hold ours against.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../toolchain/node/package.json', import.meta.url));
const mappings = require('mavlink-mappings');
const dialects = [mappings.minimal, mappings.common, mappings.standard, mappings.ardupilotmega];

export const nodeMavlink = require('node-mavlink');
export const { x25crc } = mappings;

export const registry = Object.assign({}, ...dialects.map((dialect) => dialect.REGISTRY));
export const messages = Object.fromEntries(
  Object.values(registry).map((type) => [type.MSG_NAME, type]));
