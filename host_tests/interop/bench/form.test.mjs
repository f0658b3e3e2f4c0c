// SPDX-License-Identifier: GPL-3.0-or-later
// The form of bench.session in a browser: one page, whole, readable, and one sheet of A4 to sign.
// FORM is its folder; a picture of it is left there.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { assertAccessible, launch, open } from '../../support/browser.mjs';

const folder = process.env.FORM;
const url = pathToFileURL(join(folder, 'form.html')).href;

async function withForm(options, body) {
  const browser = await launch();
  try {
    await body(await open(browser, url, options));
  } finally {
    await browser.close();
  }
}

test('the form shows 16 steps that have passed, asks for nothing else, and every cell fits', () => withForm({}, async (page) => {
  await page.screenshot({ path: join(folder, 'form.png'), fullPage: true });
  assert.deepEqual(page.faults, []);
  assert.deepEqual(page.requests, [url]);
  assert.equal(await page.textContent('.verdict'), 'passed');
  assert.deepEqual(await page.$$eval('section h2 span:first-child', (all) => all.map((each) => each.textContent)),
    Array.from({ length: 16 }, (_, i) => String(i + 1)));
  assert.deepEqual(await page.$$eval('section h2 span:last-child', (all) => [...new Set(all.map((each) => each.textContent))]), ['pass']);
  assert.deepEqual(await page.$$eval('td, dd', (all) => all.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.textContent)), []);
  await assertAccessible(page);
}));

test('on a telephone nothing is wider than the page', () => withForm({ width: 390, height: 844 }, async (page) => {
  assert.ok(await page.$eval('html', (all) => all.scrollWidth <= all.clientWidth));
}));

test('it prints on one sheet of A4', () => withForm({}, async (page) => {
  const sheet = await page.pdf({ preferCSSPageSize: true });
  writeFileSync(join(folder, 'form.pdf'), sheet);
  assert.equal([...sheet.toString('latin1').matchAll(/\/Type \/Page\b/g)].length, 1);
}));
