// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/help keeps what the tools answer to --help, so that asking needs nothing built. This
// holds it to what the programs print, and fails for any difference.
//   node help.mjs [--update] FOLDER_OF_PROGRAMS
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
const kept = join(root, 'toolchain/help');
const kCommands = { fly: 'fly', campaign: 'campaign', chaos: 'chaos', mission: 'mission_tool', param: 'param_tool', log: 'log_tool' };
const kScripts = ['bench', 'flash', 'known_bugs', 'mutate', 'same', 'self_test', 'test'];  // of node, in toolchain/NAME_tool

function ask([program, ...words]) {
  const { status, stdout, error } = spawnSync(program, [...words, '--help'], { encoding: 'utf8' });
  if (status !== 0) throw new Error(`${program} ${words.join(' ')} --help: ${error?.message ?? `status ${status}`}`);
  return `${stdout.replaceAll(root, '@ROOT@').trimEnd()}\n`;
}

const subcommandsIn = (text) => [...(/\nSubcommands:\n((?: +.*\n)+)/.exec(text)?.[1] ?? '').matchAll(/^ {2}(\w+)/gm)]
  .map(([, name]) => name);

// File name to text.
function answers(folder) {
  const found = new Map(kScripts.map((name) =>
    [`${name}.txt`, ask([process.execPath, join(root, 'toolchain', `${name}_tool/main.mjs`)])]));
  for (const [command, program] of Object.entries(kCommands)) {
    const path = join(folder, program);
    const text = ask([path]);
    found.set(`${command}.txt`, text);
    for (const name of subcommandsIn(text)) found.set(`${command}-${name}.txt`, ask([path, name]));
  }
  return found;
}

function differences(found) {
  const names = new Set([...found.keys(), ...readdirSync(kept)]);
  return [...names].filter((name) => {
    try {
      return readFileSync(join(kept, name), 'utf8') !== found.get(name);
    } catch {
      return true;
    }
  });
}

const words = process.argv.slice(2);
const update = words[0] === '--update';
const found = answers(words[update ? 1 : 0]);
if (update) for (const [name, text] of found) writeFileSync(join(kept, name), text);
const stale = differences(found);
for (const name of stale) console.log(`toolchain/help/${name} is not what the program prints`);
if (stale.length > 0) console.log('node host_tests/unit/toolchain/help/help.mjs --update build/host writes them anew');
process.exitCode = stale.length === 0 ? 0 : 1;
