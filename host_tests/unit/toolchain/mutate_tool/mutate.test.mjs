// SPDX-License-Identifier: GPL-3.0-or-later
// toolchain/mutate: what it would change in a text and what it leaves alone, what becomes of a
// mutation, and what a user is answered.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpus } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { codeOf } from '../../../../toolchain/mutate_tool/code.mjs';
import { compileLine, headersOf, linkLine, stepsOf } from '../../../../toolchain/mutate_tool/direct.mjs';
import { readOptions } from '../../../../toolchain/mutate_tool/main.mjs';
import { mutated, mutationsIn, sample } from '../../../../toolchain/mutate_tool/mutations.mjs';
import { Interrupted, Runner, filterOf, inOrder, objectsWith, unitPrograms } from '../../../../toolchain/mutate_tool/programs.mjs';
import { outcomeOf, summaryOf } from '../../../../toolchain/mutate_tool/trial.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../../..');
const after = (text) => mutationsIn(text).map((mutation) => mutated(text, mutation)).sort();

for (const [before, ...wanted] of [
  ['a < b;', 'a <= b;', 'a >= b;'],
  ['a <= b;', 'a < b;', 'a > b;'],
  ['a > b;', 'a <= b;', 'a >= b;'],
  ['a >= b;', 'a < b;', 'a > b;'],
  ['a == b;', 'a != b;'],
  ['a != b;', 'a == b;'],
  ['a && b || c;', 'a && b && c;', 'a || b || c;'],
  ['a + b - c;', 'a + b + c;', 'a - b - c;'],
  ['a += b;', 'a -= b;'],
  ['a -= b;', 'a += b;'],
  ['return -x;', 'return x;'],
  ['f(-x, -y);', 'f(-x, y);', 'f(x, -y);'],
  ['a ? -b : c;', 'a ? b : c;'],
  ['x = !ready;', 'x = ready;'],
  ['x = true;', 'x = false;'],
  ['f(false);', 'f(true);'],
  ['++i;', '--i;'],
  ['i--;', 'i++;'],
  ['x = 25;', 'x = 0;', 'x = 100;'],
  ["x = 10'000UL;", 'x = 0UL;', 'x = 40000UL;'],
  ['x = 0x1F;', 'x = 0;', 'x = 0x7c;'],
  ['x = 0.3f;', 'x = 0.0f;', 'x = 1.2f;'],
  ['x = 2.5f;', 'x = 0.0f;', 'x = 10.0f;'],
  ['x = 1e-7f;', 'x = 0.0f;', 'x = 4e-7f;'],
  ['if (a) b();', 'if (!(a)) b();'],
  ['if (f(x)) return;', 'if (!(f(x))) return;', 'if (false && (f(x))) return;'],
  ['if (a == b) return c;', 'if (a != b) return c;', 'if (false && (a == b)) return c;'],
  ['if (a == b)\n  continue;', 'if (a != b)\n  continue;', 'if (false && (a == b))\n  continue;'],
  ['if (a == b) c();', 'if (a != b) c();'],
]) test(`mutations of ${JSON.stringify(before)}`, () => assert.deepEqual(after(before), wanted.sort()));

for (const text of [
  'x = 0;', 'x = 0.0f;', 'x = 5_m;', 'x1 = y2;', 'x = 010;',
  '// a < b && c == 1\n', 'f(); // a + 1\n', '/* a < 1\n b == 2 */', 'f("a < 1, -b");', 'f("\\" < 1");', "f('<', '1');",
  '#include <vector>\n', '#define A 1 + \\\n  2\n', '  #if A == 1\n',
  'static_assert(sizeof(a) == 4, "x");', 'f(STATUS_TEXT(a + b));', 'constexpr char kName[16] ROM = "a";', 'bool on : 1;',
  'template <class T> void f(T&& t);', 'std::vector<int> a;', 'p->x;', 'a << b;', 'a >> b;', 'auto&& x = y;',
  'if (const auto x = f()) return;', 'R"(a < 1)";',
]) test(`nothing is changed in ${JSON.stringify(text)}`, () => assert.deepEqual(after(text), []));

