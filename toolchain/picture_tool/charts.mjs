// SPDX-License-Identifier: GPL-3.0-or-later
// The charts of the picture, drawn as SVG from the flight document of a report.html.

const kMap = { width: 620, height: 830 }, kAltitude = { width: 960, height: 260 };
const kEdge = { left: 64, right: 14, top: 16, bottom: 44 };
const kBefore_s = 5, kCircle = 72;

export function documentOf(page) {
  const found = /<script type="application\/json" id="flight">([^]*?)<\/script>/.exec(page);
  const document = found ? JSON.parse(found[1]) : null;
  return document?.format === 'apm-flight' ? document : null;
}

function decode(numbers) {
  if (Array.isArray(numbers)) return numbers.map((value) => value ?? NaN);
  const bytes = Buffer.from(numbers.f32 ?? numbers.i16, 'base64');
  if (numbers.f32) return Array.from({ length: bytes.length / 4 }, (_, i) => bytes.readFloatLE(4 * i));
  return Array.from({ length: bytes.length / 2 }, (_, i) => {
    const step = bytes.readInt16LE(2 * i);
    return step === -32768 ? NaN : numbers.offset + numbers.scale * step;
  });
}

// [time, value] of a series from shortly before AUTO on.
function seriesOf(document, name, kind) {
  const found = document.series.find((each) => each.name === name && (each.kind ?? '') === kind);
  if (!found) return [];
  const times = decode(document.times[found.time]), values = decode(found.values);
  const from_s = (document.bands.find((band) => band.kind === 'mode' && band.name === 'AUTO')?.from_s ?? 0) - kBefore_s;
  return times.map((time, i) => [time, values[i]]).filter(([time]) => time >= from_s);
}

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const at = (value) => String(Math.round(value * 10) / 10);

// Round steps that part the range into about `count`.
export function ticks(from, to, count) {
  const rough = (to - from) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((each) => each * power >= rough) ?? 10);
  const first = Math.ceil(from / step - 1e-9);
  return Array.from({ length: Math.floor(to / step + 1e-9) - first + 1 }, (_, i) => +((first + i) * step).toPrecision(12));
}

class Frame {
  constructor(size, [x1, x2], [y1, y2]) {
    Object.assign(this, { size, x1, x2, y1, y2 });
    this.parts = [];
  }
  x(value) { return kEdge.left + (value - this.x1) / (this.x2 - this.x1) * (this.size.width - kEdge.left - kEdge.right); }
  y(value) { return this.size.height - kEdge.bottom - (value - this.y1) / (this.y2 - this.y1) * (this.size.height - kEdge.top - kEdge.bottom); }
  grid(x_label, y_label) {
    const { width, height } = this.size, bottom = height - kEdge.bottom;
    for (const value of ticks(this.x1, this.x2, width / 110))
      this.parts.push(`<path class="grid" d="M${at(this.x(value))} ${kEdge.top}V${bottom}"/>`,
        `<text x="${at(this.x(value))}" y="${bottom + 16}" text-anchor="middle">${value}</text>`);
    for (const value of ticks(this.y1, this.y2, height / 80))
      this.parts.push(`<path class="grid" d="M${kEdge.left} ${at(this.y(value))}H${width - kEdge.right}"/>`,
        `<text x="${kEdge.left - 6}" y="${at(this.y(value) + 4)}" text-anchor="end">${value}</text>`);
    this.parts.push(`<text class="label" x="${(kEdge.left + width - kEdge.right) / 2}" y="${height - 8}" text-anchor="middle">${escaped(x_label)}</text>`,
      `<text class="label" transform="translate(14 ${at((kEdge.top + bottom) / 2)}) rotate(-90)" text-anchor="middle">${escaped(y_label)}</text>`);
  }
  line(points, ink, kind) {
    let path = '', pen = 'M';
    for (const [x, y] of points) {
      if (!Number.isFinite(y)) { pen = 'M'; continue; }
      path += `${pen}${at(this.x(x))} ${at(this.y(y))}`;
      pen = 'L';
    }
    if (path) this.parts.push(`<path class="line ${kind}" stroke="${ink}" d="${path}"/>`);
  }
  legend(entries) {
    let x = kEdge.left + 10;
    for (const [name, ink, kind] of entries) {
      this.parts.push(`<path class="line ${kind}" stroke="${ink}" d="M${x} ${kEdge.top + 10}h26"/>`,
        `<text class="legend" x="${x + 32}" y="${kEdge.top + 14}">${name}</text>`);
      x += 46 + 8 * name.length;
    }
  }
  svg(label) {
    const { width, height } = this.size;
    return `<svg class="chart" viewBox="0 0 ${width} ${height}" role="img" aria-label="${escaped(label)}">${this.parts.join('\n')}</svg>`;
  }
}

