// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a flight of the image against that of the same flight natively compiled: the same messages in the same order.
// LOG_TOOL names the program, IMAGE_FLASH and NATIVE_FLASH the contents of their DataFlash.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

const { LOG_TOOL, IMAGE_FLASH, NATIVE_FLASH } = process.env;

// The bootloader clears what the chip knows of the reset; natively there is none.
const kCause = /(CPU: started by) .*/;
// What the tool's summary lists behind the times: "MSG   Throttle armed".
function listed(flash) {
  const summary = execFileSync(LOG_TOOL, ['summary', flash], { encoding: 'utf8' });
  return [...summary.matchAll(/\d s {2}((MSG|EV|ERR|MODE) .*)$/gm)].map(([, line, kind]) => ({ kind, line: line.replace(kCause, '$1') }));
}
const [image, native] = [IMAGE_FLASH, NATIVE_FLASH].map(listed);
const of = (all, kind) => all.filter((each) => each.kind === kind).map(({ line }) => line);

for (const kind of ['MSG', 'EV', 'ERR', 'MODE']) {
  test(`${kind} comes in the same order`, () => {
    assert.ok(of(image, kind).length > 0);
    assert.deepEqual(of(native, kind), of(image, kind));
  });
}

test('the log begins alike, and all that is listed comes in the same order', () => {
  assert.ok(image.length >= 20, `${image.length} messages`);
  assert.match(image[0].line, /^MSG +ArduPilotMega autopilot/);
  assert.deepEqual(native.map(({ line }) => line), image.map(({ line }) => line));
});
