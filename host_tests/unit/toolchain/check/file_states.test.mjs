// SPDX-License-Identifier: GPL-3.0-or-later
// Which variables toolchain/check/file_states.mjs finds, and which it passes over.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { looseVariables } from '../../../../toolchain/check/file_states.mjs';

const inFile = (text) => `namespace firmware {\nnamespace {\n${text}\n}\n}\n`;

for (const loose of [
  'uint8_t next;', 'bool a, b;', 'float by = 1;', 'static uint16_t count{3};', 'Text texts[kTexts];', 'char text[9];',
  'struct { uint8_t at; } search;', 'struct Row { int a; } row = {1};', 'enum class Wish : uint8_t { none } wish;',
  'const Record* last;', 'alignas(256) core::Ring<128> ring;', 'mission::Sequencer engine(kTable, kHost, memory);',
  'void (*then)();', 'std::array<int, 2> pair = {f(1), 2};',
]) {
  test(`${loose} in a file is found`, () => assert.deepEqual(looseVariables(inFile(loose)), [3]));
}

for (const loose of ['static uint16_t reported;', 'static core::Vector3 known_mps{};', 'static const Row* row = kRows;']) {
  test(`${loose} in a function is found`, () =>
    assert.deepEqual(looseVariables(inFile(`void f(int a) {\n    if (a) {\n        ${loose}\n    }\n}`)), [5]));
}

for (const fine of [
  'core::FileState<Shutter> shutter{};', 'core::FileState<Sequencer> engine(Sequencer(kTable, kHost));',
  'constexpr uint8_t kRows = 3;', 'const Host host = {enter, leave};', 'constexpr Row kRows[] ROM = {{1}, {2}};',
  'const char* const kNames[] = {"a"};', 'Memory memory __attribute__((section(".noinit")));',
  'struct Row { uint8_t at; bool on = true; };', 'enum Bit : uint8_t { a, b };', 'class Row;', 'using Step = void (*)();',
  'float speed(const Row& row, uint8_t at);', 'template <class T>\nT twice(T a) { return a + a; }', 'void none() {}',
  '__attribute__((noinline)) bool send(Link& link) { return true; }', 'static_assert(sizeof(int) == 4, "int x;");',
  'Row find(uint8_t at) {\n    static constexpr Row kNone = {};\n    return static_cast<Row>(kNone);\n}', '// uint8_t a;',
]) {
  test(`${fine} is none`, () => assert.deepEqual(looseVariables(inFile(fine)), []));
}
