// SPDX-License-Identifier: GPL-3.0-or-later
// What is stored of an item of the fence or of a rally point, byte by byte as docs/mission.md has
// it, what of it is refused, and what becomes of it again.
#include "firmware/mission/fence_rally_items.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "points_rig.hpp"
#include "truth_table.hpp"

namespace firmware {
namespace {

using bench::all;
using bench::Bits;
using mavlink::MavCmd;

constexpr uint8_t kUntouched = 0xEE;
constexpr size_t kFenceSize = 10, kRallySize = 11;

// A record amid memory that nothing may touch.
struct Memory {
    static constexpr size_t kAt = 48;
    std::array<uint8_t, 128> bytes;
    Memory() { bytes.fill(kUntouched); }
    uint8_t* record() { return &bytes[kAt]; }
    std::vector<uint8_t> stored(size_t size) const {
        for (size_t i = 0; i < bytes.size(); ++i) {
            if (i >= kAt && i < kAt + size) continue;
            EXPECT_EQ(bytes[i], kUntouched) << "beyond the record, " << i;
        }
        return {bytes.begin() + kAt, bytes.begin() + kAt + static_cast<long>(size)};
    }
};

MissionItem corner(float param1) {
    return point(MavCmd::nav_fence_polygon_vertex_inclusion, kHome, param1);
}
MissionItem rally(float height_m, uint8_t frame = kRelativeFrame) {
    MissionItem item = point(MavCmd::nav_rally_point, kHome, 0, height_m);
    item.frame = frame;
    return item;
}

MissionItem zoneCornerItem(float param1) {
    return point(MavCmd::nav_fence_polygon_vertex_exclusion, kHome, param1);
}
MissionItem circle(float radius_m, uint16_t command = MavCmd::nav_fence_circle_inclusion,
                   uint8_t frame = kRelativeFrame) {
    MissionItem item = point(command, kHome, radius_m);
    item.frame = frame;
    return item;
}
const MissionItem kWayBack = point(MavCmd::nav_fence_return_point, kHome);

// The first of so many.
MissionResult put(ListKind kind, const MissionItem& item, uint8_t count, Memory& memory) {
    FenceUpload upload = {};
    return pointFromItem(kind, item, 0, count, upload, memory.record());
}
MissionResult result(const MissionItem& item, uint8_t count) {
    Memory memory;
    return put(item.command == MavCmd::nav_rally_point ? ListKind::rally : ListKind::fence, item,
               count, memory);
}
// Up to the first that is refused.
struct Sent {
    std::vector<std::vector<uint8_t>> records;
    MissionResult last = MissionResult::accepted;
};
Sent send(const Items& items) {
    FenceUpload upload = {};
    Sent sent;
    for (size_t i = 0; i < items.size(); ++i) {
        Memory memory;
        sent.last = pointFromItem(ListKind::fence, items[i], static_cast<uint8_t>(i),
                                  static_cast<uint8_t>(items.size()), upload, memory.record());
        if (sent.last != MissionResult::accepted) return sent;
        sent.records.push_back(memory.stored(kFenceSize));
    }
    return sent;
}
// Bytes 8 and 9 of each.
std::vector<std::vector<int>> kinds(const Items& items) {
    std::vector<std::vector<int>> rest;
    for (const auto& record : send(items).records) rest.push_back({record[8], record[9]});
    return rest;
}
Items of(std::initializer_list<std::pair<int, MissionItem>> parts) {
    Items items;
    for (const auto& part : parts)
        items.insert(items.end(), static_cast<size_t>(part.first), part.second);
    return items;
}

MissionItem again(ListKind kind, Memory& memory) {
    MissionItem item;
    itemFromPoint(kind, memory.record(), item);
    return item;
}
constexpr MissionResult invalidParam(int number) {
    return static_cast<MissionResult>(static_cast<int>(MissionResult::invalid_param1) + number - 1);
}

class PointItems : public bench::TruthTable<Points> {};

// kHome is 0x1C03A180, 0x04C4B400.
TEST_F(PointItems, are_stored_as_the_document_lists_their_bytes) {
    using Bytes = std::vector<uint8_t>;
    const Bytes place = {0x80, 0xA1, 0x03, 0x1C, 0x00, 0xB4, 0xC4, 0x04};
    const auto with = [&](Bytes rest) {
        rest.insert(rest.begin(), place.begin(), place.end());
        return rest;
    };
    MissionItem way_back = point(MavCmd::nav_fence_return_point, kHome);
    way_back.frame = kGlobalFrame;
    struct Row {
        const char* what;
        MissionItem item;
        Bytes rest;
    };
    for (const Row& row :
         {Row{"a corner", corner(4), {0, 3}}, Row{"a return point", way_back, {1, 0}},
          Row{"50 m above home", rally(50), {50, 0, 128}},
          Row{"501.25 m above the sea", rally(501.25f, 0), {0xF5, 0x01, 25}},
          Row{"0.99 m", rally(0.99f), {0, 0, 128 + 99}},
          Row{"1 cm below home", rally(-0.01f), {0xFF, 0xFF, 128 + 99}},
          Row{"5 m below home", rally(-5), {0xFB, 0xFF, 128}}}) {
        Memory memory;
        const bool fence = row.rest.size() == 2;
        const ListKind kind = fence ? ListKind::fence : ListKind::rally;
        ASSERT_EQ(put(kind, row.item, 5, memory), MissionResult::accepted);
        EXPECT_EQ(memory.stored(fence ? kFenceSize : kRallySize), with(row.rest)) << row.what;
    }
}

// As the older messages send them: without a frame.
TEST_F(PointItems, of_the_older_messages_are_stored_the_same) {
    Memory fence, point;
    setFencePoint(fence.record(), FencePoint::way_back);
    setPlace(fence.record(), kHome);
    EXPECT_EQ(fence.stored(kFenceSize)[8], 1);
    EXPECT_EQ(fence.stored(kFenceSize)[9], kGlobalFrame);
    setPlace(point.record(), kHome);
    setRallyHeight(point.record(), 12.5f, true);
    EXPECT_EQ(point.stored(kRallySize)[10], 128 + 50);
    EXPECT_EQ(placeOf(point.record()), kHome);
}

TEST_F(PointItems, come_back_as_they_went_up) {
    ASSERT_EQ(store(mavlink::MavMissionType::fence, {corner(3), corner(3), corner(3)}),
              MissionResult::accepted);
    tenths(2);
    MissionItem way_back = point(MavCmd::nav_fence_return_point, beside(-7, 9));
    way_back.frame = kGlobalFrame;
    for (const MissionItem& item : {corner(3), way_back}) {
        Memory memory;
        ASSERT_EQ(put(ListKind::fence, item, 3, memory), MissionResult::accepted);
        EXPECT_EQ(again(ListKind::fence, memory), item);
    }
    for (const uint8_t frame : {kGlobalFrame, kRelativeFrame})
        for (const float height_m : {0.0f, 0.01f, 0.02f, 0.99f, 1.0f, 123.45f, -0.01f, -5.0f, -5.5f,
                                     31999.5f, -31999.5f}) {
            Memory memory;
            ASSERT_EQ(put(ListKind::rally, rally(height_m, frame), 1, memory),
                      MissionResult::accepted);
            const MissionItem item = again(ListKind::rally, memory);
            EXPECT_EQ(item.command, +MavCmd::nav_rally_point);
            EXPECT_EQ(item.frame, frame);
            EXPECT_NEAR(item.z, height_m, 0.004f);
            const float above_home_m = frame == kRelativeFrame ? height_m : height_m - 400;
            EXPECT_NEAR(rallyHeight_m(memory.record()), above_home_m, 0.004f);
        }
}

// The frames with _INT say the same as those without.
TEST_F(PointItems, take_these_frames_and_no_other) {
    for (int frame = 0; frame < 256; ++frame) {
        MissionItem item = rally(20, static_cast<uint8_t>(frame));
        Memory memory;
        const bool global = frame == 0 || frame == 5, relative = frame == 3 || frame == 6;
        const MissionResult got = put(ListKind::rally, item, 1, memory);
        if (!global && !relative) {
            EXPECT_EQ(got, MissionResult::unsupported_frame) << frame;
            continue;
        }
        ASSERT_EQ(got, MissionResult::accepted) << frame;
        EXPECT_EQ(again(ListKind::rally, memory).frame, relative ? 3 : 0) << frame;
    }
}

TEST_F(PointItems, are_refused_for_what_is_wrong_with_them) {
    const auto at = [](MissionItem item, int32_t x, int32_t y) {
        item.x = x;
        item.y = y;
        return item;
    };
    MissionItem not_ours = rally(20);
    not_ours.command = MavCmd::nav_waypoint;
    Memory memory;
    EXPECT_EQ(put(ListKind::rally, not_ours, 1, memory), MissionResult::unsupported);
    EXPECT_EQ(result(at(rally(20), 0, 0), 1), invalidParam(5));
    EXPECT_EQ(result(at(corner(4), 900000001, 0), 4), invalidParam(5));
    EXPECT_EQ(result(rally(32000), 1), invalidParam(7));
    EXPECT_EQ(result(rally(-32000), 1), invalidParam(7));
    EXPECT_EQ(result(rally(NAN), 1), invalidParam(7));
    EXPECT_EQ(result(corner(2), 2), invalidParam(1)) << "a line is no polygon";
    EXPECT_EQ(result(corner(2), 3), invalidParam(1)) << "with a return point";
    EXPECT_EQ(result(corner(3), 3), MissionResult::accepted);
    (void)statusTexts();
    EXPECT_EQ(result(corner(5), 4), invalidParam(1)) << "more corners than points";
    EXPECT_TRUE(hasStatusText("Item 0 refused: corners or radius"));
    EXPECT_EQ(result(not_ours, 4), MissionResult::unsupported);
    EXPECT_TRUE(hasStatusText("Item 0 refused: no part of a fence"));
    for (const int beyond : {4999, 5005})
        EXPECT_EQ(result(point(static_cast<uint16_t>(beyond), kHome, 4), 4),
                  MissionResult::unsupported);
    for (const float corners : {2.99f, 3.5f, 20.5f, 21.0f, -4.0f, NAN, INFINITY})
        EXPECT_EQ(result(corner(corners), 255), invalidParam(1)) << corners;
    EXPECT_EQ(result(corner(20), 20), MissionResult::accepted);
}

// ---- zones

// The same bytes as of boards that knew nothing else.
TEST_F(PointItems, of_one_polygon_are_stored_as_ever) {
    const std::vector<std::vector<int>> polygon = {{0, 3}, {0, 3}, {0, 3}};
    EXPECT_EQ(kinds(of({{3, corner(3)}})), polygon);
    const std::vector<std::vector<int>> way_back_last = {{0, 3}, {0, 3}, {0, 3}, {1, 3}};
    EXPECT_EQ(kinds(of({{3, corner(3)}, {1, kWayBack}})), way_back_last);
    const std::vector<std::vector<int>> way_back_amid = {{0, 3}, {1, 3}, {0, 3}, {0, 3}};
    EXPECT_EQ(kinds(of({{1, corner(3)}, {1, kWayBack}, {2, corner(3)}})), way_back_amid);
    const std::vector<std::vector<int>> way_back_first = {{1, 3}, {0, 3}, {0, 3}, {0, 3}};
    EXPECT_EQ(kinds(of({{1, kWayBack}, {3, corner(3)}})), way_back_first);
}

// Each corner says which it is of how many; a circle says its radius.
TEST_F(PointItems, of_zones_are_stored_as_the_document_lists_their_bytes) {
    using Rows = std::vector<std::vector<int>>;
    const int three = 3 + 3 * 4, out = 128;
    EXPECT_EQ(kinds(of({{3, zoneCornerItem(3)}})),
              (Rows{{32, three + out}, {33, three + out}, {34, three + out}}));
    EXPECT_EQ(kinds(of({{3, corner(3)}, {3, corner(3)}})),
              (Rows{{32, three}, {33, three}, {34, three}, {32, three}, {33, three}, {34, three}}));
    EXPECT_EQ(kinds(of({{1, circle(10)}, {3, corner(3)}})),
              (Rows{{65, 1 + 2 * 36}, {32, three}, {33, three}, {34, three}}))
        << "a circle before the polygon";
    EXPECT_EQ(kinds(of({{3, corner(3)}, {1, circle(10)}})),
              (Rows{{0, 3}, {0, 3}, {0, 3}, {65, 1 + 2 * 36}}));
    const uint16_t outside = MavCmd::nav_fence_circle_exclusion;
    EXPECT_EQ(kinds({circle(0.1f, outside, kGlobalFrame)}), (Rows{{64, out + 2}}));
    EXPECT_EQ(kinds({circle(250, outside, kGlobalFrame)}), (Rows{{64 + 39, out + 2 * 4}}));
    EXPECT_EQ(kinds({circle(251)}), (Rows{{64 + 39, 1 + 2 * 5}}));
    EXPECT_EQ(kinds({circle(10000)}), (Rows{{255, 1 + 2 * 26}}));
}

TEST_F(PointItems, of_a_circle_come_back_with_their_radius) {
    const auto radiusBack = [](float radius_m, uint16_t command, uint8_t frame) {
        Memory memory;
        EXPECT_EQ(put(ListKind::fence, circle(radius_m, command, frame), 1, memory),
                  MissionResult::accepted)
            << radius_m;
        const MissionItem item = again(ListKind::fence, memory);
        EXPECT_EQ(item.command, command);
        EXPECT_EQ(item.frame, frame);
        EXPECT_EQ(item.x, kHome.latitude_e7);
        EXPECT_EQ(item.y, kHome.longitude_e7);
        EXPECT_EQ(item.z, 0);
        return item.param1;
    };
    for (const uint16_t command :
         {MavCmd::nav_fence_circle_inclusion, MavCmd::nav_fence_circle_exclusion})
        for (const uint8_t frame : {kGlobalFrame, kRelativeFrame}) {
            for (int tenths = 1; tenths <= 2500; ++tenths) {
                const float radius_m = static_cast<float>(tenths) / 10;
                ASSERT_EQ(radiusBack(radius_m, command, frame), radius_m);
            }
            for (int whole_m = 250; whole_m <= 10000; ++whole_m)
                ASSERT_EQ(radiusBack(static_cast<float>(whole_m), command, frame), whole_m);
        }
    const auto in = [&](float radius_m) {
        return radiusBack(radius_m, MavCmd::nav_fence_circle_inclusion, 0);
    };
    EXPECT_EQ(in(152.34759f), 152.3f) << "as it is drawn with a mouse";
    EXPECT_EQ(in(152.35001f), 152.4f);
    EXPECT_EQ(in(249.96f), 250);
    EXPECT_EQ(in(250.4f), 250);
    EXPECT_EQ(in(250.6f), 251);
    EXPECT_EQ(in(9999.6f), 10000);
    EXPECT_EQ(in(0.051f), 0.1f);
}

TEST_F(PointItems, of_a_circle_without_a_radius_or_with_too_large_a_one_are_refused) {
    for (const float radius_m :
         {0.0f, 0.049f, -0.1f, -100.0f, 10000.1f, 1e9f, 1e30f, NAN, INFINITY, -INFINITY})
        EXPECT_EQ(result(circle(radius_m), 1), invalidParam(1)) << radius_m;
    EXPECT_TRUE(hasStatusText("Item 0 refused: corners or radius"));
}

struct Broken {
    const char* what;
    size_t good;  // items before the one that is refused
    Items items;
};
TEST_F(PointItems, of_a_polygon_follow_one_another_until_it_is_whole) {
    const MissionItem out = zoneCornerItem(3);
    for (const Broken& each : {
             Broken{"other numbers of corners", 1, of({{1, corner(4)}, {3, corner(3)}})},
             {"in and out mixed", 2, of({{2, corner(3)}, {1, out}, {5, kWayBack}})},
             {"a circle between", 2, of({{2, out}, {1, circle(10)}, {1, out}})},
             {"the list ends", 0, of({{2, out}})},
             {"the list ends of the second", 3, of({{3, corner(3)}, {2, out}})},
             {"no place for the third", 3, of({{2, corner(3)}, {2, kWayBack}})},
             {"a fourth corner", 3, of({{4, corner(3)}})},
         }) {
        (void)statusTexts();
        const Sent sent = send(each.items);
        EXPECT_EQ(sent.last, invalidParam(1)) << each.what;
        EXPECT_EQ(sent.records.size(), each.good) << each.what;
        EXPECT_TRUE(
            hasStatusText("Item " + std::to_string(each.good) + " refused: corners or radius"))
            << each.what;
    }
    for (const Items& whole :
         {of({{3, out}, {4, zoneCornerItem(4)}, {1, circle(10)}, {3, corner(3)}}),
          of({{2, out}, {1, kWayBack}, {1, out}}), of({{20, corner(20)}}), of({{20, circle(1)}})})
        EXPECT_EQ(send(whole).last, MissionResult::accepted);
}

// ---- conditions

MissionItem item;
uint8_t count;

// There are points enough for its polygon.
TEST_F(PointItems, of_a_corner_that_is_taken_turn_it_alone) {
    check({{"a corner",
            {[](bool is) {
                 item = corner(6);
                 if (!is) item.command = MavCmd::nav_waypoint;
             },
             [](bool is) { count = is ? 6 : 5; },
             [](bool is) { item.frame = is ? kRelativeFrame : kMissionFrame; },
             [](bool is) {
                 if (!is) item.y = 1800000001;
             }},
            [] { return result(item, count) == MissionResult::accepted; },
            all}});
}

geo::Position place;

// On the globe, up to the poles and 180 degrees.
TEST_F(PointItems, of_a_place_on_the_globe_turn_it_alone) {
    const auto isOnGlobe = [] { return isPlace(place); };
    check({{"in the north-east",
            {[](bool is) { place.latitude_e7 = is ? 900000000 : 900000001; },
             [](bool is) { place.longitude_e7 = is ? 1800000000 : 1800000001; }},
            isOnGlobe,
            all},
           {"in the south-west",
            {[](bool is) { place.latitude_e7 = is ? -900000000 : -900000001; },
             [](bool is) { place.longitude_e7 = is ? -1800000000 : -1800000001; }},
            isOnGlobe,
            all},
           {"not blank",
            {[](bool is) { place.latitude_e7 = is ? 1 : 0; },
             [](bool is) { place.longitude_e7 = is ? -1 : 0; }},
            isOnGlobe,
            bench::any}});
}

}  // namespace
}  // namespace firmware
