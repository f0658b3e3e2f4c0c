// SPDX-License-Identifier: GPL-3.0-or-later
// Restarts of the image on the emulated board, through its bootloader's stand-in: one flight is
// taken to a turn, and from there each case goes on in a process of its own. Prints what was
// measured; exits 0 when all was right.
//   restart_flight FIRMWARE apm1|apm2 MISSION MINUTES_FILE
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <utility>

#include "host_tests/scenarios/flight_report.hpp"
#include "host_tests/scenarios/station.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/devices/supply.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/report/task_names.hpp"

using namespace simulator;

namespace {

constexpr double kDegree = M_PI / 180;
constexpr uint64_t kStep_us = 1000;
constexpr uint16_t kFbwa_us = 1425, kLoiter_us = 1165, kAuto_us = 1300;  // of the mode switch
constexpr uint32_t kFbwa = 5, kAuto = 10, kLoiter = 12;
constexpr double kMotorOff_us = 1110;
constexpr double kLoader_s =
    1.17;  // of either board's bootloader, behind any reset but the watchdog's

struct Sticks {
    uint16_t roll = 1500, pitch = 1500, throttle = 1100, yaw = 1500, mode = kFbwa_us;
};

struct Symbol {
    size_t address = 0, size = 0;
};

Symbol symbolOf(const std::string& firmware, const char* part_of_name) {
    const std::string command = "avr-nm -S '" + firmware + "'";
    FILE* const list = popen(command.c_str(), "r");
    Symbol found;
    char line[500], name[400], type;
    for (Symbol each; list && fgets(line, sizeof line, list);)
        if (sscanf(line, "%zx %zx %c %399s", &each.address, &each.size, &type, name) == 4 &&
            strchr("bBdD", type) && strstr(name, part_of_name))
            found = {each.address & 0xFFFF, each.size};
    if (list) pclose(list);
    if (found.size == 0) throw std::runtime_error("no such symbol in the image");
    return found;
}

class Bench {
public:
    Bench(const char* firmware, const BoardWiring& wiring, const WorldOptions& options)
        : board_(firmware, options, wiring),
          schedule_(symbolOf(firmware, "schedule")),
          tasks_(readTaskNames(firmware)),
          usart_(wiring.telemetry_usart),
          link_(board_, usart_, [this](const mavlink::Frame& frame, uint64_t at_us) {
              telemetry_.take(frame, at_us);
              if (on_frame) on_frame(frame);
          }) {
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart != usart_) return;
            link_.receive(byte, at_us);
            if (script_) script_->receive(byte, at_us);
        });
        put(Sticks{});
    }

    void put(const Sticks& s) {
        board_.world().radio().sticks(
            {s.roll, s.pitch, s.throttle, s.yaw, 1500, 1500, 1500, s.mode}, true);
    }
    void run_s(double seconds) {
        const uint64_t end_us = board_.time_us() + static_cast<uint64_t>(seconds * 1e6);
        while (board_.time_us() < end_us) step();
    }
    template <class Done>
    bool runUntil(double seconds, Done done) {
        const uint64_t end_us = board_.time_us() + static_cast<uint64_t>(seconds * 1e6);
        while (!done()) {
            if (board_.time_us() > end_us) return false;
            step();
        }
        return true;
    }
    void set(const char* name, float value) {
        mavlink::ParamSet message{};
        message.target_system = 1;
        message.target_component = 1;
        std::memcpy(message.param_id, name, std::strlen(name));
        message.param_value = value;
        message.param_type = 9;
        link_.send(message);
        run_s(0.4);
    }
    void command(uint16_t number, float param1, float param2 = 0) {
        mavlink::CommandLong message{};
        message.command = number;
        message.target_system = 1;
        message.target_component = 1;
        message.param1 = param1;
        message.param2 = param2;
        link_.send(message);
    }
    // A ground station that flies the mission, for as long as it is wanted.
    void startFlight(const Waypoints& mission) {
        script_ = std::make_unique<ScriptedFlight>(board_, usart_, mission, 300);
    }
    template <class Done>
    void flyUntil(Done done) {
        if (!runUntil(90, [&] { return done() || script_->over(); }) || script_->over())
            throw std::runtime_error("the flight did not get there: " + script_->reason());
    }
    void dismiss() { script_.reset(); }

    // ---- what goes wrong
    void hang() { board_.hang(); }
    unsigned restarts() const { return board_.restarts(); }
    // The supply sags in 20 ms until the chip, and it alone, is reset, and comes back.
    void brownOut() {
        double supply_v = 5.0;
        auto& measured = board_.chip().adc().supply_v;
        const auto before = std::exchange(measured, [&supply_v] { return supply_v; });
        for (; supply_v > 2.7; supply_v -= 0.115) step();
        board_.chip().reset(Reset::brown_out);
        measured = before;
    }
    // The supply falls to this, stays there, and comes back.
    void sag(double volts, uint64_t fall_us = 20'000, uint64_t low_us = 0) {
        const uint64_t from_us = board_.time_us() + 1, to_us = from_us + fall_us + low_us;
        board_.world().supply().add({volts, from_us, to_us, fall_us});
        run_s(static_cast<double>(fall_us + low_us) * 1e-6 + 0.002);
    }
    // Nothing but the fast tier, or nothing of the slow one, is ever due.
    void starve(bool slow_only) {
        // a scheduler::Scheduler begins with what its rows wait
        uint8_t* const waits = board_.chip().avr()->data + schedule_.address;
        for (const TaskName& task : tasks_)
            if (task.tier == "slow" || (!slow_only && task.tier == "medium"))
                waits[task.number] = 100;
    }
    void pressReset() { board_.chip().reset(Reset::external); }

    double sinceBegun_s() const { return now_s() - begun_s(); }
    double begun_s() const { return static_cast<double>(board_.begun_us()) * 1e-6; }
    double now_s() const { return static_cast<double>(board_.time_us()) * 1e-6; }
    const Truth& truth() { return board_.world().truth(); }
    double servo_us(int output) { return board_.world().servoPulse_us(output); }
    Telemetry& telemetry() { return telemetry_; }
    AvrBoard& board() { return board_; }
    std::function<void(const mavlink::Frame&)> on_frame;

