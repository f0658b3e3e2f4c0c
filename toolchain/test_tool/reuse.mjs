// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a test, unless it has passed before with the same inputs and REUSE_RESULTS is set.
//   node reuse.mjs STAMP INPUT... -- COMMAND...
// Its inputs are the files named, those among the words of the command, all scripts when the
// command is one, and the words themselves. The stamp is their SHA-256; it is written when the
// test has passed, and removed while it runs.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kVariables = ['FUZZ_RUNS', 'FLY_BOARD'];

const isFile = (path) => statSync(path, { throwIfNoEntry: false })?.isFile() ?? false;

function scripts() {
  return ['host_tests', 'toolchain'].flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true })
      .filter((name) => /\.(mjs|json)$/.test(name) && !/node_modules/.test(name))
      .map((name) => join(root, folder, name)));
}

export function digest(inputs, command) {
  const hash = createHash('sha256');
  const files = [...inputs, ...command.filter(isFile)];
  if (command.some((word) => word.endsWith('.mjs'))) files.push(...scripts());
  for (const file of [...new Set(files)].sort()) {
    hash.update(`${file}\0`);
    hash.update(isFile(file) ? createHash('sha256').update(readFileSync(file)).digest() : 'missing');
  }
  for (const word of command) hash.update(`${word}\0`);
  for (const name of kVariables) hash.update(`${name}=${process.env[name] ?? ''}\0`);
  return hash.digest('hex');
}

function read(path) {
  return isFile(path) ? readFileSync(path, 'utf8').trim() : '';
}

function run([stamp, ...words]) {
  const end = words.indexOf('--');
  const command = words.slice(end + 1);
  const now = digest(words.slice(0, end), command);
  if (process.env.REUSE_RESULTS && read(stamp) === now) {
    console.log(`passed ${statSync(stamp).mtime.toISOString()}, and nothing it depends on has changed since;`);
    console.log('toolchain/test --again runs it all the same');
    return 0;
  }
  rmSync(stamp, { force: true });
  const { status, signal, error } = spawnSync(command[0], command.slice(1), { stdio: 'inherit' });
  if (error) console.error(`reuse: ${error.message}`);
  if (signal) console.error(`ended by ${signal}`);
  if (status !== 0) return status ?? 1;
  mkdirSync(dirname(stamp), { recursive: true });
  writeFileSync(stamp, `${now}\n`);
  return 0;
}

if (process.argv[1]?.endsWith('reuse.mjs')) process.exitCode = run(process.argv.slice(2));
