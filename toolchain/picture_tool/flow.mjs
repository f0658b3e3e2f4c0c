// SPDX-License-Identifier: GPL-3.0-or-later
// Draws docs/NAME.svg of docs/NAME.txt: rows of boxes, each leading to the next.
//   node toolchain/picture_tool/flow.mjs docs/architecture.txt
import { readFileSync, writeFileSync } from 'node:fs';

import { escaped } from './wiring.mjs';

const kMargin = 12, kBox = 176, kStep = 194, kHeight = 92, kTop = 42, kRow = 158, kLine = 17, kLines = 3;
const kLetters = 24;  // of a line in a box

const style = `text{font-family:system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;font-size:12px;fill:#3d4856}
.head{font-size:16px;font-weight:600;fill:#1c2430}.name{font-size:14px;font-weight:600;fill:#1c2430}
.box{stroke-width:1.5}.a{fill:#e8f1fd;stroke:#3b73b9}.b{fill:#e9f6ec;stroke:#3a8a55}.c{fill:#fdf0e3;stroke:#b5722a}
.arrow{stroke:#5d6b7c;stroke-width:1.8;fill:none}.tip{fill:#5d6b7c}.page{fill:#fff}
@media(prefers-color-scheme:dark){text{fill:#b9c4d0}.head,.name{fill:#eef2f6}.page{fill:#14191f}
.a{fill:#17273c}.b{fill:#15291d}.c{fill:#33240f}.arrow{stroke:#93a1b0}.tip{fill:#93a1b0}}`;

const left = (index) => kMargin + index * kStep;

function addBack(flow, names, words) {
  const [from, to] = names.split(' > ').map((name) => flow.boxes.findIndex((each) => each.name === name));
  if (from < 0 || to < 0) throw new Error(`no boxes "${names}" before it in its row`);
  flow.back = { from, to, words };
}

function addBox(flow, name, lines) {
  if (lines.length > kLines) throw new Error(`"${name}" has ${lines.length} lines, ${kLines} are shown`);
  const long = lines.find((line) => line.length > kLetters);
  if (long) throw new Error(`"${long}" is longer than the ${kLetters} letters of a box`);
  flow.boxes.push({ name, lines });
}

function addLine(found, line) {
  const [, kind, rest] = /^(title|flow|back): (.+)$/.exec(line) ?? [undefined, 'box', line];
  const [first, ...others] = rest.split(' | ');
  const flow = found.flows.at(-1);
  if (kind === 'title') found.title = rest;
  else if (kind === 'flow') found.flows.push({ head: first, rate: others.join(), boxes: [] });
  else if (!flow) throw new Error('there is no "flow: " before it');
  else if (kind === 'back') addBack(flow, first, others.join());
  else addBox(flow, first, others);
}

// { title, flows: [{ head, rate, boxes: [{ name, lines }], back }] }; a wrong line is an error with its number.
export function read(source) {
  const found = { flows: [] };
  for (const [index, line] of source.split('\n').entries()) {
    if (line === '' || line.startsWith('#')) continue;
    try {
      addLine(found, line);
    } catch (error) {
      throw new Error(`line ${index + 1}: ${error.message}`);
    }
  }
  if (!found.title || found.flows.length === 0) throw new Error('there is no title or no flow');
  return found;
}

function box({ name, lines }, index, top, colour) {
  const x = left(index) + 10;
  return [`<rect x="${left(index)}" y="${top}" width="${kBox}" height="${kHeight}" rx="7" class="box ${colour}"/>`,
    `<text x="${x}" y="${top + 22}" class="name">${escaped(name)}</text>`,
    ...lines.map((line, i) => `<text x="${x}" y="${top + 43 + i * kLine}">${escaped(line)}</text>`),
    ...(index === 0 ? [] : [`<path d="M${left(index) - 17} ${top + 46}H${left(index) - 1}" class="arrow" marker-end="url(#tip)"/>`])];
}

function back({ from, to, words }, top) {
  const [begin, end] = [from, to].map((index) => left(index) + kBox / 2);
  const below = top + kHeight;
  return [`<path d="M${begin} ${below + 1}V${below + 24}H${end}V${below + 2}" class="arrow" stroke-dasharray="5 4" marker-end="url(#tip)"/>`,
    `<text x="${(begin + end) / 2}" y="${below + 40}" text-anchor="middle">${escaped(words)}</text>`];
}

function row(flow, index, width) {
  const top = kTop + index * kRow;
  return [`<text x="${kMargin}" y="${top - 14}" class="head">${escaped(flow.head)}</text>`,
    `<text x="${width - kMargin}" y="${top - 14}" text-anchor="end">${escaped(flow.rate)}</text>`,
    ...flow.boxes.flatMap((each, i) => box(each, i, top, 'abc'[index % 3])), ...(flow.back ? back(flow.back, top) : [])];
}

export function drawing(source) {
  const { title, flows } = read(source);
  const width = left(Math.max(...flows.map((flow) => flow.boxes.length)) - 1) + kBox + kMargin;
  const height = kTop + (flows.length - 1) * kRow + kHeight + 62;
  return [`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img">`,
    `<title>${escaped(title)}</title>`, `<style>\n${style}\n</style>`,
    '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="6" markerHeight="6" orient="auto">',
    '<path d="M0 0L8 4L0 8z" class="tip"/></marker></defs>', `<rect width="${width}" height="${height}" rx="6" class="page"/>`,
    ...flows.flatMap((flow, index) => row(flow, index, width)), '</svg>', ''].join('\n');
}

if (process.argv[1]?.endsWith('picture_tool/flow.mjs')) {
  for (const path of process.argv.slice(2)) writeFileSync(path.replace(/\.txt$/, '.svg'), drawing(readFileSync(path, 'utf8')));
}
