// SPDX-License-Identifier: GPL-3.0-or-later
// Deviations with their goals, where the flight comes from, and the document's other tables.
import { make } from '../dom';
import type { Deviation, FlightDocument, Provenance, TableEntry } from '../document';

const kNames: Record<string, string> = {
  command: 'Flown by', mission: 'Mission', airplane: 'Airplane', board: 'Board', native: 'Natively compiled', seed: 'Seed', wind: 'Wind',
  faults: 'Faults injected', options: 'Options', firmware: 'Firmware', parameters: 'Parameters changed', date: 'Date', log: 'Log',
};

const number = (value: number): string => (Number.isInteger(value) ? value.toLocaleString('en') : String(+value.toPrecision(4)));
const isNumber = (cell: unknown): boolean => typeof cell === 'number' || /^[-−]?[\d,.]+$/.test(String(cell));

export function table(heads: string[], rows: (string | number | Node)[][], caption?: string): HTMLElement {
  const numeric = heads.map((_, i) => i > 0 && rows.length > 0 && rows.every((row) => row[i] === '' || isNumber(row[i])));
  return make('div', { class: 'wide' }, make('table', {},
    ...(caption ? [make('caption', {}, caption)] : []),
    make('thead', {}, make('tr', {}, ...heads.map((head, i) => make(head ? 'th' : 'td', { scope: head ? 'col' : undefined, class: numeric[i] ? 'n' : '' }, head)))),
    make('tbody', {}, ...rows.map((row) => make('tr', {}, ...row.map((cell, i) =>
      make('td', { class: numeric[i] ? 'n' : '' }, typeof cell === 'number' ? number(cell) : cell)))))));
}

export function deviations(all: Deviation[]): HTMLElement {
  const rows = all.map(({ name, value, unit, goal, met }) => [
    name, value, goal === undefined ? '' : goal === 0 ? '0' : `≤ ${number(goal)}`, unit,
    met === undefined ? '' : make('span', { class: met ? 'met' : 'missed' }, met ? '✓ met' : '✗ missed'),
  ]);
  return table(['figure', 'value', 'goal', 'unit', 'goal kept'], rows);
}

export const documentTable = ({ title, note, heads, rows }: TableEntry): Node[] => [make('h2', {}, title), table(heads, rows, note)];

function copied(command: string): HTMLElement {
  const button = make('button', { type: 'button' }, 'copy');
  button.addEventListener('click', () => void navigator.clipboard.writeText(command).then(
    () => { button.textContent = 'copied'; }, () => { button.textContent = 'not allowed'; }));
  return make('div', { class: 'command' }, make('code', {}, command), button);
}

function words(value: unknown): string {
  if (Array.isArray(value)) return value.length === 0 ? 'none' : value.map(words).join(', ');
  if (value !== null && typeof value === 'object')
    return Object.entries(value).filter(([, each]) => each !== null).map(([name, each]) => `${name.replaceAll('_', ' ')} ${words(each)}`).join(', ') || 'none';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return typeof value === 'number' ? number(value) : String(value);
}

export function provenance(document: FlightDocument): Node[] {
  const found: Provenance = document.provenance ?? {};
  const nodes: Node[] = [];
  if (typeof found.command === 'string') nodes.push(make('h2', {}, 'The same flight again'), copied(found.command));
  const names = [...new Set([...Object.keys(kNames), ...Object.keys(found)])].filter((name) => name in found && name !== 'command' && name !== 'parameters');
  nodes.push(make('h2', {}, 'Provenance'), table(['', ''], names.map((name) => [kNames[name] ?? name, words(found[name])])));
  const parameters = Object.entries((found.parameters ?? {}) as Record<string, number>);
  if (found.parameters !== undefined)
    nodes.push(make('h2', {}, document.kind === 'log' ? 'Parameters' : kNames.parameters), parameters.length === 0 ? make('p', { class: 'soft' }, 'none') : table(['parameter', 'value'], parameters));
  return nodes;
}
