// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the views of a flight onto the page.
import { byId } from './dom';
import { Flight } from './flight';
import type { FlightDocument } from './document';
import { View } from './view';
import type * as AttitudeView from './view/attitude';
import { Hud } from './view/hud';
import { FlightMap } from './view/map';
import { Messages } from './view/messages';
import { Playback } from './view/playback';
import { Plots } from './view/plots';
import { deviations, documentTable, provenance } from './view/tables';
import { Tabs } from './view/tabs';

export interface Page { flight: Flight; view: View; map: FlightMap; plots: Plots; messages: Messages; playback: Playback }

const kAttitudeAfter_ms = 150;
const kBegin = 1 / 3;  // of the flight: there the airplane is in the air

function head({ title, verdict, kind }: FlightDocument): void {
  document.title = title;
  byId('title').textContent = { simulated: 'Simulated flight', log: 'Flight log', live: 'Live flight' }[kind];
  byId('subtitle').textContent = title;
  const chip = byId('verdict');
  chip.hidden = !verdict;
  if (!verdict) return;
  chip.textContent = verdict.text;
  chip.className = `chip${verdict.good ? '' : ' bad'}`;
}

function tabs(flight: Flight, view: View): Plots {
  const all = new Tabs(), { document: found } = flight;
  const plots = new Plots(flight, view, all.add('plots', 'Plots'));
  if (found.deviations?.length) all.add('deviations', 'Deviations', deviations(found.deviations));
  if (found.provenance) all.add('provenance', 'Provenance', ...provenance(found));
  if (found.tables?.length) all.add('tables', 'Tables', ...found.tables.flatMap(documentTable));
  return plots;
}

// In a script of its own, see web/build.mjs.
declare function unpack(id: string): Promise<void>;
declare const attitudeView: typeof AttitudeView | undefined;

async function attitude(flight: Flight, view: View): Promise<void> {
  try {
    if (typeof attitudeView === 'undefined') await unpack('attitude-code');
    new attitudeView!.Attitude(flight, view);
  } catch {
    byId('attitude').hidden = true;
    byId('attitude-box').style.gridTemplate = '1fr / 1fr';
  }
}

// WebGL takes its time to begin: when all else is there and can be used.
function attitudeLater(flight: Flight, view: View): void {
  const soon = (): void => {
    performance.mark('shown');
    setTimeout(() => void attitude(flight, view), kAttitudeAfter_ms);
  };
  requestAnimationFrame(() => setTimeout(soon));
}

export function show(found: FlightDocument): Page {
  const flight = new Flight(found);
  const view = new View(flight.from_s, flight.to_s);
  view.live = found.kind === 'live';
  view.time_s += (view.to_s - view.from_s) * kBegin;
  head(found);
  const plots = tabs(flight, view);  // what asks for no layout comes first
  const messages = new Messages(flight, view);
  const playback = new Playback(flight, view);
  new Hud(flight, view);
  const map = new FlightMap(flight, view);
  attitudeLater(flight, view);
  return { flight, view, map, plots, messages, playback };
}

export function clear(): void {
  for (const id of ['filters', 'message-list', 'tabs', 'panes', 'playback', 'map-legend', 'wind']) byId(id).replaceChildren();
  for (const id of ['map', 'hud', 'attitude']) {  // what held on to them goes with the elements
    const old = byId(id);
    old.replaceWith(Object.assign(old.cloneNode(false), { className: '' }));
  }
}
