// SPDX-License-Identifier: GPL-3.0-or-later
// The committed C++ definitions against npm mavlink-mappings and against themselves.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { registry } from '../../support/node_mavlink.mjs';

const root = new URL('../../../', import.meta.url);

const header = readFileSync(new URL('libraries/mavlink/messages.hpp', root), 'utf8');

// Every message as the C++ compiler will see it.
function structs() {
  const pattern = new RegExp('struct __attribute__\\(\\(packed\\)\\) (\\w+) \\{\\n([^}]*)\\};\\n' +
    'template <>\\nstruct Wire<\\1> : Shape<(\\d+), (\\d+), (\\d+), (\\d+)> \\{\\};\\n' +
    'static_assert\\(sizeof\\(\\1\\) == Wire<\\1>::length_with_extensions, "(\\w+)"\\);', 'g');
  return [...header.matchAll(pattern)].map(([, , body, id, length, full, seed, name]) => ({
    name, id: +id, length: +length, full: +full, crcExtra: +seed,
    fields: body.split('// extensions')[0].split('\n')
      .map((line) => /^ {4}(\w+) (\w+)(?:\[(\d+)\])?;$/.exec(line))
      .filter(Boolean)
      .map(([, type, field, count]) => ({ type, name: field, count: +(count ?? 0) })),
  }));
}

function crc16(bytes, crc = 0xffff) {
  for (const byte of bytes) {
    let t = byte ^ (crc & 0xff);
    t = (t ^ (t << 4)) & 0xff;
    crc = ((crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4)) & 0xffff;
  }
  return crc;
}

// https://mavlink.io/en/guide/serialization.html#crc_extra
function crcExtra({ name, fields }) {
  let crc = crc16(Buffer.from(`${name} `));
  for (const field of fields) {
    crc = crc16(Buffer.from(`${field.type} ${field.name} `), crc);
    if (field.count) crc = crc16([field.count], crc);
  }
  return (crc & 0xff) ^ (crc >> 8);
}

test('the checksum routine gives the published check value', () => {
  assert.equal(crc16(Buffer.from('123456789')), 0x6f91);
});

for (const [program, what] of [['generate', 'the header'], ['document', 'the manual']])
  test(`${what} is what its generator writes`, () => {
    const path = fileURLToPath(new URL(`toolchain/mavlink/${program}.mjs`, root));
    const run = spawnSync(process.execPath, [path, '--check'], { encoding: 'utf8' });
    assert.equal(run.status, 0, run.stderr);
  });

test('every message of the list is in the header', () => {
  const list = JSON.parse(readFileSync(new URL('toolchain/mavlink/messages.json', root), 'utf8'));
  assert.deepEqual(structs().map(({ name }) => name).sort(), [...list.messages].sort());
});

test('crc_extra follows from the name and the fields of each struct', () => {
  for (const message of structs()) assert.equal(message.crcExtra, crcExtra(message), message.name);
});

test('ids, lengths and crc_extra are those of the independent client', () => {
  for (const message of structs()) {
    const type = registry[message.id];
    assert.equal(type.MSG_NAME, message.name);
    assert.equal(type.MAGIC_NUMBER, message.crcExtra, message.name);
    const last = type.FIELDS[type.FIELDS.length - 1];
    assert.equal(last.offset + last.size * (last.length || 1), message.full, message.name);
    const base = type.FIELDS.filter((field) => !field.extension).pop();
    assert.equal(base.offset + base.size * (base.length || 1), message.length, message.name);
  }
});
