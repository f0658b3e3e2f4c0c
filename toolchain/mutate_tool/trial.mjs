// SPDX-License-Identifier: GPL-3.0-or-later
// One mutation, and what becomes of it.

// 'killed', 'survived', 'not compiled', 'timed out' or 'the same program'. `runner` builds and runs
// the programs; one whose file is the same as without the mutation cannot fail and is not run.
// Who kills comes first the next time.
export async function outcomeOf(runner, programs) {
  let differs = false;
  for (const [place, program] of programs.entries()) {
    if (!await runner.builds(program.name)) return 'not compiled';
    if (runner.hashOf(program.name) === program.hash) continue;
    differs = true;
    const { status, late } = await runner.test(program.name, program.limit_s);
    if (status === 0 && !late) continue;
    programs.unshift(...programs.splice(place, 1));
    return late ? 'timed out' : 'killed';
  }
  return differs ? 'survived' : 'the same program';
}

export const kOutcomes = ['killed', 'survived', 'not compiled', 'timed out', 'the same program'];

const kWords = { killed: 'killed', survived: 'survived', 'not compiled': 'did not compile',
  'timed out': 'timed out', 'the same program': 'compiled to the same program' };

export function summaryOf(outcomes, chosen, whole) {
  const counts = kOutcomes.map((kind) => `${kWords[kind]} ${outcomes.filter((each) => each === kind).length}`);
  const tried = outcomes.length < chosen ? `${outcomes.length} of ${chosen} mutations tried` : `${chosen} mutations`;
  return `${tried}${chosen < whole ? ` (a sample of ${whole})` : ''}: ${counts.join(', ')}`;
}
