// SPDX-License-Identifier: GPL-3.0-or-later
// host_tests/unit mirrors the sources: a test has the path of what it tests. Those of a whole
// folder, or of several of its files, are the few named here.
import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const unit = dirname(fileURLToPath(import.meta.url)), root = join(unit, '../..');
const ofAFolder = new Set([
  'firmware/mission/beyond_commands', 'firmware/mission/damaged_memory', 'firmware/mission/every_bit', 'firmware/mission/every_command',
  'firmware/mission/lost_flash', 'firmware/mission/manual', 'firmware/mission/new_flight', 'firmware/mission/upgrade', 'firmware/mission/whole_board',
  ...['conditions', 'fence_conditions', 'manual', 'restart_conditions'].map((name) => `firmware/safety/${name}`), 'firmware/sensors/radio_conditions', 'libraries/storage/damaged_lists', 'libraries/storage/damaged_parameters',
  'libraries/storage/flash_staging', 'libraries/storage/power_cut', 'simulator/airplane/parameter_files', 'simulator/campaign/program',
  'simulator/report/report', 'toolchain/cmake/configure', 'toolchain/flash_tool/flash',
  ...['errors', 'flight_limits', 'garbage', 'round_trip', 'show'].map((name) => `toolchain/mission_tool/${name}`),
  'toolchain/mutate_tool/mutate', ...['errors', 'garbage', 'round_trip'].map((name) => `toolchain/param_tool/${name}`),
  'toolchain/same_tool/same', 'toolchain/test_tool/test_tool',
]);
const subjects = readdirSync(unit, { recursive: true })
  .map((path) => /^(?!docs\/)(.+\/.+?)(?:_test\.cpp|\.test\.mjs)$/.exec(path)?.[1]).filter(Boolean);
const hasSource = (path) => ['cpp', 'hpp', 'mjs', 'csv'].some((ending) => existsSync(join(root, `${path}.${ending}`)));

test('there are tests', () => assert.ok(subjects.length > 100, `${subjects.length}`));

test('every test has the path of a source', () => {
  assert.deepEqual(subjects.filter((path) => !hasSource(path) && !existsSync(join(root, path)) && !ofAFolder.has(path)), []);
});

test('those of a whole folder exist, in a folder of the sources', () => {
  for (const path of ofAFolder) assert.ok(subjects.includes(path) && existsSync(join(root, dirname(path))), path);
});
