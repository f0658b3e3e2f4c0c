// SPDX-License-Identifier: GPL-3.0-or-later
// An ATmega2560 with a program in its flash, running cycle by cycle: libsimavr's core with its
// peripherals mended to the datasheet. Knows no board: pins, lines and buses end here.
#pragma once
#include <simavr/avr_ioport.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simulator/machine/adc_inputs.hpp"
#include "simulator/machine/eeprom.hpp"
#include "simulator/machine/image.hpp"
#include "simulator/machine/interrupts.hpp"
#include "simulator/machine/profile.hpp"
#include "simulator/machine/registers.hpp"
#include "simulator/machine/spi_master.hpp"
#include "simulator/machine/stack_watch.hpp"
#include "simulator/machine/timer.hpp"
#include "simulator/machine/twi_master.hpp"
#include "simulator/machine/usart.hpp"

namespace simulator {

// Power-on is construction as well; the watchdog acts by itself.
enum class Reset { external, brown_out, power_on };

class Chip {
public:
    explicit Chip(const Image& image);
    ~Chip();
    Chip(const Chip&) = delete;
    Chip& operator=(const Chip&) = delete;

    // Runs to this cycle, at most an instruction past it. False: it can not go on, see fault().
    bool run(uint64_t until);
    uint64_t cycle() const { return avr_->cycle; }
    uint64_t asleepCycles() const { return asleep_; }
    const std::string& fault() const { return fault_; }
    void reset(Reset cause);
    // Time passes without an instruction, until a reset.
    void skip(uint64_t until) { avr_->cycle = until; }
    // What a bootloader writes: below its own section the image, and nothing else. To be reset.
    void program(const Image& image);
    // From now on every reset begins there, as the fuse BOOTRST has it. To be called at once.
    void setBootSection(const Image& program);

    // Called after every reset, the watchdog's too, when all cycle timers are gone.
    std::function<void()> on_reset;
    // Every write to GPIOR0.
    std::function<void(uint8_t value)> on_trace;

    // Pins. Listeners are called after anything was written to the port or its direction.
    void onPort(char port, std::function<void()> changed);
    bool isOutput(char port, int bit) const;
    bool outputHigh(char port, int bit) const;  // false also when it is no output
    void drive(char port, int bit, bool high);  // from outside
    // The cycle is the edge's own, which may lie a few back.
    void onCompareOutput(char timer, int compare,
                         std::function<void(bool high, uint64_t cycle)> changed);

    void onCompareWrite(char timer, std::function<void(int compare)> written);

    // An edge on ICP4 (PL0) or ICP5 (PL1); the cycle may lie an instruction back.
    void captureEdge(char timer, bool rising, uint64_t cycle);

    avr_t* avr() { return avr_; }
    Usart& usart(int number) { return *usarts_.at(number); }
    SpiMaster& spi() { return *spi_; }
    TwiMaster& twi() { return *twi_; }
    AdcInputs& adc() { return *adc_; }
    Eeprom& eeprom() { return *eeprom_; }
    const Eeprom& eeprom() const { return *eeprom_; }
    Interrupts& interrupts() { return *interrupts_; }
    const Interrupts& interrupts() const { return *interrupts_; }
    const StackWatch& stack() const { return *stack_; }

    void serveGdb(int port);  // stops until a debugger has come
    void startProfile();      // from here on, at a tenth of the speed
    const Profile* profile() const { return profile_.get(); }
    void noteError(const std::string& text) { last_error_ = text; }

private:
    struct Listener;
    struct ResetHook;

    template <class Part, class... Arguments>
    Part* add(Arguments&&... arguments);
    void addParts();
    void joinResets();
    void settle();
    void slept(uint64_t cycles);
    bool sleepStartsConversion() const;
    void trace(uint16_t address, uint8_t value);
    void selectPage(uint16_t address, uint8_t value);
    uint64_t stop(uint64_t) { return 0; }
    int runProfiled();
    bool single() const { return debugging_ || profile_; }
    avr_ioport_t& io(char port) const { return *ports_[port - 'A']; }

    avr_t* avr_ = nullptr;
    std::vector<std::unique_ptr<Mend>> mends_;
    std::vector<std::unique_ptr<Listener>> listeners_;
    std::unique_ptr<ResetHook> reset_hook_;
    std::array<avr_ioport_t*, 'L' - 'A' + 1> ports_ = {};
    std::array<Usart*, 4> usarts_ = {};
    std::array<Timer*, 6> timers_ = {};
    SpiMaster* spi_ = nullptr;
    TwiMaster* twi_ = nullptr;
    AdcInputs* adc_ = nullptr;
    Eeprom* eeprom_ = nullptr;
    Interrupts* interrupts_ = nullptr;
    StackWatch* stack_ = nullptr;
    uint64_t asleep_ = 0;
    uint64_t asleep_until_ = UINT64_MAX;  // while a sleep goes on
    bool debugging_ = false;
    std::unique_ptr<Profile> profile_;
    std::string fault_, last_error_;
};

}  // namespace simulator
