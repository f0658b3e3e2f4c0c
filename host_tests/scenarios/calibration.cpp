// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane with bad accelerometers is held in hands and calibrated by wire, as a ground station
// talks its pilot through it; natively its compass too. Before and after, what it measures is
// held against gravity. Prints what it finds, exits 0 when all is as it should be.
//   calibration native|FIRMWARE apm1|apm2 MINUTES_FILE
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "host_tests/scenarios/bench.hpp"
#include "simulator/devices/hmc5883l.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"

using namespace simulator;

namespace {

bool ok = true;
void hold(bool holds, const char* what, double value) {
    std::printf("  %s %s (%.3f)\n", holds ? "ok    " : "FAILED", what, value);
    ok = ok && holds;
}

constexpr double kDegrees = M_PI / 180;
struct Pose {
    double roll_deg, pitch_deg;
};
// In the order in which they are asked for, as well as hands can.
constexpr Pose kPoses[] = {{2, -1}, {-86, 3}, {93, -4}, {5, -84}, {-6, 85}, {176, 5}};

class Calibration {
public:
    Calibration(Board& board, Bench& bench) : board_(board), bench_(bench) {}

    void lay(const Pose& pose) {
        board_.world().turnTo(pose.roll_deg * kDegrees, pose.pitch_deg * kDegrees, 0.3);
        bench_.run_s(3);
    }
    // The mean of a second.
    double felt_mg() {
        constexpr int kReadings = 10;
        double x = 0, y = 0, z = 0;
        for (int i = 0; i < kReadings; ++i) {
            bench_.raw_imu.reset();
            if (!bench_.waitUntil(3, [&] { return bench_.raw_imu.has_value(); })) return 0;
            x += bench_.raw_imu->xacc;
            y += bench_.raw_imu->yacc;
            z += bench_.raw_imu->zacc;
        }
        return std::sqrt(x * x + y * y + z * z) / kReadings;
    }
    double worst_mg() {
        double worst = 0;
        for (const Pose& pose : kPoses) {
            lay(pose);
            worst = std::max(worst, std::abs(felt_mg() - 1000));
        }
        return worst;
    }
    void calibrateSides() {
        const int answer = bench_.command(mavlink::MavCmd::preflight_calibration, 0, 0, 1);
        hold(answer == mavlink::MavResult::accepted, "the six sides are begun", answer);
        for (int side = 1; side <= 6; ++side) {
            if (!bench_.waitUntil(10, [&] { return bench_.wanted_side == side; }))
                return hold(false, "it asks for a side", side);
            lay(kPoses[side - 1]);
            bench_.pressKey(static_cast<uint16_t>(side));
        }
        const bool ended = bench_.waitUntil(10, [&] { return bench_.wanted_side > 6; });
        hold(ended, "it comes to an end", bench_.wanted_side);
        hold(bench_.received("Calibration successful"), "with success", 1);
    }
    void calibrateCompass() {
        const int answer = bench_.command(mavlink::MavCmd::do_start_mag_cal);
        hold(answer == mavlink::MavResult::accepted, "the compass's turns are begun", answer);
        const int before = bench_.timesReceived("Calibration successful");
        const uint64_t from_us = board_.time_us();
        for (int i = 0; i < 170 && bench_.timesReceived("Calibration successful") == before; ++i) {
            const double wobble = std::sin(0.37 * i);
            board_.world().turn(0.9 * wobble, 0.8, 0.5 * std::cos(0.21 * i));
            bench_.run_s(1);
        }
        hold(bench_.timesReceived("Calibration successful") > before, "they end well, s",
             static_cast<double>(board_.time_us() - from_us) * 1e-6);
        const auto& offset = board_.world().compass().offset_mg();
        const char* const kNames[] = {"COMPASS_OFS_X", "COMPASS_OFS_Y", "COMPASS_OFS_Z"};
        for (size_t i = 0; i < 3; ++i) {
            const double left_mg = offset[i] + double{bench_.parameter(kNames[i])};
            hold(std::abs(left_mg) < 12, kNames[i], left_mg);
        }
    }

private:
    Board& board_;
    Bench& bench_;
};

WorldOptions handHeld() {
    WorldOptions options;
    options.bench_model = true;
    options.accel_bias_g = 0.06;
    options.accel_scale = 0.03;
    return options;
}

std::unique_ptr<Board> boardOf(const std::string& firmware, const char* kind) {
    if (firmware == "native") return std::make_unique<NativeBoard>(handHeld());
    const bool first = std::strcmp(kind, "apm1") == 0;
    return std::make_unique<AvrBoard>(firmware, handHeld(), first ? kApm1Wiring : kApm2Wiring);
}

// Red flashes while it is not armed, blue shines when there is a fix.
void lookAtLights(AvrBoard& board, Bench& bench) {
    int red = 0, blue = 0;
    constexpr int kLooks = 160;
    for (int i = 0; i < kLooks; ++i) {
        bench.run_s(0.01);
        red += board.ledOn(AvrBoard::Led::a);
        blue += board.ledOn(AvrBoard::Led::c);
    }
    hold(red > 10 && red < 60, "the red light flashes", red);
    hold(blue == kLooks, "the blue one shines", blue);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("expected native|FIRMWARE apm1|apm2 MINUTES_FILE");
    const auto board = boardOf(argv[1], argv[2]);
    switchTransmitterOn(board->world());
    WatchedBoard watched(*board);
    watched.watch().excuse("late_frame");  // it has its own bound, below
    Bench bench(watched);
    bench.run_s(8);
    bench.stream(mavlink::MavDataStream::raw_sensors, 10);
    if (auto* avr = dynamic_cast<AvrBoard*>(board.get())) lookAtLights(*avr, bench);
    Calibration calibration(*board, bench);
    const double before_mg = calibration.felt_mg();
    hold(std::abs(before_mg - 1000) > 15, "before, it measures too much or too little, mg",
         before_mg);
    calibration.calibrateSides();
    const double worst_mg = calibration.worst_mg();
    hold(worst_mg < 8, "afterwards it measures gravity on every side, mg off", worst_mg);
    if (std::strcmp(argv[1], "native") == 0) calibration.calibrateCompass();
    const double throttle_us = board->world().servoPulse_us(3);
    hold(std::abs(throttle_us - 1100) < 2, "the motor's output stays at its minimum, us",
         throttle_us);
    const BoardFigures figures = board->figures();
    if (figures.frame_overruns)
        hold(*figures.frame_overruns <= 2, "no frame is late but one for the sum, longest, ms",
             *figures.frame_max_us * 1e-3);
    std::filesystem::create_directories(std::filesystem::path(argv[3]).parent_path());
    std::ofstream(argv[3]) << static_cast<double>(board->time_us()) / 60e6 << '\n';
    return watched.held() && ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "calibration: %s\n", error.what());
    return 1;
}