private:
    void step() { step_us(kStep_us); }
    void step_us(uint64_t us) {
        if (!board_.runUntil(board_.time_us() + us)) throw std::runtime_error(board_.fault());
        if (script_ && board_.time_us() / 20000 != stepped_)
            script_->step(board_.time_us()), stepped_ = board_.time_us() / 20000;
    }

    AvrBoard board_;
    const Symbol schedule_;
    const std::vector<TaskName> tasks_;
    const int usart_;
    Link link_;
    Telemetry telemetry_;
    std::unique_ptr<ScriptedFlight> script_;
    uint64_t stepped_ = 0;
};

bool failed = false;
double* emulated_s;  // of all processes

void check(bool right, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    std::printf("    %s ", right ? "ok    " : "FAILED");
    std::vprintf(format, arguments);
    std::printf("\n");
    va_end(arguments);
    failed = failed || !right;
}

double turnedBy(double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)) / kDegree; }

bool motorTurns(Bench& bench, double seconds) {
    bool turned = false;
    bench.runUntil(seconds, [&] {
        turned = turned || bench.servo_us(3) > kMotorOff_us;
        return false;
    });
    return turned;
}

// From the restart on: what the autopilot says of its attitude against the truth.
struct Watch {
    explicit Watch(Bench& to_watch) : bench(to_watch) {
        bench.on_frame = [this](const mavlink::Frame& frame) {
            const auto attitude = as<mavlink::Attitude>(frame);
            if (!attitude || before == bench.begun_s()) return;
            said.push_back(*attitude);
        };
    }
    void run(double seconds) {
        bench.runUntil(seconds, [this] {
            truth.push_back(bench.truth());
            return false;
        });
    }
    Bench& bench;
    double before = bench.begun_s();
    std::vector<mavlink::Attitude> said;
    std::vector<Truth> truth;
};

