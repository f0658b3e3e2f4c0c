// SPDX-License-Identifier: GPL-3.0-or-later
// The map: planned legs, items by name, fence, rally points, the flown track, the airplane.
import * as L from 'leaflet';
import { byId, colour, make, onThemeChange } from '../dom';
import type { PlanItem, Zone } from '../document';
import { indexAt } from '../flight';
import type { Flight, Series } from '../flight';
import type { View } from '../view';
import { isFlyingWing } from './airplane';
import { kRamp, modeColour, rampColour } from './colours';
import { Graticule } from './graticule';

const iconOf = (path: string): string => `<svg viewBox="-17 -17 34 34" aria-hidden="true"><path d="${path}"/></svg>`;
const kAirplane = iconOf('M0-15c1.6 0 2 3 2 6v2l13 6v3.2L2 0l-.6 8 4.1 3v2.4L0 12l-5.5 1.4V11l4.1-3L-2 0l-13 2.2V-1l13-6v-2c0-3 .4-6 2-6z');
const kWing = iconOf('M0-11c1.8 0 2.6 2 3.2 4L15 4V2h1.6v8H15L2.6 4.6 0 5.6l-2.6-1L-15 10h-1.6V2H-15v2L-3.2-7C-2.6-9-1.8-11 0-11z');
const kPick_px = 24, kMaxPoints = 4000;
const kAboveNames = '660';  // Leaflet's tooltips are at 650, its popups at 700
const kTiles = 'https://tile.openstreetmap.org/{z}/{x}/{y}.png';

type Placed = PlanItem & { lat_deg: number; lon_deg: number };
const isPlaced = (item: PlanItem): item is Placed => item.lat_deg !== undefined && item.lon_deg !== undefined;

export class FlightMap {
  private readonly map: L.Map;
  private readonly graticule = new Graticule();
  private readonly plan = L.layerGroup();
  private readonly track = L.layerGroup();
  private readonly airplane: L.Marker;
  private readonly tiles = L.tileLayer(kTiles, { maxZoom: 19, attribution: '© OpenStreetMap contributors' });
  private lat?: Series;
  private lon?: Series;
  private yaw?: Series;
  private by = 'mode';
  private drawn = 0;  // samples of a live track
  private held = false;  // by a user who has moved it
  private tail?: L.Polyline;
  onPlace?: (place: L.LatLng) => void;  // instead of the cursor's jump

  constructor(private readonly flight: Flight, private readonly view: View) {
    this.map = L.map('map', { preferCanvas: true, zoomSnap: 0.25, zoomAnimation: false, fadeAnimation: false, attributionControl: false, keyboard: true });
    L.control.attribution({ prefix: false }).addTo(this.map);
    L.control.scale({ imperial: false }).addTo(this.map);
    this.map.createPane('airplane').style.zIndex = kAboveNames;
    this.airplane = L.marker([0, 0], {
      icon: L.divIcon({ className: 'airplane', html: isFlyingWing(flight.document) ? kWing : kAirplane, iconSize: [34, 34] }), interactive: false, keyboard: false,
      pane: 'airplane', alt: 'the airplane',
    });
    this.lat = flight.find('lat_deg', 'truth', 'estimate');
    this.lon = flight.find('lon_deg', 'truth', 'estimate');
    this.yaw = flight.find('yaw_deg', 'truth', 'estimate');
    this.map.setView(this.home(), 15);
    for (const layer of [this.graticule, this.plan, this.track]) layer.addTo(this.map);
    this.fit();
    this.draw();
    this.controls();
    view.moved.on((time_s) => this.move(time_s));
    this.map.on('click', (event) => this.click(event.latlng));
    onThemeChange(() => { this.graticule.draw(); this.draw(); });
    new ResizeObserver(() => this.map.invalidateSize()).observe(byId('map'));
  }

  private home(): L.LatLngTuple {
    const home = this.flight.document.plan?.home;
    const i = this.lat?.values.findIndex(Number.isFinite) ?? -1;
    if (home) return [home.lat_deg, home.lon_deg];
    return this.lat && this.lon && i >= 0 ? [this.lat.values[i], this.lon.values[i]] : [0, 0];
  }
  private items(): Placed[] { return (this.flight.document.plan?.items ?? []).filter(isPlaced); }

  fit(): void {
    this.map.invalidateSize();
    const bounds = L.latLngBounds([]);
    for (const item of this.items()) bounds.extend([item.lat_deg, item.lon_deg]);
    for (const [at] of this.points()) bounds.extend(at);
    if (!bounds.isValid()) return;
    // a single place has no size: an airplane that stands still
    this.map.fitBounds(bounds, { paddingTopLeft: [30, 46], paddingBottomRight: [50, 56], maxZoom: 18 });
  }

