// SPDX-License-Identifier: GPL-3.0-or-later
// How exact the image's pulses are while both links, the mission store and the log are busy: what
// the receiver sends is what is reported, and in MANUAL what leaves on the same channel's output;
// no output's pulse comes early or late. Exits 0 when all limits hold.
//   pulse_times FIRMWARE apm1|apm2 MINUTES_FILE
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "host_tests/scenarios/flight_report.hpp"
#include "host_tests/scenarios/station.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

constexpr double kCycles_us = 16;
constexpr double kMax_us = 1;  // between in and out
// Of jitter: what is captured may differ by a tick of the timer, half a microsecond.
constexpr double kSpread_us = 0.5;
constexpr int kThrottle = 2, kSwitch = 7;            // held; the others are tried
constexpr std::array<int, 3> kSurfaces = {0, 1, 3};  // led through by MANUAL
constexpr std::array<uint16_t, 5> kTried_us = {1107, 1234, 1500, 1777, 1893};

struct Extent {
    double lowest = 1e9, highest = 0;
    int count = 0;
    void add(double value) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
        ++count;
    }
    double spread() const { return count == 0 ? 1e9 : highest - lowest; }
    double farthest(double from) const {
        return count == 0 ? 1e9 : std::max(std::fabs(highest - from), std::fabs(lowest - from));
    }
};

// The pulses of one output since begin().
struct Output {
    uint64_t rose = 0;  // cycle; 0: not yet
    Extent width_us, period_us;
};

class Exactness {
public:
    Exactness(const std::string& firmware, const BoardWiring& wiring)
        : wiring_(wiring),
          board_(firmware, WorldOptions{}, wiring_),
          station_(board_),
          radio_(board_, wiring_.telemetry_usart,
                 [this](const mavlink::Frame& frame, uint64_t) { take(frame); }) {
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart == Station::kUsb) station_.link().receive(byte, at_us);
            if (usart == wiring_.telemetry_usart) radio_.receive(byte, at_us);
        });
        for (size_t i = 0; i < outputs_.size(); ++i)
            board_.chip().onCompareOutput(
                wiring_.servos[i].timer, wiring_.servos[i].compare,
                [this, i](bool high, uint64_t cycle) { changed(outputs_[i], high, cycle); });
    }

    bool measure() {
        station_.connect();
        send({1500, 1500, 1500});
        makeBusy();
        bool ok = true;
        for (size_t i = 0; i < kTried_us.size(); ++i) {
            const auto of = [&](size_t by) { return kTried_us[(i + by) % kTried_us.size()]; };
            ok = measureAt({of(0), of(1), of(2)}, static_cast<int>(i)) && ok;
        }
        std::printf("  widths of an output within %.2f us, periods within %.2f us\n", widest_us_,
                    unsteadiest_us_);
        return ok;
    }
    double minutes() const { return static_cast<double>(board_.time_us()) / 60e6; }

private:
    using Surfaces = std::array<uint16_t, kSurfaces.size()>;

    void send(const Surfaces& surfaces) {
        std::array<uint16_t, 8> channels{};
        channels.fill(1500);
        channels[kThrottle] = 1100;
        channels[kSwitch] = 1165;
        for (size_t i = 0; i < surfaces.size(); ++i) channels[kSurfaces[i]] = surfaces[i];
        board_.world().radio().sticks(channels, true);
    }

    void makeBusy() {
        station_.set("FLTMODE1", 0);
        station_.set("LOG_BITMASK", 65536 + 16382 + 1);  // while disarmed, attitude at 50 Hz
        mavlink::RequestDataStream all{};
        all.target_system = station_.system();
        all.target_component = 1;
        all.req_message_rate = 10;
        all.start_stop = 1;
        station_.link().send(all);
        radio_.send(all);
        station_.run_us(5'000'000);
    }

    // A mission goes up meanwhile.
    bool measureAt(const Surfaces& surfaces, int seed) {
        send(surfaces);
        station_.run_us(400'000);
        for (Output& each : outputs_) each = {};
        reported_.reset();
        station_.upload(someMission(60, seed));
        station_.run_us(500'000);
        bool ok = true;
        for (size_t i = 0; i < surfaces.size(); ++i) ok = checkSurface(i, surfaces[i]) && ok;
        for (size_t i = 0; i < outputs_.size(); ++i) ok = check(i) && ok;
        return ok;
    }

    bool checkSurface(size_t which, uint16_t sent_us) const {
        const int channel = kSurfaces[which];
        const double out_us = outputs_[channel].width_us.farthest(sent_us);
        const double reported_us =
            reported_ ? std::fabs(double((*reported_)[channel]) - sent_us) : 1e9;
        const bool ok = out_us <= kMax_us && reported_us <= kMax_us;
        std::printf("  %s channel %d, %u us: reported %.1f us off, led through %.2f us off\n",
                    ok ? "ok    " : "FAILED", channel + 1, sent_us, reported_us, out_us);
        return ok;
    }

    // All outputs come at a rate of their own; those that nothing drives are silent.
    bool check(size_t output) {
        const Output& seen = outputs_[output];
        if (seen.width_us.count == 0 && output >= 4) return true;
        widest_us_ = std::max(widest_us_, seen.width_us.spread());
        unsteadiest_us_ = std::max(unsteadiest_us_, seen.period_us.spread());
        const bool ok = seen.width_us.count > 40 && seen.width_us.spread() <= kSpread_us &&
                        seen.period_us.spread() <= kSpread_us;
        if (!ok)
            std::printf(
                "  FAILED output %zu: %d pulses, width within %.2f us, period within %.2f us\n",
                output + 1, seen.width_us.count, seen.width_us.spread(), seen.period_us.spread());
        return ok;
    }

    void changed(Output& output, bool high, uint64_t now) {
        const double since_us = static_cast<double>(now - output.rose) / kCycles_us;
        if (high) {
            if (output.rose != 0) output.period_us.add(since_us);
            output.rose = now;
        } else if (output.rose != 0) {
            output.width_us.add(since_us);
        }
    }

    void take(const mavlink::Frame& frame) {
        if (const auto raw = as<mavlink::RcChannelsRaw>(frame))
            reported_ = {raw->chan1_raw, raw->chan2_raw, raw->chan3_raw, raw->chan4_raw};
    }

    const BoardWiring& wiring_;
    AvrBoard board_;
    Station station_;
    Link radio_;
    std::array<Output, 8> outputs_{};
    std::optional<std::array<uint16_t, 4>> reported_;
    double widest_us_ = 0, unsteadiest_us_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("expected FIRMWARE apm1|apm2 MINUTES_FILE");
    Exactness exactness(argv[1], std::string(argv[2]) == "apm1" ? kApm1Wiring : kApm2Wiring);
    const bool ok = exactness.measure();
    writeMinutes(argv[3], exactness.minutes());
    return ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "pulse_times: %s\n", error.what());
    return 1;
}
