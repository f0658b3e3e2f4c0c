// SPDX-License-Identifier: GPL-3.0-or-later
// Which stored fence is fit, on which side of it a place lies, and how many calls that takes.
#include "firmware/mission/fence_line.hpp"

#include <cmath>

#include "firmware/mission/fence_rally_items.hpp"
#include "hal/eeprom.hpp"
#include "points_rig.hpp"
#include "storage/eeprom_map.hpp"
#include "truth_table.hpp"

namespace firmware {
namespace {

using bench::Bits;
using core::Status;

struct StoredPoint {
    FencePoint kind;
    geo::Position place;
};
using StoredPoints = std::vector<StoredPoint>;

// The largest fence is gone round in three calls of seven records.
constexpr int kAtOnce = 7, kMaxPoints = 20, kNone = -1;
constexpr double kRadius_e7 = 40000;
int callsFor(int records) { return (records + kAtOnce - 1) / kAtOnce; }

geo::Position around(double turns, double radius_e7) {
    const double angle_rad = 2 * M_PI * turns;
    return beside(static_cast<int32_t>(std::lround(radius_e7 * std::cos(angle_rad))),
                  static_cast<int32_t>(std::lround(radius_e7 * std::sin(angle_rad))));
}
// Just inside or outside the middle of an edge of the polygon with so many equal ones.
geo::Position besideEdge(int edge, int corners, double by) {
    return around((edge + 0.5) / corners, by * kRadius_e7 * std::cos(M_PI / corners));
}
StoredPoints polygon(int corners, int way_back) {
    StoredPoints points;
    for (int i = 0; i < corners; ++i)
        points.push_back({FencePoint::corner, around(double(i) / corners, kRadius_e7)});
    if (way_back != kNone) points.insert(points.begin() + way_back, {FencePoint::way_back, kHome});
    return points;
}

class Fences : public Points {
protected:
    void SetUp() override {
        fakes::reset();
        Rig::SetUp();
        fenceLineStart();
    }
    // As they lie in memory, whatever an upload would have refused.
    static void keep(const StoredPoints& points) {
        const auto count = static_cast<uint16_t>(points.size());
        const auto accepted = [](auto step) {
            ASSERT_EQ(whileBusy(step), MissionResult::accepted);
        };
        // without a DataFlash there is no room for a large one beside another
        accepted([] { return listClear(ListKind::fence, kPointSet); });
        accepted([&] { return listBegin(ListKind::fence, count, kPointSet); });
        for (const StoredPoint& point : points) {
            uint8_t record[storage::kLargestRecord];
            setPlace(record, point.place);
            setFencePoint(record, point.kind);
            accepted([&] { return listPut(record); });
        }
        accepted(listCommit);
    }
    static int followUntilKnown() {
        int calls = 0;
        do {
            fenceLineFollow();
            ++calls;
        } while (calls < 20 && (fenceLine() == Line::unknown || fenceLine() == Line::checking));
        return calls;
    }
    // With the EEPROM's queue not empty.
    static void writeSomething() {
        fakes::setEepromSlow(true);
        const uint8_t other = fakes::eepromCell(storage::kHomeAndLog.begin) ^ 1;
        ASSERT_EQ(hal::eepromWrite(storage::kHomeAndLog.begin, &other, 1), Status::ok);
        ASSERT_FALSE(hal::eepromDrained());
    }
    static Line lineOf(const StoredPoints& points) {
        keep(points);
        (void)followUntilKnown();
        return fenceLine();
    }
    static Side sideOf(const geo::Position& place) {
        for (int calls = 0; calls < 20; ++calls) {
            const Side side = fenceSide(place);
            if (side != Side::unknown) return side;
        }
        return Side::unknown;
    }
};
class FenceLines : public bench::TruthTable<Fences> {};

// ---- which is fit

TEST_F(FenceLines, of_a_fence_that_is_fit_turn_it_alone) {
    static StoredPoints stored;
    const auto way_back_inside = [](bool is) {
        stored = {{FencePoint::way_back, is ? kHome : beside(50000, 0)},
                  {FencePoint::corner, beside(-40000, -40000)},
                  {FencePoint::corner, beside(-40000, 40000)}};
    };
    const auto no_way_back = [](bool is) {
        if (is) stored.erase(stored.begin());
    };
    const auto third_corner = [](bool is) {
        if (is) stored.push_back({FencePoint::corner, beside(40000, 0)});
    };
    const auto none_blank = [](bool is) {
        if (!is) stored.push_back({FencePoint::corner, {0, 0}});
    };
    const auto one_way_back = [](bool is) {
        if (!is)
            stored.insert(stored.end(),
                          {{FencePoint::way_back, kHome}, {FencePoint::way_back, beside(10, 10)}});
    };
    check({{"fit",
            {way_back_inside, no_way_back, third_corner, none_blank, one_way_back},
            [] { return lineOf(stored) == Line::fit; },
            [](const Bits& is) { return (is[0] || is[1]) && is[2] && is[3] && is[4]; }}});
}

TEST_F(FenceLines, are_none_without_a_point_and_unfit_with_too_few) {
    EXPECT_EQ(lineOf({}), Line::none);
    EXPECT_EQ(lineOf(polygon(2, kNone)), Line::unfit);
    EXPECT_EQ(lineOf(polygon(2, 1)), Line::unfit);
    EXPECT_EQ(lineOf(polygon(3, kNone)), Line::fit);
    EXPECT_EQ(lineOf({}), Line::none) << "it was cleared";
}

// As the older messages count them: with the return point, and the first corner again.
TEST_F(FenceLines, are_counted_in_FENCE_TOTAL) {
    const auto total = [](const StoredPoints& points) {
        (void)lineOf(points);
        return static_cast<int>(parameters.fence_total);
    };
    EXPECT_EQ(total(polygon(4, 0)), 6);
    EXPECT_EQ(total(polygon(4, kNone)), 6);
    EXPECT_EQ(total(polygon(20, kNone)), 22);
    EXPECT_EQ(total({}), 0);
}

TEST_F(FenceLines, say_why_only_when_the_return_point_is_outside) {
    EXPECT_EQ(lineOf(polygon(4, 0)), Line::fit);
    EXPECT_FALSE(hasStatusText("Fence"));
    StoredPoints points = polygon(4, 0);
    points[0].place = beside(50000, 0);
    EXPECT_EQ(lineOf(points), Line::unfit);
    EXPECT_TRUE(hasStatusText("Fence: return point is outside"));
}

TEST_F(FenceLines, have_their_return_point_wherever_it_stands) {
    for (const int at : {0, 2, 5}) {
        StoredPoints points = polygon(5, at);
        points[static_cast<size_t>(at)].place = beside(11, -22);
        ASSERT_EQ(lineOf(points), Line::fit);
        EXPECT_TRUE(fenceHasWayBack());
        EXPECT_EQ(fenceCorners(), 5);
        geo::Position place;
        ASSERT_EQ(fenceWayBack(place), Status::ok);
        EXPECT_EQ(place, beside(11, -22));
    }
    ASSERT_EQ(lineOf(polygon(5, kNone)), Line::fit);
    EXPECT_FALSE(fenceHasWayBack());
    EXPECT_EQ(fenceCorners(), 5);
}

TEST_F(FenceLines, are_not_known_from_a_change_until_they_are_looked_at) {
    ASSERT_EQ(lineOf(polygon(4, 0)), Line::fit);
    keep(polygon(2, 0));
    EXPECT_EQ(fenceLine(), Line::unknown);
    (void)followUntilKnown();
    EXPECT_EQ(fenceLine(), Line::unfit);
}

TEST_F(FenceLines, are_not_known_before_the_stored_ones_have_been_looked_for) {
    keep(polygon(4, 0));
    writeSomething();
    missionBoot();
    fenceLineStart();
    fakes::advance_ms(100);
    ASSERT_FALSE(missionKnown());
    for (int i = 0; i < 10; ++i) fenceLineFollow();
    EXPECT_EQ(fenceLine(), Line::unknown) << "not: none";
    for (int i = 0; i < 80; ++i) missionRun();
    ASSERT_TRUE(missionKnown());
    (void)followUntilKnown();
    EXPECT_EQ(fenceLine(), Line::fit);
}

// ---- on which side

TEST_F(FenceLines, have_each_of_their_edges_wherever_the_return_point_stands) {
    for (int corners = 3; corners <= kMaxPoints; ++corners)
        for (const int way_back : {kNone, 0, 1, corners / 2, corners}) {
            if (corners == kMaxPoints && way_back != kNone) continue;
            ASSERT_EQ(lineOf(polygon(corners, way_back)), Line::fit);
            for (int edge = 0; edge < corners; ++edge) {
                SCOPED_TRACE(testing::Message() << corners << ", " << way_back << ": " << edge);
                EXPECT_EQ(sideOf(besideEdge(edge, corners, 0.99)), Side::inside);
                EXPECT_EQ(sideOf(besideEdge(edge, corners, 1.01)), Side::outside);
            }
        }
}

// Each reads from the EEPROM, and the frame has 10 ms.
TEST_F(FenceLines, are_gone_round_in_seven_records_a_call) {
    for (int corners = 3; corners <= kMaxPoints; ++corners) {
        keep(polygon(corners, kNone));
        EXPECT_EQ(followUntilKnown(), callsFor(corners)) << corners;
        int calls = 1;
        while (fenceSide(kHome) == Side::unknown && calls < 20) ++calls;
        EXPECT_EQ(calls, callsFor(corners)) << corners;
    }
}

TEST_F(FenceLines, have_the_place_of_the_first_call_on_a_side) {
    ASSERT_EQ(lineOf(polygon(15, kNone)), Line::fit);
    EXPECT_EQ(fenceSide(kHome), Side::unknown);
    EXPECT_EQ(fenceSide(beside(90000, 0)), Side::unknown);
    EXPECT_EQ(fenceSide(beside(90000, 0)), Side::inside);
    EXPECT_EQ(sideOf(beside(90000, 0)), Side::outside);
}

TEST_F(FenceLines, are_gone_round_anew_when_another_is_stored_meanwhile) {
    ASSERT_EQ(lineOf(polygon(15, kNone)), Line::fit);
    EXPECT_EQ(fenceSide(beside(90000, 0)), Side::unknown);
    ASSERT_EQ(lineOf(polygon(5, 0)), Line::fit);
    EXPECT_EQ(fenceSide(kHome), Side::inside);
}

// ---- while the EEPROM is being written

TEST_F(FenceLines, are_looked_at_when_the_EEPROM_rests_and_say_that_they_wait) {
    keep(polygon(5, 0));
    writeSomething();
    fenceLineFollow();
    EXPECT_EQ(fenceLine(), Line::unknown);
    EXPECT_TRUE(fenceLineWaits());
    fakes::advance_ms(10);
    fenceLineFollow();
    EXPECT_EQ(fenceLine(), Line::checking);
    EXPECT_FALSE(fenceLineWaits());
    writeSomething();
    fenceLineFollow();
    EXPECT_EQ(fenceLine(), Line::checking) << "neither fit nor unfit by half a look";
    fakes::advance_ms(10);
    fenceLineFollow();
    EXPECT_EQ(fenceLine(), Line::fit);
}

TEST_F(FenceLines, are_gone_round_when_the_EEPROM_rests) {
    ASSERT_EQ(lineOf(polygon(10, 0)), Line::fit);
    writeSomething();
    EXPECT_EQ(fenceSide(kHome), Side::unknown);
    EXPECT_TRUE(fenceLineWaits());
    fakes::advance_ms(10);
    EXPECT_EQ(fenceSide(kHome), Side::unknown);
    EXPECT_FALSE(fenceLineWaits());
    writeSomething();
    EXPECT_EQ(fenceSide(kHome), Side::unknown) << "nothing was read";
    fakes::advance_ms(10);
    EXPECT_EQ(fenceSide(kHome), Side::inside);
}

// Who writes in the background goes on.
TEST_F(FenceLines, do_not_wait_when_nothing_of_them_is_to_be_read) {
    ASSERT_EQ(lineOf(polygon(5, 0)), Line::fit);
    writeSomething();
    EXPECT_EQ(fenceSide(kHome), Side::unknown);
    ASSERT_TRUE(fenceLineWaits());
    fenceLineFollow();
    EXPECT_FALSE(fenceLineWaits());
}

}  // namespace
}  // namespace firmware