  // [place, index of the sample], so many that a canvas draws them at once.
  private points(): [L.LatLngTuple, number][] {
    const { lat, lon } = this;
    if (!lat || !lon) return [];
    const by = this.flight.document.kind === 'live' ? 1 : Math.max(1, Math.floor(lat.values.length / kMaxPoints));
    const found: [L.LatLngTuple, number][] = [];
    for (let i = 0; i < lat.values.length; i += by)
      if (Number.isFinite(lat.values[i]) && Number.isFinite(lon.values[i])) found.push([[lat.values[i], lon.values[i]], i]);
    return found;
  }

  draw(): void {
    this.drawPlan();
    this.drawTrack();
    this.move(this.view.time_s);
  }

  private drawPlan(): void {
    this.plan.clearLayers();
    const { home, fence = [], zones = [], rally = [] } = this.flight.document.plan ?? {};
    const items = this.items();
    const way: L.LatLngTuple[] = [...(home ? [home] : []), ...items].map(({ lat_deg, lon_deg }) => [lat_deg, lon_deg]);
    L.polyline(way, { color: colour('plan'), weight: 5, opacity: 0.4, interactive: false }).addTo(this.plan);
    if (fence.length > 2) this.drawZone({ keeps: 'in', rim: fence });
    for (const zone of zones) this.drawZone(zone);
    for (const [i, at] of rally.entries()) this.mark([at.lat_deg, at.lon_deg], `R${i + 1}`, 'rally point', 'rally');
    const atHome = items.some(({ lat_deg, lon_deg }) => lat_deg === home?.lat_deg && lon_deg === home.lon_deg);
    if (home && !atHome) this.mark([home.lat_deg, home.lon_deg], 'H', 'home', 'ink');
    for (const item of items) this.drawItem(item);
  }
  // What is to be stayed out of is filled.
  private drawZone({ keeps, rim, radius_m }: Zone): void {
    const style = { color: colour('fence'), weight: 2, dashArray: '7 5', fill: keeps === 'out', fillOpacity: 0.18, interactive: false };
    const places = rim.map((at): L.LatLngTuple => [at.lat_deg, at.lon_deg]);
    (radius_m ? L.circle(places[0], { ...style, radius: radius_m }) : L.polygon(places, style)).addTo(this.plan);
  }
  private drawItem(item: Placed): void {
    const at: L.LatLngTuple = [item.lat_deg, item.lon_deg];
    if (item.radius_m)
      L.circle(at, { radius: Math.abs(item.radius_m), color: colour('plan'), weight: 5, opacity: 0.4, fill: false, interactive: false }).addTo(this.plan);
    const plain = /^(NAV_)?WAYPOINT$/.test(item.name);
    this.mark(at, `${item.index}${plain ? '' : ` ${item.name.toLowerCase().replaceAll('_', ' ')}`}`, `${item.index} ${item.text}`, 'plan', item.name === 'LAND' ? 'bottom' : 'right');
  }
  private mark(at: L.LatLngTuple, name: string, words: string, ink: string, direction: L.Direction = 'right'): void {
    L.circleMarker(at, { radius: 4, color: colour(ink), weight: 2, fillColor: colour('panel'), fillOpacity: 1 })
      .bindPopup(() => make('span', {}, words), { closeButton: false })
      .bindTooltip(make('span', {}, name), { permanent: true, direction, offset: direction === 'right' ? [5, 0] : [0, 5], className: 'place', opacity: 0.92 })
      .addTo(this.plan);
  }

  private drawTrack(): void {
    this.track.clearLayers();
    const points = this.points();
    this.drawn = this.lat?.values.length ?? 0;
    const of = this.by === 'height' ? this.heightColour() : (time_s: number) => modeColour(this.flight.bandAt('mode', time_s)?.name ?? '');
    let line: L.LatLngTuple[] = [], ink = '';
    this.tail = undefined;
    const end = (): void => {
      if (line.length > 1) this.tail = L.polyline(line, { color: ink, weight: 2.2, interactive: false, smoothFactor: 0.5 }).addTo(this.track);
    };
    for (const [at, i] of points) {
      const now = of((this.lat as Series).times[i]);
      if (now !== ink) {
        if (line.length > 0) line.push(at);
        end();
        line = [];
        ink = now;
      }
      line.push(at);
    }
    end();
    this.legend();
  }
  private heightColour(): (time_s: number) => string {
    const height = this.flight.find('height_m', 'truth', 'estimate');
    const [low, high] = this.heights(height);
    return (time_s) => rampColour((this.flight.at(height, time_s) - low) / Math.max(high - low, 1));
  }
  private heights(height: Series | undefined): [number, number] {
    const known = (height?.values ?? []).filter(Number.isFinite);
    return known.length === 0 ? [0, 1] : [known.reduce((a, b) => Math.min(a, b)), known.reduce((a, b) => Math.max(a, b))];
  }
  private legend(): void {
    const box = byId('map-legend');
    if (this.by === 'height') {
      const [low, high] = this.heights(this.flight.find('height_m', 'truth', 'estimate'));
      const ramp = make('i', { class: 'ramp' });
      ramp.style.background = `linear-gradient(90deg, ${kRamp.join(',')})`;
      return box.replaceChildren(make('span', {}, `${low.toFixed(0)} m`), make('span', {}, ramp), make('span', {}, `${high.toFixed(0)} m`));
    }
    const modes = [...new Set(this.flight.bands.filter((band) => band.kind === 'mode').map((band) => band.name))];
    const entries: [string, string][] = [...modes.map((mode): [string, string] => [mode, modeColour(mode)]), ['planned', colour('plan')]];
    box.replaceChildren(...entries.map(([name, ink]) => {
      const line = make('i');
      line.style.background = ink;
      return make('span', {}, line, name);
    }));
  }

