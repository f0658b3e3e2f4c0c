// SPDX-License-Identifier: GPL-3.0-or-later
// What a campaign document of chaos says about a known bug.

// { seed, line } of the first flight in which one of these invariants failed, and how.
export function foundIn({ flights }, names) {
  for (const { seed, violations } of flights) {
    const violation = violations.find(({ name }) => names.includes(name));
    if (violation) return { seed, line: `${violation.name}: ${violation.numbers}` };
  }
  return undefined;
}

export function verdictOf({ name, violates }, { flights, found }) {
  if (!found) return `${name}  not found in ${flights} flights (${violates.join(', ')})`;
  return `${name}  found after ${flights} flights, seed ${found.seed}: ${found.line}`;
}
