// SPDX-License-Identifier: GPL-3.0-or-later
// Where avr-gcc saves and takes back registers by its library's routines (-mcall-prologues), which
// costs some 30 cycles a call, a function that is called often does so itself.
const kSaved = [...Array.from({ length: 16 }, (_, i) => i + 2), 28, 29];  // as the routines do

const kPrologue = /^ldi r26,(?:lo8\()?(\d+)\)?\nldi r27,0\nldi r30,lo8\(gs\(1f\)\)\nldi r31,hi8\(gs\(1f\)\)\njmp __prologue_saves__\+\(\(18 - (\d+)\) \* 2\)\n1:$/;
const kEpilogue = /^(?:adiw r28,(\d+)|in r28,__SP_L__\nin r29,__SP_H__)\nldi r30, lo8\((\d+)\)\njmp __epilogue_restores__ \+ \(\(18 - (\d+)\) \* 2\)$/;
const kMostFrame = 63;  // bytes that one instruction takes off

const setStack = ['in __tmp_reg__,__SREG__', 'cli', 'out __SP_H__,r29', 'out __SREG__,__tmp_reg__', 'out __SP_L__,r28'];

// Places of the lines that match, `count` of them up to the one that contains `last`.
function find(lines, last, patterns) {
  const found = [];
  lines.forEach((line, at) => {
    if (!line.includes(last)) return;
    for (const { pattern, count, after } of patterns) {
      const from = at - count + 1;
      const match = pattern.exec(lines.slice(Math.max(from, 0), at + 1 + after).map((text) => text.trim()).join('\n'));
      if (match) return void found.push({ from, to: at + 1 + after, match });
    }
    found.push(undefined);
  });
  return found;
}

// The lines of one function; as they are when they are not of the forms above.
function inPlace(lines) {
  const prologues = find(lines, '__prologue_saves__', [{ pattern: kPrologue, count: 5, after: 1 }]);
  const epilogues = find(lines, '__epilogue_restores__', [{ pattern: kEpilogue, count: 3, after: 0 }, { pattern: kEpilogue, count: 4, after: 0 }]);
  if (prologues.length !== 1 || epilogues.length === 0 || [...prologues, ...epilogues].includes(undefined)) return lines;
  const frame = Number(prologues[0].match[1]), count = Number(prologues[0].match[2]);
  if (frame > kMostFrame || epilogues.some(({ match }) => Number(match[1] ?? 0) !== frame || Number(match[3]) !== count)) return lines;
  const places = [...prologues, ...epilogues];
  const body = lines.filter((_, at) => !places.some(({ from, to }) => at >= from && at < to)).join('\n');
  const usesY = frame > 0 || /\br2[89]\b|\bY\b/.test(body);
  const saved = kSaved.slice(-count).filter((register) => register < 28 || usesY);
  const begins = [...saved.map((register) => `push r${register}`),
    ...(frame > 0 ? ['in r28,__SP_L__', 'in r29,__SP_H__', `sbiw r28,${frame}`, ...setStack] : [])];
  const ends = [...(frame > 0 ? [`adiw r28,${frame}`, ...setStack] : []),
    ...[...saved].reverse().map((register) => `pop r${register}`), 'ret'];
  return lines.flatMap((line, at) => {
    const place = places.find(({ from, to }) => at >= from && at < to);
    if (!place) return [line];
    if (at !== place.from) return [];
    return (place === prologues[0] ? begins : ends).map((text) => `\t${text}`);
  });
}

// `saves(name)` of a function: true where it shall.
export function saveInPlace(lines, saves) {
  const whole = [];
  for (let at = 0; at < lines.length;) {
    const name = /^([A-Za-z_][\w$.]*):$/.exec(lines[at])?.[1];
    const end = name && saves(name) ? lines.findIndex((line, i) => i > at && line.startsWith(`\t.size\t${name}, `)) : -1;
    whole.push(...(end < 0 ? [lines[at]] : [lines[at], ...inPlace(lines.slice(at + 1, end))]));
    at = end < 0 ? at + 1 : end;
  }
  return whole;
}
