// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a self-test: its program onto the board, the report, the firmware back, the table.
import { kPass } from '../bench_tool/limits.mjs';
import { boards } from '../flash_tool/boards.mjs';
import { Refusal } from '../flash_tool/refusal.mjs';
import { verdicts } from './parts.mjs';
import { Report } from './report.mjs';

const kSilent_ms = 20_000;  // its longest part takes 11 s
const kLongest_ms = 180_000;  // some 30 s; a simulator on a busy computer is slower
const kLook_ms = 50;

const lastOf = ({ last }) => `its last line was "${last}"`;

// Why a board that speaks does not come to the end of its report.
function whyEndless(report) {
  if (report.begins === 0) return 'what comes is no report of the self-test: is another program on the board?';
  const again = report.begins > 2 ? `the board began ${report.begins} times: something resets it; ` : '';
  return `${again}${lastOf(report)}`;
}

// Until the report has ended. Throws a Refusal when it does not.
export async function readReport(port, { now_ms, sleep, stopped = () => false }) {
  const report = new Report();
  const begin_ms = now_ms();
  let heard_ms = begin_ms;
  port.onBytes((bytes) => {
    heard_ms = now_ms();
    report.take(bytes, heard_ms);
  });
  while (!report.ended) {
    if (stopped()) throw new Refusal('interrupted', 1);
    if (now_ms() - heard_ms > kSilent_ms)
      throw new Refusal(`the board says nothing for ${kSilent_ms / 1000} s; ` +
        (report.last === undefined ? 'nothing came at all' : lastOf(report)), 1);
    if (now_ms() - begin_ms > kLongest_ms)
      throw new Refusal(`the report has no end within ${kLongest_ms / 1000} s; ${whyEndless(report)}`, 1);
    await sleep(kLook_ms);
  }
  return report;
}

export function table(results, report) {
  const wide = (key) => Math.max(...results.map((each) => each[key].length));
  const [title, measured] = [wide('title'), wide('measured')];
  const rows = results.flatMap(({ title: name, measured: value, limit, verdict, failed }) => [
    `${verdict.padEnd(7)}  ${name.padEnd(title)}  ${value.padEnd(measured)}  ${limit.text}: ${limit.why}`,
    ...(verdict === kPass || !failed ? [] : [`         ${failed}`])]);
  return [...rows, ...report.unknown.map((line) => `         not understood: ${line}`)];
}

// `device`: flashes 'self_test' or 'firmware', opens the port; `flashes` is false for TCP.
// Gives { passed, results, report }.
export async function selfTest({ board, device, clock, print }) {
  let report, problem;
  try {
    if (device.flashes) await device.flash('self_test');
    const port = await device.open();
    try {
      report = await readReport(port, clock);
    } finally {
      port.close();
    }
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    problem = error;
  } finally {
    if (device.flashes) await restore(device, print, problem);
  }
  if (problem) throw problem;
  const wanted = boards[board].name;
  const results = verdicts(report);
  if (report.board !== wanted) print(wrongBoard(report.board, wanted));
  const passed = report.board === wanted && report.unknown.length === 0 && results.every(({ verdict }) => verdict === kPass);
  return { passed, results, report };
}

const wrongBoard = (found, wanted) => (found === undefined
  ? 'The beginning of the report is missing: nothing of this counts. Start the board after the tool, or reset it.'
  : `The program on the board is that of an ${found}, not of an ${wanted}: nothing of this counts.`);

async function restore(device, print, problem) {
  try {
    await device.flash('firmware');
  } catch (error) {
    print(`THE BOARD DOES NOT HAVE ITS FIRMWARE: ${error.message}`);
    print(`Write it with: ${device.command}`);
    throw new Refusal(`${problem ? `${problem.message}; and ` : ''}the firmware could not be written back`, 1);
  }
}