// Metres east and north of home.
function localOf({ lat_deg, lon_deg }) {
  const north = 111_132.95, east = 111_319.49 * Math.cos(lat_deg * Math.PI / 180);
  return (lat, lon) => [(lon - lon_deg) * east, (lat - lat_deg) * north];
}

function arrow(frame, wind) {
  const x = kEdge.left + 42, y = kEdge.top + 66;
  const calm = !(wind.mps > 0);
  return [`<circle class="rose" cx="${x}" cy="${y}" r="26"/>`, `<text x="${x}" y="${y - 31}" text-anchor="middle">N</text>`,
    calm ? '' : `<path class="wind" transform="translate(${x} ${y}) rotate(${wind.from_deg})" d="M0-20V14M0 20l-5-8h10z"/>`,
    `<text class="legend" x="${x + 34}" y="${y + 4}">${escaped(calm ? (wind.gusts ? 'gusts only' : 'calm air') : `${wind.mps.toFixed(1)} m/s${wind.gusts ? ', gusts' : ''}`)}</text>`];
}

export function mapOf(document, wind) {
  const lat = seriesOf(document, 'lat_deg', 'truth'), lon = seriesOf(document, 'lon_deg', 'truth');
  const { home, items = [] } = document.plan ?? {};
  if (!home || lat.length < 2) return null;
  const local = localOf(home), placed = items.filter((item) => item.lat_deg !== undefined);
  const flown = lat.map(([, value], i) => local(value, lon[i][1]));
  const places = placed.map((item) => ({ item, at: local(item.lat_deg, item.lon_deg) }));
  const all = [...flown, ...places.flatMap(({ item, at: [x, y] }) => { const r = Math.abs(item.radius_m ?? 0); return [[x - r, y - r], [x + r, y + r]]; })];
  const [xs, ys] = [0, 1].map((i) => all.map((point) => point[i]));
  const middle = (values) => (Math.min(...values) + Math.max(...values)) / 2, wide = (values) => Math.max(...values) - Math.min(...values);
  const metres = Math.max(wide(xs) / (kMap.width - kEdge.left - kEdge.right), wide(ys) / (kMap.height - kEdge.top - kEdge.bottom)) * 1.12;
  const half = [(kMap.width - kEdge.left - kEdge.right) * metres / 2, (kMap.height - kEdge.top - kEdge.bottom) * metres / 2];
  const frame = new Frame(kMap, [middle(xs) - half[0], middle(xs) + half[0]], [middle(ys) - half[1], middle(ys) + half[1]]);
  frame.grid('east of home, m', 'north of home, m');
  frame.line([[0, 0], ...places.map((each) => each.at)], '#f3c892', 'band');
  for (const { item, at: [x, y] } of places) {
    if (!item.radius_m) continue;
    const turn = (i) => i * 2 * Math.PI / kCircle;
    frame.line(Array.from({ length: kCircle + 1 }, (_, i) => [x + item.radius_m * Math.sin(turn(i)), y + item.radius_m * Math.cos(turn(i))]), '#f3c892', 'band');
  }
  frame.line(flown, '#1f6ab0', '');
  for (const { item, at: [x, y] } of places)
    frame.parts.push(`<circle class="place" cx="${at(frame.x(x))}" cy="${at(frame.y(y))}" r="4"/>`,
      `<text x="${at(frame.x(x) + 8)}" y="${at(frame.y(y) - 6)}" class="name">${item.index}</text>`);
  frame.legend([['planned', '#f3c892', 'band'], ['flown', '#1f6ab0', '']]);
  frame.parts.push(...arrow(frame, wind));
  return frame.svg('north of home, m over east of home, m');
}

export function altitudeOf(document) {
  const truth = seriesOf(document, 'height_m', 'truth');
  if (truth.length < 2) return null;
  const planned = seriesOf(document, 'planned_height_m', ''), estimate = seriesOf(document, 'height_m', 'estimate');
  const highest = truth.reduce((most, [, value]) => Math.max(most, value), 0);
  const frame = new Frame(kAltitude, [truth[0][0], truth.at(-1)[0]], [-highest * 0.05, highest * 1.2]);
  frame.grid('time since power-on, s', 'altitude above home, m');
  for (const { kind, time_s, text } of document.events) {
    const item = kind === 'item' && /^flies item (\d+)$/.exec(text);
    if (item) frame.parts.push(`<path class="upright" d="M${at(frame.x(time_s))} ${kEdge.top}V${kAltitude.height - kEdge.bottom}"/>`,
      `<text class="mark" x="${at(frame.x(time_s) + 3)}" y="${kEdge.top + 34}">${item[1]}</text>`);
  }
  frame.line(estimate, '#7fb2d9', 'thin');
  frame.line(planned, '#d9771f', 'dashed');
  frame.line(truth, '#1f6ab0', '');
  frame.legend([['as estimated', '#7fb2d9', 'thin'], ['planned', '#d9771f', 'dashed'], ['truth', '#1f6ab0', '']]);
  return frame.svg('altitude above home, m over time');
}
