// SPDX-License-Identifier: GPL-3.0-or-later
// Touches everything on the APM 2 once, reports what it finds on USART2 as number, low, high, and
// then runs marked frames: task 2 in each, the 20th frame too long, sleep between.
#include <util/delay.h>

#include "report.hpp"

enum : uint8_t { kTaskEnd = 0x80, kFrameBegin = 0xF0, kFrameEnd = 0xF1, kTask2 = 3 };

volatile uint16_t samples, edge_ticks[2];
volatile uint8_t edges, dollars, garbage;

ISR(INT6_vect) { samples++; }
ISR(TIMER5_CAPT_vect) {
    edge_ticks[0] = edge_ticks[1];
    edge_ticks[1] = ICR5;
    edges++;
}
ISR(USART1_RX_vect) {
    const uint8_t byte = UDR1;
    if (byte == '$') dollars++;
    if (byte & 0x80) garbage++;
}
ISR(USART0_RX_vect) { UDR0 = UDR0 + 1; }
EMPTY_INTERRUPT(TIMER2_COMPA_vect)

static void put(uint8_t byte) {
    while (!(UCSR2A & _BV(UDRE2))) {
    }
    UDR2 = byte;
}
static void showValue(uint8_t number, uint16_t value) {
    put(number);
    put(static_cast<uint8_t>(value));
    put(static_cast<uint8_t>(value >> 8));
}

static uint8_t transfer(uint8_t byte) {
    SPDR = byte;
    while (!(SPSR & _BV(SPIF))) {
    }
    return SPDR;
}
static uint8_t imu(uint8_t reg, uint8_t value) {
    PORTB &= ~_BV(0);
    transfer(reg);
    const uint8_t got = transfer(value);
    PORTB |= _BV(0);
    return got;
}
static uint16_t coefficient(uint8_t index) {
    PORTG &= ~_BV(1);
    transfer(static_cast<uint8_t>(0xA0 + 2 * index));
    const uint8_t high = transfer(0), low = transfer(0);
    PORTG |= _BV(1);
    return static_cast<uint16_t>(high << 8 | low);
}
static void resetBarometer() {
    PORTG &= ~_BV(1);
    transfer(0x1E);
    _delay_us(20);
    PORTG |= _BV(1);
    _delay_ms(4);
}

static void sensorBus() {
    PORTG |= _BV(1);
    DDRG |= _BV(1);
    DDRB |= _BV(1) | _BV(2);
    SPCR = _BV(SPE) | _BV(MSTR) | _BV(SPR0);
    resetBarometer();
    showValue(1, coefficient(1));  // the other chip is not held deselected
    PORTB |= _BV(0);
    DDRB |= _BV(0);
    resetBarometer();
    showValue(2, coefficient(1));
    _delay_ms(100);
    showValue(3, imu(0x80 | 0x75, 0));
    PORTG &= ~_BV(1);
    imu(0x80 | 0x75, 0);  // both at once
    PORTG |= _BV(1);
    imu(0x6B, 0x01);
    _delay_ms(5);
    imu(0x6B, 0x01);  // it obeys the second
    _delay_ms(50);
    imu(0x19, 4);  // 1 kHz / 5
    imu(0x1A, 3);
    imu(0x37, 0x10);  // data ready clears at any read
    imu(0x38, 0x01);
    EICRB = _BV(ISC61) | _BV(ISC60);
    EIMSK = _BV(INT6);
    for (uint8_t i = 0; i < 100; i++) {
        _delay_ms(1);
        imu(0x80 | 0x3A, 0);
    }
    showValue(4, samples);
    EIMSK = 0;
}

static uint8_t twi(uint8_t control) {
    TWCR = static_cast<uint8_t>(control | _BV(TWINT) | _BV(TWEN));
    while (!(TWCR & _BV(TWINT))) {
    }
    return TWDR;
}
static void compass() {
    TWBR = 12;
    twi(_BV(TWSTA));
    TWDR = 0x1E << 1;
    twi(0);
    TWDR = 10;
    twi(0);
    twi(_BV(TWSTA));
    TWDR = 0x1E << 1 | 1;
    twi(0);
    const uint8_t first = twi(_BV(TWEA)), second = twi(0);
    TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
    showValue(5, static_cast<uint16_t>(second << 8 | first));
}

