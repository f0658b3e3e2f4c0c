// SPDX-License-Identifier: GPL-3.0-or-later
// Which kind of airplane a flight was flown with, as far as its document knows.
import type { FlightDocument } from '../document';

// A log has its parameters, a simulated flight those that were changed and the airplane's name.
export function isFlyingWing({ provenance = {} }: FlightDocument): boolean {
  const { airplane, parameters } = provenance as { airplane?: string; parameters?: Record<string, number> };
  const mixed = parameters?.ELEVON_OUTPUT ?? 0;
  return mixed > 0 || /(^|[/_-])(flying_?)?wing[^/]*$/i.test(airplane ?? '');
}
