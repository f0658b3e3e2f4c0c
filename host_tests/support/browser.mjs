// SPDX-License-Identifier: GPL-3.0-or-later
// Debian's Chromium for tests of the pages; CHROMIUM names another.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const web = join(dirname(fileURLToPath(import.meta.url)), '../../web');
const require = createRequire(join(web, 'package.json'));
const { chromium } = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const kTimeout_ms = 120_000;  // other programs may have the processor

// The page is drawn as on any computer without a graphics chip; WebGL has to be asked for there.
export const launch = () => chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
});

// What the busiest of the browser's processes has taken of the processor since: one runs the page, one draws the screen, at once.
export async function busiest(browser) {
  const session = await browser.newBrowserCDPSession();
  const times = async () => new Map((await session.send('SystemInfo.getProcessInfo')).processInfo.map(({ id, cpuTime }) => [id, cpuTime * 1000]));
  const begun = await times();
  return async () => Math.max(...[...await times()].map(([id, spent_ms]) => spent_ms - (begun.get(id) ?? 0)));
}

// A page whose errors and requests are kept: page.faults, page.requests.
export async function open(browser, url, { width = 1200, height = 800, dark = false, touch = false } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light', hasTouch: touch, isMobile: touch });
  context.setDefaultTimeout(kTimeout_ms);
  const page = await context.newPage();
  page.faults = [];
  page.requests = [];
  page.on('pageerror', (error) => page.faults.push(error.message));
  page.on('console', (message) => { if (message.type() === 'error') page.faults.push(message.text()); });
  page.on('request', (request) => { if (!/^(data|blob):/.test(request.url())) page.requests.push(request.url()); });
  await page.goto(url);
  return page;
}

// For up to five seconds, until it holds: other programs may have the processor.
export async function eventually(page, holds) {
  for (let i = 0; i < 100; ++i) {
    if (await holds()) return true;
    await page.waitForTimeout(50);
  }
  return holds();
}

// Fails with what axe finds, by rule and element.
export async function assertAccessible(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 160)).join(' | ')}`), []);
}