static uint16_t analog(uint8_t channel) {
    ADMUX = _BV(REFS0) | (channel & 7);
    ADCSRB = channel & 8 ? _BV(MUX5) : 0;
    ADCSRA = _BV(ADEN) | _BV(ADSC) | 7;
    while (ADCSRA & _BV(ADSC)) {
    }
    return ADC;
}

static uint8_t flash(uint8_t byte) {
    UDR3 = byte;
    while (!(UCSR3A & _BV(RXC3))) {
    }
    return UDR3;
}
static uint16_t flashIdentity() {
    PORTA &= ~_BV(6);
    flash(0x9F);
    const uint8_t maker = flash(0), family = flash(0);
    PORTA |= _BV(6);
    return static_cast<uint16_t>(maker << 8 | family);
}
static void dataflash() {
    PORTA |= _BV(6);
    DDRA |= _BV(6);
    DDRJ = _BV(2);
    UCSR3C = _BV(UMSEL31) | _BV(UMSEL30);
    UCSR3B = _BV(RXEN3) | _BV(TXEN3);
    showValue(13, flashIdentity());
    DDRG |= _BV(0);  // reset, low
    showValue(14, flashIdentity());
    PORTG |= _BV(0);
    showValue(15, flashIdentity());
}

static void gps() {
    UCSR1A = _BV(U2X1);
    UBRR1 = 207;  // 9600
    UCSR1B = _BV(RXEN1) | _BV(RXCIE1);
    _delay_ms(2500);
    showValue(7, dollars);
    showValue(8, garbage);
    UBRR1 = 51;  // 38400
    _delay_ms(2500);
    showValue(9, garbage);
    UCSR1B = 0;
}

static void radio() {
    TCCR5A = 3;
    OCR5A = 39999;
    TCCR5B = _BV(ICES5) | _BV(WGM53) | _BV(WGM52) | _BV(CS51);
    TIMSK5 = _BV(ICIE5);
    while (edges < 12) {
    }
    TIMSK5 = 0;
    // Edges 10 to 12 of frames of nine: the second frame's first and second channels.
    const uint16_t ticks = edge_ticks[1] - edge_ticks[0];
    showValue(10, ticks > 40000 ? ticks + 40000 : ticks);
}

static void outputs() {
    DDRB |= _BV(5) | _BV(6) | _BV(7);
    PORTB |= _BV(7);
    DDRA = _BV(3) | _BV(4) | _BV(5);
    PORTA = _BV(4) | _BV(3);
    TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM11);
    TCCR1B = _BV(WGM13) | _BV(WGM12);
    ICR1 = 39999;
    OCR1B = 2999;
    OCR1A = 2199;
    TCCR1B |= _BV(CS11);
}

static void frames() {
    TCCR2A = _BV(WGM21);
    OCR2A = 155;
    TIMSK2 = _BV(OCIE2A);
    TCCR2B = 7;  // 9.98 ms
    for (uint8_t frame = 1;; frame++) {
        sleep_mode();
        GPIOR0 = kFrameBegin;
        GPIOR0 = kTask2;
        _delay_us(500);
        GPIOR0 = kTaskEnd;
        if (frame == 20) _delay_ms(12);
        GPIOR0 = kFrameEnd;
    }
}

int main() {
    UCSR2A = UCSR0A = _BV(U2X0);
    UBRR2 = UBRR0 = 16;
    UCSR2B = _BV(TXEN2);
    UCSR0B = _BV(TXEN0) | _BV(RXEN0) | _BV(RXCIE0);
    sei();
    outputs();
    sensorBus();
    compass();
    dataflash();
    showValue(6, analog(13));
    showValue(11, PINA & _BV(1));
    gps();
    radio();
    showValue(12, PINA & _BV(1));
    frames();
}
