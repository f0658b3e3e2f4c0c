// SPDX-License-Identifier: GPL-3.0-or-later
// A page without plots or map: status, numbers, events and the buttons.
#include "simulator/live/page.hpp"

namespace simulator::live {

std::string_view livePage() {
    static constexpr char kPage[] = R"page(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="source" content="live">
<title>Live flight</title>
<link rel="icon" href="data:,">
<style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 1em; max-width: 60em; }
form, #buttons { display: flex; flex-wrap: wrap; gap: .4em; margin: .5em 0; }
#numbers { display: grid; grid-template-columns: repeat(auto-fill, minmax(9em, 1fr)); margin: 0; }
#events { list-style: none; padding: 0; font-family: monospace; }
input { width: 7em; }
</style>
<h1 id="title">Live flight</h1>
<p id="status" role="status">waiting for the simulator</p>
<div id="buttons"></div>
<form id="mode"><select name="mode" aria-label="mode"></select><button>set mode</button></form>
<form id="goto"><input name="lat_deg" aria-label="latitude" placeholder="latitude" required>
<input name="lon_deg" aria-label="longitude" placeholder="longitude" required>
<input name="altitude_m" aria-label="metres above home" value="60"><button>fly to here</button></form>
<form id="fault"><select name="name" aria-label="fault"></select>
<button name="on" value="true">begin fault</button><button name="on" value="false">end fault</button></form>
<form id="wind"><input name="speed_mps" aria-label="m/s" value="5">
<input name="from_deg" aria-label="from, degrees" value="270">
<button>set wind</button></form>
<p id="answer" role="status"></p>
<dl id="numbers"></dl>
<ol id="events" reversed></ol>
<script>
const id = (name) => document.getElementById(name);
async function command(order) {
  const response = await fetch('/command', { method: 'POST', headers: { 'Content-Type': 'application/json' },
    body: JSON.stringify(order) });
  const { ok, text } = await response.json();
  id('answer').textContent = `${order.do}: ${ok ? '' : 'refused: '}${text}`;
}
for (const [name, order] of [['arm', { do: 'arm' }], ['disarm', { do: 'disarm' }], ['take off', { do: 'takeoff' }],
  ['pause', { do: 'pause' }], ['resume', { do: 'resume' }],
  ...[1, 2, 5, 'max'].map((times) => [`speed ${times}`, { do: 'speed', times }])]) {
  const button = document.createElement('button');
  button.textContent = name;
  button.onclick = () => command(order);
  id('buttons').append(button);
}
for (const form of document.querySelectorAll('form'))
  form.onsubmit = (event) => {
    event.preventDefault();
    const order = { do: form.id };
    for (const [name, value] of new FormData(form, event.submitter))
      order[name] = name === 'on' ? value === 'true' : name === 'mode' || name === 'name' ? value : Number(value);
    command(order);
  };
function line(time_s, text) {
  const item = document.createElement('li');
  item.textContent = `${time_s.toFixed(1)} s  ${text}`;
  id('events').prepend(item);
}
const stream = new EventSource('/live');
const on = (name, take) => stream.addEventListener(name, ({ data }) => take(JSON.parse(data)));
on('flight', (flight) => {
  id('title').textContent = flight.title;
  for (const [list, names] of [[id('mode').elements.mode, flight.offers.modes],
    [id('fault').elements.name, flight.offers.faults]])
    if (list.options && list.options.length === 0) list.append(...names.map((name) => new Option(name)));
  id('events').replaceChildren();
  for (const event of flight.events) line(event.time_s, event.text);
});
on('event', (event) => line(event.time_s, event.text));
on('status', (status) => {
  id('status').textContent = `${status.armed ? 'armed' : 'disarmed'}, ${status.mode}, item ${status.item}, ` +
    (status.paused ? 'paused' : `${status.speed.toFixed(1)} times real time`) +
    (status.ended ? `, ended: ${status.ended}` : '');
});
on('samples', ({ time_s, values }) => {
  id('numbers').replaceChildren(...['height_m', 'airspeed_mps', 'climb_mps', 'roll_deg', 'yaw_deg', 'throttle_percent',
    'battery_v', 'wind_mps'].map((name) => {
    const box = document.createElement('div');
    box.textContent = `${name} ${values[name] ?? '-'}`;
    return box;
  }));
});
</script>
</html>
)page";
    return {kPage, sizeof kPage - 1};
}

}  // namespace simulator::live
