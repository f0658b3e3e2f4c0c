// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the .mjs files; toolchain/check_scripts runs ESLint with them.
import js from '@eslint/js';

// What node 18 offers without an import, as far as it is used.
const globals = ['AbortController', 'AbortSignal', 'Buffer', 'URL', 'clearInterval', 'clearTimeout', 'console',
  'performance', 'process', 'setImmediate', 'setInterval', 'setTimeout', 'structuredClone', 'TextDecoder', 'TextEncoder'];

// Of what a browser runs for a test.
const inBrowser = ['atob', 'DataTransfer', 'document', 'File', 'innerWidth', 'requestAnimationFrame'];

const readonly = (names) => Object.fromEntries(names.map((name) => [name, 'readonly']));

export default [
  js.configs.recommended,
  {
    files: ['**/*.mjs'],
    languageOptions: {
      ecmaVersion: 2022,
      sourceType: 'module',
      globals: readonly(globals),
    },
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      'array-callback-return': 'error',
      eqeqeq: 'error',
      'no-regex-spaces': 'off',  // columns of a table are matched as they are printed
      'no-self-compare': 'error',
      'no-shadow': 'error',
      'no-template-curly-in-string': 'error',
      'no-throw-literal': 'error',
      'no-unreachable-loop': 'error',
      'no-unused-expressions': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
    },
  },
  { files: ['**/host_tests/web/*.mjs', '**/host_tests/support/browser.mjs'], languageOptions: { globals: readonly(inBrowser) } },
];
