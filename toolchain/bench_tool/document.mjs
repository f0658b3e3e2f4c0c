// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the steps' tables of docs/bench.md, between its marks, from the table of steps.
//   node toolchain/bench_tool/document.mjs
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { kSteps } from './steps/table.mjs';

const kDocument = fileURLToPath(new URL('../../docs/bench.md', import.meta.url));
const kColumns = 116;
const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`;

function folded(text) {
  const lines = [''];
  for (const word of text.split(' ')) {
    const longer = lines.at(-1) === '' ? word : `${lines.at(-1)} ${word}`;
    if (longer.length > kColumns) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines.join('\n');
}

const row = ({ title, limit }, where = '') => `| ${where}${title} | ${limit.text} | ${limit.why} |`;
const kApm1 = 'on an APM 1';

// A part's row, and one more where an APM 1 has another limit.
function rows(part) {
  if (part.only) return [row(part, `${kApm1}: `)];
  return part.apm1?.limit ? [row(part), row({ ...part, ...part.apm1 }, `${kApm1}: `)] : [row(part)];
}

// What to do when a part fails, where it is not what its step has.
function advice(part, failed) {
  const when = (text, title, where) => (text && text !== failed ? ['', folded(sentence(`${where}when the ${title} fails: ${sentence(text)}`))] : []);
  return [...when(part.failed, part.title, ''), ...when(part.apm1?.failed, part.apm1?.title ?? part.title, `${kApm1}, `)];
}

function section({ number, title, tools, failed, parts, apm1 = {} }) {
  const otherwise = [apm1.note, apm1.failed && `When it fails: ${apm1.failed}`].filter(Boolean).join(' ');
  return [`### ${number}. ${title}`, '', folded(`Tools: ${sentence(tools)} When it fails: ${sentence(failed)}`), '',
    '| part | limit | why |', '| --- | --- | --- |',
    ...parts.flatMap(rows), ...(otherwise ? ['', folded(`APM 1: ${otherwise}`)] : []),
    ...parts.flatMap((part) => advice(part, failed))].join('\n');
}

export const written = (document) =>
  document.replace(/(<!-- steps: .* -->\n)[^]*?(<!-- end -->)/, (_, begin, end) => `${begin}${kSteps.map(section).join('\n\n')}\n${end}`);

if (process.argv[1]?.endsWith('bench_tool/document.mjs')) writeFileSync(kDocument, written(readFileSync(kDocument, 'utf8')));
