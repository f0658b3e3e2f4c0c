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

constexpr uint16_t kExclusion = 5002;
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

MissionResult result(const MissionItem& item, uint8_t count) {
    Memory memory;
    const ListKind kind =
        item.command == MavCmd::nav_rally_point ? ListKind::rally : ListKind::fence;
    return pointFromItem(kind, item, count, memory.record());
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
        ASSERT_EQ(pointFromItem(kind, row.item, 5, memory.record()), MissionResult::accepted);
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
        ASSERT_EQ(pointFromItem(ListKind::fence, item, 3, memory.record()),
                  MissionResult::accepted);
        EXPECT_EQ(again(ListKind::fence, memory), item);
    }
    for (const uint8_t frame : {kGlobalFrame, kRelativeFrame})
        for (const float height_m : {0.0f, 0.01f, 0.02f, 0.99f, 1.0f, 123.45f, -0.01f, -5.0f, -5.5f,
                                     31999.5f, -31999.5f}) {
            Memory memory;
            ASSERT_EQ(pointFromItem(ListKind::rally, rally(height_m, frame), 1, memory.record()),
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
        const MissionResult got = pointFromItem(ListKind::rally, item, 1, memory.record());
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
    EXPECT_EQ(pointFromItem(ListKind::rally, not_ours, 1, memory.record()),
              MissionResult::unsupported);
    EXPECT_EQ(result(at(rally(20), 0, 0), 1), invalidParam(5));
    EXPECT_EQ(result(at(corner(4), 900000001, 0), 4), invalidParam(5));
    EXPECT_EQ(result(rally(32000), 1), invalidParam(7));
    EXPECT_EQ(result(rally(-32000), 1), invalidParam(7));
    EXPECT_EQ(result(rally(NAN), 1), invalidParam(7));
    EXPECT_EQ(result(corner(2), 2), invalidParam(1)) << "a line is no polygon";
    EXPECT_EQ(result(corner(2), 3), invalidParam(1)) << "with a return point";
    EXPECT_EQ(result(corner(3), 3), MissionResult::accepted);
    (void)statusTexts();
    EXPECT_EQ(result(corner(5), 4), MissionResult::unsupported);
    EXPECT_TRUE(hasStatusText("Fence: one inclusion polygon, no more"));
}

// ---- conditions

MissionItem item;
uint8_t count;

// Every corner belongs to the one polygon: param1 is the number of all points, or of all but a
// return point.
TEST_F(PointItems, of_a_corner_that_is_taken_turn_it_alone) {
    check({{"a corner",
            {[](bool is) {
                 item = corner(6);
                 if (!is) item.command = kExclusion;
             },
             [](bool is) { count = is ? 6 : 9; },
             [](bool is) {
                 if (is) count = 7;
             },
             [](bool is) { item.frame = is ? kRelativeFrame : kMissionFrame; },
             [](bool is) {
                 if (!is) item.y = 1800000001;
             }},
            [] { return result(item, count) == MissionResult::accepted; },
            [](const Bits& is) { return is[0] && (is[1] || is[2]) && is[3] && is[4]; }}});
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
