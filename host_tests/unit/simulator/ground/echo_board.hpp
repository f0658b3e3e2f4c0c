// SPDX-License-Identifier: GPL-3.0-or-later
// A board without a firmware: every 10 ms it sends one byte on each line, and it remembers what
// it was sent.
#pragma once
#include <array>

#include "simulator/board.hpp"

class EchoBoard : public simulator::Board {
public:
    EchoBoard() : world_(simulator::WorldOptions()) {}

    bool runUntil(uint64_t time_us) override {
        for (; now_us_ / 10'000 < time_us / 10'000; now_us_ += 10'000) {
            for (const int usart : {0, 2}) listener_(usart, static_cast<uint8_t>(usart), now_us_);
        }
        now_us_ = time_us;
        return true;
    }
    uint64_t time_us() const override { return now_us_; }
    std::string fault() const override { return ""; }
    void listen(Listener listener) override { listener_ = std::move(listener); }
    void send(int usart, const uint8_t* bytes, size_t size) override {
        sent.at(static_cast<size_t>(usart)).append(bytes, bytes + size);
    }
    size_t unsent(int) const override { return 0; }
    void setUsb(bool plugged) override { usb = plugged; }
    void reset() override {}
    std::string flash(const std::string& firmware) override {
        return firmware == "right.elf" ? "" : "no image";
    }
    std::vector<uint8_t> eeprom() const override { return {}; }
    void setEeprom(const std::vector<uint8_t>&) override {}
    simulator::World& world() override { return world_; }
    simulator::BoardFigures figures() const override { return {}; }

    std::array<std::string, 4> sent;
    bool usb = false;

private:
    simulator::World world_;
    uint64_t now_us_ = 0;
    Listener listener_ = [](int, uint8_t, uint64_t) {};
};
