// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the pairs for today's texts and names, and says what they take.
import { kHeaders, packedSize, stored, write } from './pairs.mjs';

write();
for (const header of kHeaders) {
  const texts = header.texts(), pairs = stored(header);
  const letters = texts.reduce((sum, { length }) => sum + length, 0);
  console.log(`${header.file}: ${texts.length} texts, ${letters} letters are ${packedSize(texts, pairs)} codes and ${2 * pairs.length} B of pairs`);
}
