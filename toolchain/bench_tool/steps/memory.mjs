// SPDX-License-Identifier: GPL-3.0-or-later
// Step 14: the DataFlash. Logs are written while disarmed, by a bit of LOG_BITMASK that is restored.
import { NotDone, NotMeasured } from '../errors.mjs';
import { within } from '../limits.mjs';
import { longestGap_s, readLog } from '../log_file.mjs';
import { restart } from './readings.mjs';

const kWhileDisarmed = 65536, kLog_ms = 120_000, kSilent_ms = 2500, kChunk = 90, kCuts = 5, kBeforeCut_ms = 5000;
const kAll = 0xffffffff;

async function logs(board) {
  const entries = new Map();
  let last, none = false;
  const listener = ({ name, data }) => {
    if (name !== 'LOG_ENTRY') return;
    none ||= data.numLogs === 0;
    entries.set(data.id, data);
    last = data.lastLogNum;
  };
  return board.listening(listener, async () => {
    for (let tries = 0; tries < 3 && !none && !entries.has(last); ++tries) {
      board.send('LOG_REQUEST_LIST', { start: 0, end: 0xffff });
      await board.until(() => none || entries.has(last), kSilent_ms);
    }
    if (none) return [];
    if (entries.size === 0) throw new NotMeasured('the board lists no logs');
    return [...entries.values()].sort((a, b) => a.id - b.id);
  });
}

// All of a log; what gets lost on the way is asked for again.
async function download(board, { id, size }, print) {
  const bytes = Buffer.alloc(size);
  const parts = new Set();
  let heard_ms = board.now_ms();
  const listener = ({ name, data, at_ms }) => {
    if (name !== 'LOG_DATA' || data.id !== id || data.ofs + data.count > size) return;
    Buffer.from(data.data.slice(0, data.count)).copy(bytes, data.ofs);
    parts.add(data.ofs / kChunk);
    heard_ms = at_ms;
  };
  const count = Math.ceil(size / kChunk);
  const missing = () => { for (let i = 0; i < count; ++i) if (!parts.has(i)) return i; return count; };
  print(`  reading log ${id}, ${(size / 1024).toFixed(0)} KiB`);
  await board.listening(listener, async () => {
    for (let tries = 0; tries < 50 && missing() < count; ++tries) {
      const from = missing() * kChunk;
      board.send('LOG_REQUEST_DATA', { id, ofs: from, count: tries === 0 ? kAll : 20 * kChunk });
      heard_ms = board.now_ms();
      await board.until(() => missing() === count || board.now_ms() - heard_ms > kSilent_ms, 600_000);
    }
  });
  board.send('LOG_REQUEST_END');
  if (missing() < count) throw new NotMeasured(`log ${id} could not be read whole: ${parts.size} of ${count} parts`);
  return bytes;
}

async function newest(b) {
  const entry = (await logs(b.board)).at(-1);
  if (!entry) throw new NotMeasured('there is no log');
  return readLog(await download(b.board, entry, b.print));
}
async function logging(b, on) {
  const mask = b.safety.restore.LOG_BITMASK ?? await b.board.parameter('LOG_BITMASK');
  if (on) await b.safety.change('LOG_BITMASK', mask | kWhileDisarmed);
  else await b.safety.putBack();
}

// The log that the cut has ended; the one that was begun after it is short.
const reachesTheCut = ({ times_s }) => times_s.length > 0 && times_s.at(-1) - times_s[0] > (kBeforeCut_ms - 2000) / 1000;

export const memory = {
  number: 14, title: 'Log memory', tools: 'a switch in the supply',
  failed: 'A worn or badly soldered DataFlash: the board flies with LOG_BITMASK 0 only, and without a record.',
  parts: [
    { id: '14.gaps', title: 'longest gap in two minutes of log',
      limit: within({ high: 0.25, unit: 's', digits: 2, why: 'attitudes are logged ten times a second (docs/log.md)' }),
      measure: async (b) => {
        await b.person.action(b.id, 'Leave the board alone for two minutes of logging and as long for reading.');
        await logging(b, true);
        await b.board.wait(kLog_ms);
        await logging(b, false);
        await b.board.wait(1500);
        const log = await newest(b);
        const [first_s, last_s] = [log.times_s[0] ?? 0, log.times_s.at(-1) ?? 0];
        return { value: longestGap_s(log.times_s), ok: log.bad_at === undefined && log.dropped === 0 && last_s - first_s > 0.95 * kLog_ms / 1000,
          note: `${log.records} records, ${(last_s - first_s).toFixed(0)} s, ${log.dropped} dropped` +
            `${log.bad_at === undefined ? '' : `, unreadable from byte ${log.bad_at}`}` };
      } },
    { id: '14.cuts', title: 'readable logs after five cuts of the supply while writing',
      limit: within({ low: kCuts, high: kCuts, unit: 'logs', digits: 0, why: 'each page has a checksum: what was written before the cut stays' }),
      measure: async (b) => {
        let good = 0;
        const notes = [];
        for (let i = 1; i <= kCuts; ++i) {
          await logging(b, true);
          await b.board.wait(kBeforeCut_ms);
          await restart(b, () => b.person.action(b.id, `Cut ${i} of ${kCuts}: press Enter, then cut the supply for a second.`)).catch((error) => {
            throw error instanceof NotDone ? new NotDone(`${i - 1} of ${kCuts} cuts were made`) : error;
          });
          await logging(b, false);
          await b.board.wait(1500);
          const entries = await logs(b.board);
          const whole = [];
          for (const entry of entries.slice(-2)) whole.push(readLog(await download(b.board, entry, b.print)));
          if (whole.every(({ bad_at }) => bad_at === undefined) && whole.some(reachesTheCut)) ++good;
          notes.push(whole.map(({ records }) => records).join('+'));
        }
        return { value: good, note: `records: ${notes.join(', ')}` };
      } },
  ],
};