test('digit separators do not begin a character, and what is behind them is still code', () => {
  assert.equal(codeOf("x = 1'000'000; // c"), "x = 1'000'000;     ");
  assert.ok(after("x = 1'000 + y;").includes("x = 1'000 - y;"));
});

test('a mutation names its line, with the text before and after', () => {
  const [first] = mutationsIn('// a < b\n\n    return a < b;\n');

  assert.deepEqual([first.line, first.before, first.after], [3, 'return a < b;', 'return a <= b;']);
  assert.ok(mutationsIn('  if (a == b) return;').some(({ after: text }) => text === '(guard deleted)'));
});

test('every mutation keeps the number of lines and changes the text', () => {
  const text = 'int f(int a) {\n  // 5\n  if (a < 3 && !done)\n    return -4;\n  return a + 1;\n}\n';
  const all = mutationsIn(text).map((mutation) => mutated(text, mutation));

  assert.ok(all.length >= 12, String(all.length));
  assert.equal(new Set(all).size, all.length);
  for (const each of all) {
    assert.notEqual(each, text);
    assert.equal(each.split('\n').length, text.split('\n').length);
  }
});

test('a sample is the same for the same seed, in order, without repetition', () => {
  const all = [...Array(100).keys()], ten = sample(all, 10, 1);

  assert.deepEqual(ten, sample(all, 10, 1));
  assert.notDeepEqual(ten, sample(all, 10, 2));
  assert.deepEqual(ten, [...new Set(ten)].sort((a, b) => a - b));
  assert.equal(ten.length, 10);
  assert.deepEqual(sample(all, Infinity, 3), all);
});

// Programs a, b of which `built` says whether they compile, whether they are as before and what
// their test does.
function rig(built) {
  const ran = [];
  const runner = {
    builds: async (name) => built[name] !== 'broken',
    hashOf: (name) => (built[name] === 'as before' ? 'before' : 'other'),
    test: async (name) => {
      ran.push(name);
      return { passes: { status: 0, late: false }, fails: { status: 1, late: false },
        hangs: { status: null, late: true }, 'not linked': { unlinked: true }, crashes: { status: null, late: false } }[built[name]];
    },
  };
  const names = Object.keys(built);
  return { ran, runner, programs: names.map((name) => ({ name, limit_s: 1 })),
    hashes: new Map(names.map((name) => [name, 'before'])) };
}

for (const [built, outcome, run] of [
  [{ a: 'passes', b: 'fails' }, 'killed', ['a', 'b']],
  [{ a: 'fails', b: 'passes' }, 'killed', ['a']],
  [{ a: 'crashes' }, 'killed', ['a']],
  [{ a: 'passes', b: 'passes' }, 'survived', ['a', 'b']],
  [{ a: 'as before', b: 'passes' }, 'survived', ['b']],
  [{ a: 'broken', b: 'fails' }, 'not compiled', []],
  [{ a: 'not linked', b: 'fails' }, 'not compiled', ['a']],
  [{ a: 'passes', b: 'hangs' }, 'timed out', ['a', 'b']],
  [{ a: 'as before', b: 'as before' }, 'the same program', []],
]) {
  test(`${JSON.stringify(built)}: ${outcome}`, async () => {
    const { ran, runner, programs, hashes } = rig(built);
    assert.equal(await outcomeOf(runner, programs, hashes), outcome);
    assert.deepEqual(ran, run);
  });
}

test('who kills is tried first the next time', async () => {
  const { ran, runner, programs, hashes } = rig({ a: 'passes', b: 'fails' });
  await outcomeOf(runner, programs, hashes);
  await outcomeOf(runner, programs, hashes);

  assert.deepEqual(ran, ['a', 'b', 'b']);
});

test('the summary counts each outcome, and says what was not tried', () => {
  const outcomes = ['killed', 'killed', 'survived', 'not compiled', 'timed out', 'the same program'];

  assert.equal(summaryOf(outcomes, 6, 6), '6 mutations: killed 2, survived 1, did not compile 1, timed out 1, ' +
    'compiled to the same program 1; noticed 75.0 % of 4');
  assert.match(summaryOf(['killed'], 30, 200), /^1 of 30 mutations tried \(a sample of 200\): killed 1,/);
});

