// SPDX-License-Identifier: GPL-3.0-or-later
// Writes docs/registers.md: which registers the images of both boards write, what, and when, with the
// names that avr-libc's header has for the bits.
//   node toolchain/image/registers.mjs REGISTER_WRITES APM2.elf APM1.elf [--check]
// REGISTER_WRITES is the program of host_tests/scenarios; with --check nothing is written, and what
// differs ends it with status 1.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';

const kDocument = new URL('../../docs/registers.md', import.meta.url);
const kHeader = '/usr/lib/avr/include/avr/iomxx0_1.h';

// What goes through these is data: levels, bytes, times, addresses.
const kData = /^((PIN|PORT)[A-L]|GPIOR\d|SPDR|UDR\d|TWDR|EEDR|EEAR[LH]|TCNT\d[LH]?|OCR\d[ABC]?[LH]?|RAMPZ|EIND|SPL|SPH)$/;

// Chapters of the data sheet (2549), by the registers' names.
const kChapters = [
  [/^EE/, '8'], [/^(CLKPR|OSCCAL)$/, '10'], [/^(SMCR|PRR\d)$/, '11'], [/^(MCUSR|WDTCSR)$/, '12'],
  [/^(DDR[A-L]|MCUCR)$/, '13'], [/^(EI|PC)|^EIMSK$/, '15'], [/^(TCCR0|TIMSK0|TIFR0)/, '16'], [/^(TCCR|TIMSK|TIFR|ICR)[1345]/, '17'],
  [/^GTCCR$/, '18'], [/^(TCCR2|TIMSK2|TIFR2|ASSR)/, '20'], [/^SP[CS]R$/, '21'], [/^(UCSR|UBRR)/, '22, 23'],
  [/^TW/, '24'], [/^ACSR$/, '25'], [/^(AD|DIDR)/, '26'], [/^SPMCSR$/, '29'], [/^XMCR/, '9'],
];

// { address: { name, bits: [name of bit 0, ...] } }
function readHeader(path) {
  const registers = {};
  let last;
  for (const line of readFileSync(path, 'latin1').split('\n')) {
    const register = /^#\s*define\s+(\w+)\s+_SFR_(MEM8|IO8)\s*\((0x[0-9a-f]+)\)/i.exec(line);
    const bit = /^#\s*define\s+(\w+)\s+([0-7])\s*$/.exec(line);
    if (register) {
      const address = Number(register[3]) + (register[2].toUpperCase() === 'IO8' ? 0x20 : 0);
      last = registers[address] ??= { name: register[1], bits: [] };
    } else if (bit && last) last.bits[Number(bit[2])] ??= bit[1];
    else if (/_SFR_(MEM|IO)16/.test(line)) last = undefined;
  }
  return registers;
}

// { address: { start: [values], run: [values] } }
function writesOf(program, image, board) {
  const writes = {};
  const text = execFileSync(program, [image, board], { encoding: 'utf8' });
  for (const line of text.trim().split('\n')) {
    const [address, value, when] = line.split(' ');
    (writes[address] ??= { start: [], run: [] })[when].push(Number(value));
  }
  return writes;
}

function spelled(value, { name, bits }) {
  const hex = `\`0x${value.toString(16).padStart(2, '0')}\``;
  if (/^(DDR|UBRR|ICR|TWBR|OSCCAL)/.test(name)) return hex;
  const names = bits.filter((bit, i) => bit && value >> i & 1).reverse();
  return names.length > 0 ? `${hex} ${names.join(' ')}` : hex;
}

function cell(writes, register) {
  if (!writes) return '';
  const list = (values) => values.map((value) => spelled(value, register)).join('; ');
  return [writes.start.length > 0 && list(writes.start), writes.run.length > 0 && `*running* ${list(writes.run)}`]
    .filter(Boolean).join('; ');
}

function chapterOf(name) {
  const found = kChapters.find(([names]) => names.test(name));
  if (!found) throw new Error(`${name} is written, and kChapters does not know it`);
  return found[1];
}

function documentOf(program, images) {
  const registers = readHeader(kHeader);
  const [apm2, apm1] = ['apm2', 'apm1'].map((board, i) => writesOf(program, images[i], board));
  const rows = Object.keys({ ...apm2, ...apm1 }).map(Number).sort((a, b) => a - b)
    .map((address) => ({ address, register: registers[address] }))
    .filter(({ register }) => register && !kData.test(register.name))
    .map(({ address, register }) => `| 0x${address.toString(16).padStart(3, '0')} | ${register.name} | ${
      chapterOf(register.name)} | ${cell(apm2[address], register)} | ${cell(apm1[address], register)} |`);
  return `# What the images write to the chip's registers

Every value that an image gives to a register in its first three seconds on the emulated board, in the order in which
it comes first; after *running* those that came only after the first interrupt was let in. Behind each value stand the
bits that it sets, by the names of avr-libc's header, for comparing with the chapter of the data sheet (ATmega2560,
2549).
Registers through which data goes are left out: ports, bytes, counters and compare values, addresses.

\`node toolchain/image/registers.mjs\` writes this page; the test \`on_board.registers\` holds it against the images.

| address | register | chapter | APM 2 | APM 1 |
|---|---|---|---|---|
${rows.join('\n')}
`;
}

const [program, apm2, apm1, mode] = process.argv.slice(2);
if (!apm1) {
  console.error('usage: registers.mjs REGISTER_WRITES APM2.elf APM1.elf [--check]');
  process.exit(2);
}
const text = documentOf(program, [apm2, apm1]);
if (mode !== '--check') {
  writeFileSync(kDocument, text);
} else {
  const old = readFileSync(kDocument, 'utf8').split('\n'), now = text.split('\n');
  for (const line of old.filter((each) => !now.includes(each))) console.log(`- ${line}`);
  for (const line of now.filter((each) => !old.includes(each))) console.log(`+ ${line}`);
  if (old.join('\n') !== text) {
    console.error('registers.mjs: docs/registers.md does not have what the images write');
    process.exitCode = 1;
  }
}
