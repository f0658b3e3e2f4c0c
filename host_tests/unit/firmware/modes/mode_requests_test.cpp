// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/mode_requests.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include "firmware/modes/modes.hpp"
#include "firmware/state/causes.hpp"
#include "firmware_bench.hpp"

namespace {

using firmware::modes::mayEnter;
using firmware::modes::ModeSituation;
using firmware::state::Mode;
using firmware::state::ModeReason;
using firmware::state::mutable_vehicle;

constexpr Mode kModes[] = {Mode::manual,   Mode::circle,    Mode::stabilize, Mode::training,
                           Mode::acro,     Mode::fbwa,      Mode::fbwb,      Mode::cruise,
                           Mode::autotune, Mode::automatic, Mode::rtl,       Mode::loiter,
                           Mode::guided};
const char* const kReasons[] = {"restart", "failsafe", "boot", "pilot", "ground", "mission"};
constexpr ModeSituation kSituations[] = {
    {true, false, false}, {false, true, false}, {false, false, true}};

bool needsNoSticks(Mode mode) {
    return mode == Mode::circle || mode == Mode::automatic || mode == Mode::rtl ||
           mode == Mode::loiter || mode == Mode::guided;
}

// The rows of the table in docs/failsafes.md: "| ground | none | MANUAL | without sticks |".
std::string cell(const std::string& reason, int column) {
    std::stringstream page;
    page << std::ifstream(FAILSAFE_MANUAL).rdbuf();
    const std::string text = page.str();
    size_t at = text.find("## Who may change the mode");
    at = text.find("\n| " + reason + " |", at);
    for (int i = 0; i <= column; ++i) at = text.find(" | ", at + 1);
    const size_t end = text.find(" |", at + 3);
    return text.substr(at + 3, end - at - 3);
}

bool grants(const std::string& cell, Mode mode) {
    if (cell == "MANUAL") return mode == Mode::manual;
    if (cell == "without sticks") return needsNoSticks(mode);
    EXPECT_TRUE(cell == "any" || cell == "none") << cell;
    return cell == "any";
}

TEST(ModeRequests, are_granted_as_the_table_of_the_manual_says) {
    for (int reason = 0; reason < 6; ++reason)
        for (int situation = 0; situation < 3; ++situation)
            for (const Mode mode : kModes)
                EXPECT_EQ(mayEnter(mode, ModeReason(reason), kSituations[situation]),
                          grants(cell(kReasons[reason], situation), mode))
                    << kReasons[reason] << ' ' << situation << ' ' << int(mode);
}

TEST(ModeRequests, of_all_are_granted_when_nothing_is_wrong) {
    for (int reason = 0; reason < 6; ++reason)
        for (const Mode mode : kModes) EXPECT_TRUE(mayEnter(mode, ModeReason(reason), {}));
}

TEST(ModeRequests, have_to_be_granted_by_every_situation_that_holds) {
    const ModeSituation no_attitude_no_sticks = {false, true, true};
    for (const Mode mode : kModes)
        EXPECT_FALSE(mayEnter(mode, ModeReason::ground, no_attitude_no_sticks)) << int(mode);
    EXPECT_TRUE(mayEnter(Mode::manual, ModeReason::failsafe, no_attitude_no_sticks));
}

TEST(ModeRequests, know_what_stands_against_them) {
    using firmware::state::bitOf;
    using firmware::state::Cause;
    const auto situation = [](uint16_t failing) {
        mutable_vehicle.failing = failing;
        return firmware::modes::modeSituation();
    };
    for (const Cause cause : {Cause::radio_short, Cause::radio_long}) {
        EXPECT_TRUE(situation(bitOf(cause)).no_sticks);
        EXPECT_FALSE(situation(bitOf(cause)).no_attitude);
    }
    EXPECT_TRUE(situation(bitOf(Cause::inertial)).no_attitude);
    EXPECT_FALSE(situation(bitOf(Cause::inertial)).no_sticks);
    EXPECT_FALSE(situation(bitOf(Cause::battery)).no_sticks);
    mutable_vehicle.failing = 0;
    mutable_vehicle.resuming = true;
    EXPECT_TRUE(firmware::modes::modeSituation().resuming);
}

using ModeRequest = bench::Bench;

TEST_F(ModeRequest, that_is_refused_changes_nothing_and_is_reported) {
    fly(Mode::loiter);
    const uint8_t entries = mutable_vehicle.mode_entries;
    mutable_vehicle.resuming = true;
    EXPECT_FALSE(firmware::modes::requestMode(Mode::rtl, ModeReason::pilot));
    EXPECT_EQ(mutable_vehicle.mode, Mode::loiter);
    EXPECT_EQ(mutable_vehicle.mode_entries, entries);
    mutable_vehicle.resuming = false;
    EXPECT_TRUE(firmware::modes::requestMode(Mode::rtl, ModeReason::pilot));
    EXPECT_EQ(mutable_vehicle.mode_reason, ModeReason::pilot);
}

}  // namespace