void checkAttitude(Watch& watch) {
    const double begun_us = watch.bench.begun_s() * 1e6;
    for (const mavlink::Attitude& said : watch.said) {
        if (said.time_boot_ms < 300) continue;
        const double at_us = begun_us + said.time_boot_ms * 1e3;
        const auto is = std::find_if(watch.truth.begin(), watch.truth.end(), [&](const Truth& t) {
            return static_cast<double>(t.time_us) >= at_us;
        });
        if (is == watch.truth.end()) break;
        const double roll = turnedBy(double(said.roll), is->roll_rad),
                     pitch = turnedBy(double(said.pitch), is->pitch_rad),
                     yaw = turnedBy(double(said.yaw), is->yaw_rad);
        check(
            roll < 5 && pitch < 5 && yaw < 5,
            "attitude %u ms after the beginning: wrong by %.1f, %.1f and %.1f degrees, banked %.0f",
            unsigned(said.time_boot_ms), roll, pitch, yaw, is->roll_rad / kDegree);
        return;
    }
    check(false, "attitude: nothing was said of it");
}

// ---- the cases
struct Case {
    const char* name;
    void (*run)(Bench&);
};

bool said(Bench& bench, double since_s, const char* words) {
    for (const Event& text : bench.telemetry().texts)
        if (text.time_s > since_s && text.text.find(words) != std::string::npos) return true;
    return false;
}
void checkSaid(Bench& bench, double since_s, const char* words) {
    check(said(bench, since_s, words), "it says \"%s\"", words);
}

void fliesOn(Bench& bench, void (*fail)(Bench&), uint32_t mode, const char* why) {
    std::printf("    before: banked %.0f, pitched %.0f degrees, %.1f m/s, %.0f m high\n",
                bench.truth().roll_rad / kDegree, bench.truth().pitch_rad / kDegree,
                bench.truth().airspeed_mps, bench.truth().height_m);
    Watch watch(bench);
    const double height_m = bench.truth().height_m, failed_s = bench.now_s();
    const unsigned restarts = bench.restarts();
    fail(bench);
    double motor_s = 0, pulses_s = 0;
    watch.run(0.001);
    bench.runUntil(kLoader_s + 0.4, [&] {
        watch.truth.push_back(bench.truth());
        const bool begun = bench.begun_s() > failed_s;
        const bool off = bench.servo_us(3) > 0 && bench.servo_us(3) < kMotorOff_us;
        if (begun && pulses_s == 0 && off) pulses_s = bench.sinceBegun_s();
        if (pulses_s > 0 && motor_s == 0 && bench.servo_us(3) > kMotorOff_us)
            motor_s = bench.sinceBegun_s();
        return false;
    });
    check(bench.begun_s() > failed_s, "the application began again after %.0f ms",
          (bench.begun_s() - failed_s) * 1e3);
    check(motor_s > 0 && motor_s <= 0.3, "pulses %.0f, motor %.0f ms after the beginning",
          pulses_s * 1e3, motor_s * 1e3);
    checkAttitude(watch);
    bench.run_s(8.4);
    check(bench.telemetry().mode() == mode && bench.telemetry().armed(), "in mode %u, armed",
          bench.telemetry().mode());
    check(bench.restarts() == restarts + 1, "%u restarts", bench.restarts() - restarts);
    check(!bench.truth().crashed && bench.truth().height_m > height_m - 15,
          "10 s later it is %.0f m high, it was %.0f", bench.truth().height_m, height_m);
    checkSaid(bench, failed_s, why);
}

void hang(Bench& bench) {
    bench.hang();
    bench.run_s(0.1);
}
void brownOut(Bench& bench) { bench.brownOut(); }
// The chip is reset, and of the parts those that need more than it does.
void realBrownOut(Bench& bench) { bench.sag(2.65); }
// Every part is reset, the memory lasts.
void deepBrownOut(Bench& bench) { bench.sag(1.5); }

