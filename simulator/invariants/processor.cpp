// SPDX-License-Identifier: GPL-3.0-or-later
// The processor: restarted by nothing of its own, every frame in time, the stack within the memory.
#include "simulator/invariants/invariant.hpp"

namespace simulator::invariants {
namespace {

class NoRestartByItself : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        constexpr double kReboot_s = 3;
        if (now.restarts == restarts_) return;
        restarts_ = now.restarts;
        const double now_s = now.time_s();
        if (history.within(Cause::reboot, now_s - kReboot_s, now_s)) ++asked_;
        if (restarts_ > provoked_ + asked_)
            report(now_s, text("%u restarts, %u of them provoked", restarts_, provoked_ + asked_));
    }
    void provoked(const Provoked& what) override { provoked_ = what.restarts; }

    unsigned restarts_ = 0, provoked_ = 0, asked_ = 0;
};

class FrameInTime : public Invariant {
    void frame(const Snapshot&, const History&, const Report&) override {}
    void end(double now_s, const BoardFigures& figures, const Report& report) override {
        constexpr uint32_t kRam_bytes = 8192;  // datasheet of the ATmega2560, section 8.2
        const uint32_t late = figures.frame_overruns.value_or(0);
        if (late > 0) report(now_s, text("%u frames were late", late));
        const uint32_t used =
            figures.ram_static_bytes.value_or(0) + figures.stack_max_bytes.value_or(0);
        if (used > kRam_bytes) report(now_s, text("%u bytes of memory and stack", used));
    }
};

}  // namespace

std::unique_ptr<Invariant> noRestartByItself() { return std::make_unique<NoRestartByItself>(); }
std::unique_ptr<Invariant> frameInTime() { return std::make_unique<FrameInTime>(); }

}  // namespace simulator::invariants
