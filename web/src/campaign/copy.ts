// SPDX-License-Identifier: GPL-3.0-or-later
import { make } from '../dom';

export function copyButton(command: string): HTMLElement {
  const button = make('button', { type: 'button', title: command, 'aria-label': `copy: ${command}` }, 'copy');
  button.addEventListener('click', () => void navigator.clipboard.writeText(command).then(
    () => { button.textContent = 'copied'; }, () => { button.textContent = 'not allowed'; }));
  return button;
}

export const again = (command: string): HTMLElement =>
  make('div', { class: 'again' }, copyButton(command), make('code', { tabindex: 0 }, command));