struct SagShape {
    const char* name;
    double volts;
    uint64_t fall_us, low_us;
};
constexpr SagShape kSags[] = {
    {"2.65 V in 1 ms", 2.65, 1000, 10'000}, {"2.65 V in 8 ms", 2.65, 8000, 10'000},
    {"1.5 V at once", 1.5, 0, 20'000},      {"1.5 V in 4 ms", 1.5, 4000, 10'000},
    {"1.5 V in 20 ms", 1.5, 20'000, 0},     {"1.5 V for 0.3 s", 1.5, 20'000, 300'000},
};

// Every part restarts with the chip, or those that need more than it does. Whatever the processor
// makes of the cause, it flies on.
template <uint32_t mode, int shape>
void fliesOnAfterSag(Bench& bench) {
    const SagShape& sag = kSags[shape];
    const double height_m = bench.truth().height_m, failed_s = bench.now_s();
    bench.sag(sag.volts, sag.fall_us, sag.low_us);
    const bool armed = bench.runUntil(kLoader_s + 1.2, [&] {
        return bench.begun_s() > failed_s && bench.servo_us(3) > kMotorOff_us;
    });
    check(armed, "%s: the motor turns %.0f ms after the beginning", sag.name,
          bench.sinceBegun_s() * 1e3);
    double lowest_m = height_m;
    bench.runUntil(10, [&] {
        lowest_m = std::min(lowest_m, bench.truth().height_m);
        return false;
    });
    check(bench.telemetry().mode() == mode && bench.telemetry().armed(), "in mode %u, armed",
          bench.telemetry().mode());
    check(lowest_m > height_m - 10, "never under %.0f m, it was %.0f m high", lowest_m, height_m);
}

constexpr char kByWatchdog[] = "Restarted by watchdog, task", kByBrownOut[] = "after a brown-out";

void watchdogInTheTurn(Bench& bench) { fliesOn(bench, hang, kLoiter, kByWatchdog); }
void brownOutInTheTurn(Bench& bench) { fliesOn(bench, brownOut, kLoiter, kByBrownOut); }

// Behind the bootloader it looks like a short loss of power, and no hand reaches it there.
void buttonInTheAir(Bench& bench) {
    bench.pressReset();
    bench.run_s(4);
    check(bench.telemetry().mode() == kLoiter && bench.telemetry().armed(), "in LOITER, armed");
}

// The switch says more than what was flown before.
void otherSwitch(Bench& bench) {
    Sticks sticks;
    sticks.throttle = 1700;
    sticks.mode = kFbwa_us;
    bench.hang();
    bench.put(sticks);
    bench.run_s(2);
    check(bench.telemetry().mode() == kFbwa && bench.telemetry().armed(), "in FBWA, armed");
}

void withoutReceiver(Bench& bench) {
    bench.hang();
    bench.board().world().radio().sticks({}, false);
    bench.run_s(2);
    check(bench.telemetry().mode() == kLoiter && bench.telemetry().armed(),
          "it flies on as before, in mode %u", bench.telemetry().mode());
}

void sticksWhileItHangs(Bench& bench) {
    bench.hang();
    Sticks sticks;
    sticks.roll = 1780;
    sticks.pitch = 1390;
    sticks.throttle = 1622;
    sticks.yaw = 1444;
    bench.put(sticks);
    const double hung_s = bench.now_s(), before_s = bench.begun_s();
    const auto arrived = [&] {
        return std::abs(bench.servo_us(1) - 1780) < 4 && std::abs(bench.servo_us(2) - 1390) < 4 &&
               std::abs(bench.servo_us(3) - 1622) < 4 && std::abs(bench.servo_us(4) - 1444) < 4;
    };
    const bool came = bench.runUntil(0.25, arrived);
    check(came && bench.begun_s() == before_s, "the sticks are at the servos after %.0f ms",
          (bench.now_s() - hung_s) * 1e3);
    check(came && bench.now_s() - hung_s <= 0.2, "within 200 ms");
}

// The schedule forgets all but its fast tier.
void tierStarves(Bench& bench, bool slow_only) {
    const double before_s = bench.begun_s();
    const bool bitten = bench.runUntil(4, [&] {
        bench.starve(slow_only);
        return bench.begun_s() > before_s;
    });
    const double bitten_s = bench.now_s();
    check(bitten, "the watchdog bites");
    bench.run_s(3);
    check(bench.begun_s() < bitten_s + 0.5 && bench.telemetry().armed(), "once, and it flies on");
}
void slowTierStarves(Bench& bench) { tierStarves(bench, true); }
void mediumTierStarves(Bench& bench) { tierStarves(bench, false); }

const Case kInTheTurn[] = {
    {"the loop hangs in a turn", watchdogInTheTurn},
    {"the supply breaks down in a turn", brownOutInTheTurn},
    {"a sag for all parts in a turn", fliesOnAfterSag<kLoiter, 0>},
    {"another", fliesOnAfterSag<kLoiter, 1>},
    {"another", fliesOnAfterSag<kLoiter, 2>},
    {"another", fliesOnAfterSag<kLoiter, 3>},
    {"another", fliesOnAfterSag<kLoiter, 4>},
    {"another", fliesOnAfterSag<kLoiter, 5>},
    {"the reset button in a turn", buttonInTheAir},
    {"the mode switch is moved meanwhile", otherSwitch},
    {"without a receiver", withoutReceiver},
    {"the sticks while the loop hangs", sticksWhileItHangs},
    {"the slow tier starves", slowTierStarves},
    {"all but the fast tier starve", mediumTierStarves},
};

void missionGoesOn(Bench& bench, void (*fail)(Bench&)) {
    const int before = bench.telemetry().current();
    const double failed_s = bench.now_s();
    fail(bench);
    bench.run_s(kLoader_s + 2);
    check(bench.telemetry().mode() == kAuto && bench.telemetry().current() == before,
          "in AUTO at item %d, it was at %d", bench.telemetry().current(), before);
    check(!said(bench, failed_s, "Mission item 1"), "not from the beginning");
    const bool on = bench.runUntil(60, [&] { return bench.telemetry().current() > before + 1; });
    check(on, "it flies on to item %d", bench.telemetry().current());
}
void watchdogInTheMission(Bench& bench) { missionGoesOn(bench, hang); }
void brownOutInTheMission(Bench& bench) { missionGoesOn(bench, brownOut); }
void realBrownOutInTheMission(Bench& bench) { missionGoesOn(bench, realBrownOut); }

const Case kInTheMission[] = {
    {"the loop hangs in a mission", watchdogInTheMission},
    {"the supply breaks down in a mission", brownOutInTheMission},
    {"and for the parts that need more than the chip", realBrownOutInTheMission},
    {"a sag for all parts", fliesOnAfterSag<kAuto, 2>},
    {"another", fliesOnAfterSag<kAuto, 4>},
};

void staysOnTheGround(Bench& bench, void (*fail)(Bench&), const char* why) {
    const double failed_s = bench.now_s();
    fail(bench);
    check(!motorTurns(bench, 3), "the motor stays off");
    check(bench.begun_s() > failed_s && !bench.telemetry().armed(), "it began again, disarmed");
    if (why) checkSaid(bench, failed_s, why);
}
void button(Bench& bench) { bench.pressReset(); }
void watchdogOnTheGround(Bench& bench) { staysOnTheGround(bench, hang, kByWatchdog); }
void brownOutOnTheGround(Bench& bench) { staysOnTheGround(bench, brownOut, kByBrownOut); }
void deepBrownOutOnTheGround(Bench& bench) { staysOnTheGround(bench, deepBrownOut, kByBrownOut); }
void buttonOnTheGround(Bench& bench) { staysOnTheGround(bench, button, nullptr); }

const Case kOnTheGround[] = {
    {"the loop hangs", watchdogOnTheGround},
    {"the supply breaks down", brownOutOnTheGround},
    {"and for every part", deepBrownOutOnTheGround},
    {"the reset button", buttonOnTheGround},
};

bool runCase(Bench& bench, const Case& which) {
    std::printf("  %s\n", which.name);
    std::fflush(stdout);
    const double from_s = bench.now_s();
    const pid_t child = fork();
    if (child == 0) {
        try {
            which.run(bench);
        } catch (const std::exception& error) {
            check(false, "%s", error.what());
        }
        std::fflush(stdout);
        *emulated_s += bench.now_s() - from_s;
        _exit(failed ? 1 : 0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status == 0;
}

}  // namespace

// Heartbeat, readiness for all but what needs satellites, and the reasons meanwhile.
void coldStart(const char* firmware, const BoardWiring& wiring) {
    std::printf("  a cold start, EEPROM and DataFlash blank\n");
    WorldOptions options;
    options.gps_acquire_s = 1000;
    Bench bench(firmware, wiring, options);
    bench.runUntil(kLoader_s + 1, [&] { return bench.telemetry().heard(); });
    check(bench.telemetry().heard() && bench.sinceBegun_s() <= 0.3,
          "the first heartbeat comes %.0f ms after the beginning", bench.sinceBegun_s() * 1e3);
    bench.command(mavlink::MavCmd::component_arm_disarm, 1);
    bench.run_s(0.5);
    check(said(bench, 0, "PreArm"), "asked at once it says why it can not arm");
    bench.set("ARMING_CHECK", 1023 - 1 - 8);  // all but GPS
    bench.runUntil(4.0 - bench.sinceBegun_s(), [] { return false; });
    bench.command(mavlink::MavCmd::component_arm_disarm, 1);
    const bool armed = bench.runUntil(1.5, [&] { return bench.telemetry().armed(); });
    check(armed, "ready 4 s after the beginning");
    if (!armed) std::printf("      %s\n", bench.telemetry().texts.back().text.c_str());
    checkSaid(bench, 0, "EEPROM blank: defaults");
    checkSaid(bench, 0, "Started by a reset");
}

int main(int argc, char** argv) try {
    if (argc != 5) throw std::runtime_error("expected FIRMWARE BOARD MISSION MINUTES_FILE");
    const BoardWiring& wiring = std::strcmp(argv[2], "apm1") == 0 ? kApm1Wiring : kApm2Wiring;
    emulated_s = static_cast<double*>(
        mmap(nullptr, sizeof(double), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    if (emulated_s == MAP_FAILED) throw std::runtime_error("no shared memory");
    coldStart(argv[1], wiring);
    bool ok = !failed;
    Bench bench(argv[1], wiring, WorldOptions{});
    bench.run_s(3);
    for (const auto& [name, value] : {std::pair<const char*, float>{"FLTMODE1", kLoiter},
                                      {"FLTMODE2", kAuto},
                                      {"WP_LOITER_RAD", 20},
                                      {"SR1_EXTRA1", 25}})
        bench.set(name, value);
    std::printf(" on the ground, disarmed\n");
    for (const Case& each : kOnTheGround) ok = runCase(bench, each) && ok;
    bench.startFlight(readWaypoints(argv[3]));
    bench.flyUntil([&] { return bench.telemetry().armed(); });
    std::printf(" on the ground, armed, %.0f s\n", bench.now_s());
    for (const Case& each : kOnTheGround) ok = runCase(bench, each) && ok;
    bench.flyUntil([&] { return bench.truth().height_m > 40 && bench.telemetry().current() == 2; });
    std::printf(" in the mission, %.0f s\n", bench.now_s());
    bench.dismiss();
    Sticks sticks;
    sticks.mode = kAuto_us;
    bench.put(sticks);
    bench.run_s(1);
    for (const Case& each : kInTheMission) ok = runCase(bench, each) && ok;
    sticks.mode = kLoiter_us;
    bench.put(sticks);
    bench.run_s(20);
    std::printf(" in a turn, %.0f s\n", bench.now_s());
    for (const Case& each : kInTheTurn) ok = runCase(bench, each) && ok;
    *emulated_s += bench.now_s();
    writeMinutes(argv[4], *emulated_s / 60);
    return ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "restart_flight: %s\n", error.what());
    return 1;
}
