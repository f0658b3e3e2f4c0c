// SPDX-License-Identifier: GPL-3.0-or-later
// The board whose firmware is compiled for this computer: the same sources, the same device
// models, a hal:: that runs on emulated time. Computing takes no emulated time here; resting,
// bytes on a wire and the chip's own delays do. The firmware is global state, so a process has
// one NativeBoard. A reset comes between two turns of the firmware, never within one.
#pragma once
#include <memory>

#include "hal/watchdog.hpp"
#include "simulator/board.hpp"
#include "simulator/devices/line_fault.hpp"
#include "simulator/native/analog_inputs.hpp"
#include "simulator/native/eeprom_chip.hpp"
#include "simulator/native/firmware_memory.hpp"
#include "simulator/native/i2c_bus.hpp"
#include "simulator/native/ppm_receiver.hpp"
#include "simulator/native/serial_lines.hpp"
#include "simulator/native/servo_outputs.hpp"

namespace simulator {

class NativeBoard : public Board {
public:
    explicit NativeBoard(const WorldOptions& options);
    ~NativeBoard() override;
    NativeBoard(const NativeBoard&) = delete;
    NativeBoard& operator=(const NativeBoard&) = delete;

    // May pass `time_us` by the rest the firmware had begun, at most 1 ms, so that what happens
    // does not depend on the steps in which it is asked for.
    bool runUntil(uint64_t time_us) override;
    uint64_t time_us() const override { return now_us_; }
    std::string fault() const override { return fault_; }
    void listen(Listener listener) override { serial_.listen(std::move(listener)); }
    void send(int usart, const uint8_t* bytes, size_t size) override;
    size_t unsent(int usart) const override;
    void setUsb(bool plugged) override { usb_ = plugged; }
    void reset() override { restart(hal::ResetCause::unknown); }  // as behind a bootloader
    unsigned restarts() const override { return restarts_; }
    uint64_t begun_us() const override { return begun_us_; }
    // The processor alone: what hangs on it goes on.
    void restart(hal::ResetCause cause);
    std::vector<uint8_t> eeprom() const override { return eeprom_.cells(); }
    void setEeprom(const std::vector<uint8_t>& image) override { eeprom_.setCells(image); }
    World& world() override { return world_; }
    BoardFigures figures() const override;

    // ---- for hal.cpp and board.cpp: what the firmware asks of the board that runs it
    static NativeBoard& running();
    void idle(bool (*work_waits)());
    void select(bool imu, bool chosen);
    uint8_t transfer(uint8_t mosi);
    uint8_t flashTransfer(uint8_t mosi);
    void setBusFast(bool fast) { byte_ns_ = fast ? 1000 : 16'000; }
    void lockImu(bool lock);
    void trace(uint8_t value);
    core::Status eepromRead(uint16_t address, void* to, uint8_t size);
    void watchdogStart() { fed_us_ = now_us_; }
    void watchdogFeed();
    [[noreturn]] void reboot();
    uint64_t sinceBegun_us() const { return now_us_ - begun_us_; }
    const hal::LastRun& lastRun() const { return last_run_; }
    bool usb() const { return usb_; }
    SerialLines& serial() { return serial_; }
    EepromChip& eepromChip() { return eeprom_; }
    I2cBus& i2c() { return i2c_; }
    AnalogInputs& analog() { return analog_; }
    ServoOutputs& servos() { return servos_; }
    PpmReceiver& receiver() { return receiver_; }

private:
    struct Reboot {};
    void run();
    void bringUp();
    uint64_t nextEvent_us();
    void moveTo(uint64_t time_us);
    void runImu();
    void runDevices();
    void spend_ns(uint32_t duration_ns);
    void checkSupply();
    void waitWithFirmware(uint64_t before_us);

    FirmwareMemory memory_;
    World world_;
    uint64_t now_us_ = 0;
    LineFault spi_line_;
    uint32_t spent_ns_ = 0;  // of bus time, less than a microsecond
    SerialLines serial_;
    EepromChip eeprom_;
    I2cBus i2c_;
    AnalogInputs analog_;
    ServoOutputs servos_;
    PpmReceiver receiver_;
    uint32_t byte_ns_ = 16'000;
    bool imu_chosen_ = false, barometer_chosen_ = false;
    int imu_locks_ = 0;
    bool imu_pin_ = false, imu_waits_ = false;
    bool usb_ = false;
    bool started_ = false;
    int still_turns_ = 0;           // of the firmware, one after the other without time between
    uint64_t fed_us_ = UINT64_MAX;  // the watchdog runs once this is a time
    uint32_t frames_ = 0;
    uint8_t traced_ = 0;
    unsigned restarts_ = 0;
    uint64_t begun_us_ = 0;
    hal::LastRun last_run_ = {hal::ResetCause::power_on, 0, 0, 0};
    std::string fault_;
};

}  // namespace simulator
