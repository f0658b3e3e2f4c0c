// SPDX-License-Identifier: GPL-3.0-or-later
// A standard output that takes nothing, as on a full disk, is one line and exit status 1; a reader
// that has read enough, as head does, ends the program quietly.
export function checkOutput(tool) {
  process.stdout.on('error', (error) => {
    if (error.code !== 'EPIPE')
      process.stderr.write(`${tool}: the standard output cannot be written: ${error.code}\n`);
    process.exit(1);
  });
}
