// SPDX-License-Identifier: GPL-3.0-or-later
// Step 16: toolchain/self_test, its parts as one row for each group of them.
import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';

import { boards } from '../../flash_tool/boards.mjs';
import { kParts, shown } from '../../self_test_tool/parts.mjs';
import { NotDone, NotMeasured } from '../errors.mjs';
import { holds, kPass } from '../limits.mjs';
import { runTool } from './tool.mjs';

const kPassed = 0, kFailed = 1;

// The figures that toolchain/self_test writes at its end.
async function selfTested(b) {
  const { board, folder, selfTest: simulated } = b.options;
  const file = join(folder, 'self_test.json');
  rmSync(file, { force: true });
  const status = await runTool(b, 'self_test', ['--board', board, '--yes', '--out', file],
    simulated && ((path) => simulated(path, board, file)));
  if (status !== kPassed && status !== kFailed) throw new NotMeasured(`toolchain/self_test ended with status ${status}`);
  return figuresOf(file);
}

function figuresOf(file) {
  try {
    return JSON.parse(readFileSync(file, 'utf8'));
  } catch {
    throw new NotMeasured('toolchain/self_test did not come to its end');
  }
}

// What a part is called within its group.
const nameOf = ({ title }) => title.split(': ').at(-1);
const unique = (texts) => [...new Set(texts)];
const named = (part, all, text) => (unique(all.map(nameOf)).length > 1 ? `${nameOf(part)} ${text}` : text);

// Parts of a group that have the same name have the same limit: the same of each output.
function limitOf(parts) {
  const text = unique(parts.map((part) => named(part, parts, part.limit.text))).join('; ');
  return holds(text, unique(parts.map(({ limit }) => limit.why)).join('; '));
}

function measuredOf(parts, found) {
  return unique(parts.map((part) => {
    const values = parts.filter((each) => nameOf(each) === nameOf(part)).flatMap(({ title }) => found.get(title)?.values ?? [NaN]);
    return named(part, parts, values.every(Number.isFinite) ? shown(values, part.limit) : 'not in the report');
  })).join('; ');
}

function verdictOf(parts, figures) {
  const found = new Map(figures.parts.map((part) => [part.title, part]));
  const bad = parts.filter(({ title }) => found.get(title)?.verdict !== kPass);
  const outputs = bad.filter(({ title }) => /^output \d/.test(title)).map(({ title }) => title);
  return { ok: bad.length === 0, note: [measuredOf(parts, found), ...outputs].join('; ') };
}

const kGroups = unique(kParts.map(({ group }) => group));
const groupParts = (group) => kParts.filter((part) => part.group === group);

const row = (group) => ({
  id: `16.${group.toLowerCase().replace(/\W+/g, '_')}`, title: group, limit: limitOf(groupParts(group)),
  failed: unique(groupParts(group).flatMap(({ failed = [] }) => failed)).join(' '),
  measure: ({ found }) => {
    if (!found.selfTest) throw new NotDone('no report');
    return verdictOf(groupParts(group), found.selfTest);
  },
});

export const selfTest = {
  number: 16, title: 'The board\'s own self-test', tools: 'the USB cable; nothing in the outputs, the radio unplugged',
  failed: 'docs/bench.md, "The board\'s self-test".',
  parts: [
    { id: '16.run', title: 'run, and the firmware written back', limit: holds('the report of this board, whole', 'toolchain/self_test'),
      measure: async (b) => {
        await b.person.action(b.id, 'The self-test is written through the bootloader, runs for half a minute, and the firmware is written back. ' +
          'Its outputs get pulses of up to 1000 us: nothing in them.');
        const { board, unknown, parts } = await selfTested(b);
        const wanted = boards[b.options.board].name;
        if (board !== wanted) return { ok: false, note: `the report of an ${board ?? 'unknown board'}` };
        b.found.selfTest = { parts };
        return { ok: unknown.length === 0, note: unknown.length === 0 ? `of an ${board}` : `not understood: ${unknown.join('; ')}` };
      } },
    ...kGroups.map(row),
  ],
};
