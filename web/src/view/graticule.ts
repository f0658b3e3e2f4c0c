// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of round latitudes and longitudes, which the map has where there are no tiles.
import * as L from 'leaflet';
import { colour } from '../dom';

const kSteps = [10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001];
const kApart = 90;  // pixels, at least

export const step = (degreesPerPixel: number): number =>
  kSteps.findLast((each) => each / degreesPerPixel >= kApart) ?? kSteps[0];

function label(degrees: number, names: string, by: number): string {
  const decimals = Math.max(0, -Math.floor(Math.log10(by) + 1e-9));
  return `${Math.abs(degrees).toFixed(decimals)}° ${degrees < 0 ? names[1] : names[0]}`;
}

export class Graticule extends L.Layer {
  private canvas = L.DomUtil.create('canvas', 'leaflet-zoom-hide');
  private readonly redraw = (): void => this.draw();
  private shown = L.latLngBounds([0, 0], [0, 0]);

  override onAdd(map: L.Map): this {
    map.getPane('tilePane')?.append(this.canvas);
    map.on('moveend resize zoomend', this.redraw);
    this.draw();
    return this;
  }
  override onRemove(map: L.Map): this {
    this.canvas.remove();
    map.off('moveend resize zoomend', this.redraw);
    return this;
  }
  draw(): void {
    const map = this._map as L.Map | undefined;
    if (!map) return;
    const size = map.getSize(), ratio = devicePixelRatio || 1;
    this.shown = map.getBounds();
    L.DomUtil.setPosition(this.canvas, map.containerPointToLayerPoint([0, 0]));
    Object.assign(this.canvas, { width: size.x * ratio, height: size.y * ratio });
    Object.assign(this.canvas.style, { width: `${size.x}px`, height: `${size.y}px` });
    const context = this.canvas.getContext('2d') as CanvasRenderingContext2D;
    context.scale(ratio, ratio);
    context.strokeStyle = colour('map-line');
    context.fillStyle = colour('map-ink');
    context.font = '11px system-ui, sans-serif';
    this.lines(context, map, size, true);
    this.lines(context, map, size, false);
  }
  private lines(context: CanvasRenderingContext2D, map: L.Map, size: L.Point, upright: boolean): void {
    const [from, to] = upright ? [this.shown.getWest(), this.shown.getEast()] : [this.shown.getSouth(), this.shown.getNorth()];
    const by = step((to - from) / (upright ? size.x : size.y));
    for (let i = Math.ceil(from / by); i * by <= to; ++i) {
      const at = map.latLngToContainerPoint(upright ? [this.shown.getNorth(), i * by] : [i * by, this.shown.getWest()]);
      const place = Math.round(upright ? at.x : at.y) + 0.5;
      context.beginPath();
      if (upright) context.moveTo(place, 0);
      else context.moveTo(0, place);
      context.lineTo(upright ? place : size.x, upright ? size.y : place);
      context.stroke();
      if (upright) context.fillText(label(i * by, 'EW', by), place + 3, size.y - 4);
      else if (place > 90) context.fillText(label(i * by, 'NS', by), 4, place - 3);
    }
  }
}
