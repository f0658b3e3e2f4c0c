// SPDX-License-Identifier: GPL-3.0-or-later
// docs/failsafes.md says what the firmware's tables say: row by row, in their order.
#include <fstream>
#include <sstream>
#include <string>

#include "firmware/safety/failsafe_table.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/spelt.hpp"

namespace {

using firmware::safety::Cause;

const char* const kNames[firmware::safety::kCauses] = {
    "inertial sensor", "fence",     "battery",  "headwind", "radio for long",
    "ground station",  "radio",     "position", "height",   "GPS",
    "GPS jump",        "barometer", "airspeed", "compass"};
const char* const kSeverities[] = {"emergency", "alert",  "critical", "error",
                                   "warning",   "notice", "info",     "debug"};
const char* const kActions[] = {"MANUAL", "turn back", "RTL", "glide", "CIRCLE"};

std::string manual() {
    std::stringstream text;
    text << std::ifstream(FAILSAFE_MANUAL).rdbuf();
    return text.str();
}

std::string causesOf(const firmware::safety::Transition& row) {
    std::string names;
    for (int cause = 0; cause < firmware::safety::kCauses; ++cause)
        if (row.causes >> cause & 1)
            names += (names.empty() ? "" : ", ") + std::string(kNames[cause]);
    return names;
}

std::string flownOf(uint8_t flown) {
    if (flown == firmware::safety::kWhatever) return "anything";
    const char* const kFlown[] = {"pilot", "itself", "CIRCLE", "RTL"};
    std::string names;
    for (int bit = 0; bit < 4; ++bit)
        if (flown >> bit & 1) names += (names.empty() ? "" : ", ") + std::string(kFlown[bit]);
    return names;
}

// "" where nothing is reported.
std::string quoted(firmware::notify::StatusText text) {
    return text.isEmpty() ? "" : " \"" + spelt(text) + "\"";
}

TEST(FailsafeManual, lists_every_cause_with_its_words_and_its_number_in_the_log) {
    const std::string page = manual();
    size_t at = 0;
    for (int cause = 0; cause < firmware::safety::kCauses; ++cause) {
        const firmware::safety::CauseRow& row = firmware::safety::kCauseTable[cause];
        std::stringstream begins, rest;
        begins << "\n| " << kNames[cause] << " | ";
        rest << " |" << quoted(row.begins) << " | " << kSeverities[int(row.severity)] << " |"
             << quoted(row.ends) << " | " << int(row.subsystem) << ", " << int(row.code) << " |\n";
        const size_t found = page.find(begins.str(), at);
        ASSERT_NE(found, page.npos) << begins.str();
        const size_t end = page.find('\n', found + 1);
        const std::string line = page.substr(found, end + 1 - found);
        EXPECT_NE(line.find(rest.str()), line.npos) << line << "should end in" << rest.str();
        at = found;
    }
}

TEST(FailsafeManual, lists_every_transition_in_its_order) {
    const std::string page = manual();
    size_t at = 0;
    for (int index = 0; index < firmware::safety::kTransitionCount; ++index) {
        const firmware::safety::Transition& row = firmware::safety::kTransitions[index];
        std::stringstream begins;
        begins << "\n| " << index + 1 << " | " << causesOf(row) << " | " << flownOf(row.flown)
               << " | ";
        const size_t found = page.find(begins.str(), at);
        ASSERT_NE(found, page.npos) << begins.str();
        const size_t end = page.find('\n', found + 1);
        const std::string line = page.substr(found, end + 1 - found);
        const std::string rest = " | " + std::string(kActions[int(row.action)]) + " | " +
                                 (row.after == firmware::safety::After::back ? "back" : "stays") +
                                 " |\n";
        EXPECT_NE(line.find(rest), line.npos) << line << "should end in" << rest;
        at = found;
    }
    EXPECT_EQ(page.find("\n| " + std::to_string(firmware::safety::kTransitionCount + 1) + " | "),
              page.npos);
}

}  // namespace
