// SPDX-License-Identifier: GPL-3.0-or-later
// Panes behind tabs, with the arrow keys as every tab list has them.
import { byId, make } from '../dom';

export class Tabs {
  private readonly tabs: { tab: HTMLButtonElement; pane: HTMLElement }[] = [];

  add(id: string, title: string, ...content: Node[]): HTMLElement {
    const pane = make('div', { class: 'pane', id: `pane-${id}`, role: 'tabpanel', 'aria-labelledby': `tab-${id}`, tabindex: 0 }, ...content);
    const tab = make('button', { id: `tab-${id}`, type: 'button', role: 'tab', 'aria-controls': `pane-${id}` }, title);
    tab.addEventListener('click', () => this.choose(tab));
    tab.addEventListener('keydown', (event) => this.key(event, tab));
    this.tabs.push({ tab, pane });
    byId('tabs').append(tab);
    byId('panes').append(pane);
    if (this.tabs.length === 1) this.choose(tab);
    else this.choose(this.tabs[0].tab);
    return pane;
  }
  private key(event: KeyboardEvent, tab: HTMLElement): void {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    const at = this.tabs.findIndex((each) => each.tab === tab);
    const next = this.tabs[(at + by + this.tabs.length) % this.tabs.length].tab;
    this.choose(next);
    next.focus();
    event.preventDefault();
  }
  private choose(chosen: HTMLButtonElement): void {
    for (const { tab, pane } of this.tabs) {
      const on = tab === chosen;
      tab.setAttribute('aria-selected', String(on));
      tab.tabIndex = on ? 0 : -1;
      pane.hidden = !on;
    }
  }
}
