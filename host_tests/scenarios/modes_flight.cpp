// SPDX-License-Identifier: GPL-3.0-or-later
// A flight through every mode, each entered by the mode switch and flown for a while in wind with
// gusts, by a pilot who sees the airplane. Fails when a mode does not do what it is for.
//   modes_flight native|FIRMWARE MISSION OUT SECONDS_A_MODE MINUTES_FOLDER
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "host_tests/scenarios/flight_scenario.hpp"
#include "simulator/devices/ppm_encoder.hpp"

using namespace simulator;

namespace {

constexpr uint64_t kStep_us = 20'000;
constexpr double kAlone_s = 35;
constexpr double kFrom_s = 20;  // in the air and past the take-off
constexpr double kBankLimit_deg = 45;
constexpr int kInvertedChannel = 7;
constexpr float kCircleOption = 72;
constexpr uint16_t kUp_us = 1815, kMiddle_us = 1500, kDown_us = 1165;

struct Moment {
    double t_s, roll_deg, north_m, east_m, height_m, airspeed_mps;
};
using Flown = std::vector<Moment>;

struct Range {
    double lowest = 1e9, highest = -1e9, sum = 0;
    int count = 0;
    double span() const { return highest - lowest; }
    double mean() const { return sum / count; }
};
Range range(const Flown& flown, double Moment::*what, double from_s, double to_s) {
    Range found;
    for (const Moment& moment : flown) {
        if (moment.t_s < from_s || moment.t_s > to_s) continue;
        found.lowest = std::min(found.lowest, moment.*what);
        found.highest = std::max(found.highest, moment.*what);
        found.sum += moment.*what;
        ++found.count;
    }
    return found;
}

double distance_m(const Moment& from, const Moment& to) {
    return std::hypot(to.north_m - from.north_m, to.east_m - from.east_m);
}

// Farthest from the line between the first moment after `from_s` and the last one.
double bend_m(const Flown& flown, double from_s) {
    const auto first =
        std::find_if(flown.begin(), flown.end(), [&](const Moment& m) { return m.t_s >= from_s; });
    const Moment& last = flown.back();
    const double length_m = distance_m(*first, last);
    double max_m = 0;
    for (auto at = first; at != flown.end(); ++at) {
        const double across = (at->east_m - first->east_m) * (last.north_m - first->north_m) -
                              (at->north_m - first->north_m) * (last.east_m - first->east_m);
        max_m = std::max(max_m, std::abs(across) / length_m);
    }
    return max_m;
}

struct Sticks {
    int roll = 0, pitch = 0, throttle = 0;  // us from the middle
};

// ---- what the pilot does, by the seconds in the mode
int pull(double wanted, double is, double gain) {
    return static_cast<int>(std::clamp((wanted - is) * gain, -250.0, 250.0));
}
Sticks holdLevel(double, const Truth& truth) {
    const double climb_rad = std::clamp((70 - truth.height_m) * 0.01, -0.1, 0.15);
    return {pull(0, truth.roll_rad + 0.3 * truth.roll_rate_rads, 350),
            pull(climb_rad + 0.03, truth.pitch_rad + 0.3 * truth.pitch_rate_rads, 500), 40};
}
Sticks hands_off(double, const Truth&) { return {}; }
Sticks holdHeight(double t_s, const Truth& truth) {
    return {0, holdLevel(t_s, truth).pitch / 2, 40};
}
Sticks bankHard(double t_s, const Truth& truth) {
    if (t_s < 1 || t_s > 5) return holdLevel(t_s, truth);
    return {400, pull(0.1, truth.pitch_rad, 500), 60};
}
Sticks bankByFbw(double t_s, const Truth&) { return {t_s > 1 && t_s < 5 ? 400 : 0, 30, 60}; }
Sticks bankBothWays(double t_s, const Truth&) {
    if (t_s < 1 || t_s > 13) return {0, 30, 60};
    return {std::fmod(t_s, 6) < 3 ? 400 : -400, 30, 60};
}
Sticks rollAndStop(double t_s, const Truth& truth) {
    static bool out;  // on the way to the bank, and back
    if (t_s < 1) out = false;
    if (t_s > 1 && t_s < 4 && truth.roll_rad > 25 * kDegree) out = true;
    if (t_s > 1 && t_s < 4 && !out) return {200, 0, 60};
    if (t_s > 6 && truth.roll_rad > 6 * kDegree) return {-200, 0, 60};
    return {0, 0, 60};
}
Sticks climbAWhile(double t_s, const Truth&) { return {0, t_s > 8 && t_s < 12 ? 400 : 0, 0}; }

// ---- what is to be seen of it
bool straight(const Flown& flown) {
    return range(flown, &Moment::roll_deg, 3, 99).highest < 20 &&
           range(flown, &Moment::roll_deg, 3, 99).lowest > -20;
}
bool controlled(const Flown& flown) {
    return range(flown, &Moment::roll_deg, 3, 99).highest < 40 &&
           range(flown, &Moment::roll_deg, 3, 99).lowest > -40;
}
bool withinTheLimit(const Flown& flown) {
    const Range bank = range(flown, &Moment::roll_deg, 0, 99);
    return bank.highest < kBankLimit_deg + 6 && bank.lowest > -kBankLimit_deg - 6;
}
bool heldAtTheLimit(const Flown& flown) {
    const double max_deg = range(flown, &Moment::roll_deg, 1, 6).highest;
    const double held_deg = range(flown, &Moment::roll_deg, 3, 5).mean();
    return max_deg < kBankLimit_deg + 8 && std::abs(held_deg - kBankLimit_deg) < 3 &&
           straight({flown.end() - 20, flown.end()});
}
bool stoppedWhereLetGo(const Flown& flown) {
    const Range bank = range(flown, &Moment::roll_deg, 4, 6);
    const Range back = range(flown, &Moment::roll_deg, 9, 99);
    return bank.span() < 10 && bank.mean() > 18 && back.highest < 20 && back.lowest > -20;
}
bool bankedAsDemanded(const Flown& flown) {
    const Range bank = range(flown, &Moment::roll_deg, 3.5, 5);
    return std::abs(bank.mean() - kBankLimit_deg) < 5 && bank.highest < kBankLimit_deg + 8;
}
bool bankedBothWays(const Flown& flown) {
    const Range bank = range(flown, &Moment::roll_deg, 1, 13);
    return std::abs(bank.highest - kBankLimit_deg) < 8 &&
           std::abs(bank.lowest + kBankLimit_deg) < 8;
}
bool heldAndClimbed(const Flown& flown) {
    const double end_s = flown.back().t_s;
    const Range before = range(flown, &Moment::height_m, 3, 8);
    const Range after = range(flown, &Moment::height_m, end_s - 2, end_s);
    const double speed_mps = range(flown, &Moment::airspeed_mps, 6, 8).mean();
    return before.span() < 4 && after.span() < 3 && std::abs(speed_mps - 15.2) < 2 &&
           std::abs(after.mean() - before.mean() - 8) < 3.5;
}
bool heldTrackAndHeight(const Flown& flown) {
    return bend_m(flown, 3) < 2.5 && range(flown, &Moment::height_m, 3, 99).span() < 5;
}
bool circledGently(const Flown& flown) {
    const Range bank = range(flown, &Moment::roll_deg, 4, 99);
    return std::abs(bank.mean() - kBankLimit_deg / 3) < 4 &&
           range(flown, &Moment::height_m, 4, 99).span() < 6;
}
bool stayedNear(const Flown& flown) {
    const auto far = std::max_element(flown.begin(), flown.end(), [&](auto& a, auto& b) {
        return distance_m(flown.front(), a) < distance_m(flown.front(), b);
    });
    return distance_m(flown.front(), *far) < 120 &&
           range(flown, &Moment::height_m, 5, 99).span() < 8;
}
bool cameNearer(const Flown& flown) {
    const Moment home{};
    double max_m = 0;
    for (const Moment& moment : flown) max_m = std::max(max_m, distance_m(home, moment));
    const double now_m = distance_m(home, flown.back());
    return now_m < max_m - 30 || now_m < 100;
}

// Half a roll each way takes the time before and after.
constexpr double kInvertedFrom_s = 1, kInvertedUntil_s = 5;  // of the start, before the end
bool flewInverted(const Flown& flown) {
    const double end_s = flown.back().t_s;
    for (const Moment& each : flown)
        if (each.t_s > 4.5 && each.t_s < end_s - kInvertedUntil_s && std::abs(each.roll_deg) < 150)
            return false;
    const Range height = range(flown, &Moment::height_m, 0, end_s);
    return height.span() < 12 && std::abs(flown.back().roll_deg) < 25;
}

struct Leg {
    const char* name;
    uint8_t mode;
    Sticks (*pilot)(double t_s, const Truth& truth);
    bool (*passes)(const Flown& flown);
    const char* what;
    bool inverted = false;   // by the pilot's switch
    bool by_option = false;  // entered by the switch that RC6_OPTION gives CIRCLE to
};
constexpr Leg kLegs[] = {
    {"MANUAL", 0, holdLevel, controlled, "flew as the pilot did"},
    {"STABILIZE", 2, holdHeight, straight, "levelled the wings"},
    {"TRAINING", 3, bankHard, heldAtTheLimit, "banked to the limit and no further"},
    {"ACRO", 4, rollAndStop, stoppedWhereLetGo, "stayed where the stick was let go"},
    {"FBWA", 5, bankByFbw, bankedAsDemanded, "banked as demanded"},
    {"AUTOTUNE", 8, bankBothWays, bankedBothWays, "banked both ways"},
    {"FBWB", 6, climbAWhile, heldAndClimbed, "held height and speed, climbed as demanded"},
    {"CRUISE", 7, hands_off, heldTrackAndHeight, "held track and height"},
    {"CRUISE", 7, hands_off, flewInverted, "flew upside down, and rolled back", true},
    {"CIRCLE", 1, hands_off, circledGently, "circled at a third of the bank", false, true},
    {"LOITER", 12, hands_off, stayedNear, "stayed near"},
    {"GUIDED", 15, hands_off, stayedNear, "stayed near"},
    {"RTL", 11, hands_off, cameNearer, "came nearer"},
    {"AUTO", 10, hands_off, withinTheLimit, "went on"},
};

class ModesFlight : FlightScenario {
public:
    ModesFlight(Board& board, const Waypoints& items, double seconds_a_mode)
        : FlightScenario(board, items, 900, kStep_us), seconds_a_mode_(seconds_a_mode) {}

