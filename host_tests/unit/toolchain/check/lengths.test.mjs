// SPDX-License-Identifier: GPL-3.0-or-later
// Which functions toolchain/check/lengths.mjs finds, how long it says they are, and what it refuses.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { exceeded, figuresOf, functionsIn, kLimits } from '../../../../toolchain/check/lengths.mjs';

test('functions in namespaces and classes, with the lines of their declaration', () => {
  const source = `namespace a {
struct Row {
    int first;
    bool valid() const { return first > 0; }
};
constexpr Row kRows[] = {{1}, {2}};
static void none() {}

template <class T>
T twice(T value,
        int more) {
    if (more) {
        return value;
    }
    return value + value;
}
}  // namespace a
`;
  assert.deepEqual(functionsIn(source),
    [{ line: 4, length: 1 }, { line: 7, length: 1 }, { line: 9, length: 8 }]);
});

test('members that a constructor initialises with braces belong to it, and so does a lambda', () => {
  const source = `class Port {
public:
    explicit Port(int a)
        : a_{a}, b_{} {
        each([](int x) { return x; });
    }
private:
    int a_, b_;
};
`;
  assert.deepEqual(functionsIn(source), [{ line: 3, length: 4 }]);
});

test('comments, texts, enums and declarations are no functions', () => {
  assert.deepEqual(functionsIn('// void f() {}\nenum class E { a, b };\nvoid g();\nauto s = "void h() {}";\n'), []);
});

test('median, ninth decile and longest', () => {
  assert.deepEqual(figuresOf([9, 1, 2, 3, 4, 5, 6, 7, 8, 40]), { count: 10, median: 5, p90: 9, max: 40 });
});

test('each limit is held', () => {
  assert.deepEqual(exceeded(kLimits), []);
  for (const name of Object.keys(kLimits))
    assert.deepEqual(exceeded({ ...kLimits, [name]: kLimits[name] + 1 }), [name]);
});
