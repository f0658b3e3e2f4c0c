// SPDX-License-Identifier: GPL-3.0-or-later
// The form to sign: one page of HTML that prints on A4.
import { kFail, kNotDone, kPass } from './limits.mjs';
import { kSteps } from './steps/table.mjs';

const escaped = (text) => String(text).replace(/[<>&"]/g, (c) => `&#${c.charCodeAt(0)};`);
const kClass = { [kPass]: 'pass', [kFail]: 'fail', [kNotDone]: 'open', 'not fitted': 'none' };

const style = `
:root { --ink: #1a1a1a; --soft: #666; --line: #c8c8c8; --pass: #176b2c; --fail: #b00020; --page: #fff; --band: #f3f4f6; }
* { box-sizing: border-box; }
body { font: 13px/1.35 system-ui, "Liberation Sans", Arial, sans-serif; color: var(--ink); background: var(--page);
  max-width: 1000px; margin: 24px auto; padding: 0 24px; }
h1 { font-size: 22px; margin: 0 0 2px; }
.verdict { float: right; font-size: 18px; font-weight: 700; padding: 4px 12px; border: 2px solid; border-radius: 4px; }
.facts { display: grid; grid-template-columns: repeat(3, auto 1fr); gap: 2px 12px; margin: 14px 0; }
.facts dt { color: var(--soft); } .facts dd { margin: 0; font-weight: 600; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 3px 8px; border-bottom: 1px solid var(--line); overflow-wrap: anywhere; }
thead th { color: var(--soft); font-weight: 600; }
tr.step th, tr.step td { background: var(--band); border-top: 1px solid var(--soft); font-weight: 700; }
tr { break-inside: avoid; } tr.step { break-after: avoid; }
td.value { font-variant-numeric: tabular-nums; } td.limit { color: var(--soft); }
td.mark, th.mark { white-space: nowrap; width: 1%; }
.pass { color: var(--pass); } .fail { color: var(--fail); } .open, .none { color: var(--soft); }
tr.fail td.value { color: var(--fail); font-weight: 600; }
.sign { display: grid; grid-template-columns: 1fr 1fr 2fr; gap: 32px; margin-top: 44px; break-inside: avoid; }
.sign div { border-top: 1px solid var(--ink); padding-top: 4px; color: var(--soft); }
@page { size: A4; margin: 12mm; }
@media print { body { margin: 0; padding: 0; max-width: none; font-size: 8.5pt; } th, td { padding: 1.5pt 4pt; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
@media (max-width: 700px) { .facts { grid-template-columns: auto 1fr; } td.limit, th.limit { display: none; } }
`;

const mark = (verdict) => `<td class="mark ${kClass[verdict]}">${escaped(verdict)}</td>`;

function partRow({ title, value, limit, verdict }) {
  return `<tr class="${kClass[verdict]}"><td></td><td>${escaped(title)}</td><td class="value">${escaped(value)}</td>` +
    `<td class="limit">${escaped(limit)}</td>${mark(verdict)}</tr>`;
}

function stepRows({ number, title }, result) {
  const verdict = result?.verdict ?? kNotDone;
  const at = result ? result.at.slice(0, 16).replace('T', ' ') : '';
  const head = `<tr class="step"><th>${number}</th><td>${escaped(title)}</td><td colspan="2">${escaped(at)}</td>${mark(verdict)}</tr>`;
  const remarks = (result?.remarks ?? []).map((text) => `<tr><td></td><td colspan="4">Remark: ${escaped(text)}</td></tr>`);
  return [head, ...(result?.parts ?? []).map(partRow), ...remarks].join('\n');
}

// Of all steps: failed when one has, passed when all have.
export function verdictOfAll(state) {
  const verdicts = kSteps.map(({ number }) => state.steps[number]?.verdict ?? kNotDone);
  if (verdicts.includes(kFail)) return kFail;
  return verdicts.every((verdict) => verdict === kPass) ? kPass : kNotDone;
}

function facts(state, board) {
  const passed = kSteps.filter(({ number }) => state.steps[number]?.verdict === kPass).length;
  const rows = [['board', state.name], ['kind', board === 'apm1' ? 'APM 1' : 'APM 2'], ['port', state.port ?? ''],
    ['firmware', state.firmware ?? ''], ['tool\'s commit', state.commit ?? ''], ['date (UTC)', state.date ?? ''],
    ['steps passed', `${passed} of ${kSteps.length}`]];
  return rows.map(([name, value]) => `<dt>${name}</dt><dd>${escaped(value)}</dd>`).join('');
}

export function formOf(state, board) {
  const verdict = verdictOfAll(state);
  const words = { [kPass]: 'passed', [kFail]: 'failed', [kNotDone]: 'not complete' };
  return `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Bench form ${escaped(state.name)}</title><style>${style}</style></head><body>
<div class="verdict ${kClass[verdict]}">${words[verdict]}</div>
<h1>Bench form of an autopilot board</h1>
<dl class="facts">${facts(state, board)}</dl>
<table><thead><tr><th></th><th>what</th><th>measured</th><th class="limit">limit</th><th class="mark">verdict</th></tr></thead><tbody>
${kSteps.map((step) => stepRows(step, state.steps[step.number])).join('\n')}
</tbody></table>
<div class="sign"><div>date</div><div>name</div><div>signature</div></div>
</body></html>
`;
}
