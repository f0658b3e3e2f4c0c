// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/drill.hpp"

#include "simulator/devices/supply.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"

namespace simulator::chaos {
namespace {

// A sag of the supply: to where the fuses' detector resets the chip alone, or so deep that every
// part restarts with it while the memory survives.
bool sag(Board& board, const std::string& how) {
    if (how != "brown_out" && how != "power_dip") return false;
    constexpr uint64_t kFall_us = 5000, kLow_us = 10'000;
    const double volts = how == "brown_out" ? 2.65 : 1.5;
    const uint64_t from_us = board.time_us() + 1;
    board.world().supply().add({volts, from_us, from_us + kFall_us + kLow_us, kFall_us});
    return true;
}

class NativeDrill : public Drill {
public:
    explicit NativeDrill(const WorldOptions& world) : board_(world) {}

    Board& board() override { return board_; }
    void restart(const std::string& how) override {
        if (!sag(board_, how))
            board_.restart(how == "watchdog" ? hal::ResetCause::watchdog
                                             : hal::ResetCause::unknown);
    }

private:
    NativeBoard board_;
};

class ImageDrill : public Drill {
public:
    ImageDrill(const std::string& firmware, const WorldOptions& world) : board_(firmware, world) {}

    Board& board() override { return board_; }
    void restart(const std::string& how) override {
        if (sag(board_, how)) return;
        if (how == "watchdog") return board_.hang();
        board_.reset();
    }

private:
    AvrBoard board_;
};

}  // namespace

std::unique_ptr<Drill> makeDrill(const std::string& firmware, const WorldOptions& world) {
    if (firmware.empty()) return std::make_unique<NativeDrill>(world);
    return std::make_unique<ImageDrill>(firmware, world);
}

}  // namespace simulator::chaos
