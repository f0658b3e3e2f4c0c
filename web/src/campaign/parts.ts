// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages of campaigns have in common.
import { make } from '../dom';

export const percent = (met: number, all: number): string => `${all === 0 ? 0 : Math.floor(100 * met / all)} %`;

export function tile(value: string, label: string, about: string): HTMLElement {
  return make('div', { class: 'tile' }, make('b', {}, value), make('span', {}, label), make('span', { class: 'soft' }, about));
}

export function bar(met: number, all: number): HTMLElement {
  const fill = make('i');
  fill.style.width = `${all === 0 ? 0 : 100 * met / all}%`;
  return make('div', { class: 'share' }, make('span', { class: 'track' }, fill), make('b', {}, percent(met, all)));
}

export const reportLink = (report: string | undefined, of: string): Node | string =>
  (report ? make('a', { href: report, 'aria-label': `report of ${of}` }, 'report') : '');

export const scrolling = (label: string, content: HTMLElement, tall = false): HTMLElement =>
  make('div', { class: `scroll${tall ? ' tall' : ''}`, tabindex: 0, role: 'region', 'aria-label': label }, content);

export const box = (title: string, ...content: (Node | string)[]): HTMLElement =>
  make('section', { class: 'box' }, make('h2', {}, title), ...content);
