// SPDX-License-Identifier: GPL-3.0-or-later
// The image and power cuts: while a mission is changed, what the EEPROM and the DataFlash would be
// left with is taken at many of their writes, with the byte or page in flight damaged. Another
// board wakes up with that and is asked for its mission: the old or the new one, whole, and the
// new one once it has been acknowledged. Prints counts; exits 0 when all were right.
//   power_cuts FIRMWARE MINUTES_FILE
#include <cstdio>

#include "host_tests/scenarios/flight_report.hpp"
#include "host_tests/scenarios/station.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

constexpr uint64_t kSettled_us = 12'000'000;  // 60 items are copied in 6 s
constexpr unsigned kEach = 12, kThen = 41;    // each of the first cuts, then every so many

double emulated_min = 0;

struct Change {
    const char* name;
    Waypoints before, after;
    std::function<void(Station&, const Waypoints&)> make;
};

struct Memories {
    std::vector<uint8_t> eeprom, flash;
};

class Campaign {
public:
    Campaign(const char* firmware, const Change& change)
        : firmware_(firmware),
          change_(change),
          board_(firmware, WorldOptions{}),
          station_(board_) {}

    bool run() {
        station_.connect();
        station_.upload(change_.before);
        station_.run_us(kSettled_us);
        World& world = board_.world();
        world.dataflash().on_operation = [this](const At45db::Operation&) { ++pages_; };
        first_ = writes();
        seen_ = 0;
        station_.on_step = [this] { look(); };
        change_.make(station_, change_.after);
        station_.run_us(kSettled_us);
        station_.on_step = nullptr;
        const bool done = same(station_.download(), change_.after);
        emulated_min += static_cast<double>(board_.time_us()) / 60e6;
        std::printf("  %s %s: %u writes of bytes and pages, %u cuts: %u old, %u new, %u wrong\n",
                    wrong_ == 0 && done ? "ok    " : "FAILED", change_.name, seen_, cuts_, old_,
                    new_, wrong_);
        return wrong_ == 0 && done;
    }

    unsigned cuts() const { return cuts_; }

private:
    unsigned writes() { return static_cast<unsigned>(eeprom().writes()) + pages_; }
    const Eeprom& eeprom() { return board_.chip().eeprom(); }

    // What has begun since the last look is in flight now.
    void look() {
        const unsigned now = writes() - first_;
        if (now == seen_) return;
        seen_ = now;
        if (seen_ > kEach && seen_ % kThen != 0) return;
        cut({eeprom().contents(), board_.world().dataflash().image(board_.time_us())});
    }

    void cut(const Memories& left) {
        ++cuts_;
        AvrBoard board(firmware_, WorldOptions{});
        board.setEeprom(left.eeprom);
        board.world().dataflash().setImage(left.flash);
        Station station(board);
        station.connect();
        const auto found = station.download();
        emulated_min += static_cast<double>(board.time_us()) / 60e6;
        const bool is_new = same(found, change_.after);
        const bool is_old = same(found, change_.before) && !station_.answered();
        ++(is_new ? new_ : is_old ? old_ : wrong_);
        if (is_new || is_old) return;
        std::printf("  cut at write %u: %zu items%s\n", seen_, found.size(),
                    station_.answered() ? ", after it was acknowledged" : "");
    }

    const char* firmware_;
    const Change& change_;
    AvrBoard board_;
    Station station_;
    unsigned pages_ = 0, first_ = 0, seen_ = 0, cuts_ = 0, old_ = 0, new_ = 0, wrong_ = 0;
};

void upload(Station& station, const Waypoints& mission) { station.upload(mission); }
void clear(Station& station, const Waypoints&) { station.clear(); }
void replacePart(Station& station, const Waypoints& mission) { station.replace(20, 24, mission); }

Waypoints withPart(Waypoints base, int first, int last) {
    const Waypoints other = someMission(static_cast<int>(base.size()), 9);
    for (int i = first; i <= last; ++i)
        base[static_cast<size_t>(i)] = other[static_cast<size_t>(i)];
    return base;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) throw std::runtime_error("expected FIRMWARE MINUTES_FILE");
    const Change changes[] = {
        {"a long mission over a short one", someMission(8, 1), someMission(60, 2), upload},
        {"a short mission over a long one", someMission(60, 2), someMission(8, 1), upload},
        {"a part of a mission", someMission(40, 3), withPart(someMission(40, 3), 20, 24),
         replacePart},
        {"a clear", someMission(40, 3), {}, clear},
    };
    bool ok = true;
    unsigned cuts = 0;
    for (const Change& change : changes) {
        Campaign campaign(argv[1], change);
        ok = campaign.run() && ok;
        cuts += campaign.cuts();
    }
    std::printf("%u power cuts in %.1f emulated minutes\n", cuts, emulated_min);
    writeMinutes(argv[2], emulated_min);
    return ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "power_cuts: %s\n", error.what());
    return 1;
}
