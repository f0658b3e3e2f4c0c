// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/native_board.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "firmware/app/tasks.hpp"
#include "hal/eeprom.hpp"
#include "hal/imu_interrupt.hpp"
#include "hal/trace.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/devices/gps_receiver.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ms5611.hpp"
#include "simulator/devices/supply.hpp"
#include "simulator/native/board.hpp"

namespace simulator {

constexpr uint64_t kBitsPerByte_ns = 8'000'000'000;
constexpr uint64_t kLongestRest_us = 1000;
constexpr uint64_t kWatchdog_us = 250'000;
constexpr uint64_t kStartUp_us = 65'000;  // of the fuses, as simulator/machine/boot has it

static NativeBoard* running_board = nullptr;

NativeBoard& NativeBoard::running() { return *running_board; }

NativeBoard::NativeBoard(const WorldOptions& options)
    : world_(options),
      spi_line_(options.seed),
      serial_(now_us_, world_),
      eeprom_(now_us_, options.seed),
      i2c_(now_us_, world_.compass()),
      analog_(now_us_, world_),
      servos_(now_us_, world_),
      receiver_(now_us_, world_.radio()) {
    static bool used = false;
    if (std::exchange(used, true)) {
        throw std::logic_error("a process can have one native board: its firmware is global");
    }
    running_board = this;
    eeprom_.wear(WornCells(options.worn_cells, hal::kEepromSize, options.seed));
}

NativeBoard::~NativeBoard() { running_board = nullptr; }

bool NativeBoard::runUntil(uint64_t time_us) {
    while (fault_.empty() && now_us_ < time_us) {
        try {
            run();
        } catch (const Reboot&) {
            restart(hal::ResetCause::asked);
        }
    }
    return fault_.empty();
}

// The firmware starts anew when the supply is back. Of memory that has been lost this computer
// knows nothing.
void NativeBoard::checkSupply() {
    const Supply& supply = world_.supply();
    eeprom_.endanger(supply.below(least_v::kEepromWrite, now_us_));
    if (!supply.below(least_v::kChip, now_us_)) return;
    restart(hal::ResetCause::unknown);
    while (fault_.empty() && supply.below(least_v::kChip, now_us_)) {
        constexpr uint64_t kLook_us = 100;
        moveTo(now_us_ + kLook_us);
        if (supply.below(least_v::kMemory, now_us_))
            fault_ =
                "the supply fell so low that memory is lost: only the image shows what follows";
    }
}

void NativeBoard::run() {
    if (!started_) bringUp();
    const uint64_t before_us = now_us_;
    firmware::app::loop();
    waitWithFirmware(before_us);
    checkSupply();
    if (fed_us_ != UINT64_MAX && now_us_ - fed_us_ > kWatchdog_us)
        fault_ = "the watchdog was not fed for 250 ms";
}

// No pulse leaves the processor while the fuses hold it in reset, nor while its bootloader waits.
void NativeBoard::bringUp() {
    constexpr uint64_t kLoader_us = 1000ULL * board::kLoader_ms;  // with the fuses' time
    started_ = true;
    const bool passes_loader =
        last_run_.ended != hal::ResetCause::watchdog && last_run_.ended != hal::ResetCause::fault;
    if (restarts_ > 0) moveTo(now_us_ + (passes_loader ? kLoader_us : kStartUp_us));
    begun_us_ = now_us_;
    firmware::app::setup();
}

void NativeBoard::restart(hal::ResetCause cause) {
    if (!memory_.known()) {
        fault_ = "reset: this program's firmware cannot start twice";
        return;
    }
    if (!started_) return;
    last_run_ = {cause, traced_, static_cast<uint16_t>(sinceBegun_us() / 1000),
                 static_cast<uint8_t>(kStartUp_us / 1000)};
    memory_.startAnew();
    serial_.restart();
    eeprom_.restart();
    i2c_.restart();
    analog_.restart();
    servos_.restart();
    receiver_.restart();
    select(true, false);
    select(false, false);
    world_.dataflash().select(false, now_us_);
    byte_ns_ = 16'000;
    imu_locks_ = 0;
    imu_waits_ = false;
    fed_us_ = UINT64_MAX;
    started_ = false;
    ++restarts_;
}

// Firmware that works on waits for time to pass, not for an event: on a chip it does pass.
void NativeBoard::waitWithFirmware(uint64_t before_us) {
    constexpr int kMaxStill = 1000;
    constexpr uint64_t kTurn_us = 20;
    still_turns_ = now_us_ == before_us ? still_turns_ + 1 : 0;
    if (still_turns_ < kMaxStill) return;
    still_turns_ = kMaxStill;
    moveTo(now_us_ + kTurn_us);
    runDevices();
}

void NativeBoard::send(int usart, const uint8_t* bytes, size_t size) {
    if (usart < SerialLines::kPorts) serial_.send(usart, bytes, size);
}

size_t NativeBoard::unsent(int usart) const {
    return usart < SerialLines::kPorts ? serial_.unsent(usart) : 0;
}

void NativeBoard::idle(bool (*work_waits)()) {
    const uint64_t wake_us = now_us_ + kLongestRest_us;
    runDevices();
    while (now_us_ < wake_us && !work_waits()) {
        moveTo(std::min(nextEvent_us(), wake_us));
        runDevices();
    }
}

uint64_t NativeBoard::nextEvent_us() {
    return std::min({world_.imu().nextSample_us(), world_.gps().nextEvent_us(), serial_.due_us(),
                     eeprom_.due_us(), i2c_.due_us(), analog_.due_us(), servos_.due_us(),
                     receiver_.due_us()});
}

void NativeBoard::moveTo(uint64_t time_us) {
    now_us_ = std::max(now_us_, time_us);
    world_.advanceTo(now_us_);
    i2c_.fail(world_.faultOf(Faulty::i2c));
    spi_line_.fail(world_.faultOf(Faulty::spi));
}

void NativeBoard::runDevices() {
    runImu();
    serial_.run();
    eeprom_.run();
    i2c_.run();
    analog_.run();
    servos_.run();
    receiver_.run();
}

// The rising edge of the data-ready pin is the interrupt; it stays up until the sample is read.
void NativeBoard::runImu() {
    const bool pin = world_.imu().interruptPin();
    if (pin && !imu_pin_) imu_waits_ = true;
    imu_pin_ = pin;
    if (!imu_waits_ || imu_locks_ > 0) return;
    imu_waits_ = false;
    hal::imuDataReady();
    imu_pin_ = world_.imu().interruptPin();
}

void NativeBoard::lockImu(bool lock) { imu_locks_ += lock ? 1 : -1; }

void NativeBoard::select(bool imu, bool chosen) {
    if (std::exchange(imu ? imu_chosen_ : barometer_chosen_, chosen) == chosen) return;
    if (imu) {
        world_.imu().select(chosen, now_us_);
    } else {
        world_.barometer().select(chosen, now_us_);
    }
}

uint8_t NativeBoard::transfer(uint8_t mosi) {
    spend_ns(byte_ns_);
    uint8_t miso = 0xFF;
    world_.imu().clock(static_cast<uint32_t>(kBitsPerByte_ns / byte_ns_));
    if (imu_chosen_) miso &= world_.imu().transfer(mosi, now_us_);
    if (barometer_chosen_) miso &= world_.barometer().transfer(mosi, now_us_);
    return spi_line_.through(miso);
}

uint8_t NativeBoard::flashTransfer(uint8_t mosi) {
    spend_ns(1000);  // 8 MHz
    return world_.dataflash().transfer(mosi, now_us_);
}

void NativeBoard::spend_ns(uint32_t duration_ns) {
    spent_ns_ += duration_ns;
    now_us_ += spent_ns_ / 1000;
    spent_ns_ %= 1000;
}

// At start-up the firmware asks until it is served: the asking must take time.
core::Status NativeBoard::eepromRead(uint16_t address, void* to, uint8_t size) {
    const core::Status status = eeprom_.read(address, to, size);
    if (status == core::Status::busy) {
        spend_ns(10'000);
        eeprom_.run();
    }
    return status;
}

void NativeBoard::trace(uint8_t value) {
    traced_ = value;
    frames_ += value == hal::kTraceFrameBegin;
}

void NativeBoard::watchdogFeed() {
    if (fed_us_ != UINT64_MAX) fed_us_ = now_us_;
}

void NativeBoard::reboot() { throw Reboot{}; }

BoardFigures NativeBoard::figures() const {
    BoardFigures figures;
    figures.frames = frames_;
    return figures;
}

}  // namespace simulator
