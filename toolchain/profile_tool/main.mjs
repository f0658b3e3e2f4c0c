// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a profile that fly --profile has written; see --help. Its figures are shares of the
// processor, so they add up to the processor's load.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

import { checkOutput } from '../shared/output.mjs';

const usage = `usage: toolchain/profile PROFILE ELF [--lines N] [--of FUNCTION]

Where the cycles went that toolchain/fly --profile PROFILE --firmware ELF has counted.
  --lines N      of the table, 60
  --of FUNCTION  who calls what contains this name, what it calls, and where in it the cycles went
The ELF must be the one that was flown: its SHA-256 is in the profile. A .hex has no names of functions:
fly the .elf.
Columns: own, in the function itself; arithmetic, in the compiler's and C library's routines it
calls; all, with everything called from it. Percent of the processor.`;

// What is wrong with the files or the command line: one line for the user.
class Refusal extends Error {}

const plain = (name) => name.replace(/\(anonymous namespace\)::|firmware::| \[clone .*\]/g, '')
  .replace(/^.* (?=\S+\()/, '').replace(/\(.*$/, '');

// The functions of an ELF in the order of their addresses.
function functionsOf(elf) {
  let lines;
  try {
    lines = execFileSync('avr-nm', ['-C', '-n', '--defined-only', elf],
      { maxBuffer: 1 << 26, stdio: ['ignore', 'pipe', 'ignore'] });
  } catch {
    throw new Refusal(`${elf}: avr-nm cannot read it: an ELF is needed`);
  }
  const found = [];
  for (const line of lines.toString().split('\n')) {
    const [, address, name] = /^([0-9a-f]+) [Ttw] (.*)$/.exec(line) ?? [];
    if (!name || /^(__trampolines|__dtors|__ctors|\.L|L0)/.test(name)) continue;
    const at = parseInt(address, 16);
    if (found.at(-1)?.at === at) found.pop();
    const ours = name.includes('(') || /^(__vector|main$)/.test(name);
    found.push({ at, ours, name: plain(name), own: 0, all: 0, calls: 0, arithmetic: 0 });
  }
  return found;
}

const find = (functions, address) => {
  let low = 0, high = functions.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (functions[middle].at <= address) low = middle;
    else high = middle;
  }
  return functions[low];
};

// The compiler's and the C library's: what is ours has a namespace.
const isLibrary = ({ ours }) => !ours;

function gather(profile, functions) {
  for (const [address, cycles] of profile.cycles) find(functions, address).own += cycles;
  const ways = new Map();
  for (const [from, to, calls, cycles] of profile.calls) {
    const caller = from === to ? null : find(functions, from);
    const callee = find(functions, to);
    callee.calls += calls;
    if (caller !== callee) callee.all += cycles;
    if (caller && isLibrary(callee) && !isLibrary(caller)) caller.arithmetic += cycles;
    const way = `${caller?.at}>${callee.at}`;
    const known = ways.get(way) ?? { caller, callee, calls: 0, cycles: 0 };
    known.calls += calls;
    known.cycles += cycles;
    ways.set(way, known);
  }
  return [...ways.values()];
}

function table(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => String(row[column]).length)));
  for (const row of rows)
    console.log(row.map((cell, i) => (i === 0 ? String(cell).padEnd(Math.min(widths[0], 70)) : String(cell).padStart(widths[i]))).join('  '));
}

function report(profile, functions, ways, lines, of) {
  const share = (cycles) => (100 * cycles / profile.all).toFixed(2);
  const each = (cycles, calls) => (calls ? Math.round(cycles / calls) : '');
  if (of) {
    const chosen = ways.filter(({ caller, callee }) => callee.name.includes(of) || caller?.name.includes(of));
    table([['caller', 'called', 'calls', 'all, %', 'each'],
      ...chosen.sort((a, b) => b.cycles - a.cycles).slice(0, lines)
        .map((way) => [way.caller?.name ?? 'interrupt', way.callee.name, way.calls, share(way.cycles), each(way.cycles, way.calls)])]);
    return;
  }
  const shown = functions.filter(({ own }) => own > 0);
  console.log(`${share(shown.reduce((sum, { own }) => sum + own, 0))} % of the processor, ` +
    `${share(shown.filter(isLibrary).reduce((sum, { own }) => sum + own, 0))} % in library routines\n`);
  table([['function', 'calls', 'own, %', 'arithmetic, %', 'both, %', 'all, %', 'own each', 'all each'],
    ...shown.sort((a, b) => b.own + b.arithmetic - a.own - a.arithmetic).slice(0, lines)
      .map((f) => [f.name, f.calls, share(f.own), share(f.arithmetic), share(f.own + f.arithmetic), share(f.all),
        each(f.own, f.calls), each(f.all, f.calls)])]);
}

function read(path) {
  try {
    return readFileSync(path);
  } catch (error) {
    throw new Refusal(`${path}: cannot be read: ${error.code}`);
  }
}

function readProfile(path) {
  let profile;
  try {
    profile = JSON.parse(read(path));
  } catch (error) {
    if (error instanceof Refusal) throw error;
  }
  const whole = profile && profile.all > 0 && Array.isArray(profile.cycles) && Array.isArray(profile.calls);
  if (!whole) throw new Refusal(`${path}: no profile that fly --profile has written`);
  if (typeof profile.program?.sha256 !== 'string')
    throw new Refusal(`${path}: does not say of which program it is: fly it again`);
  return profile;
}

// Addresses mean something in the program that was flown, and in another something else.
function checkProgram({ program }, path, elf) {
  const found = createHash('sha256').update(read(elf)).digest('hex');
  if (found === program.sha256) return;
  throw new Refusal(`${path} is the profile of ${program.path} (SHA-256 ${program.sha256.slice(0, 12)}), ` +
    `not of ${resolve(elf)} (${found.slice(0, 12)})`);
}

checkOutput('profile');
const words = process.argv.slice(2);
const option = (name, otherwise) => {
  const at = words.indexOf(name);
  return at < 0 ? otherwise : words.splice(at, 2)[1];
};
const lines = Number(option('--lines', 60)), of = option('--of', null);
if (words.length !== 2 || words.includes('--help') || !(lines > 0)) {
  if (words.includes('--help')) console.log(usage);
  else console.error(usage);
  process.exit(words.includes('--help') ? 0 : 2);
}
try {
  const profile = readProfile(words[0]);
  checkProgram(profile, words[0], words[1]);
  const functions = functionsOf(words[1]);
  if (functions.length === 0) throw new Refusal(`${words[1]}: holds no names of functions`);
  report(profile, functions, gather(profile, functions), lines, of);
} catch (error) {
  if (!(error instanceof Refusal)) throw error;
  console.error(`profile: ${error.message}`);
  process.exitCode = 1;
}
