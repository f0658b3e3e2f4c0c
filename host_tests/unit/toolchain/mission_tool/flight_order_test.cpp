// SPDX-License-Identifier: GPL-3.0-or-later
// Rules 2 to 5 and 9 of docs/mission.md, as the tool shows them: of both sets.
#include "toolchain/mission_tool/flight_order.hpp"

#include "firmware/state/parameters.hpp"
#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/table.hpp"

namespace mission_tool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using End = FlightOrder::End;
using Items = std::vector<size_t>;

constexpr char kHome2[] = "APM 2.0\n0x10 0 0 40000 470000000 80000000\n";
constexpr char kWp2[] = "0x10 1 0 6000 470100000 80000000\n";
constexpr char kWp1[] = "0x10 0 6000 470100000 80000000\n";
constexpr char kRelay2[] = "0xB5 0 0 1 0 0\n", kDelay2[] = "0x70 0 0 0 5 0\n";
constexpr char kRelay1[] = "0x81 1 0 0 0\n", kDelay1[] = "0x20 5 0 0 0\n";

std::string apm2(const std::string& lines) { return kHome2 + lines; }
std::string jump(int target, int times) {
    return "0xB1 0 " + std::to_string(target) + " 0 " + std::to_string(times) + " 0\n";
}

FlightOrder orderOf(const std::string& text) { return flightOrder(loaded(text)); }
Items navsOf(const FlightOrder& order) {
    Items navs;
    for (const Visit& visit : order.visits) navs.push_back(visit.nav);
    return navs;
}

TEST(FlightOrderOfSet2, what_stands_before_a_nav_accompanies_it) {
    const FlightOrder order =
        orderOf(apm2(std::string(kWp2) + kRelay2 + kDelay2 + kRelay2 + kWp2 + kRelay2));
    EXPECT_THAT(navsOf(order), ElementsAre(1, 5));
    EXPECT_THAT(order.visits[0].beside, IsEmpty());
    EXPECT_THAT(order.visits[1].beside, ElementsAre(2, 3, 4));
    EXPECT_EQ(order.end, End::complete);
}

TEST(FlightOrderOfSet2, a_jump_flies_its_body_once_more_than_it_counts) {
    const FlightOrder order = orderOf(apm2(std::string(kWp2) + kRelay2 + kWp2 + jump(2, 2) + kWp2));
    EXPECT_THAT(navsOf(order), ElementsAre(1, 3, 3, 3, 5));
    EXPECT_THAT(order.visits[2].beside, ElementsAre(4, 2));
    EXPECT_THAT(order.visits[4].beside, ElementsAre(4));
}

TEST(FlightOrderOfSet2, a_jump_behind_a_condition_takes_the_airplane_off_its_leg) {
    const FlightOrder order =
        orderOf(apm2(std::string(kWp2) + kDelay2 + jump(5, 1) + kWp2 + kRelay2 + kWp2));
    EXPECT_THAT(navsOf(order), ElementsAre(1, 4, 6));
    EXPECT_THAT(order.visits[1].beside, ElementsAre(2, 3));
    EXPECT_THAT(order.visits[2].beside, ElementsAre(5));
    EXPECT_TRUE(order.visits[2].from_here);
    EXPECT_FALSE(order.visits[1].from_here);
}

TEST(FlightOrderOfSet2, a_loop_without_a_count_is_found) {
    const FlightOrder order = orderOf(apm2(std::string(kWp2) + kWp2 + kWp2 + jump(2, -1) + kWp2));
    EXPECT_THAT(navsOf(order), ElementsAre(1, 2, 3));
    EXPECT_EQ(order.end, End::repeats);
    EXPECT_EQ(order.again, 1u);
    EXPECT_EQ(endOf(order), "goes on from item 2 again, for ever");
}

TEST(FlightOrderOfSet2, ends_at_a_loiter_without_end_and_at_a_landing) {
    const std::string loiter = "0x11 1 0 6000 470000000 80000000\n";
    EXPECT_THAT(navsOf(orderOf(apm2(kWp2 + loiter + kWp2))), ElementsAre(1, 2));
    EXPECT_EQ(orderOf(apm2(kWp2 + loiter + kWp2)).end, End::circles);
    EXPECT_EQ(orderOf(apm2(loiter + kDelay2 + jump(4, 1) + kWp2)).end, End::circles);
    EXPECT_THAT(navsOf(orderOf(apm2(kDelay2 + jump(4, 1) + loiter + kWp2))), ElementsAre(3, 4));
    const std::string land = "0x15 1 0 0 470000000 80000000\n";
    EXPECT_EQ(orderOf(apm2(kWp2 + land)).end, End::landed);
    EXPECT_THAT(navsOf(orderOf(apm2(kWp2 + land + kWp2))), ElementsAre(1, 2));
}

TEST(FlightOrderOfSet2, many_counted_loops_within_one_another_are_broken_off) {
    std::string lines = kWp2;
    for (int i = 2; i < 8; ++i) lines += jump(1, 32767);
    const FlightOrder order = orderOf(apm2(lines + kWp2));
    EXPECT_EQ(order.end, End::longer);
    EXPECT_EQ(order.visits.size(), 5000u);
}

TEST(FlightOrderOfSet1, what_stands_behind_a_nav_accompanies_it) {
    const FlightOrder order =
        orderOf(apm1(std::string(kRelay1) + kWp1 + kRelay1 + kDelay1 + kRelay1 + kWp1 + kRelay1));
    EXPECT_THAT(navsOf(order), ElementsAre(2, 6));
    EXPECT_THAT(order.visits[0].beside, ElementsAre(3, 4, 5));
    EXPECT_THAT(order.visits[1].beside, ElementsAre(7));
}

TEST(FlightOrderOfSet1, a_jump_leaves_the_airplane_on_its_leg) {
    const FlightOrder back = orderOf(apm1(std::string(kWp1) + kWp1 + "0x31 0 0 0 0\n"));
    EXPECT_THAT(navsOf(back), ElementsAre(1, 2));
    EXPECT_EQ(back.end, End::repeats);
    EXPECT_EQ(back.again, 0u);

    const FlightOrder working =
        orderOf(apm1(std::string(kWp1) + kRelay1 + kDelay1 + "0x75 0 2 0 0\n" + kWp1));
    ASSERT_FALSE(working.visits.empty());
    EXPECT_EQ(working.visits[0].nav, 1u);
    EXPECT_THAT(working.visits[0].beside, testing::IsSupersetOf({2, 3, 4}));
}

TEST(FlightOrder, is_none_of_a_mission_that_is_refused_or_has_no_nav) {
    EXPECT_THAT(orderOf(apm2("0xB5 0 9 1 0 0\n" + std::string(kWp2))).visits, IsEmpty());
    EXPECT_THAT(orderOf(apm2(kRelay2)).visits, IsEmpty());
}

TEST(FlightOrder, is_what_the_table_shows_beside_each_nav) {
    const std::string loop =
        tableOf(loaded(apm2(std::string(kWp2) + kRelay2 + kWp2 + kRelay2 + jump(2, 1) + kWp2)));
    EXPECT_THAT(loop, HasSubstr("2  DO     SET_RELAY  3 "));
    EXPECT_THAT(loop, HasSubstr("4  DO     SET_RELAY  3, 6 "));
    const std::string unreached =
        tableOf(loaded(apm2("0x11 1 0 6000 470000000 80000000\n" + std::string(kRelay2) + kWp2)));
    EXPECT_THAT(unreached, HasSubstr("2  DO     SET_RELAY     (3) "));
}

}  // namespace
}  // namespace mission_tool
