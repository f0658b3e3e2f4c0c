// SPDX-License-Identifier: GPL-3.0-or-later
// An APM 1 or 2.x: the emulated ATmega2560 with any firmware in its flash, and the World's chips on
// its pins. It knows the wiring, nothing of the firmware.
#pragma once
#include <memory>
#include <optional>

#include "simulator/board.hpp"
#include "simulator/devices/line_fault.hpp"
#include "simulator/line_noise.hpp"
#include "simulator/machine/board_wiring.hpp"
#include "simulator/machine/chip.hpp"
#include "simulator/machine/chip_supply.hpp"
#include "simulator/machine/radio_line.hpp"
#include "simulator/machine/serial_feed.hpp"
#include "simulator/machine/servo_pulses.hpp"
#include "simulator/machine/vcd_trace.hpp"
#include "simulator/machine/work_meter.hpp"

namespace simulator {

class AvrBoard : public Board {
public:
    // `firmware`: an .elf or .hex file; throws std::runtime_error that says what is wrong with it.
    AvrBoard(const std::string& firmware, const WorldOptions& options,
             const BoardWiring& wiring = kApm2Wiring);
    ~AvrBoard() override;

    bool runUntil(uint64_t time_us) override;
    uint64_t time_us() const override { return chip_.cycle() / kCyclesPer_us; }
    std::string fault() const override { return chip_.fault(); }
    void listen(Listener listener) override { listener_ = std::move(listener); }
    void send(int usart, const uint8_t* bytes, size_t size) override;
    size_t unsent(int usart) const override { return feeds_.at(usart).unsent(); }
    void setUsb(bool plugged) override;
    void reset() override { chip_.reset(Reset::external); }
    std::string flash(const std::string& firmware) override;
    unsigned restarts() const override { return restarts_; }
    // The program stays where it is for ever, as soon as it runs and has switched its watchdog on,
    // within 5 s; interrupts go on.
    void hang();
    uint64_t begun_us() const override { return begun_us_; }
    std::vector<uint8_t> eeprom() const override { return chip_.eeprom().contents(); }
    void setEeprom(const std::vector<uint8_t>& image) override;
    World& world() override { return world_; }
    BoardFigures figures() const override;
    std::optional<uint32_t> lastFrame_us() const override { return work_.lastFrame_us(); }

    enum class Led { a, b, c };
    bool ledOn(Led led) const;
    // SPI bytes that went to both sensors at once: a fault of the firmware.
    uint64_t busContentions() const { return contentions_; }

    void traceTo(const std::string& path);    // servos, PPM, data ready, trace as VCD
    void profileTo(const std::string& path);  // written by closeProfile
    void closeTrace() override;
    void closeProfile() override;
    void serveGdb(int port) { chip_.serveGdb(port); }  // the CPU waits for the debugger
    Chip& chip() { return chip_; }
    bool heldInReset() const { return supply_.held(); }  // by a low supply

private:
    void wireSensorBus();
    void wireFlash();
    void wireConverter();
    template <class Device>
    void wireTwoWire(Device& device);
    double volts(int pin);
    void wireSerial();
    bool flies(char timer, int compare) const;
    void wireOutputs();
    void wireMarks();
    void restart();
    void begun(uint16_t address, uint8_t value);

    void portChanged();
    void selectSensors();
    void selectFlash();
    void selectConverter();
    bool pulledLow(const PinName& pin) const;
    bool chosen(const std::optional<PinName>& pin) const { return pin && pulledLow(*pin); }
    uint8_t exchange(uint8_t mosi);
    void sent(int usart, uint8_t byte, uint64_t cycle);
    void feedGps();
    void passTime(uint64_t now_us);
    void showFaults();
    void showDataReady();
    void showConversionEnd();

    uint64_t conversionEnds_us();
    uint64_t nextEvent();
    void planWake();
    uint64_t wake(uint64_t due);
    void trace(size_t signal, unsigned value);

    const BoardWiring wiring_;
    World world_;
    Image image_;
    LineFault spi_line_;
    Chip chip_;
    ChipSupply supply_;
    std::vector<SerialFeed> feeds_;
    Listener listener_;
    LineNoise gps_noise_;
    ServoPulses servos_;
    RadioLine radio_;
    WorkMeter work_;
    std::unique_ptr<VcdTrace> trace_;
    std::string profile_path_;
    uint64_t wake_cycle_ = UINT64_MAX;
    bool imu_chosen_ = false, barometer_chosen_ = false, barometer_deaf_ = false;
    bool flash_chosen_ = false, flash_in_reset_ = false;
    bool converter_chosen_ = false;
    bool data_ready_ = false, conversion_ended_ = false;
    uint64_t contentions_ = 0;
    unsigned restarts_ = 0;
    bool program_runs_ = false;  // since the last reset
    uint64_t begun_us_ = 0;
    std::optional<uint64_t> first_cycle_;  // of the program, after the first reset
    WriteChain clears_;
};

}  // namespace simulator
