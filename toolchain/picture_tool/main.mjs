// SPDX-License-Identifier: GPL-3.0-or-later
// node main.mjs REPORT MISSIONS OUT: one SVG of a flight, from the document in its report.html, the
// figures of its summary.json and the mission of that name in the folder MISSIONS.
import { readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { altitudeOf, documentOf, mapOf } from './charts.mjs';

const kWidth = 960, kMapWidth = 600, kMapTop = 76, kPanelLeft = 640, kMargin = 24, kLine = 21;

const style = `<style>
text{font-family:system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;font-size:13px;fill:#5d6b7c}
.title{font-size:25px;font-weight:600;fill:#1c2430}.head{font-size:16px;font-weight:600;fill:#1c2430}
.good{fill:#18794e;font-weight:600}.value{fill:#1c2430;font-weight:600}.item{fill:#1c2430}
.grid{stroke:#e9edf2}.axis{stroke:#9aa7b5}.upright{stroke:#b9c3cf;stroke-dasharray:2 3}
.label,.legend{fill:#1c2430;font-size:14px}
.mark{font-size:12px}
.name{fill:#1c2430;font-size:15px;font-weight:600;paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-opacity:.85}
.line{fill:none;stroke-width:1.7;stroke-linejoin:round}.thin{stroke-width:1}
.dashed{stroke-dasharray:6 4;stroke-width:1.5}.band{stroke-width:7;stroke-linecap:round}
.rose{fill:#fff;stroke:#c4ccd6}.wind{stroke:#b42318;fill:#b42318;stroke-width:2}
.place{fill:#fff;stroke:#5d6b7c;stroke-width:1.5}
</style>`;

class Refusal extends Error {}

function read(path) {
  try {
    return readFileSync(path, 'utf8');
  } catch (error) {
    throw new Refusal(`${path} cannot be read: ${error.code}`);
  }
}

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const text = (x, y, kind, words, anchor = 'start') =>
  `<text x="${x}" y="${y}" class="${kind}" text-anchor="${anchor}">${escaped(words)}</text>`;

// ---- the mission, QGC WPL 110

const height = ({ z }) => ` at ${z} m`;
const kCommands = {
  16: ['waypoint', height],
  17: ['loiter', height],
  18: ['loiter', (item) => `, ${item.p[0]} turns${height(item)}`],
  19: ['loiter', (item) => `, ${item.p[0]} s${height(item)}`],
  20: ['return to launch', () => ''],
  21: ['land', () => ''],
  22: ['take-off', ({ z }) => ` to ${z} m`],
  114: ['wait', ({ p }) => ` until ${p[0]} m before the next`],
  178: ['airspeed', ({ p }) => ` ${p[1]} m/s`],
  183: ['servo', ({ p }) => ` ${p[0]} to ${p[1]} µs`],
};

function missionItems(file) {
  const [head, ...lines] = read(file).trim().split(/\r?\n/);
  if (!head.startsWith('QGC WPL')) throw new Refusal(`${file} is not a waypoint file`);
  return lines.slice(1).map((line) => {
    const [number, , , command, ...rest] = line.trim().split(/\s+/).map(Number);
    const [name, more] = kCommands[command] ?? [`command ${command}`, () => ''];
    return { number, name, more: more({ p: rest.slice(0, 4), z: rest[6] }) };
  });
}

// ---- the charts of the report

function chartsOf(page, summary) {
  const document = documentOf(page);
  if (!document) throw new Refusal('report.html has no flight document');
  const wind = { mps: summary.wind_mps, from_deg: summary.wind_from_deg, gusts: summary.gusts };
  const found = { map: mapOf(document, wind), altitude: altitudeOf(document) };
  if (!found.map || !found.altitude) throw new Refusal('report.html has no ground track or no altitude');
  return found;
}

function placed(chart, x, y, width) {
  const [, wide, tall] = /viewBox="0 0 (\d+) (\d+)"/.exec(chart);
  const tallHere = Math.round(width * tall / wide);
  return {
    bottom: y + tallHere,
    svg: chart.replace('<svg ', `<svg x="${x}" y="${y}" width="${width}" height="${tallHere}" `),
  };
}

// The dots are named by number; their names are the mission's.
function nameDots(map, items) {
  return map.replace(/(class="name">)(\d+)[^<]*/g, (_, before, number) => {
    const item = items.find((each) => each.number === Number(number));
    if (!item) throw new Refusal(`the report has an item ${number}, the mission has not`);
    return `${before}${number}${item.name === 'waypoint' ? '' : ` ${escaped(item.name)}`}`;
  });
}

// ---- the panel at the right

const figure = (name, value, digits, unit) =>
  (value === undefined || value === null ? [] : [[name, `${value.toFixed(digits)} ${unit}`]]);

const figures = (s) => [
  ...figure('flight time', s.flight_time_s, 0, 's'),
  ...figure('touch-down from the point', s.landed_distance_m, 1, 'm'),
  ...figure('crosstrack, RMS', s.crosstrack_rms_m, 2, 'm'),
  ...figure('altitude, RMS', s.altitude_rms_m, 2, 'm'),
  ...figure('airspeed, RMS', s.airspeed_rms_mps, 2, 'm/s'),
  ...figure('processor load', s.cpu_load === undefined ? undefined : s.cpu_load * 100, 0, '%'),
  ...figure('longest frame of 10 ms', s.frame_max_us === undefined ? undefined : s.frame_max_us / 1000, 1, 'ms'),
];

function panel(summary, items) {
  const right = kWidth - kMargin;
  let y = kMapTop + 34;
  const lines = [text(kPanelLeft, y, 'head', 'Figures')];
  for (const [name, value] of figures(summary)) {
    y += kLine;
    lines.push(text(kPanelLeft, y, 'item', name), text(right, y, 'value', value, 'end'));
  }
  y += kLine * 2;
  lines.push(text(kPanelLeft, y, 'head', 'Mission'));
  for (const { number, name, more } of items) {
    y += kLine;
    lines.push(text(kPanelLeft + 18, y, 'value', number, 'end'),
      text(kPanelLeft + 28, y, 'item', `${name}${more}`));
  }
  return lines.join('\n');
}

function subtitle(s) {
  const air = s.wind_mps > 0 ? `wind ${s.wind_mps} m/s from ${s.wind_from_deg}°` : 'calm air';
  return `${s.mission} · ${s.firmware} on ${s.board} · ${air}${s.gusts ? ', gusts' : ''} · seed ${s.seed}`;
}

export function picture(folder, missions) {
  const summary = JSON.parse(read(join(folder, 'summary.json')));
  if (!summary.completed) throw new Refusal(`the mission was not completed: ${summary.reason}`);
  const items = missionItems(join(missions, summary.mission));
  const charts = chartsOf(read(join(folder, 'report.html')), summary);
  const map = placed(nameDots(charts.map, items), 0, kMapTop, kMapWidth);
  const altitude = placed(charts.altitude, 0, map.bottom + 40, kWidth);
  const tall = altitude.bottom + 10;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${kWidth} ${tall}" width="${kWidth}" height="${tall}">
<title>${escaped(`A flight in the simulator: ${subtitle(summary)}`)}</title>
${style}
<rect width="${kWidth}" height="${tall}" fill="#fff"/>
${text(kMargin, 40, 'title', 'A flight in the simulator')}
${text(kWidth - kMargin, 40, 'good', 'mission completed', 'end')}
${text(kMargin, 64, 'item', subtitle(summary))}
${map.svg}
${panel(summary, items)}
${text(kMargin, map.bottom + 30, 'head', 'Altitude')}
${altitude.svg}
</svg>
`;
}

if (process.argv[1]?.endsWith('picture_tool/main.mjs')) {
  const [folder, missions, out] = process.argv.slice(2);
  try {
    const drawn = picture(folder, missions);
    try {
      writeFileSync(`${out}.new`, drawn);
      renameSync(`${out}.new`, out);
    } catch (error) {
      throw new Refusal(`${out} cannot be written: ${error.code}`);
    }
    console.log(`picture: ${out}`);
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    console.error(`picture: ${error.message}`);
    process.exitCode = 1;
  }
}
