// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/timer.hpp"

#include <utility>

namespace simulator {
namespace {

constexpr uint16_t kControlCAfterA = 2;  // TCCRnC of a 16-bit timer

}  // namespace

Timer::Timer(avr_t* avr, char name) : avr_(avr) {
    io_ = findPeripheral<avr_timer_t>(avr, "timer", name);
    write_control_[0] = hookWrite<&Timer::writeControl>(avr, io_->wgm[0].reg, this);
    write_control_[1] = hookWrite<&Timer::writeControl>(avr, io_->cs[0].reg, this);
    hookWrite<&Timer::writeCount>(avr, io_->r_tcnt, this);
    hookRead<&Timer::readCount>(avr, io_->r_tcnt, this);
    for (int i = 0; i < AVR_TIMER_COMP_COUNT; i++) {
        const avr_timer_comp_t& compare = io_->comp[i];
        if (!compare.r_ocr) continue;
        compares_[i].write = hookWrite<&Timer::writeCompare>(avr, compare.r_ocr, this);
        hookRead<&Timer::readCompare>(avr, compare.r_ocr, this);
        if (!compare.r_ocrh) continue;
        hookWrite<&Timer::writeHigh>(avr, compare.r_ocrh, this);
        hookRead<&Timer::readCompare>(avr, compare.r_ocrh, this);
    }
    for (int i = 0; i < AVR_TIMER_COMP_COUNT; i++) {
        outputs_[i].timer = this;
        outputs_[i].compare = i;
        hookLine<&Output::raised>(io_->io.irq + TIMER_IRQ_OUT_COMP + i, &outputs_[i]);
    }
    if (wide()) {
        hookWrite<&Timer::writeForce>(avr, io_->wgm[0].reg + kControlCAfterA, this);
        hookWrite<&Timer::writeHigh>(avr, io_->r_tcnth, this);
        hookWrite<&Timer::writeHigh>(avr, io_->r_icrh, this);
        hookWrite<&Timer::writeTop>(avr, io_->r_icr, this);
    }
    hookLine<&Timer::overflowed>(io_->overflow.irq + AVR_INT_IRQ_PENDING, this);
}

void Timer::reset() {
    temp_ = 0;
    for (Compare& compare : compares_) compare.waiting = false;
    for (Output& output : outputs_) {
        output.latch = false;
        show(output.compare, avr_->cycle);
    }
}

void Timer::onPin(int compare, std::function<void(bool, uint64_t)> changed) {
    outputs_.at(static_cast<size_t>(compare)).changed.push_back(std::move(changed));
}

uint8_t Timer::driven(const avr_ioport_t& port, uint8_t pins) const {
    for (const Output& output : outputs_) {
        const avr_timer_comp_t& compare = io_->comp[output.compare];
        const auto bit = static_cast<uint8_t>(1 << compare.com_pin.bit);
        const bool drives = compare.com_pin.reg == port.r_port && avr_->data[port.r_ddr] & bit &&
                            avr_regbit_get(avr_, compare.com) != avr_timer_com_normal;
        if (drives) pins = static_cast<uint8_t>(output.pin ? pins | bit : pins & ~bit);
    }
    return pins;
}

uint32_t Timer::prescaler() const {
    if (!avr_regbit_get_array(avr_, const_cast<avr_regbit_t*>(io_->cs), 3)) return 0;
    constexpr uint8_t kFromPin = AVR_TIMER_EXTCLK_FLAG_TN | AVR_TIMER_EXTCLK_FLAG_AS2;
    if (io_->ext_clock_flags & kFromPin || io_->tov_cycles <= 1) return 0;
    return static_cast<uint32_t>(io_->tov_cycles / (io_->tov_top + 1u));
}

uint16_t Timer::count(uint64_t cycle) const {
    const uint32_t clock = prescaler();
    return static_cast<uint16_t>((cycle - io_->tov_base) / clock % (io_->tov_top + 1u));
}

// The library computes its events anew, from tov_base on, when a compare value changes.
void Timer::reconfigure() {
    const uint16_t low = io_->comp[AVR_TIMER_COMPA].r_ocr;
    const uint8_t value = avr_->data[low];
    avr_->data[low] = static_cast<uint8_t>(~value);
    compares_[AVR_TIMER_COMPA].write(avr_, low, value);
}

void Timer::setCount(uint16_t count) {
    const uint64_t clock = prescaler();
    io_->tov_base = avr_->cycle - count % (io_->tov_top + 1u) * clock;
    reconfigure();
}

// A change of clock or mode leaves the count as it is; the library begins at 0 again.
void Timer::writeControl(uint16_t address, uint8_t value) {
    const WriteChain& write = write_control_[address == io_->cs[0].reg];
    const bool ran = prescaler() != 0;
    const uint16_t stored = static_cast<uint16_t>(avr_->data[io_->r_tcnt] |
                                                  (wide() ? avr_->data[io_->r_tcnth] << 8 : 0));
    const uint16_t before = ran && countsUp() ? count(avr_->cycle) : stored;
    write(avr_, address, value);
    for (const Output& output : outputs_) show(output.compare, avr_->cycle);
    if (!countsUp()) return;
    if (!prescaler()) {
        avr_->data[io_->r_tcnt] = static_cast<uint8_t>(before);
        if (wide()) avr_->data[io_->r_tcnth] = static_cast<uint8_t>(before >> 8);
    } else if (count(avr_->cycle) != before) {
        setCount(before);
    }
}

void Timer::writeCount(uint16_t address, uint8_t value) {
    avr_->data[address] = value;
    if (wide()) avr_->data[io_->r_tcnth] = temp_;
    if (prescaler()) setCount(static_cast<uint16_t>(wide() ? temp_ << 8 | value : value));
}

// Reading the low byte puts the high one aside, so that both belong together.
uint8_t Timer::readCount(uint16_t address) {
    if (prescaler()) {
        const uint16_t now = count(avr_->cycle);
        avr_->data[address] = static_cast<uint8_t>(now);
        if (wide()) avr_->data[io_->r_tcnth] = static_cast<uint8_t>(now >> 8);
    }
    return avr_->data[address];
}

void Timer::writeTop(uint16_t address, uint8_t value) {
    avr_->data[address] = value;
    avr_->data[io_->r_icrh] = temp_;
    if (io_->mode.top == avr_timer_wgm_reg_icr && prescaler()) reconfigure();
}

bool Timer::buffered(int compare) const {
    const int kind = io_->wgm_op_mode_kind;
    const bool pwm = kind == avr_timer_wgm_fast_pwm || kind == avr_timer_wgm_pwm;
    const bool is_top = compare == AVR_TIMER_COMPA && io_->mode.top == avr_timer_wgm_reg_ocra;
    return pwm && prescaler() && !is_top;
}

int Timer::compareAt(uint16_t address) const {
    int i = 0;
    while (io_->comp[i].r_ocr != address && io_->comp[i].r_ocrh != address) i++;
    return i;
}

void Timer::writeCompare(uint16_t address, uint8_t value) {
    const int i = compareAt(address);
    Compare& compare = compares_[i];
    compare.low = value;
    compare.high = temp_;
    compare.waiting = buffered(i);
    if (on_compare) on_compare(i);
    if (compare.waiting) return;
    setCompare(i);
}

// The library looks at the low byte alone to see whether the value changes.
void Timer::setCompare(int compare) {
    const avr_timer_comp_t& registers = io_->comp[compare];
    const Compare& written = compares_[compare];
    if (wide() && avr_->data[registers.r_ocrh] != written.high) {
        avr_->data[registers.r_ocrh] = written.high;
        avr_->data[registers.r_ocr] = static_cast<uint8_t>(~written.low);
    }
    written.write(avr_, registers.r_ocr, written.low);
}

uint8_t Timer::readCompare(uint16_t address) {
    const int i = compareAt(address);
    const Compare& compare = compares_[i];
    if (!compare.waiting) return avr_->data[address];
    return address == io_->comp[i].r_ocr ? compare.low : compare.high;
}

// Not at once: the library is in the middle of beginning its period.
void Timer::overflowed(uint32_t raised) {
    if (!raised) return;
    for (const Compare& compare : compares_) {
        if (!compare.waiting) continue;
        startTimer<&Timer::takeOver>(avr_, 1, this);
        return;
    }
}

uint64_t Timer::takeOver(uint64_t) {
    for (int i = 0; i < AVR_TIMER_COMP_COUNT; i++) {
        Compare& compare = compares_[i];
        if (!compare.waiting) continue;
        compare.waiting = false;
        setCompare(i);
    }
    return 0;
}

// A strobe that reads as zero. In PWM modes it does nothing (datasheet 17.11.9).
void Timer::writeForce(uint16_t address, uint8_t value) {
    avr_->data[address] = 0;
    const int mode = avr_regbit_get_array(avr_, io_->wgm, 4);  // the library's kind is late
    const int kind = io_->wgm_op[mode].kind;
    if (kind != avr_timer_wgm_normal && kind != avr_timer_wgm_ctc) return;
    for (int i = 0; i < 3; i++)
        if (value & 0x80 >> i) force(i);
}

// As a match would, but without its flag.
void Timer::force(int compare) {
    bool& latch = outputs_[compare].latch;
    const uint8_t mode = avr_regbit_get(avr_, io_->comp[compare].com);
    if (mode == avr_timer_com_normal) return;
    latch = mode == avr_timer_com_toggle ? !latch : mode == avr_timer_com_set;
    show(compare, avr_->cycle);
}

// Raised for every event, changed or not.
void Timer::matched(int compare, bool high) {
    bool& latch = outputs_[compare].latch;
    if (high == latch || !fromMatch(compare, high)) return;
    latch = high;
    show(compare, edge(compare, high));
}

void Timer::show(int compare, uint64_t cycle) {
    Output& output = outputs_[compare];
    const bool high = output.latch && avr_regbit_get(avr_, io_->comp[compare].com) != 0;
    if (high == output.pin) return;
    output.pin = high;
    for (const auto& each : output.changed) each(high, cycle);
}

// Whether a level the library gives a compare's pin comes from a match. Outside PWM it also does
// at each new computing of its events what PWM does at the end of a period.
bool Timer::fromMatch(int compare, bool high) const {
    const int kind = io_->wgm_op_mode_kind;
    if (kind != avr_timer_wgm_normal && kind != avr_timer_wgm_ctc) return true;
    const uint8_t mode = avr_regbit_get(avr_, io_->comp[compare].com);
    return mode < avr_timer_com_clear || high == (mode == avr_timer_com_set);
}

// The cycle in which a compare's pin took this level. The library raises its events between two
// instructions, the timer changes the pin at the count itself (datasheet 17.8).
uint64_t Timer::edge(int compare, bool high) const {
    constexpr uint64_t kLatest = 64;  // cycles: an instruction and the interrupts served before it
    const uint64_t clock = prescaler();
    const int kind = io_->wgm_op_mode_kind;
    if (kind == avr_timer_wgm_pwm || !clock) return avr_->cycle;
    const uint64_t period = (io_->tov_top + 1u) * clock;
    const bool sets = avr_regbit_get(avr_, io_->comp[compare].com) == avr_timer_com_set;
    const bool matches = kind != avr_timer_wgm_fast_pwm || high == sets;
    const uint64_t from_begin = matches ? io_->comp[compare].comp_cycles : 0;
    const uint64_t late = (avr_->cycle - io_->tov_base + period - from_begin % period) % period;
    return late <= kLatest ? avr_->cycle - late : avr_->cycle;
}

void Timer::captureEdge(bool rising, uint64_t cycle) {
    if (!wide() || !prescaler() || io_->mode.top == avr_timer_wgm_reg_icr) return;
    if (bool(avr_regbit_get(avr_, io_->ices)) != rising) return;
    const uint16_t captured = count(cycle);
    avr_->data[io_->r_icr] = static_cast<uint8_t>(captured);
    avr_->data[io_->r_icrh] = static_cast<uint8_t>(captured >> 8);
    avr_raise_interrupt(avr_, &io_->icr);
}

}  // namespace simulator
