// SPDX-License-Identifier: GPL-3.0-or-later
// node web/build.mjs PAGE... FOLDER: makes FOLDER/PAGE.html (page: of a flight; campaign), one file
// that needs nothing else. The tools put a document where its placeholder is.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const kEntries = { page: ['src/main.ts', ['src/style.css']], campaign: ['src/campaign/main.ts', ['src/style.css', 'src/campaign/style.css']] };
// Packed apart: two thirds of the page's code are for what is shown last.
const kLater = { page: { id: 'attitude-code', entry: 'src/view/attitude.ts', name: 'attitudeView' } };
const kLibraryStyles = { page: ['leaflet/dist/leaflet.css', 'uplot/dist/uPlot.min.css'], campaign: ['uplot/dist/uPlot.min.css'] };

async function esbuild() {
  try {
    return await import('esbuild');
  } catch {
    console.error('web: the npm packages of web/ are not installed; run toolchain/setup fly');
    process.exit(1);
  }
}

const read = (file) => readFileSync(join(here, file), 'utf8');

// Packed the code is a third as large, and every report holds it. What is not needed at once stays
// packed until somebody calls unpack(ID OF ITS ELEMENT).
const pack = (code) => deflateRawSync(code, { level: 9 }).toString('base64');
const kUnpack = `async function unpack(id) {
  const packed = await fetch('data:;base64,' + document.getElementById(id).textContent);
  const script = document.createElement('script');
  script.textContent = await new Response(packed.body.pipeThrough(new DecompressionStream('deflate-raw'))).text();
  document.body.append(script);
}`;

// Of the libraries' styles without the images, which the page does not use.
const withoutImages = (css) => css.replace(/background-image:\s*url\([^)]*\);?/g, '').replace(/url\((?!data:)[^)]*\)/g, 'none');

async function bundled(entry, options = {}) {
  const { build: bundle } = await esbuild();
  const made = await bundle({
    entryPoints: [join(here, entry)], bundle: true, minify: true, format: 'iife', target: 'es2022',
    write: false, legalComments: 'eof', logLevel: 'warning', charset: 'utf8', ...options,
  });
  return made.outputFiles[0].text;
}

const packedScript = (id, code) => `<script type="text/plain" id="${id}">${pack(code)}</script>\n`;

async function scripts(page, entry) {
  const later = page in kLater ? packedScript(kLater[page].id, await bundled(kLater[page].entry, { globalName: kLater[page].name })) : '';
  return `${packedScript('code', await bundled(entry))}${later}<script>${kUnpack}\nunpack('code');</script>`;
}

async function build(page, folder) {
  const { transform } = await esbuild();
  const [entry, styles] = kEntries[page];
  const css = [...kLibraryStyles[page].map((file) => withoutImages(read(`node_modules/${file}`))), ...styles.map(read)].join('\n');
  const style = (await transform(css, { loader: 'css', minify: true, charset: 'utf8' })).code;
  const code = await scripts(page, entry);
  const html = read(`src/${page === 'page' ? 'page' : 'campaign/campaign'}.html`)
    .replace('/*STYLE*/', () => style).replace('<!--SCRIPTS-->', () => code);
  mkdirSync(folder, { recursive: true });
  const out = join(folder, `${page}.html`);
  writeFileSync(`${out}.new`, html);
  renameSync(`${out}.new`, out);
}

const words = process.argv.slice(2);
const folder = words.pop();
const pages = words;
if (!folder || pages.length === 0 || pages.some((page) => !kEntries[page])) {
  console.error('usage: node web/build.mjs page|campaign... FOLDER');
  process.exit(2);
}
for (const page of pages) await build(page, folder);