test('a program that does not end is ended at its limit, with what it has started', async () => {
  const { status, late } = await new Runner(root, process.env).run('sh', ['-c', 'sleep 60 & sleep 60'], { limit_s: 0.2 });

  assert.deepEqual([status, late], [null, true]);
});

test('an interruption ends the program that runs, and no other one begins', async () => {
  const runner = new Runner(root, process.env), running = runner.run('sleep', ['60']);
  runner.stop();

  await assert.rejects(running, Interrupted);
  await assert.rejects(runner.run('true', []), Interrupted);
});

test('of the tests, only quick unit tests that need no file but their program', () => {
  const of = (name, labels, ...needs) => ({ name, properties: [{ name: 'LABELS', value: labels },
    { name: 'REQUIRED_FILES', value: needs }] });
  const tests = [of('a_test', ['unit', 'quick'], '/h/a_test'), of('b_test', ['unit', 'quick'], '/h/b_test', '/h/fly'),
    of('c_test', ['unit'], '/h/c_test'), of('help', ['unit', 'quick'], '/h/fly'), { name: 'layering' }];

  assert.deepEqual(unitPrograms({ tests }, '/h'), ['a_test']);
});

test('objects that include a header are found in what ninja knows', () => {
  const deps = 'a.o: #deps 2, deps mtime 1 (VALID)\n    /x/a.cpp\n    /x/a.hpp\n\n' +
    'b.o: #deps 1, deps mtime 1 (VALID)\n    /x/b.cpp\n\nc.o: #deps 1, deps mtime 1 (VALID)\n    ../../a.hpp\n';

  assert.deepEqual(objectsWith(deps, '/x/a.hpp', '/x/build/host'), ['a.o', 'c.o']);
});

test('the tests of the file itself come first, then the quick ones', () => {
  const programs = [['c_test', 2], ['b_test', 1], ['mission_test', 9], ['firmware_mission_test', 10]]
    .map(([name, seconds]) => ({ name, seconds }));

  assert.deepEqual(inOrder(programs, 'libraries/mission/record.cpp').map(({ name }) => name),
    ['mission_test', 'b_test', 'c_test']);
  assert.deepEqual(inOrder(programs, 'firmware/mission/item.cpp').map(({ name }) => name),
    ['firmware_mission_test', 'b_test', 'c_test']);
});

test('tests that take long are left out when they are not of the folder of the file', () => {
  const programs = [{ name: 'x_test', seconds: 6 }, { name: 'core_test', seconds: 7 }, { name: 'a_test', seconds: 4 }];
  const names = (file, few = programs) => inOrder(few, file).map(({ name }) => name);

  assert.deepEqual(names('libraries/core/a.cpp'), ['core_test', 'a_test']);
  assert.deepEqual(names('libraries/geo/a.cpp'), ['a_test']);
  assert.deepEqual(names('libraries/geo/a.cpp', programs.slice(0, 1)), ['x_test'], 'rather than none');
});

test('of a program that takes more than a second, the tests of the file itself come first', () => {
  const filter = filterOf('TEST(Item, IsRead) {\n}\nTEST_P(\n    Items, AreRead) {}\n// TEST(None, Here)\n');
  const of = (seconds) => inOrder([{ name: 'core_test', seconds }], 'libraries/core/a.cpp', filter);

  assert.equal(filter, '--gtest_filter=Item.*:*/Item.*:Items.*:*/Items.*');
  assert.deepEqual(of(2).map(({ name, words }) => [name, words]), [['core_test', [filter]], ['core_test', undefined]]);
  assert.deepEqual(of(0.5).map(({ words }) => words), [undefined]);
  assert.equal(filterOf('int main() {}'), undefined);
});

const kCompile = 'ccache /usr/bin/c++ -I/x/t -Wall -Werror -std=gnu++17 -MD -MT d/a.cpp.o -MF d/a.cpp.o.d -o d/a.cpp.o -c /x/t/a.cpp';
const kLink = ': && /usr/bin/c++ -O2 d/b.o -o core_test lib.a -lm && :';

