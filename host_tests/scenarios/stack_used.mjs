// SPDX-License-Identifier: GPL-3.0-or-later
// The stack's bound, reckoned from the image, against the deepest stack its flights have used.
//   node stack_used.mjs FIRMWARE.elf FLIGHT_FOLDER...
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { stackBound } from '../../toolchain/image/stack_bound.mjs';

const [image, ...folders] = process.argv.slice(2);
const bound = stackBound(image).bytes;
const used = folders.map(
  (folder) => JSON.parse(readFileSync(join(folder, 'summary.json'))).stack_max_bytes);
const deepest = Math.max(...used);
console.log(`bound ${bound} bytes, deepest of ${used.length} flights ${deepest}`);
// a bound far above the truth would be as useless as one below it
process.exit(deepest > 0 && deepest <= bound && bound <= 1.5 * deepest ? 0 : 1);
