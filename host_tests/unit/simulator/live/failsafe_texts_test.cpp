// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/failsafe_texts.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <set>

using namespace simulator::live;

namespace {

struct Row {
    std::string begins, over;
};

// The table "What can fail": the text, and where it has one the text of its end.
std::vector<Row> manual() {
    const std::regex row(R"row(^\|[^|]+\|[^|]+\| "([^"]+)" \|[^|]+\| (?:"([^"]+)" )?\|.*)row");
    std::vector<Row> rows;
    std::ifstream file(FAILSAFE_MANUAL);
    for (std::string line; std::getline(file, line);) {
        std::smatch found;
        if (std::regex_match(line, found, row)) rows.push_back({found[1], found[2]});
    }
    return rows;
}

}  // namespace

TEST(FailsafeTexts, are_those_of_the_manual) {
    std::set<std::string> known, documented;
    for (const FailsafeText& each : failsafeTexts()) known.insert(each.begins);
    for (const Row& each : manual()) documented.insert(each.begins);

    EXPECT_GT(documented.size(), 10u);
    EXPECT_EQ(known, documented);
}

TEST(FailsafeTexts, end_as_the_manual_says) {
    for (const Row& row : manual()) {
        const FailsafeText* text = failsafeBegunBy(row.begins);
        ASSERT_NE(text, nullptr) << row.begins;
        if (row.over.empty()) continue;
        EXPECT_THAT(std::vector<std::string>(text->over.begin(), text->over.end()),
                    testing::ElementsAre(row.over));
    }
    EXPECT_EQ(failsafeBegunBy("GPS back"), nullptr);
}
