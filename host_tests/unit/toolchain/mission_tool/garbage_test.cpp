// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged input of every kind: the program ends with an answer, whatever it is given. Runs under
// the sanitizers, too.
#include <random>

#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/airplane.hpp"
#include "toolchain/mission_tool/arduplane.hpp"
#include "toolchain/mission_tool/flight_findings.hpp"
#include "toolchain/mission_tool/flight_table.hpp"
#include "toolchain/mission_tool/page.hpp"
#include "toolchain/mission_tool/table.hpp"
#include "toolchain/mission_tool/text_form.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"

namespace mission_tool {
namespace {

constexpr uint32_t kSeed = 19990401;
constexpr int kMutations = 10'000;

std::string mutated(std::string text, std::mt19937& random) {
    const auto below = [&](size_t limit) { return random() % std::max<size_t>(limit, 1); };
    static const char* const kPieces[] = {"nan",
                                          "inf",
                                          "-",
                                          "1e308",
                                          "\t",
                                          "\n",
                                          "#",
                                          "0x",
                                          ":",
                                          "4294967296",
                                          "-2147483648",
                                          "QGC",
                                          "999999999999999999999",
                                          "APM 2.0\n",
                                          "null",
                                          "{",
                                          "]",
                                          "\"",
                                          "[[[["};
    for (size_t changes = 1 + below(4); changes > 0; --changes) {
        const size_t at = below(text.size());
        switch (below(6)) {
            case 0:
                if (!text.empty()) text[at] = static_cast<char>(random());
                break;
            case 1:
                if (!text.empty()) text[at] = static_cast<char>(text[at] ^ 1 << below(8));
                break;
            case 2:
                text.erase(at, below(20));
                break;
            case 3:
                text.insert(at, kPieces[below(std::size(kPieces))]);
                break;
            case 4:
                text.insert(at, text.substr(below(text.size()), below(200)));
                break;
            default:
                if (!text.empty()) text[at] = static_cast<char>('0' + below(10));
                break;
        }
    }
    return text;
}

// Shown, checked and drawn.
void fly(const Document& document, uint32_t chance) {
    static const Power power(airplaneNamed(kUsualAirplane));
    const FlightOrder order = flightOrder(document);
    Conditions conditions;
    conditions.wind = {chance % 16 * 1.0, {}};
    if (chance % 3 != 0) conditions.wind.from_deg = chance % 360;
    conditions.fence = document.fence;
    const Estimate flight = estimate(document, order, power, conditions.wind);
    const auto found = flightFindings(document, order, flight, conditions);
    if (order.visits.empty() || flight.stretches.empty()) return;
    EXPECT_FALSE(flightTableOf(document, order, flight).empty());
    EXPECT_FALSE(sumsOf(order, flight).empty());
    EXPECT_FALSE(pageOf({document, order, flight, found, kUsualAirplane, conditions.wind}).empty());
}

// All that the program does with a file, but for the files it writes. True: it was a good mission.
bool digest(const std::string& contents, bool records15, uint32_t chance) {
    Reading reading;
    reading.onto = blankImage();
    reading.records15 = records15;
    try {
        Document document = load(contents, "fuzz", reading);
        bool good = true;
        for (const Finding& finding : findings(document)) good = good && !finding.error;
        EXPECT_FALSE(tableOf(document).empty());
        EXPECT_FALSE(recordsAsText(document).empty());
        const std::string waypoints = recordsAsWaypoints(document);
        if (!good) return false;
        fly(document, chance);
        const std::string plan = recordsAsPlan(document);
        if (!plan.empty()) {
            EXPECT_EQ(recordsAsWaypoints(loaded(plan)), waypoints);
        }
        const Image image = uploaded(document, reading.onto, "");
        Document stored = storedMission(image, "fuzz");
        checkAll(stored);
        EXPECT_EQ(recordsAsWaypoints(stored), waypoints);
        EXPECT_EQ(compiled(recordsAsText(stored)), image);
        return true;
    } catch (const WrongInput& error) {
        EXPECT_NE(std::string(error.what()), "");
        return false;
    }
}

TEST(Garbage, ten_thousand_mutations_of_every_kind_of_input_get_an_answer) {
    const std::string text1 = apm1("0x10 30 6000 470100000 80000000\n0x20 5 0 0 0\n0x75 0 1 0 0\n");
    const std::string text2 = between("3 178 0 12.5 -1 0 0 0 0");
    const Image image = compiled(text2);
    const std::string plan = R"({"fileType":"Plan","version":1,"mission":{"version":2,
"plannedHomePosition":[47,8,400],"items":[
{"type":"SimpleItem","command":22,"doJumpId":1,"frame":3,"params":[15,0,0,null,0,0,40]},
{"type":"ComplexItem","complexItemType":"survey","TransectStyleComplexItem":{"Items":[
{"type":"SimpleItem","command":16,"frame":3,"params":[0,0,0,null,47.003,8,60]},
{"type":"SimpleItem","command":18,"frame":3,"params":[2,0,0,null,47.003,8.004,60]}]}},
{"type":"SimpleItem","command":177,"doJumpId":5,"frame":2,"params":[1,2,0,0,0,0,0]},
{"type":"SimpleItem","command":21,"doJumpId":6,"frame":3,"params":[0,0,0,null,47,8,0]}]},
"geoFence":{"version":2,"breachReturn":[47,8],"circles":[{"inclusion":false,"circle":{
"center":[47.01,8],"radius":50}}],"polygons":[{"inclusion":true,"polygon":[[46.9,7.9],[46.9,8.1],
[47.1,8.1],[47.1,7.9]]}]},"rallyPoints":{"version":2,"points":[[47.001,8,50]]}})";
    const std::string inputs[] = {text1, text2,        kTwoWaypoints, plan,
                                  plan,  rawOf(image), hexOf(image),  hexOf(compiled(text1))};
    std::mt19937 random(kSeed);
    int good = 0;
    for (int i = 0; i < kMutations; ++i) {
        const std::string input = mutated(inputs[random() % std::size(inputs)], random);
        good += digest(input, random() % 8 == 0, random());
    }
    // both ways out are taken often
    EXPECT_GT(good, kMutations / 20);
    EXPECT_LT(good, kMutations * 19 / 20);
}

// CRCs stop nearly every mutation of an image: here it is the stored bytes that are anything.
TEST(Garbage, any_bytes_as_records_of_15_get_an_answer) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < 500; ++i) {
        Image image = blankImage();
        for (size_t at = 0x500; at < 0x500 + 15 * (random() % 190); ++at)
            if (at < image.size()) image[at] = static_cast<uint8_t>(random() >> (random() % 8));
        for (size_t at = 0x506; at < image.size(); at += 15) image[at] = 0;
        (void)digest(rawOf(image), true, random());
    }
}

}  // namespace
}  // namespace mission_tool
