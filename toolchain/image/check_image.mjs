// SPDX-License-Identifier: GPL-3.0-or-later
// After linking: one line for each memory, and a failure when one is past its budget.
//   node toolchain/image/check_image.mjs FILE.elf [BUDGETS.json [BOARD]]
// A board has the budgets of all but for those that stand under its name.
// The budgets are those of avr-gcc 5.4, and so is what is known of the code a compiler writes: of an
// image by another one they are notes.
// Also fails when the image has `!!!` and the board's loader may have a monitor that is called by it,
// when it reaches the bootloader, constructs a global object at start-up, or
// has tables in flash where the short load instruction does not reach. The interrupts' budget in
// cycles is held by the simulated flight, which measures it.
import { readFileSync } from 'node:fs';

import { readElf } from './elf.mjs';
import { describe, stackBound } from './stack_bound.mjs';

const kBootloader = 0x3e000;  // of both boards: the top 8 KiB
const kNearFlash = 0x10000;
const kCompiler = 'GCC: (GNU) 5.4.0';
// What is to survive a restart must not lie in the RAM that a bootloader may use.
const kSurvivesFrom = 0x800600, kSurvivesTo = 0x801e00;

// What cannot be followed is an overrun: nobody knows how deep the stack gets.
function boundOf(path, overruns) {
  try {
    return stackBound(path);
  } catch (error) {
    overruns.push(`stack: ${error.message}`);
    return null;
  }
}

export function checkImage(path, budgets) {
  const elf = readElf(path);
  const lines = [], faults = [], overruns = [];
  const weigh = (name, bytes, budget, more = '') => {
    const percent = (100 * bytes / budget).toFixed(1);
    lines.push(`${name.padEnd(11)} ${String(bytes).padStart(6)} of ${String(budget).padStart(6)} (${percent} %)${more}`);
    if (bytes > budget) overruns.push(`${name}: ${bytes} bytes are ${bytes - budget} past the budget of ${budget}`);
  };

  const flash = elf.length('.text') + elf.length('.data');
  const ram = elf.length('.data') + elf.length('.bss') + elf.length('.noinit');
  const stack = boundOf(path, overruns);
  weigh('flash', flash, budgets.flash);
  weigh('ram', ram, budgets.ram_static, `  data ${elf.length('.data')}, bss ${elf.length('.bss')}, noinit ${elf.length('.noinit')}`);
  if (stack) {
    weigh('stack', stack.bytes, budgets.stack, `  ${describe(stack)}`);
    weigh('ram + stack', ram + stack.bytes, budgets.ram_static_and_stack);
  }

  if (flash > kBootloader) faults.push(`the image ends at 0x${flash.toString(16)}, behind the bootloader's 0x${kBootloader.toString(16)}`);
  const call = Buffer.concat([elf.text, elf.data]).indexOf('!!!');
  if (budgets.loader_monitor && call >= 0) faults.push(`'!!!' at 0x${call.toString(16)} calls the monitor of old Mega 2560 loaders: flashing hangs`);
  const tables = elf.symbol('__ctors_start')?.value ?? 0;
  if (tables >= kNearFlash) faults.push(`tables in flash reach 0x${tables.toString(16)}, past 64 KiB`);
  const constructors = elf.symbols.filter((symbol) => symbol.name.startsWith('_GLOBAL__sub_I'));
  for (const symbol of constructors) faults.push(`a global object is constructed at start-up: ${symbol.name}`);
  if (elf.symbol('__ctors_end')?.value !== elf.symbol('__ctors_start')?.value) faults.push('.ctors is not empty');
  for (const { value, size, name } of elf.symbols.filter((symbol) => symbol.section === '.noinit' && symbol.size > 0)) {
    if (value < kSurvivesFrom || value + size > kSurvivesTo) faults.push(`${name} is to survive a restart where a bootloader may write, at 0x${value.toString(16)}`);
  }
  if (elf.compiler === kCompiler) return { lines, faults: [...faults, ...overruns], notes: [] };
  return { lines, faults, notes: [`compiled by ${elf.compiler || 'an unknown compiler'}; the budgets are of ${kCompiler}`, ...overruns] };
}

function run([path, file = new URL('budgets.json', import.meta.url), board]) {
  if (!path) throw new Error('usage: check_image.mjs FILE.elf [BUDGETS.json [BOARD]]');
  const budgets = JSON.parse(readFileSync(file));
  const { lines, faults, notes } = checkImage(path, { ...budgets, ...budgets[board] });
  for (const line of lines) console.log(line);
  for (const note of notes) console.log(`note: ${note}`);
  for (const fault of faults) console.error(`check_image: ${fault}`);
  if (faults.length > 0) process.exitCode = 1;
}

if (process.argv[1]?.endsWith('check_image.mjs')) {
  try {
    run(process.argv.slice(2));
  } catch (error) {
    console.error(`check_image: ${error.message}`);
    process.exitCode = 1;
  }
}
