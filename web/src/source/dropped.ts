// SPDX-License-Identifier: GPL-3.0-or-later
// A log that is dropped onto the page or chosen in its dialog; it is read here and goes nowhere.
import { byId } from '../dom';
import { parseDocument } from '../document';
import type { FlightDocument } from '../document';
import { logDocument } from './log_document';

const kMax_bytes = 256 << 20;

async function read(file: File): Promise<FlightDocument> {
  if (file.size > kMax_bytes) throw new Error(`${file.name} is larger than 256 MB`);
  if (file.name.toLowerCase().endsWith('.json')) return parseDocument(await file.text());
  return logDocument(await file.arrayBuffer(), file.name);
}

export function takeFiles(show: (found: FlightDocument) => void, notice: (words: string) => void): void {
  const take = async (file: File | undefined): Promise<void> => {
    if (!file) return;
    try {
      show(await read(file));
    } catch (error) {
      notice(`${file.name}: ${error instanceof Error ? error.message : String(error)}`);
    }
  };
  const input = byId<HTMLInputElement>('file'), cover = byId('drop');
  input.addEventListener('change', () => void take(input.files?.[0]));
  addEventListener('dragover', (event) => { event.preventDefault(); cover.hidden = false; });
  addEventListener('dragleave', (event) => { if (!event.relatedTarget) cover.hidden = true; });
  addEventListener('drop', (event) => {
    event.preventDefault();
    cover.hidden = true;
    void take(event.dataTransfer?.files[0]);
  });
}
