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
  max-width: 1160px; margin: 24px auto; padding: 0 24px; }
h1 { font-size: 22px; margin: 0 0 2px; } p { margin: 0 0 6px; color: var(--soft); }
.verdict { float: right; font-size: 18px; font-weight: 700; padding: 4px 12px; border: 2px solid; border-radius: 4px; }
.facts { display: grid; grid-template-columns: repeat(3, auto 1fr); gap: 2px 12px; margin: 14px 0; }
.facts dt { color: var(--soft); } .facts dd { margin: 0; font-weight: 600; }
.steps { columns: 2; column-gap: 24px; }
section { break-inside: avoid; margin-bottom: 10px; }
h2 { display: flex; gap: 8px; font-size: 13px; margin: 0; padding: 2px 6px; background: var(--band); border-top: 1px solid var(--soft); }
h2 span:nth-child(2) { flex: 1; }
tr { break-inside: avoid; }
table { border-collapse: collapse; width: 100%; table-layout: fixed; }
td { text-align: left; vertical-align: top; padding: 2px 6px; border-bottom: 1px solid var(--line); overflow-wrap: break-word; }
td.value { width: 36%; font-variant-numeric: tabular-nums; } td.limit { width: 19%; color: var(--soft); }
td.mark { white-space: nowrap; width: 84px; text-align: right; }
.pass { color: var(--pass); } .fail { color: var(--fail); } .open, .none { color: var(--soft); }
tr.is-fail td.value { color: var(--fail); font-weight: 600; }
.remark { padding: 2px 6px; font-style: italic; }
.sign { display: grid; grid-template-columns: 1fr 1fr 2fr; gap: 32px; margin-top: 44px; break-inside: avoid; }
.sign div { border-top: 1px solid var(--ink); padding-top: 4px; color: var(--soft); }
@page { size: A4; margin: 7mm; }
@media print { body { margin: 0; padding: 0; max-width: none; font-size: 5.9pt; line-height: 1.08; } h1 { font-size: 13pt; }
  section { break-inside: auto; } h2 { break-after: avoid; font-size: 6.5pt; padding: 0.5pt 3pt; } section { margin-bottom: 2pt; } .steps { column-gap: 10pt; } td { padding: 0.2pt 2pt; } td.limit { width: 25%; } td.value { width: 38%; }
  td.mark { width: 30pt; } .verdict { font-size: 11pt; } .facts { margin: 3pt 0; } .sign { margin-top: 16pt; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
@media screen and (max-width: 900px) { .steps { columns: 1; } .facts { grid-template-columns: auto 1fr; } }
`;

function partRow({ title, value, limit, verdict }) {
  return `<tr class="is-${kClass[verdict]}"><td>${escaped(title)}</td><td class="value">${escaped(value)}</td>` +
    `<td class="limit">${escaped(limit)}</td><td class="mark ${kClass[verdict]}">${escaped(verdict)}</td></tr>`;
}

function stepSection({ number, title }, result) {
  const verdict = result?.verdict ?? kNotDone;
  const rows = (result?.parts ?? []).map(partRow).join('\n');
  const remarks = (result?.remarks ?? []).map((text) => `<div class="remark">Remark: ${escaped(text)}</div>`).join('');
  return `<section><h2><span>${number}</span><span>${escaped(title)}</span><span class="${kClass[verdict]}">${escaped(verdict)}</span></h2>\n` +
    `${rows ? `<table>\n${rows}\n</table>` : ''}${remarks}</section>`;
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
<title>Bench form ${escaped(state.name)}</title><style>${style}</style></head><body><main>
<div class="verdict ${kClass[verdict]}">${words[verdict]}</div>
<h1>Bench form of an autopilot board</h1>
<dl class="facts">${facts(state, board)}</dl>
<p>Of each part: what was measured, its limit, the verdict.</p>
<div class="steps">
${kSteps.map((step) => stepSection(step, state.steps[step.number])).join('\n')}
</div>
<div class="sign"><div>date</div><div>name</div><div>signature</div></div>
</main></body></html>
`;
}
