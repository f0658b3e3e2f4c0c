// SPDX-License-Identifier: GPL-3.0-or-later
// Draws docs/wiring/NAME.svg of NAME.txt: a board in the middle, its sockets, and what goes there.
//   node toolchain/picture_tool/wiring.mjs docs/wiring/NAME.txt...
import { readFileSync, writeFileSync } from 'node:fs';

const kWidth = 1120, kBoardLeft = 400, kBoardWidth = 320, kRow = 44, kTop = 76, kBox = 36, kMargin = 16, kDeviceWidth = 330;
const kKinds = { power: 'supply', signal: 'pulses', serial: 'serial', bus: 'I2C', analog: 'voltage' };
const kLetters = 46;  // of a device's line

const style = `:root{--page:#fff;--ink:#1c2430;--soft:#5b6776;--box:#f1f4f8;--line:#b9c2cd}
@media(prefers-color-scheme:dark){:root{--page:#14181e;--ink:#e8ecf2;--soft:#9aa6b5;--box:#222932;--line:#475262}}
text{font-family:system-ui,"DejaVu Sans",sans-serif;font-size:13px;fill:var(--ink)}
.title{font-size:18px;font-weight:600}.board{font-size:15px;font-weight:600}.key{font-size:12px;fill:var(--soft)}
rect{fill:var(--box);stroke:var(--line)}.page{fill:var(--page);stroke:none}
path{fill:none;stroke-width:3}.power{stroke:#d1495b}.signal{stroke:#2e86de}.serial{stroke:#2a9d5c}.bus{stroke:#9b5de5}.analog{stroke:#e08e1a}`;

export const escaped = (text) => text.replace(/[<>&"]/g, (c) => `&#${c.charCodeAt(0)};`);
const text = (x, y, words, kind, anchor = 'start') => `<text x="${x}" y="${y}" class="${kind}" text-anchor="${anchor}">${escaped(words)}</text>`;

// { title, board, left, right } of the lines; a wrong one is an error with its number.
export function read(source) {
  const found = { left: [], right: [] };
  for (const [index, line] of source.split('\n').entries()) {
    if (line === '' || line.startsWith('#')) continue;
    const [, name, value] = /^(title|board): (.+)$/.exec(line) ?? [];
    const [, side, socket, device, kind] = /^(left|right) \| ([^|]+) \| ([^|]+) \| (\w+)$/.exec(line) ?? [];
    if (name) found[name] = value;
    else if (side && kind in kKinds) found[side].push({ socket, device, kind });
    else throw new Error(`line ${index + 1}: expected "title: ", "board: " or "left | socket | device | ${Object.keys(kKinds).join('/')}"`);
  }
  if (!found.title || !found.board) throw new Error('there is no title or no board');
  return found;
}

// In at most two lines.
function folded(words) {
  if (words.length <= kLetters) return [words];
  const at = words.lastIndexOf(' ', kLetters);
  return [words.slice(0, at), words.slice(at + 1)];
}

function row({ socket, device, kind }, index, side) {
  const y = kTop + index * kRow + kRow / 2;
  const left = side === 'left';
  const device_x = left ? kMargin : kWidth - kMargin - kDeviceWidth;
  const [from, to] = left ? [device_x + kDeviceWidth, kBoardLeft] : [kBoardLeft + kBoardWidth, device_x];
  const lines = folded(device);
  return [`<path class="${kind}" d="M${from} ${y}H${to}"/>`,
    `<rect x="${device_x}" y="${y - kBox / 2}" width="${kDeviceWidth}" height="${kBox}" rx="5"/>`,
    ...lines.map((line, i) => text(device_x + 9, y + (lines.length === 1 ? 5 : i * 15 - 3), line, '')),
    text(left ? kBoardLeft + 10 : kBoardLeft + kBoardWidth - 10, y + 5, socket, '', left ? 'start' : 'end')].join('\n');
}

function key(y) {
  return Object.entries(kKinds).map(([kind, name], i) =>
    `<path class="${kind}" d="M${kMargin + i * 110} ${y}h26"/>\n${text(kMargin + 34 + i * 110, y + 4, name, 'key')}`).join('\n');
}

export function drawing(source) {
  const { title, board, left, right } = read(source);
  const rows = Math.max(left.length, right.length), bottom = kTop + rows * kRow;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${kWidth} ${bottom + 50}" width="${kWidth}" height="${bottom + 50}" role="img">
<title>Wiring: ${escaped(title)}</title>
<style>
${style}
</style>
<rect class="page" width="${kWidth}" height="${bottom + 50}"/>
${text(kMargin, 32, title, 'title')}
<rect x="${kBoardLeft}" y="${kTop - 32}" width="${kBoardWidth}" height="${bottom - kTop + 40}" rx="8"/>
${text(kBoardLeft + kBoardWidth / 2, kTop - 10, board, 'board', 'middle')}
${left.map((each, i) => row(each, i, 'left')).join('\n')}
${right.map((each, i) => row(each, i, 'right')).join('\n')}
${key(bottom + 30)}
</svg>
`;
}

if (process.argv[1]?.endsWith('picture_tool/wiring.mjs')) {
  for (const path of process.argv.slice(2)) {
    const source = readFileSync(path, 'utf8');
    writeFileSync(path.replace(/\.txt$/, '.svg'), drawing(source));
  }
}
