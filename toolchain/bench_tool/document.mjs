// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the steps' tables of docs/bench.md, between its marks, from the table of steps.
//   node toolchain/bench_tool/document.mjs
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { kSteps } from './steps/table.mjs';

const kDocument = fileURLToPath(new URL('../../docs/bench.md', import.meta.url));
const kColumns = 116;
const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}${/[.!]$/.test(text) ? '' : '.'}`;

function folded(text) {
  const lines = [''];
  for (const word of text.split(' ')) {
    const longer = lines.at(-1) === '' ? word : `${lines.at(-1)} ${word}`;
    if (longer.length > kColumns) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines.join('\n');
}

function section({ number, title, tools, failed, parts }) {
  return [`### ${number}. ${title}`, '', folded(`Tools: ${sentence(tools)} When it fails: ${sentence(failed)}`), '',
    '| part | limit | why |', '| --- | --- | --- |',
    ...parts.map((part) => `| ${part.title} | ${part.limit.text} | ${part.limit.why} |`),
    ...parts.filter((part) => part.failed && part.failed !== failed).flatMap((part) => ['', folded(`When the ${part.title} fails: ${sentence(part.failed)}`)])].join('\n');
}

export const written = (document) =>
  document.replace(/(<!-- steps: .* -->\n)[^]*?(<!-- end -->)/, (_, begin, end) => `${begin}${kSteps.map(section).join('\n\n')}\n${end}`);

if (process.argv[1]?.endsWith('bench_tool/document.mjs')) writeFileSync(kDocument, written(readFileSync(kDocument, 'utf8')));
