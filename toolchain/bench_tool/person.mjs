// SPDX-License-Identifier: GPL-3.0-or-later
// The person at the bench: asked for one action at a time. Any question may be answered with one of
// kWords instead.
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

import { Refusal } from '../flash_tool/refusal.mjs';
import { NotDone, NotFitted, NotMeasured, Stopped } from './errors.mjs';

export const kWords = `Enter: done. skip: leave this part out. none: the airplane has no such thing.
fail REASON: it does not work. remark TEXT: for the form. quit: end, to be resumed later.`;

// A number with a point or a comma, its unit behind it or not; undefined when it is none.
export function numberOf(text, unit) {
  const match = /^([+-]?\d+(?:[.,]\d+)?)\s*(\S*)$/.exec(text.trim());
  if (!match || (match[2] !== '' && match[2].toLowerCase() !== unit.toLowerCase())) return undefined;
  return Number(match[1].replace(',', '.'));
}

// `reply(id, question)` gives the line that the person types, undefined at the end of the input.
export class Person {
  constructor(reply, print) {
    this.reply = reply;
    this.print = print;
    this.remarks = [];
  }

  // What was typed, when it is none of kWords.
  async line(id, question, { fits = true } = {}) {
    for (;;) {
      const typed = await this.reply(id, question);
      if (typed === undefined) throw new Stopped();
      const [word, ...rest] = String(typed).trim().split(/\s+/);
      const more = rest.join(' ');
      if (word === 'quit') throw new Stopped();
      if (word === 'skip') throw new NotDone(more || 'left out');
      if (word === 'none' && fits) throw new NotFitted(more || 'the airplane has none');
      if (word === 'fail') throw new NotMeasured(more || 'seen to fail');
      if (word !== 'remark') return String(typed).trim();
      this.remarks.push(more);
      this.print('  noted');
    }
  }
  async action(id, text) {
    await this.line(id, `${text}\n  [Enter] `);
  }
  // A reading of a meter; asked again until it is a number that such a meter can show.
  async number(id, text, { unit, low, high }) {
    for (;;) {
      const value = numberOf(await this.line(id, `${text}\n  reading in ${unit}: `), unit);
      if (value !== undefined && value >= low && value <= high) return value;
      this.print(`  a number in ${unit}, ${low} to ${high}, please`);
      if (this.scripted) throw new Refusal(`the answer to ${id} is no number in ${unit} from ${low} to ${high}`);
    }
  }
  // A byte as avrdude prints it.
  async byte(id, text) {
    for (;;) {
      const [, digits] = /^(?:0x)?([0-9a-f]{1,2})$/i.exec(await this.line(id, `${text}\n  value: `)) ?? [];
      if (digits) return `0x${digits.toUpperCase().padStart(2, '0')}`;
      this.print('  a byte in hexadecimal, please, such as 0xFF');
      if (this.scripted) throw new Refusal(`the answer to ${id} is no byte`);
    }
  }
  // Only the very words count.
  async confirms(id, text, words) {
    return await this.line(id, `${text}\n  type "${words}": `, { fits: false }) === words;
  }
}

export function atTerminal(input, output, stop) {
  const lines = [], waiting = [];
  const reader = createInterface({ input, terminal: false });
  let ended = false;
  reader.on('line', (line) => { if (waiting.length > 0) waiting.shift()(line); else lines.push(line); });
  reader.on('close', () => { ended = true; for (const each of waiting.splice(0)) each(undefined); });
  stop.onStop(() => { for (const each of waiting.splice(0)) each(undefined); });
  const reply = (id, question) => {
    output.write(question);
    if (lines.length > 0 || ended || stop.stopped) return Promise.resolve(stop.stopped ? undefined : lines.shift());
    return new Promise((resolve) => { waiting.push(resolve); });
  };
  const person = new Person(reply, (line) => output.write(`${line}\n`));
  person.close = () => reader.close();
  return person;
}

// --answers: a JSON object, from the name of a question to what would be typed; "*" for the others.
export function fromFile(path, output) {
  let answers;
  try {
    answers = JSON.parse(readFileSync(path, 'utf8'));
  } catch (error) {
    throw new Refusal(`${path} cannot be used: ${error.code ?? 'it is no JSON'}`);
  }
  if (answers === null || typeof answers !== 'object' || Array.isArray(answers))
    throw new Refusal(`${path} is no object of answers`);
  const person = new Person((id, question) => {
    const answer = answers[id] ?? answers['*'];
    if (answer === undefined) throw new Refusal(`${path} has no answer to ${id}`);
    output.write(`${question}${answer}\n`);
    return Promise.resolve(String(answer));
  }, (line) => output.write(`${line}\n`));
  person.scripted = true;
  person.close = () => {};
  return person;
}
