// SPDX-License-Identifier: GPL-3.0-or-later
// node npm.mjs FOLDER: puts npm itself into FOLDER/package, where the system has none. Debian's
// package of it brings 360 others and takes longer than all else that is installed.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { get as getHttp } from 'node:http';
import { get as getHttps } from 'node:https';
import { join } from 'node:path';

const kVersion = '10.9.4';  // for node 18.17 and later
const kIntegrity = 'sha512-OnUG836FwboQIbqtefDNlyR0gTHzIfwRfE3DuiNewBvnMnWEpB0VEXwBlFVgqpNzIgYo/MHh3d2Hel/pszapAA==';
const kTimeout_ms = 60_000;

function download(url) {
  return new Promise((resolve, reject) => {
    const get = url.startsWith('https:') ? getHttps : getHttp;
    const request = get(url, { timeout: kTimeout_ms }, (response) => {
      if (response.statusCode !== 200) return void reject(new Error(`${url}: status ${response.statusCode}`));
      const parts = [];
      response.on('data', (part) => parts.push(part));
      response.on('end', () => resolve(Buffer.concat(parts)));
      response.on('error', reject);
    });
    request.on('timeout', () => request.destroy(new Error(`${url}: no answer`)));
    request.on('error', reject);
  });
}

async function install(folder) {
  if (existsSync(join(folder, 'package/bin/npm-cli.js'))) return;
  const registry = (process.env.npm_config_registry ?? 'https://registry.npmjs.org/').replace(/\/*$/, '/');
  const bytes = await download(`${registry}npm/-/npm-${kVersion}.tgz`);
  const found = `sha512-${createHash('sha512').update(bytes).digest('base64')}`;
  if (found !== kIntegrity) throw new Error(`npm-${kVersion}.tgz is not what it should be`);
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `npm-${kVersion}.tgz`);
  writeFileSync(file, bytes);
  execFileSync('tar', ['-xzf', file, '-C', folder]);
}

try {
  await install(process.argv[2]);
} catch (error) {
  console.error(`npm could not be fetched (${error.message}); install it yourself, then once more`);
  process.exitCode = 1;
}
