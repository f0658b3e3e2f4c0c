// SPDX-License-Identifier: GPL-3.0-or-later
// The live page in a browser with the simulator behind it: a natively compiled flight is armed, flown, disturbed and watched by what
// a user clicks. FLY names the program, SHOTS where screenshots go; live_air.png is the README's picture.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { Served } from '../interop/live/served.mjs';
import { assertAccessible, launch, open } from '../support/browser.mjs';

const { SHOTS } = process.env;
let browser;

before(async () => {
  mkdirSync(SHOTS, { recursive: true });
  browser = await launch();
});
after(() => browser?.close());

const kServe = ['--serve', '--listen', '0'], kWatch = ['--watch', '--http', '0'];

async function served(body, words = kServe, init = undefined) {
  const flight = await Served.start(words);
  const page = await open(browser, 'about:blank', { width: 1280, height: 800 });
  if (init) await page.addInitScript(init);
  try {
    await page.goto(`http://127.0.0.1:${flight.port}/`);
    await page.locator('.u-over[data-group="height"]').waitFor();
    await body(page, flight);
    assert.deepEqual(page.faults, []);
  } catch (error) {
    error.message += `\n${flight.said}\n${await page.locator('#live-panel').textContent().catch(() => '')}`;
    throw error;
  } finally {
    await page.context().close();
    flight.clean();
  }
}

const state = (page) => page.locator('#live-panel .state');
const says = (page, text) => page.locator('#message-list li').filter({ hasText: text }).first().waitFor();
async function speed(page, name) {
  const button = page.getByRole('group', { name: 'Speed of the simulation' }).getByRole('button', { name, exact: true });
  await button.click();
  await page.getByRole('group', { name: 'Speed of the simulation' }).locator('[aria-pressed="true"]').getByText(name, { exact: true }).waitFor();
}
const shown = (page, series) => page.locator(`.plot-head button[title^="${series},"]`).first().locator('b').textContent();
const height_m = async (page) => parseFloat(await shown(page, 'height_m'));
const place = (page) => page.locator('.airplane').evaluate((element) => element.style.transform);

async function until(what, check) {
  for (const end = Date.now() + 60_000; !await check();) {
    assert.ok(Date.now() < end, `${what}: never`);
    await new Promise((resolve) => { setTimeout(resolve, 50); });
  }
}
// Refused until the sensors are ready.
async function arm(page) {
  await until('armed', async () => {
    if (/^armed/.test(await state(page).textContent())) return true;
    await page.click('#arm');
    await page.waitForTimeout(200);
    return false;
  });
}
async function takeOff(page) {
  await speed(page, '10×');
  await arm(page);
  await page.getByRole('button', { name: 'take-off' }).click();
  await state(page).getByText('armed · AUTO').waitFor();
  await until('40 m high', async () => await height_m(page) > 40);
}

test('a flight by the page: arm, modes, fly to here, pause, speed, faults, wind', () => served(async (page, flight) => {
  await page.getByText(/^disarmed · /).waitFor();
  assert.equal(await page.locator('#subtitle').textContent(), 'foam_trainer, live');
  assert.equal(await page.getByLabel('end a fault').isDisabled(), true);
  await takeOff(page);
  await page.locator('#map .place').filter({ hasText: '2 loiter unlim' }).waitFor();  // of the mission that the board holds

  await page.getByLabel('mode', { exact: true }).selectOption('LOITER');
  await state(page).getByText('armed · LOITER').waitFor();
  await page.getByLabel('mode', { exact: true }).selectOption('AUTO');
  await state(page).getByText('armed · AUTO').waitFor();

  await page.click('#goto');
  const map = await page.locator('#map').boundingBox();
  await page.locator('#map').click({ position: { x: map.width * 0.5, y: map.height * 0.3 } });
  await state(page).getByText('armed · GUIDED').waitFor();
  const left = await place(page);
  await until('it is somewhere else', async () => await place(page) !== left);

  await page.getByLabel('Wind, m/s').fill('6');
  await page.getByLabel('Wind from, degrees').fill('250');
  await page.getByRole('button', { name: 'set wind' }).click();
  await says(page, 'wind 6 m/s from 250 deg');
  await page.locator('#wind').getByText('wind 6.0 m/s from 250°').waitFor();

  await page.getByLabel('inject a fault').selectOption('gps:lost');
  await says(page, 'GPS lost: dead reckoning');
  await page.getByLabel('end a fault').selectOption('gps:lost');
  await says(page, 'gps:lost is over');
  await says(page, 'GPS back');
  assert.equal(await page.getByLabel('end a fault').isDisabled(), true);

  await page.click('#pause');
  await state(page).getByText('paused').waitFor();
  await page.waitForTimeout(800);  // what came before is drawn
  const stood = await page.locator('#now').textContent();
  await page.waitForTimeout(500);
  assert.equal(await page.locator('#now').textContent(), stood, 'nothing goes on');
  await page.click('#pause');
  await until('it goes on', async () => await page.locator('#now').textContent() !== stood);

  await speed(page, '1×');
  await until('as fast as time', async () => /· (0\.[89]|1\.[012])×/.test(await state(page).textContent()));
  await page.getByLabel('mode', { exact: true }).selectOption('AUTO');
  await state(page).getByText('armed · AUTO').waitFor();
  assert.ok(await height_m(page) > 30, 'it is in the air');
  await page.waitForTimeout(600);
  await assertAccessible(page);
  await page.screenshot({ path: join(SHOTS, 'live_served.png') });
  assert.equal(await flight.stop(), 0, flight.said);
  await page.getByText('The flight has ended: served flight: ended in the air').waitFor();
  page.faults.length = 0;  // that the stream has gone is one
}));

