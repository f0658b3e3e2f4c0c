// SPDX-License-Identifier: GPL-3.0-or-later
// Modes, failsafes and faults as bands behind a plot or a timeline.
import { colour } from '../dom';
import type { Flight } from '../flight';
import { modeColour } from './colours';

type Place = (time_s: number) => number;  // in pixels

// A strip of modes, `height` pixels high; with names where there is room.
export function drawModes(context: CanvasRenderingContext2D, flight: Flight, x: Place, top: number, height: number, right: number, names: boolean): void {
  for (const band of flight.bands) {
    if (band.kind !== 'mode') continue;
    const [from, to] = [Math.max(x(band.from_s), 0), Math.min(x(band.to_s ?? flight.to_s), right)];
    if (to <= from) continue;
    context.fillStyle = modeColour(band.name);
    context.globalAlpha = names ? 0.8 : 0.55;
    context.fillRect(from, top, to - from, height);
    context.globalAlpha = 1;
    if (names && to - from > context.measureText(band.name).width + 8) {
      context.fillStyle = colour('panel');
      context.fillText(band.name, from + 4, top + height - 3);
    }
  }
}

export function drawTroubles(context: CanvasRenderingContext2D, flight: Flight, x: Place, top: number, height: number): void {
  for (const band of flight.bands) {
    if (band.kind === 'mode') continue;
    const [from, to] = [x(band.from_s), x(band.to_s ?? flight.to_s)];
    context.fillStyle = colour(band.kind);
    context.globalAlpha = 0.16;
    context.fillRect(from, top, Math.max(to - from, 2), height);
    context.globalAlpha = 1;
  }
}