    bool fly() {
        // nobody connects for a while: home is refined, and what is missing for arming is reported
        while (seconds() < kAlone_s && advance(false)) {
        }
        while (advance() && sinceAirborne_s() <= kFrom_s) {
        }
        set("ACRO_LOCKING", 1);
        set("INVERTEDFLT_CH", kInvertedChannel);
        set("RC6_OPTION", kCircleOption);
        bool passed = true;
        bool upper = false;
        prepare(kLegs[0], upper);
        for (const Leg& leg : kLegs) {
            if (leg.by_option) upper = !upper;  // the mode switch stays where it is
            const Flown flown = flyLeg(leg, upper);
            passed = check(leg, flown) && passed;
            upper = !upper;
        }
        if (frameWasLate()) std::printf("  FAILED  a frame was late\n");
        passed_ = passed && !flight_.over() && !frameWasLate();
        if (!passed_) printEvents(flight_);
        return passed_;
    }

    Summary summary(const std::string& firmware, const WorldOptions& world) const {
        return summarised("every mode", passed_, firmware, world);
    }

private:
    // The next mode goes to the end of the switch where it does not stand.
    void prepare(const Leg& leg, bool upper) { set(upper ? "FLTMODE6" : "FLTMODE1", leg.mode); }

    Flown flyLeg(const Leg& leg, bool upper) {
        Flown flown;
        const Leg* next = &leg + 1 == std::end(kLegs) ? nullptr : &leg + 1;
        const double from_s = seconds();
        for (double t_s = 0; t_s < seconds_a_mode_ && advance(); t_s = seconds() - from_s) {
            const Truth& truth = board_.world().truth();
            const Sticks sticks = leg.pilot(t_s, truth);
            const auto us = [](int by) { return static_cast<uint16_t>(kMiddle_us + by); };
            const bool inverted =
                leg.inverted && t_s > kInvertedFrom_s && t_s < seconds_a_mode_ - kInvertedUntil_s;
            board_.world().radio().sticks(
                {us(sticks.roll), us(sticks.pitch), us(sticks.throttle), kMiddle_us, kMiddle_us,
                 leg.by_option ? kUp_us : kDown_us, inverted ? kUp_us : kMiddle_us,
                 upper ? kUp_us : kDown_us},
                true);
            if (step_ % 5 != 0) continue;
            flown.push_back({t_s, truth.roll_rad / kDegree, truth.north_m, truth.east_m,
                             truth.height_m, truth.equivalent_airspeed_mps});
            if (next != nullptr && !next->by_option && flown.size() % 20 == 0)
                prepare(*next, !upper);
        }
        return flown;
    }

