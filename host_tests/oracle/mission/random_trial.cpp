// SPDX-License-Identifier: GPL-3.0-or-later
// Random missions and random flights: mostly short, so that what matters meets often.
#include "trial.hpp"

namespace oracle {

// xorshift64*, Vigna 2016: the same numbers everywhere.
uint32_t Random::next() {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<uint32_t>((state_ * 0x2545F4914F6CDD1DULL) >> 32);
}

namespace {

constexpr int kMaxItems = 171;
constexpr int kMaxCounters = 15;

template <size_t N>
int oneOf(Random& random, const int (&ids)[N]) {
    return ids[random.below(static_cast<int>(N))];
}

int randomNavId(Random& random, CommandSet set) {
    const int dice = random.below(100);
    if (dice < 10) return 0x15;
    if (dice < 22) return 0x16;
    if (dice < 32 && set == CommandSet::apm2) return random.from(0x1E, 0x1F);
    return dice < 70 ? 0x10 : random.from(0x10, set == CommandSet::apm1 ? 0x16 : 0x17);
}

int randomActionId(Random& random, CommandSet set) {
    static constexpr int kApm1[] = {0x30, 0x32, 0x33, 0x34, 0x40, 0x41, 0x42, 0x60,
                                    0x61, 0x64, 0x70, 0x72, 0x73, 0x80, 0x81, 0x82};
    static constexpr int kArduPlaneExtension[] = {0x5D, 0xBD, 0xBF, 0xC3, 0xC5, 0xC9, 0xCB,
                                                  0xCD, 0xCE, 0xCF, 0xD2, 0xD4, 0xF0, 0xF1,
                                                  0xF2, 0xD6, 0xF3, 0xF4, 0xF5};
    if (set == CommandSet::apm1) return oneOf(random, kApm1);
    return random.percent(30) ? oneOf(random, kArduPlaneExtension) : random.from(0xB2, 0xB8);
}

Bytes randomJump(Random& random, CommandSet set, int count, int& counters) {
    const int target = random.percent(8) ? random.below(256) : random.from(1, count);
    if (set == CommandSet::apm1) {
        if (random.percent(35)) return make(set, 0x31, 0, 0, 0, 0);
        if (random.percent(20)) return make(set, 0x75, target, 0, 0, 0);
        const int64_t wild = random.percent(4)   ? -target
                             : random.percent(4) ? target + 256
                                                 : target;
        return make(set, 0x75, random.below(256), wild, 0, 0);
    }
    const bool counted = counters < kMaxCounters && random.percent(75);
    counters += counted;
    static constexpr int kUnfit[] = {0, -2, 32768, -32768};
    const int times = random.percent(4)   ? oneOf(random, kUnfit)
                      : !counted          ? -1
                      : random.percent(3) ? 32767
                                          : random.from(1, 4);
    return make(set, 0xB1, target, random.from(-9, 9), times, 0);
}

// The mix of a mission: how many of 100 are of each class.
struct Mix {
    int nav, condition, jump;
};

Bytes randomItem(Random& random, CommandSet set, const Mix& mix, int index, int count,
                 int& counters) {
    const int dice = random.below(100);
    const int64_t p2 = random.from(-32000, 32000) * 256 + index;
    const int p1 = random.percent(5) ? kOutOfRange : random.below(70);
    if (random.percent(4)) {
        static constexpr int kUnknown[] = {0x00, 0x01, 0x18, 0x2F, 0x50, 0xB0, 0xB9, 0xFF};
        return make(set, oneOf(random, kUnknown), p1, p2, 0, 0);
    }
    if (dice < mix.jump) return randomJump(random, set, count, counters);
    const int64_t p3 = random.from(-1800000000, 1800000000);
    const int64_t p4 = random.from(-900000000, 900000000);
    if (dice < mix.jump + mix.nav) {
        const bool here = random.percent(20);
        return make(set, randomNavId(random, set), p1, p2, here ? 0 : p3,
                    here || random.percent(5) ? 0 : p4);
    }
    if (dice < mix.jump + mix.nav + mix.condition) {
        const int id = set == CommandSet::apm1 ? random.from(0x20, 0x21) : random.from(0x70, 0x73);
        return make(set, id, p1, p2, p3, p4);
    }
    const bool leaves = random.percent(8);
    return make(set, randomActionId(random, set), leaves ? kLeavesAuto : p1, p2, p3, p4);
}

int randomLength(Random& random) {
    const int dice = random.below(1000);
    if (dice < 10) return 0;
    if (dice < 960) return random.from(1, 12);
    return dice < 997 ? random.from(13, 40) : random.from(41, kMaxItems - 1);
}

Stored randomMission(Random& random, CommandSet set) {
    const Mix mix = {random.from(5, 60), random.from(0, 30), random.from(0, 40)};
    const int items = randomLength(random);
    Stored stored;
    stored.set = set;
    stored.mission.push_back(make(set, 0x10, 0, 0, 7, 7));  // home
    int counters = 0;
    for (int i = 1; i <= items; ++i)
        stored.mission.push_back(randomItem(random, set, mix, i, items, counters));
    return stored;
}

// The same again, or with something changed near what is flown, or another one.
Stored nextMission(Random& random, const Stored& before) {
    const int dice = random.below(100);
    if (dice < 30) return before;
    if (dice < 40)
        return randomMission(random, random.percent(50) ? CommandSet::apm1 : CommandSet::apm2);
    if (dice < 45) return {before.set, {before.mission.front()}};  // cleared
    Stored after = before;
    int counters = kMaxCounters;
    const int size = static_cast<int>(after.mission.size());
    const int at = random.from(1, size);
    if (at == size || dice < 55) {
        if (size <= kMaxItems)
            after.mission.push_back(
                randomItem(random, after.set, {30, 20, 20}, size, size, counters));
    } else if (dice < 65) {
        after.mission.pop_back();
    } else {
        after.mission[static_cast<size_t>(at)] =
            randomItem(random, after.set, {30, 20, 20}, at, size - 1, counters);
    }
    return after;
}

Step randomStep(Random& random, Trial& trial) {
    const int dice = random.below(1000);
    Step step;
    if (dice < 800) {
        step.how.nav = random.percent(35);
        step.how.condition = random.percent(45);
        if (random.percent(20)) step.how.busy = random.next() | 1;
        if (step.how.busy != 0 && random.percent(50)) step.how.cut = random.from(1, 4);
        step.how.late_nav = random.percent(30);
        step.how.late_condition = random.percent(30);
    } else if (dice < 920) {
        step.what = random.percent(85) ? Happens::enter : Happens::enter_afresh;
    } else if (dice < 940) {
        step.what = Happens::leave;
    } else if (dice < 960) {
        step.what = Happens::set_current;
        const int count = static_cast<int>(trial.missions.back().mission.size());
        step.argument = random.percent(10) ? random.below(256) : random.below(count + 1);
    } else if (dice < 968) {
        step.what = Happens::trailing;
        step.argument = random.below(2);
    } else if (dice < 985) {
        step.what = Happens::commit;
        trial.missions.push_back(nextMission(random, trial.missions.back()));
        step.argument = static_cast<int>(trial.missions.size()) - 1;
    } else {
        step.what = random.percent(70) ? Happens::watchdog : Happens::power_loss;
    }
    return step;
}

}  // namespace

Trial randomTrial(uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 4; ++i) random.next();
    Trial trial;
    const CommandSet set = random.percent(50) ? CommandSet::apm1 : CommandSet::apm2;
    trial.missions.push_back(randomMission(random, set));
    if (random.percent(50)) trial.steps.push_back({Happens::trailing, 1, {}});
    trial.steps.push_back({Happens::enter, 0, {}});
    const int steps = random.from(4, 60);
    for (int i = 0; i < steps; ++i) trial.steps.push_back(randomStep(random, trial));
    return trial;
}

}  // namespace oracle
