// SPDX-License-Identifier: GPL-3.0-or-later
// Which stored fence is fit, on which side of it a place lies, and how many calls that takes.
#include "firmware/mission/fence_line.hpp"

#include <cmath>
#include <random>

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

// The largest polygon is gone round in three calls of seven records.
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
    // As a ground station sends it.
    static void send(const Items& items) {
        ASSERT_EQ(whileBusy([] { return listClear(ListKind::fence, kPointSet); }),
                  MissionResult::accepted);
        ASSERT_EQ(store(mavlink::MavMissionType::fence, items), MissionResult::accepted);
        (void)followUntilKnown();
    }
    static Line sentLine(const Items& items) {
        send(items);
        return fenceLine();
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

// ---- zones as items

using Corners = std::vector<geo::Position>;
MissionItem circle(bool inclusion, const geo::Position& centre, float radius_m) {
    return point(inclusion ? mavlink::MavCmd::nav_fence_circle_inclusion
                           : mavlink::MavCmd::nav_fence_circle_exclusion,
                 centre, radius_m);
}
Items area(bool inclusion, const Corners& corners) {
    Items items;
    for (const auto& corner : corners)
        items.push_back(point(inclusion ? mavlink::MavCmd::nav_fence_polygon_vertex_inclusion
                                        : mavlink::MavCmd::nav_fence_polygon_vertex_exclusion,
                              corner, static_cast<float>(corners.size())));
    return items;
}
MissionItem wayBack(const geo::Position& place) {
    return point(mavlink::MavCmd::nav_fence_return_point, place);
}
Corners square(int32_t half_e7, int32_t north_e7 = 0, int32_t east_e7 = 0) {
    return {beside(north_e7 - half_e7, east_e7 - half_e7),
            beside(north_e7 - half_e7, east_e7 + half_e7),
            beside(north_e7 + half_e7, east_e7 + half_e7),
            beside(north_e7 + half_e7, east_e7 - half_e7)};
}
Items operator+(Items a, const Items& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
// Northward, where 1e-7 degrees are 11.1 mm.
geo::Position north_m(double metres) { return geo::moved(kHome, {static_cast<float>(metres), 0}); }

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

TEST_F(FenceLines, are_counted_in_FENCE_TOTAL) {
    const auto total = [](const StoredPoints& points) {
        (void)lineOf(points);
        return static_cast<int>(parameters.fence_total);
    };
    EXPECT_EQ(total(polygon(4, 0)), 5);
    EXPECT_EQ(total(polygon(4, kNone)), 4);
    EXPECT_EQ(total(polygon(20, kNone)), 20);
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

// ---- zones

TEST_F(FenceLines, of_a_circle_have_its_two_sides) {
    for (const float radius_m : {20.0f, 249.9f, 250.0f, 251.0f, 3000.0f, 10000.0f}) {
        SCOPED_TRACE(radius_m);
        const double near = radius_m * 0.0005 + 0.05;
        ASSERT_EQ(sentLine(Items{circle(true, kHome, radius_m)}), Line::fit);
        EXPECT_EQ(sideOf(north_m(radius_m - near)), Side::inside);
        EXPECT_EQ(sideOf(north_m(radius_m + near)), Side::outside);
        ASSERT_EQ(sentLine(Items{circle(false, kHome, radius_m)}), Line::fit);
        EXPECT_EQ(sideOf(north_m(radius_m - near)), Side::outside);
        EXPECT_EQ(sideOf(north_m(radius_m + near)), Side::inside);
    }
}

// Of the places that 1e-7 degrees part, one whose distance is the radius to the last bit.
TEST_F(FenceLines, of_a_circle_have_its_rim_outside) {
    constexpr float kWide_m = 100;
    ASSERT_EQ(sentLine(Items{circle(true, kHome, kWide_m)}), Line::fit);
    int on_the_rim = 0;
    for (int32_t north_e7 = 8000; north_e7 < 8900 && on_the_rim == 0; ++north_e7)
        for (int32_t east_e7 = 0; east_e7 < 8000 && on_the_rim == 0; ++east_e7) {
            const geo::Position place = beside(north_e7, east_e7);
            if (geo::distance_m(kHome, place) != kWide_m) continue;
            ++on_the_rim;
            EXPECT_EQ(sideOf(place), Side::outside);
        }
    EXPECT_EQ(on_the_rim, 1);
}

// Of inclusions all hold at once, of exclusions none.
TEST_F(FenceLines, hold_a_place_that_is_in_each_zone_to_stay_in_and_in_none_to_stay_out_of) {
    static geo::Position centres[2], exclusions[2];
    static const geo::Position apart = beside(90000, 0);
    check({{"inside",
            {[](bool is) { centres[0] = is ? kHome : apart; },
             [](bool is) { centres[1] = is ? kHome : apart; },
             [](bool is) { exclusions[0] = is ? apart : kHome; },
             [](bool is) { exclusions[1] = is ? apart : kHome; }},
            [] {
                const auto at = [](const geo::Position& centre) {
                    return square(20000, centre.latitude_e7 - kHome.latitude_e7);
                };
                send(Items{circle(true, centres[0], 200)} + area(false, at(exclusions[1])) +
                     area(true, at(centres[1])) + Items{circle(false, exclusions[0], 200)});
                return sideOf(kHome) == Side::inside;
            },
            bench::all}});
}

TEST_F(FenceLines, are_fit_with_any_one_zone_and_no_other_point) {
    const Items ring{circle(true, kHome, 100)}, hole{circle(false, beside(90000, 0), 100)};
    for (const Items& zone :
         {ring, hole, area(false, square(20000, 90000)), area(true, square(20000))}) {
        EXPECT_EQ(sentLine(zone), Line::fit);
        EXPECT_EQ(sentLine(zone + Items{wayBack(kHome)}), Line::fit);
        EXPECT_EQ(sentLine(Items{wayBack(kHome)} + zone), Line::fit);
    }
    EXPECT_EQ(sentLine(Items{wayBack(kHome)}), Line::unfit);
}

TEST_F(FenceLines, are_not_fit_when_a_zone_forbids_the_return_point) {
    const Items polygon = area(true, square(40000)), back{wayBack(beside(10000, 0))};
    ASSERT_EQ(sentLine(polygon + back), Line::fit);
    for (const Items& zone :
         {Items{circle(false, beside(12000, 0), 50)}, area(false, square(3000, 12000)),
          Items{circle(true, beside(-12000, 0), 50)}, area(true, square(3000, -12000))}) {
        (void)statusTexts();
        EXPECT_EQ(sentLine(polygon + zone + back), Line::unfit);
        EXPECT_TRUE(hasStatusText("Fence: return point is outside"));
    }
}

TEST_F(FenceLines, with_zones_are_counted_by_all_their_points) {
    ASSERT_EQ(sentLine(area(true, square(40000)) + Items{wayBack(kHome)}), Line::fit);
    EXPECT_EQ(parameters.fence_total, 5);
    EXPECT_FALSE(fenceHasZones());
    ASSERT_EQ(sentLine(area(true, square(40000)) + Items{circle(false, beside(90000, 0), 9)}),
              Line::fit);
    EXPECT_EQ(parameters.fence_total, 5);
    EXPECT_TRUE(fenceHasZones());
    ASSERT_EQ(sentLine(area(false, square(3000, 90000))), Line::fit);
    EXPECT_TRUE(fenceHasZones());
    ASSERT_EQ(sentLine(area(true, square(40000))), Line::fit);
    EXPECT_FALSE(fenceHasZones());
}

// To go on to another zone costs as much as two edges, a circle as one.
TEST_F(FenceLines, with_zones_take_more_calls) {
    const auto calls = [](const Items& items) {
        send(items);
        int count = 1;
        while (fenceSide(kHome) == Side::unknown && count < 20) ++count;
        return count;
    };
    const Items ring{circle(true, kHome, 500)}, hole = area(false, square(3000, 90000));
    Items rings;
    for (int count = 1; count <= kMaxPoints; ++count) {
        rings = rings + ring;
        EXPECT_EQ(calls(rings), (count + 2) / 3) << count;
    }
    EXPECT_EQ(calls(hole), 1);
    EXPECT_EQ(calls(ring + hole), 1) << "3 and 4";
    EXPECT_EQ(calls(hole + ring), 1) << "6, and the circle is done once begun";
    const Items five = area(false, {beside(90000, 0), beside(93000, 0), beside(95000, 2000),
                                    beside(93000, 4000), beside(90000, 4000)});
    EXPECT_EQ(calls(five + ring), 2) << "7 are enough";
    EXPECT_EQ(calls(hole + hole), 2) << "6 and 1, 3";
    EXPECT_EQ(calls(hole + hole + hole), 3) << "6 and 1, 5 and 2, 2";
    EXPECT_EQ(calls(hole + hole + hole + hole + hole), 4) << "6 and 1, 5 and 2, 4 and 3, 3 and 4";
}

// Outside of one is outside: what follows need not be looked at.
TEST_F(FenceLines, are_left_as_soon_as_one_zone_says_so) {
    Items rings(20, circle(true, kHome, 500));
    send(rings);
    EXPECT_EQ(fenceSide(north_m(510)), Side::outside);
    EXPECT_EQ(fenceSide(kHome), Side::unknown);
}

// A place on the other side of the earth, or farther than any circle is wide, is in none.
TEST_F(FenceLines, of_a_circle_end_with_it) {
    ASSERT_EQ(sentLine(Items{circle(true, kHome, 10000)}), Line::fit);
    for (const geo::Position& far :
         {geo::Position{-470000000, -1720000000}, geo::Position{900000000, 0},
          geo::Position{-900000000, 1800000000}, beside(1000000, 0), beside(-1000000, 0),
          beside(0, 2000000), beside(0, -2000000)})
        EXPECT_EQ(sideOf(far), Side::outside);
}

// ---- drawn fences, and another way to find out what holds a place

struct Zone {
    bool inclusion;
    Corners rim;
    float radius_m;  // 0: a polygon
};
bool holds(const Zone& zone, const geo::Position& place) {
    const auto east = [&](const geo::Position& at) {
        return static_cast<double>(at.longitude_e7 - place.longitude_e7);
    };
    const auto north = [&](const geo::Position& at) {
        return static_cast<double>(at.latitude_e7 - place.latitude_e7);
    };
    if (zone.radius_m > 0) return geo::distance_m(zone.rim[0], place) < zone.radius_m;
    double turned = 0;  // the angle under which the whole rim is seen
    for (size_t i = 0; i < zone.rim.size(); ++i) {
        const auto &a = zone.rim[i], &b = zone.rim[(i + 1) % zone.rim.size()];
        turned +=
            std::remainder(std::atan2(east(b), north(b)) - std::atan2(east(a), north(a)), 2 * M_PI);
    }
    return std::abs(turned) > M_PI;
}

TEST_F(FenceLines, have_the_sides_of_zones_in_any_order) {
    std::mt19937 random(3);
    const auto up_to = [&](int most) { return static_cast<int>(random() % (most + 1u)); };
    const auto somewhere = [&] { return beside(up_to(80000) - 40000, up_to(80000) - 40000); };
    int inside = 0, outside = 0;
    for (int fence = 0; fence < 300; ++fence) {
        SCOPED_TRACE(fence);
        std::vector<Zone> zones;
        Items items;
        while (items.size() < 16 && (zones.empty() || up_to(3) > 0)) {
            Zone zone = {up_to(2) == 0, {somewhere()}, 0};
            const int corners = 3 + up_to(2);
            if (up_to(1) == 0) {
                zone.radius_m = static_cast<float>((zone.inclusion ? 300 : 50) + up_to(200));
                items.push_back(circle(zone.inclusion, zone.rim[0], zone.radius_m));
            } else {
                zone.rim.clear();
                const double size_e7 = zone.inclusion ? 60000 : 15000;
                const geo::Position centre = somewhere();
                for (int i = 0; i < corners; ++i) {
                    const double turn = (i + up_to(90) * 0.01) / corners * 2 * M_PI;
                    zone.rim.push_back(
                        {centre.latitude_e7 + static_cast<int32_t>(size_e7 * std::cos(turn)),
                         centre.longitude_e7 + static_cast<int32_t>(size_e7 * std::sin(turn))});
                }
                items = items + area(zone.inclusion, zone.rim);
            }
            zones.push_back(zone);
        }
        const bool has_way_back = up_to(1) == 0 && items.size() < 20;
        if (has_way_back)
            items.insert(items.begin() + up_to(static_cast<int>(items.size())),
                         wayBack(somewhere()));
        send(items);
        EXPECT_EQ(fenceHasWayBack(), has_way_back);
        for (uint16_t i = 0; i < items.size(); ++i) {
            MissionItem back;
            ASSERT_EQ(gcs::readItem(mavlink::MavMissionType::fence, i, back), Status::ok);
            EXPECT_EQ(back, items[i]) << i;
        }
        for (int i = 0; i < 40; ++i) {
            const geo::Position at = somewhere();
            bool is_inside = true;
            for (const Zone& zone : zones)
                is_inside = is_inside && holds(zone, at) == zone.inclusion;
            EXPECT_EQ(sideOf(at), is_inside ? Side::inside : Side::outside);
            ++(is_inside ? inside : outside);
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
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