    bool check(const Leg& leg, const Flown& flown) {
        if (flown.size() < 10) return false;
        const Range bank = range(flown, &Moment::roll_deg, 0, 99);
        const Range height = range(flown, &Moment::height_m, 0, 99);
        const bool entered = flight_.telemetry().mode() == leg.mode;
        const bool banked = bank.highest < 56 && bank.lowest > -56;
        const bool safe = (banked || leg.inverted) && height.lowest > 25;
        const bool passed = entered && safe && leg.passes(flown);
        std::printf("  %s  %-9s %s: bank %.0f to %.0f, height %.1f to %.1f m, bend %.1f m%s%s\n",
                    passed ? "ok    " : "FAILED", leg.name, leg.what, bank.lowest, bank.highest,
                    height.lowest, height.highest, bend_m(flown, 3),
                    entered ? "" : ", was not entered", safe ? "" : ", was not safe");
        if (!passed)
            for (size_t i = 0; i < flown.size(); i += 5)
                std::printf("    %5.1f s bank %5.1f height %5.1f speed %4.1f at %.1f %.1f\n",
                            flown[i].t_s, flown[i].roll_deg, flown[i].height_m,
                            flown[i].airspeed_mps, flown[i].north_m, flown[i].east_m);
        return passed;
    }

    void set(const char* name, float value) {
        usb_.send(paramSet(flight_.telemetry().system, name, value));
    }

    const double seconds_a_mode_;
    bool passed_ = false;
};

}  // namespace

int main(int count, char** words) {
    if (count != 6) {
        std::cerr << "usage: modes_flight native|FIRMWARE MISSION OUT SECONDS_A_MODE MINUTES\n";
        return 2;
    }
    const Waypoints items = readWaypoints(words[2]);
    return flyAndCheck<ModesFlight>(words[1], gustyWorldAt(items, 5, 5), words[3], words[5], items,
                                    std::stod(words[4]));
}
