// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a flight: from the document inside it, from a server, or from a file dropped onto it.
import { byId } from './dom';
import { parseDocument } from './document';
import { clear, show } from './page';
import { takeFiles } from './source/dropped';
import { connect } from './source/live';

function notice(words: string): void {
  const box = byId('notice');
  box.textContent = words;
  box.hidden = words === '';
}

function begin(): void {
  const source = document.querySelector<HTMLMetaElement>('meta[name=source]')?.content;
  if (source === 'live') return connect(notice);
  const text = byId('flight').textContent ?? '';
  if (text.trim() === '{}') return notice('Drop a log (.bin) here, or open one.');
  show(parseDocument(text));
}

try {
  takeFiles((found) => { clear(); notice(''); show(found); }, notice);
  begin();
} catch (error) {
  notice(error instanceof Error ? error.message : String(error));
  throw error;
}
