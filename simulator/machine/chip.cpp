// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/chip.hpp"

#include <simavr/avr_extint.h>
#include <simavr/sim_gdb.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>

#include "simulator/machine/flag_registers.hpp"
#include "simulator/machine/port_pins.hpp"

namespace simulator {
namespace {

constexpr uint64_t kRunLimit = 10000;  // cycles between looks at the timers; 1 halves the speed

Chip* chipOf(avr_t* avr) { return avr ? static_cast<Chip*>(avr->custom.data) : nullptr; }

// libsimavr's only log is the process's; what it last complained of explains a crash.
void storeError(avr_t* avr, const int level, const char* format, va_list arguments) {
    if (level > LOG_ERROR || !chipOf(avr)) return;
    char text[200];
    vsnprintf(text, sizeof text, format, arguments);
    std::string line = text;
    while (!line.empty() && line.back() == '\n') line.pop_back();
    chipOf(avr)->noteError(line);
}

// libsimavr notices an access behind the RAM and makes it all the same: a program gone astray
// would write over this program's own heap. Every address of 16 bits has its byte now.
void widenMemory(avr_t* avr) {
    constexpr size_t kDataSpace = 0x10000;
    auto* wide = static_cast<uint8_t*>(std::calloc(1, kDataSpace));
    if (!wide) throw std::bad_alloc();
    std::memcpy(wide, avr->data, avr->ramend + 1u);
    std::free(avr->data);
    avr->data = wide;
}

}  // namespace

struct Chip::Listener {
    std::function<void()> port_changed;
    void port(uint32_t) { port_changed(); }
};

// A peripheral without registers, last in the list, so its reset comes after all others.
struct Chip::ResetHook {
    avr_io_t io = {};
    Chip* chip = nullptr;
};

template <class Part, class... Arguments>
Part* Chip::add(Arguments&&... arguments) {
    auto part = std::make_unique<Part>(avr_, std::forward<Arguments>(arguments)...);
    Part* raw = part.get();
    mends_.push_back(std::move(part));
    return raw;
}

Chip::Chip(const Image& image) {
    avr_global_logger_set(storeError);
    avr_ = avr_make_mcu_by_name("atmega2560");
    if (!avr_) throw std::runtime_error("libsimavr was built without the ATmega2560");
    avr_->custom.data = this;
    avr_init(avr_);
    widenMemory(avr_);
    avr_->frequency = kClock_hz;
    avr_->vcc = avr_->avcc = avr_->aref = 5000;
    avr_->log = LOG_ERROR;
    avr_->sleep = [](avr_t* avr, avr_cycle_count_t cycles) { chipOf(avr)->slept(cycles); };
    avr_loadcode(avr_, const_cast<uint8_t*>(image.flash.data()),
                 static_cast<uint32_t>(image.flash.size()), 0);
    avr_->codeend = avr_->flashend;

    addParts();
    joinResets();
    avr_reset(avr_);
    avr_regbit_set(avr_, avr_->reset_flags.porf);
}

void Chip::addParts() {
    for (char name = 'A'; name <= 'L'; name++)  // there is no port I
        ports_[name - 'A'] = findPeripheral<avr_ioport_t>(avr_, "port", name);
    interrupts_ = add<Interrupts>();
    add<FlagRegisters>();
    stack_ = add<StackWatch>();
    for (char n = 0; n < 6; n++) timers_[n] = add<Timer>(static_cast<char>('0' + n));
    for (char name : {'B', 'E', 'H', 'L'}) add<PortPins>(name, timers_);  // with compares
    for (char n = 0; n < 4; n++) usarts_[n] = add<Usart>(static_cast<char>('0' + n));
    spi_ = add<SpiMaster>();
    twi_ = add<TwiMaster>();
    adc_ = add<AdcInputs>();
    eeprom_ = add<Eeprom>();
    hookWrite<&Chip::trace>(avr_, kGpior0, this);
    hookWrite<&Chip::selectPage>(avr_, kRampz, this);
}

void Chip::joinResets() {
    reset_hook_ = std::make_unique<ResetHook>();
    reset_hook_->chip = this;
    reset_hook_->io.kind = "after reset";
    reset_hook_->io.avr = avr_;
    reset_hook_->io.reset = [](avr_io_t* io) { reinterpret_cast<ResetHook*>(io)->chip->settle(); };
    avr_io_t* last = avr_->io_port;
    while (last->next) last = last->next;
    last->next = &reset_hook_->io;
}

// avr_terminate leaves behind the lines of the interrupts, the list of all lines and the core.
Chip::~Chip() {
    avr_int_table_t& table = avr_->interrupts;
    for (int i = 0; i < table.vector_count; i++)
        avr_free_irq(table.vector[i]->irq, AVR_INT_IRQ_COUNT);
    avr_free_irq(table.irq, AVR_INT_IRQ_COUNT);
    avr_terminate(avr_);
    free(avr_->irq_pool.irq);
    free(avr_);
}

void Chip::settle() {
    avr_->run_cycle_limit = single() ? 1 : kRunLimit;
    // A low INTn pin in the level mode of reset is looked at every cycle: 25 times slower.
    for (uint8_t i = 0; i < 8; i++) avr_extint_set_strict_lvl_trig(avr_, i, 0);
    for (avr_ioport_t* port : ports_)
        if (port) avr_->data[port->r_pin] = port->external.pull_value;  // still driven
    for (auto& mend : mends_) mend->reset();
    if (profile_) profile_->reset();
    if (on_reset) on_reset();
}

// Without permission the instruction does nothing (datasheet 11.10.1); libsimavr's sleeps all the
// same.
void Chip::slept(uint64_t cycles) {
    if (!(avr_->data[kSmcr] & kSleepEnable)) {
        avr_->cycle -= cycles + 1;
        avr_->state = cpu_Running;
        return;
    }
    const bool entered = avr_->cycle != asleep_until_;
    if (entered && sleepStartsConversion() && adc_->sleepBegins()) {
        avr_->cycle -= cycles + 1;  // so long it does not sleep: the conversion ends before
        asleep_until_ = avr_->cycle + cycles + 1;
        return;
    }
    asleep_until_ = avr_->cycle + cycles + 1;
    asleep_ += cycles + 1;  // libsimavr goes on by one more
    interrupts_->slept();
}

// Idle and ADC Noise Reduction do (datasheet 11.2, 11.3 and 26.6).
bool Chip::sleepStartsConversion() const { return (avr_->data[kSmcr] >> 1 & 7) <= 1; }

bool Chip::run(uint64_t until) {
    if (!fault_.empty()) return false;
    // So that sleep ends in time; a reset drops the timer, and is over before the next event.
    if (until > avr_->cycle) startTimerAt<&Chip::stop>(avr_, until, this);
    while (avr_->cycle < until) {
        const int state = profile_ ? runProfiled() : avr_run(avr_);
        if (state != cpu_Done && state != cpu_Crashed) continue;
        char place[32];
        snprintf(place, sizeof place, " at 0x%05x", avr_->pc);
        fault_ = state == cpu_Done ? "the CPU sleeps with interrupts off, for ever,"
                                   : "the CPU has crashed: " + last_error_;
        fault_ += place;
        return false;
    }
    return true;
}

void Chip::startProfile() {
    profile_ = std::make_unique<Profile>(kFlashSize);
    avr_->run_cycle_limit = 1;
}

// One instruction, and the interrupt that comes after it.
int Chip::runProfiled() {
    const auto stack = [this] {
        return static_cast<uint16_t>(avr_->data[kSpl] | avr_->data[kSph] << 8);
    };
    Profile::Step step = {};
    step.address = avr_->pc;
    const auto code = static_cast<uint16_t>(avr_->flash[avr_->pc] | avr_->flash[avr_->pc + 1] << 8);
    // RCALL, CALL, ICALL and EICALL
    step.calls =
        (code & 0xF000) == 0xD000 || (code & 0xFE0E) == 0x940E || (code & 0xFFEF) == 0x9509;
    const uint64_t began = avr_->cycle, asleep = asleep_;
    const size_t entered = interrupts_->entered();
    const int state = avr_run(avr_);
    step.cycles = avr_->cycle - began - (asleep_ - asleep);
    step.next = avr_->pc;
    step.stack = stack();
    step.interrupted = interrupts_->entered() != entered;
    profile_->add(step);
    return state;
}

// The supply's rise from nothing passes the level of the brown-out detector as well.
void Chip::reset(Reset cause) {
    const uint8_t flags = avr_->data[kMcusr];
    avr_reset(avr_);
    avr_->data[kMcusr] = cause == Reset::power_on ? 0 : flags;
    if (cause == Reset::power_on) avr_regbit_set(avr_, avr_->reset_flags.porf);
    avr_regbit_set(avr_,
                   cause == Reset::external ? avr_->reset_flags.extrf : avr_->reset_flags.borf);
}

void Chip::program(const Image& image) {
    const size_t size = std::min<size_t>(image.flash.size(), kBootSection);
    std::fill_n(avr_->flash, kBootSection, 0xFF);
    std::copy_n(image.flash.begin(), size, avr_->flash);
}

void Chip::setBootSection(const Image& program) {
    std::copy(program.flash.begin() + kBootSection, program.flash.end(),
              avr_->flash + kBootSection);
    avr_->reset_pc = avr_->pc = kBootSection;
}

// Two bits of it exist; libsimavr would read far behind its flash with the others.
void Chip::selectPage(uint16_t address, uint8_t value) { avr_->data[address] = value & 3; }

void Chip::trace(uint16_t address, uint8_t value) {
    avr_->data[address] = value;
    if (on_trace) on_trace(value);
}

void Chip::onPort(char port, std::function<void()> changed) {
    listeners_.push_back(std::make_unique<Listener>());
    listeners_.back()->port_changed = std::move(changed);
    avr_irq_t* line = avr_io_getirq(avr_, AVR_IOCTL_IOPORT_GETIRQ(port), IOPORT_IRQ_PIN_ALL);
    hookLine<&Listener::port>(line, listeners_.back().get());
}

void Chip::onCompareOutput(char timer, int compare, std::function<void(bool, uint64_t)> changed) {
    timers_.at(static_cast<size_t>(timer - '0'))->onPin(compare, std::move(changed));
}

void Chip::onCompareWrite(char timer, std::function<void(int)> written) {
    timers_.at(static_cast<size_t>(timer - '0'))->on_compare = std::move(written);
}

bool Chip::isOutput(char port, int bit) const { return avr_->data[io(port).r_ddr] >> bit & 1; }

bool Chip::outputHigh(char port, int bit) const {
    return avr_->data[io(port).r_ddr] & avr_->data[io(port).r_port] & 1 << bit;
}

// Also remembered as an external pull, or the next write to the port would put the pin's own
// pull-up in its place.
void Chip::drive(char port, int bit, bool high) {
    avr_ioport_t& pins = io(port);
    const auto mask = static_cast<uint8_t>(1 << bit);
    pins.external.pull_mask |= mask;
    pins.external.pull_value &= static_cast<uint8_t>(~mask);
    if (high) pins.external.pull_value |= mask;
    avr_raise_irq(pins.io.irq + bit, high);
}

void Chip::captureEdge(char timer, bool rising, uint64_t cycle) {
    timers_.at(timer - '0')->captureEdge(rising, cycle);
}

// Interrupt entries, timers and sleep as without a debugger, but a look at its port between any
// two instructions.
void Chip::serveGdb(int port) {
    debugging_ = true;
    avr_->run_cycle_limit = 1;
    avr_->gdb_port = port;
    avr_->state = cpu_Stopped;
    if (avr_gdb_init(avr_) != 0)
        throw std::runtime_error("gdb can not be served on port " + std::to_string(port));
    avr_->sleep = [](avr_t* avr, avr_cycle_count_t cycles) { chipOf(avr)->slept(cycles); };
}

}  // namespace simulator
