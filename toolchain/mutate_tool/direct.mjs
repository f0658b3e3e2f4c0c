// SPDX-License-Identifier: GPL-3.0-or-later
// One source compiled, and the programs of its tests linked, without the build: that would look at
// every file and archive everything again. The headers of the source are compiled once, the linker
// is the quickest there is, and what the compiler makes of a mutation is compared before anything
// is linked.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { NotTried } from '../shared/checkout.mjs';

const quoted = (path) => `'${path.replaceAll("'", "'\\''")}'`;
const withoutCache = (line) => line.replace(/^\S*ccache /, '');

// { compile, object, link } of what ninja -t commands prints for a program and one of its sources,
// or undefined: the program is not built so.
export function stepsOf(commands, source, program) {
  const lines = commands.trimEnd().split('\n');
  const compile = lines.find((line) => line.endsWith(` -c ${source}`));
  const [, link] = /^: && (.*) && :$/.exec(lines.at(-1)) ?? [];
  const [, object] = / -o (\S+) -c \S+$/.exec(compile ?? '') ?? [];
  if (!object || !link?.includes(` -o ${program} `)) return undefined;
  return { compile: withoutCache(compile), object, link };
}

// The compiler's line with another source and object, the headers compiled before. Without warnings:
// a mutation that only deserves one is a mistake that can be made.
export function compileLine(compile, source, object, headers) {
  const plain = compile.replace(/ -MD -MT \S+ -MF \S+/, '').replace(/ -o \S+ -c \S+$/, '').replace(' -Werror', ' -w');
  const before = headers ? ` -include ${quoted(headers)}` : '';
  return `${plain}${before} -o ${quoted(object)} -c ${quoted(source)}`;
}

// The linker's line with the object in the place of the one it stands for, which may be in an
// archive: what comes before an archive is taken from there no more.
export function linkLine({ link, object }, program, to, mutant, linker) {
  const words = link.split(' ');
  const whole = words.includes(object)
    ? words.map((word) => (word === object ? quoted(mutant) : word)).join(' ')
    : link.replace(` -o ${program} `, ` -o ${program} ${quoted(mutant)} `);
  return whole.replace(` -o ${program} `, ` -o ${quoted(to)} `) + (linker ? ` -fuse-ld=${linker}` : '');
}

// The #include lines at the beginning of a source, before anything that could change them.
export function headersOf(text) {
  const lines = [];
  for (const line of text.split('\n')) {
    if (/^#include /.test(line)) lines.push(line);
    else if (!/^(\/\/.*|\s*)$/.test(line)) break;
  }
  return lines.length > 0 ? `${lines.join('\n')}\n` : '';
}

export const quickLinker = () =>
  ['lld', 'gold'].find((name) => spawnSync(`ld.${name}`, ['--version']).status === 0);

// Tries the mutations of one source in a folder of its own, so that several may at once.
export class Direct {
  constructor(runner, file, folder, linker = quickLinker()) {
    Object.assign(this, { runner, folder, linker });
    this.origin = join(runner.tree, file);
    this.source = join(folder, basename(file));
    this.steps = new Map();   // of each program
    this.objects = new Map(); // compiled since the source was written: true, or false
    mkdirSync(join(folder, 'tmp'), { recursive: true });
    this.env = { TMPDIR: join(folder, 'tmp'), TEST_TMPDIR: join(folder, 'tmp') };
  }
  write(text) {
    writeFileSync(this.source, text);
    this.objects.clear();
  }
  async stepsOf(name) {
    if (!this.steps.has(name)) {
      const commands = await this.runner.must('ninja', ['-C', this.runner.host, '-t', 'commands', name]);
      const steps = stepsOf(commands.replace(/^ninja: .*\n/, ''), this.origin, name);
      if (!steps) throw new NotTried(`the build of ${name} is not understood`);
      this.steps.set(name, steps);
    }
    return this.steps.get(name);
  }
  shell(line) { return this.runner.run('sh', ['-c', line], { cwd: this.runner.host }); }
  objectOf(steps) { return join(this.folder, steps.object.replaceAll('/', '_')); }
  async headersFor(steps) {
    const path = join(this.folder, `${steps.object.replaceAll('/', '_')}.hpp`);
    if (!existsSync(path)) {
      writeFileSync(path, headersOf(readFileSync(this.origin, 'utf8')));
      const line = compileLine(steps.compile, path, `${path}.gch`).replace(/ -c (\S+)$/, ' -x c++-header $1');
      await this.shell(line);  // without it, the header itself is included: slower, and the same
    }
    return path;
  }
  async builds(name) {
    const steps = await this.stepsOf(name), object = this.objectOf(steps);
    if (!this.objects.has(object)) {
      const headers = steps.compile.includes(' -include ') ? undefined : await this.headersFor(steps);
      const { status } = await this.shell(compileLine(steps.compile, this.source, object, headers));
      this.objects.set(object, status === 0);
    }
    return this.objects.get(object);
  }
  async hashOf(name) {
    const object = this.objectOf(await this.stepsOf(name));
    return createHash('sha256').update(readFileSync(object)).digest('hex');
  }
  async link(name) {
    const steps = await this.stepsOf(name);
    return this.shell(linkLine(steps, name, join(this.folder, name), this.objectOf(steps), this.linker));
  }
  // A program with a double of the source has everything of it twice, and is not linked with it.
  async uses(name) { return (await this.link(name)).status === 0; }
  async test(name, limit_s, words = []) {
    const { status, output } = await this.link(name);
    if (status !== 0) {
      console.error(`${name}: ${output.trim().split('\n')[0]}`);
      return { unlinked: true };
    }
    return this.runner.test(join(this.folder, name), limit_s, words, this.env);
  }
}
