// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the C++ side of the MAVLink messages this project speaks. Run after changing
// messages.json or the version of mavlink-mappings:
//   node toolchain/mavlink/generate.mjs           writes libraries/mavlink/
//   node toolchain/mavlink/generate.mjs --check   exit 1 when what is there differs
import { readFileSync, writeFileSync } from 'node:fs';
import { definitionsVersion, enums, messages } from './definitions.mjs';

const head = (about) => `// SPDX-License-Identifier: GPL-3.0-or-later
// ${about}
// Written by toolchain/mavlink/generate.mjs from mavlink-mappings ${definitionsVersion}. Do not edit.
#pragma once
`;

const typeName = (name) =>
  name.split('_').map((word) => word[0] + word.slice(1).toLowerCase()).join('');

const sizeOf = (fields) =>
  fields.reduce((sum, field) => sum + field.size * Math.max(field.count, 1), 0);

const keywords = new Set(['auto', 'default', 'float', 'int', 'static', 'switch', 'new', 'delete']);
function constantName(key) {
  const name = key.toLowerCase();
  return keywords.has(name) ? `${name}_` : name;
}

function width(entries) {
  const most = Math.max(...entries.map((entry) => entry.value));
  return most < 256 ? 'uint8_t' : most < 65536 ? 'uint16_t' : 'uint32_t';
}

function enumText({ name, entries }) {
  const type = width(entries);
  const suffix = type === 'uint32_t' ? 'UL' : '';
  const rows = entries.map(({ key, value }) => `        ${constantName(key)} = ${value}${suffix},\n`);
  return `struct ${name} {\n    enum : ${type} {\n${rows.join('')}    };\n};\n`;
}

const cppType = { float: 'float', double: 'double', char: 'char' };

function fieldText(field) {
  const type = cppType[field.type] ?? field.type;
  const array = field.count ? `[${field.count}]` : '';
  return `    ${type} ${field.name}${array};\n`;
}

function messageText(message) {
  const base = message.fields.filter((field) => !field.extension);
  const extensions = message.fields.filter((field) => field.extension);
  const name = typeName(message.name);
  if (message.id > 65535) throw new Error(`${message.name}: the id takes more than 16 bits`);
  let offset = 0;
  for (const field of message.fields) {
    if (field.offset !== offset) throw new Error(`${message.name}.${field.name} is not in wire order`);
    offset += sizeOf([field]);
  }
  const more = extensions.length ? `    // extensions: MAVLink 2 only\n${extensions.map(fieldText).join('')}` : '';
  return `struct __attribute__((packed)) ${name} {
${base.map(fieldText).join('')}${more}};
template <>
struct Wire<${name}> : Shape<${message.id}, ${sizeOf(base)}, ${sizeOf(message.fields)}, ${message.crcExtra}> {};
static_assert(sizeof(${name}) == Wire<${name}>::length_with_extensions, "${message.name}");
`;
}

function messagesHeader() {
  return `${head('Every message as a struct that is its payload: fields in wire order, little-endian.')}
#include <stdint.h>

#include "mavlink/wire.hpp"

// clang-format off
namespace mavlink {

${enums().map(enumText).join('\n')}
${messages().map(messageText).join('\n')}
}  // namespace mavlink
// clang-format on
`;
}

function allMessagesHeader() {
  const rows = messages().map((message) => `    accepts<${typeName(message.name)}>(),\n`);
  return `${head('The table of all messages, for a peer that wants to understand everything.')}
#include "core/rom.hpp"
#include "mavlink/messages.hpp"

// clang-format off
namespace mavlink {

constexpr Accepted kAllMessages[] ROM = {
${rows.join('')}};

}  // namespace mavlink
// clang-format on
`;
}

const outputs = {
  'messages.hpp': messagesHeader(),
  'all_messages.hpp': allMessagesHeader(),
};

const check = process.argv.includes('--check');
for (const [file, text] of Object.entries(outputs)) {
  const path = new URL(`../../libraries/mavlink/${file}`, import.meta.url);
  if (!check) {
    writeFileSync(path, text);
  } else if (readFileSync(path, 'utf8') !== text) {
    console.error(`libraries/mavlink/${file} is not what toolchain/mavlink/generate.mjs writes`);
    process.exitCode = 1;
  }
}
