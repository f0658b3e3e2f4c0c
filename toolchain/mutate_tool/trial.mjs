// SPDX-License-Identifier: GPL-3.0-or-later
// One mutation, and what becomes of it.

// 'killed', 'survived', 'not compiled', 'timed out' or 'the same program'. `builder` builds and
// runs the programs; one that is compiled to the same as without the mutation (`hashes`, by name)
// cannot fail and is not run. Who kills comes first the next time.
export async function outcomeOf(builder, programs, hashes) {
  let differs = false;
  for (const program of [...programs]) {
    const { name, limit_s, words } = program;
    if (!await builder.builds(name)) return 'not compiled';
    if (await builder.hashOf(name) === hashes.get(name)) continue;
    differs = true;
    const { status, late, unlinked } = await builder.test(name, limit_s, words);
    if (unlinked) return 'not compiled';
    if (status === 0 && !late) continue;
    programs.splice(programs.indexOf(program), 1);
    programs.unshift(program);
    return late ? 'timed out' : 'killed';
  }
  return differs ? 'survived' : 'the same program';
}

export const kOutcomes = ['killed', 'survived', 'not compiled', 'timed out', 'the same program'];

const kWords = { killed: 'killed', survived: 'survived', 'not compiled': 'did not compile',
  'timed out': 'timed out', 'the same program': 'compiled to the same program' };

// Of those that are another program, how many were noticed: rounded down, so that 100 % is all.
function scoreOf(count) {
  const noticed = count('killed') + count('timed out'), all = noticed + count('survived');
  return all === 0 ? '' : `; noticed ${(Math.floor(1000 * noticed / all) / 10).toFixed(1)} % of ${all}`;
}

export function summaryOf(outcomes, chosen, whole) {
  const count = (kind) => outcomes.filter((each) => each === kind).length;
  const counts = kOutcomes.map((kind) => `${kWords[kind]} ${count(kind)}`);
  const tried = outcomes.length < chosen ? `${outcomes.length} of ${chosen} mutations tried` : `${chosen} mutations`;
  return `${tried}${chosen < whole ? ` (a sample of ${whole})` : ''}: ${counts.join(', ')}${scoreOf(count)}`;
}
