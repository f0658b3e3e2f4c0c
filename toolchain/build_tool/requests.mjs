// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of toolchain/build ask for: one request a tree, since two builds of one tree at a
// time would overwrite each other's files.
import { kTrees } from './trees.mjs';

export class WrongUsage extends Error {}

function requestOf(word) {
  const [, tree, targets] = /^(\w+)(?::(.+))?$/.exec(word) ?? [];
  if (!kTrees.includes(tree)) throw new WrongUsage(`there is no tree ${word}: ${kTrees.join(', ')}`);
  return { tree, targets: targets?.split(',') ?? [] };
}

// A tree without targets is its target all, which leaves out what is only built by name.
export function requestsOf(words) {
  const byTree = new Map();
  for (const { tree, targets } of words.map(requestOf)) {
    const wanted = targets.length > 0 ? targets : ['all'];
    byTree.set(tree, [...new Set([...(byTree.get(tree) ?? []), ...wanted])]);
  }
  return [...byTree].map(([tree, targets]) => ({ tree, targets }));
}