  private move(time_s: number): void {
    const { flight } = this;
    const at = [flight.smooth(this.lat, time_s), flight.smooth(this.lon, time_s)] as L.LatLngTuple;
    if (!at.every(Number.isFinite)) return void this.airplane.remove();
    this.airplane.setLatLng(at);
    if (!this.map.hasLayer(this.airplane)) this.airplane.addTo(this.map);
    const picture = this.airplane.getElement()?.firstElementChild as SVGElement | undefined;
    const yaw = flight.smooth(this.yaw, time_s, true);
    if (picture) picture.style.transform = `rotate(${Number.isFinite(yaw) ? yaw : 0}deg)`;
    if (byId<HTMLInputElement>('follow').checked) this.map.panTo(at, { animate: false });
    else if (this.view.live && !this.held && !this.map.getBounds().contains(at)) this.fit();
    this.wind(time_s);
  }
  private wind(time_s: number): void {
    const speed = this.flight.at(this.flight.find('wind_mps', 'truth', 'estimate'), time_s);
    const from = this.flight.at(this.flight.find('wind_from_deg', 'truth', 'estimate'), time_s);
    const box = byId('wind');
    box.hidden = !Number.isFinite(speed) || !Number.isFinite(from);
    if (box.hidden) return;
    if (!box.firstElementChild) {
      box.innerHTML = '<svg viewBox="-12 -12 24 24" aria-hidden="true"><path d="M0 11-4.5 3h3.2v-14h2.6v14h3.2z"/></svg><span></span>';
    }
    (box.firstElementChild as SVGElement).style.transform = `rotate(${from}deg)`;
    (box.lastElementChild as HTMLElement).textContent = `wind ${speed.toFixed(1)} m/s from ${from.toFixed(0)}°`;
  }

  private click(place: L.LatLng): void {
    if (this.onPlace) return this.onPlace(place);
    const at = this.map.latLngToContainerPoint(place);
    let best = kPick_px, found = -1;
    for (const [point, i] of this.points()) {
      const apart = this.map.latLngToContainerPoint(point).distanceTo(at);
      if (apart < best) [best, found] = [apart, i];
    }
    if (found >= 0 && this.lat) this.view.jumpTo(this.lat.times[found]);
  }
  private controls(): void {
    const hold = (): void => { this.held = true; };
    this.map.on('dragstart', hold);
    for (const name of ['wheel', 'dblclick']) byId('map').addEventListener(name, hold);
    byId('map').querySelector('.leaflet-control-zoom')?.addEventListener('click', hold);
    const by = byId<HTMLSelectElement>('track-by');
    by.addEventListener('change', () => { this.by = by.value; this.drawTrack(); });
    const tiles = byId<HTMLInputElement>('tiles');
    tiles.addEventListener('change', () => {
      if (tiles.checked) this.tiles.addTo(this.map);
      else this.tiles.remove();
    });
    byId('follow').addEventListener('change', () => this.move(this.view.time_s));
  }

  // Of a live flight: adds what has come; from time to time and at a new mode all is drawn again.
  grow(): void {
    const { lat, lon } = this;
    if (!lat || !lon || lat.values.length === this.drawn) return;
    const newest = indexAt(lat.times, Infinity);
    if (this.drawn < 20 || !this.tail || this.by === 'height') return this.regrow();
    for (let i = this.drawn; i <= newest; ++i)
      if (Number.isFinite(lat.values[i])) this.tail.addLatLng([lat.values[i], lon.values[i]]);
    this.drawn = newest + 1;
  }
  private regrow(): void {
    const first = this.drawn < 20;
    this.drawTrack();
    if (first && this.items().length === 0) this.fit();
  }
}
