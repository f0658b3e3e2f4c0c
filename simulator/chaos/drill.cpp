// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/drill.hpp"

#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"

namespace simulator::chaos {
namespace {

class NativeDrill : public Drill {
public:
    explicit NativeDrill(const WorldOptions& world) : board_(world) {}

    Board& board() override { return board_; }
    void restart(const std::string& how) override {
        board_.restart(how == "brown_out"  ? hal::ResetCause::brown_out
                       : how == "watchdog" ? hal::ResetCause::watchdog
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
        if (how == "brown_out") return sag();
        if (how == "watchdog") return hang();
        board_.reset();
    }

private:
    // In 20 ms down to where the fuses' detector resets the chip.
    void sag() {
        constexpr double kDetector_v = 2.7, kStep_v = 0.115;
        double& supply_v = board_.chip().adc().supply_v;
        for (; supply_v > kDetector_v; supply_v -= kStep_v) run_us(1000);
        board_.chip().reset(Reset::brown_out);
        supply_v = 5.0;
    }
    // The program stays where it is, interrupts go on: a jump to itself.
    void hang() {
        constexpr uint32_t kSpare = kBootSection - 2;
        avr_t* avr = board_.chip().avr();
        while (board_.chip().interrupts().running() || !avr->sreg[S_I]) run_us(1);
        avr->flash[kSpare] = 0xFF;
        avr->flash[kSpare + 1] = 0xCF;
        avr->pc = kSpare;
        avr->state = cpu_Running;
    }
    void run_us(uint64_t us) { board_.runUntil(board_.time_us() + us); }

    AvrBoard board_;
};

}  // namespace

std::unique_ptr<Drill> makeDrill(const std::string& firmware, const WorldOptions& world) {
    if (firmware.empty()) return std::make_unique<NativeDrill>(world);
    return std::make_unique<ImageDrill>(firmware, world);
}

}  // namespace simulator::chaos