test('a mission that is watched is drawn as the board holds it, with the airplane on its way', () => served(async (page, flight) => {
  await speed(page, '10×');
  await says(page, 'reached item 4');
  await page.getByLabel('inject a fault').selectOption('gps:lost');
  await says(page, 'GPS lost: dead reckoning');
  await page.getByLabel('end a fault').selectOption('gps:lost');
  await says(page, 'reached item 8');
  await speed(page, '1×');
  const { plan } = flight.stream.got.flight.at(-1);
  const placed = plan.items.filter(({ index, lat_deg }) => index > 0 && lat_deg !== undefined);
  assert.ok(placed.length > 5, `${placed.length} places`);
  const names = await page.locator('#map .place').allTextContents();
  for (const { index } of placed) assert.ok(names.some((name) => name.split(' ')[0] === String(index)), `${index} of ${names}`);
  assert.ok(await height_m(page) > 20, 'it is in the air');
  const [map, airplane] = [await page.locator('#map').boundingBox(), await page.locator('.airplane').boundingBox()];
  assert.ok(airplane.x > map.x && airplane.x + airplane.width < map.x + map.width && airplane.y > map.y && airplane.y + airplane.height < map.y + map.height,
    'the airplane is on the map');
  await page.waitForTimeout(1500);
  await page.screenshot({ path: join(SHOTS, 'live_air.png') });
}, [...kWatch, '--wind', '5,320', '--gusts']));

test('every mode and fault that the simulator offers can be chosen', () => served(async (page, flight) => {
  const { offers } = await flight.stream.until('flight');
  const names = (label) => page.getByLabel(label, { exact: true }).locator('option[value]:not([value=""])').evaluateAll((all) => all.map(({ value }) => value));
  assert.deepEqual(await names('mode'), offers.modes);
  assert.deepEqual(await names('inject a fault'), offers.faults);
  for (const name of ['ACRO', 'TRAINING']) assert.ok(offers.modes.includes(name), name);
  for (const name of ['supply:cut', 'i2c:sda_low']) assert.ok(offers.faults.includes(name), name);
}));

// The stick that the test moves, as a browser shows a gamepad of four axes.
function gamepad() {
  globalThis.stickRoll = 0;
  globalThis.navigator.getGamepads = () => [null, { connected: true, axes: [0, -0.4, globalThis.stickRoll, 0], buttons: [], id: 'two sticks', index: 1, mapping: 'standard', timestamp: 0 }];
}

test('a gamepad banks the airplane', () => served(async (page) => {
  await takeOff(page);
  await speed(page, '1×');
  await page.getByLabel('mode', { exact: true }).selectOption('FBWA');
  await state(page).getByText('armed · FBWA').waitFor();
  await page.click('#sticks');
  const roll_deg = async () => parseFloat(await shown(page, 'roll_deg'));
  for (const side of [1, -1]) {
    await page.evaluate((roll) => { globalThis.stickRoll = roll; }, 0.8 * side);
    await until(`banked to the ${side > 0 ? 'right' : 'left'}`, async () => await roll_deg() * side > 20);
  }
  await page.evaluate(() => { globalThis.stickRoll = 0.04; });
  await until('level again, as the middle of a stick is wide', async () => Math.abs(await roll_deg()) < 8);
}, kServe, gamepad));

test('keys bank the airplane, and the throttle begins where its stick is, on a page that is opened again, too', () => served(async (page) => {
  await takeOff(page);
  await speed(page, '1×');
  await page.getByLabel('mode', { exact: true }).selectOption('FBWA');
  await state(page).getByText('armed · FBWA').waitFor();
  const inputs = () => page.locator('#groups [data-group="rc"]').click();
  const throttle_us = async () => parseFloat(await shown(page, 'rc3_us'));
  await inputs();
  await page.click('#sticks');
  await page.keyboard.down('w');
  await until('more throttle', async () => await throttle_us() > 1500);
  await page.keyboard.up('w');

  await page.reload();
  await page.locator('.u-over[data-group="height"]').waitFor();
  await inputs();
  await until('heard again', async () => await throttle_us() > 1500);
  await page.click('#sticks');
  await page.keyboard.down('ArrowLeft');
  await until('banked to the left', async () => parseFloat(await shown(page, 'roll_deg')) < -20);
  assert.ok(await throttle_us() > 1500, `${await throttle_us()} us`);
  await page.keyboard.up('ArrowLeft');
}));