test('the source is compiled as the build does, to another object, warnings let pass, headers compiled before', () => {
  const steps = stepsOf(`cc -c other\n${kCompile}\nar lib.a d/a.cpp.o\n${kLink}\n`, '/x/t/a.cpp', 'core_test');

  assert.equal(steps.object, 'd/a.cpp.o');
  assert.equal(compileLine(steps.compile, '/j/a.cpp', '/j/a.o', '/j/h.hpp'),
    "/usr/bin/c++ -I/x/t -Wall -w -std=gnu++17 -include '/j/h.hpp' -o '/j/a.o' -c '/j/a.cpp'");
  assert.equal(stepsOf(`${kLink}\n`, '/x/t/a.cpp', 'core_test'), undefined);
  assert.equal(stepsOf(`${kCompile}\n: && cp a b && :\n`, '/x/t/a.cpp', 'core_test'), undefined);
});

test('the object takes the place of its original, or comes before the archive that has it', () => {
  const line = (link) => linkLine({ link, object: 'd/a.o' }, 'core_test', '/j/core_test', '/j/a.o', 'lld');

  assert.equal(line('c++ d/a.o d/b.o -o core_test lib.a'), "c++ '/j/a.o' d/b.o -o '/j/core_test' lib.a -fuse-ld=lld");
  assert.equal(line('c++ d/b.o -o core_test lib.a'), "c++ d/b.o -o '/j/core_test' '/j/a.o' lib.a -fuse-ld=lld");
});

test('headers are the #include lines before anything else', () => {
  assert.equal(headersOf('// a\n#include "a.hpp"\n\n#include <b>\n\nint x;\n#include "c.inc"\n'),
    '#include "a.hpp"\n#include <b>\n');
  assert.equal(headersOf('#define A\n#include "a.hpp"\n'), '');
});

test('options', () => {
  assert.deepEqual(readOptions(['a.cpp', '--at', '5-9', '--limit', '3', '--seed', '7', '--list']),
    { files: ['a.cpp'], at: { first: 5, last: 9 }, limit: 3, seed: 7, jobs: cpus().length, list: true });
  assert.equal(readOptions(['a.cpp', '--jobs', '3']).jobs, 3);
  assert.deepEqual(readOptions(['a.cpp', '--at', '5']).at, { first: 5, last: 5 });
});

const run = (...words) => spawnSync(process.execPath, [join(root, 'toolchain/mutate_tool/main.mjs'), ...words],
  { encoding: 'utf8', cwd: root });

for (const [what, words, says] of [
  ['no file', [], 'which file'],
  ['a file that is not there', ['firmware/none.cpp'], 'no such file'],
  ['no C++', ['README.md'], 'only .cpp and .hpp'],
  ['a file of elsewhere', ['/tmp/x.cpp'], 'no source of this project'],
  ['an option that is none', ['firmware/safety/arming.cpp', '--fast'], 'no option --fast'],
  ['a limit that is no number', ['firmware/safety/arming.cpp', '--limit', 'few'], '--limit needs a number'],
  ['lines in the wrong order', ['firmware/safety/arming.cpp', '--at', '9-5'], '--at needs'],
  ['lines of two files', ['firmware/safety/arming.cpp', 'firmware/app/tasks.cpp', '--at', '9'], 'one FILE'],
  ['lines that are not there', ['firmware/safety/arming.cpp', '--at', '99999'], 'nothing there'],
]) {
  test(`${what}: one line and exit status 2`, () => {
    const { status, stdout, stderr } = run(...words);
    assert.equal(status, 2);
    assert.equal(stdout, '');
    assert.match(stderr, /^mutate: .*\n$/);
    assert.ok(stderr.includes(says), stderr);
  });
}

test('a list names every mutation of the lines asked for, and nothing is built', () => {
  const { status, stdout } = run('firmware/safety/arming.cpp', '--list', '--limit', '5');
  assert.equal(status, 0);
  assert.equal(stdout.trimEnd().split('\n').length, 5);
  for (const line of stdout.trimEnd().split('\n')) assert.match(line, /^firmware\/safety\/arming\.cpp:\d+: .+ {2}-> {2}.+$/);
});
