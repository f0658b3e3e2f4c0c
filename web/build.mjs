// SPDX-License-Identifier: GPL-3.0-or-later
// node web/build.mjs PAGE... FOLDER: makes FOLDER/PAGE.html (page: of a flight; campaign), one file
// that needs nothing else. The tools put a document where its placeholder is.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const kEntries = { page: ['src/main.ts', ['src/style.css']], campaign: ['src/campaign/main.ts', ['src/style.css', 'src/campaign/style.css']] };
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

// Packed the code is a third as large, and every report holds it. What runs first unpacks it.
const packed = (code) => `(async () => {
  const bytes = Uint8Array.from(atob('${deflateRawSync(code, { level: 9 }).toString('base64')}'), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const script = document.createElement('script');
  script.textContent = await new Response(stream).text();
  document.body.append(script);
})()`;

// Of the libraries' styles without the images, which the page does not use.
const withoutImages = (css) => css.replace(/background-image:\s*url\([^)]*\);?/g, '').replace(/url\((?!data:)[^)]*\)/g, 'none');

async function build(page, folder) {
  const { build: bundle, transform } = await esbuild();
  const [entry, styles] = kEntries[page];
  const made = await bundle({
    entryPoints: [join(here, entry)], bundle: true, minify: true, format: 'iife', target: 'es2022',
    write: false, legalComments: 'eof', logLevel: 'warning', charset: 'utf8',
  });
  const css = [...kLibraryStyles[page].map((file) => withoutImages(read(`node_modules/${file}`))), ...styles.map(read)].join('\n');
  const style = (await transform(css, { loader: 'css', minify: true, charset: 'utf8' })).code;
  const html = read(`src/${page === 'page' ? 'page' : 'campaign/campaign'}.html`)
    .replace('/*STYLE*/', () => style).replace('/*SCRIPT*/', () => packed(made.outputFiles[0].text));
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
