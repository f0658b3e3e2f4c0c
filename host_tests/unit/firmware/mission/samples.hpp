// SPDX-License-Identifier: GPL-3.0-or-later
// A good record of every command of both sets, and what its row takes instead: the ranges as they
// are found by asking the row itself.
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "firmware/mission/command_table.hpp"

namespace firmware {
using namespace mission;

constexpr ::mission::Site kSampleSite = {5, 20};  // item 5 of 20

struct Sample {
    ::mission::Set set;
    ::mission::Record record;
};

// clang-format off
constexpr ::mission::Set kSet1 = ::mission::Set::apm1, kSet2 = ::mission::Set::apm2;
constexpr int32_t kNorth = 470900000, kEast = 80264000;
constexpr Sample kSamples[] = {
    {kSet2, {0x10, 1,  25, 12345, kNorth, kEast}},
    {kSet2, {0x11, 1,   0, 12345, kNorth, kEast}},
    {kSet2, {0x12, 1,   3, 12345, kNorth, kEast}},
    {kSet2, {0x13, 1,  12, 12345, kNorth, kEast}},
    {kSet2, {0x14, 1,   0, 12345, kNorth, kEast}},
    {kSet2, {0x15, 1,   0, 12345, kNorth, kEast}},
    {kSet2, {0x16, 1,  15,  4000, 0, 0}},
    {kSet2, {0x17, 1,   7, 12345, kNorth, kEast}},
    {kSet2, {0x70, 0,   0, 0, 90, 0}},
    {kSet2, {0x71, 1, 200, 8000, 0, 0}},
    {kSet2, {0x72, 0,   0, 0, 300, 0}},
    {kSet2, {0xB1, 0,   2, 0, 5, 0}},
    {kSet2, {0xB2, 0,   0, 14, 60, 0}},
    {kSet2, {0xB3, 0,   0, 50000, kNorth, kEast}},
    {kSet2, {0xB4, 0, 134, 45, 0, 0}},
    {kSet2, {0xB5, 0,   0, 1, 0, 0}},
    {kSet2, {0xB6, 0,   0, 10, 4, 0}},
    {kSet2, {0xB7, 0,   6, 1700, 0, 0}},
    {kSet2, {0xB8, 0,   7, 3, 2, 1900}},
    {kSet2, {0x1E, 1,   2, 12345, kNorth, kEast}},
    {kSet2, {0x1F, 5,   1, 12345, kNorth, kEast}},
    {kSet2, {0xBD, 1,   0, 12345, kNorth, kEast}},
    {kSet2, {0xC9, 1,   3, 12345, kNorth, kEast}},
    {kSet2, {0xCB, 0,   1, 2, -3, 4}},
    {kSet2, {0xCD, 0,   2, -45, 10, 180}},
    {kSet2, {0xCE, 0,   0, 25, 0, 0}},
    {kSet2, {0xCF, 0,   2, 0, 0, 0}},
    {kSet2, {0xD2, 0,   1, 0, 0, 0}},
    {kSet1, {0x10, 0,  25, 12345, kNorth, kEast}},
    {kSet1, {0x11, 0,   0, 12345, kNorth, kEast}},
    {kSet1, {0x12, 0,   3, 12345, kNorth, kEast}},
    {kSet1, {0x13, 0,  12, 12345, kNorth, kEast}},
    {kSet1, {0x14, 0,   0, 12345, kNorth, kEast}},
    {kSet1, {0x15, 0,   0, 12345, kNorth, kEast}},
    {kSet1, {0x16, 0,  15,  4000, 0, 0}},
    {kSet1, {0x20, 0, 200, 0, 0, 0}},
    {kSet1, {0x21, 0, 200, 8000, 0, 0}},
    {kSet1, {0x30, 0,   5, 0, 0, 0}},
    {kSet1, {0x31, 0,   0, 0, 0, 0}},
    {kSet1, {0x32, 0, 134, 0, 0, 0}},
    {kSet1, {0x33, 0, 134, 0, 0, 0}},
    {kSet1, {0x34, 0,   1, 0, 0, 0}},
    {kSet1, {0x40, 0,  14, 0, 0, 0}},
    {kSet1, {0x41, 0,  60, 0, 0, 0}},
    {kSet1, {0x42, 0,   0, 50000, kNorth, kEast}},
    {kSet1, {0x60, 0,   0, 45000, 0, 0}},
    {kSet1, {0x61, 0,   1, 4000, 0, 0}},
    {kSet1, {0x62, 0,   1, 3000, 0, 0}},
    {kSet1, {0x63, 0,   2, 12500000, 0, 0}},
    {kSet1, {0x64, 0,   1, 50000, 0, 0}},
    {kSet1, {0x70, 0,   4, 1510, 0, 0}},
    {kSet1, {0x71, 0,   7, 1910, 0, 0}},
    {kSet1, {0x72, 0,   0, 1090, 0, 0}},
    {kSet1, {0x73, 0,   2, 960, 0, 0}},
    {kSet1, {0x75, 0,   0, 3, 0, 0}},
    {kSet1, {0x80, 0,   3, 1800, 5, 10}},
    {kSet1, {0x81, 0,   1, 0, 0, 0}},
    {kSet1, {0x82, 0,   6, 1234, 0, 0}},
};
// clang-format on

inline ::mission::Record sampleOf(::mission::Set set, uint8_t id) {
    for (const Sample& sample : kSamples)
        if (sample.set == set && sample.record.id == id) return sample.record;
    return {};
}

inline ::mission::Record with(::mission::Record record, int field, int32_t value) {
    if (field == 1) record.p1 = static_cast<uint8_t>(value);
    if (field == 2) record.p2 = value;
    if (field == 3) record.p3 = value;
    if (field == 4) record.p4 = value;
    return record;
}

inline uint8_t answerTo(::mission::Set set, const ::mission::Record& record) {
    return kCommandTable.valid(kCommandTable.find(set, record.id), record, kSampleSite);
}

struct Interval {
    int32_t lowest, highest;
};
using Intervals = std::vector<Interval>;

// What the layout has room for.
inline Interval roomOf(::mission::Set set, int field) {
    if (field == 1) return {0, 255};
    if (field == 2 && set == ::mission::Set::apm2) return {-8388608, 8388607};
    return {std::numeric_limits<int32_t>::min(), std::numeric_limits<int32_t>::max()};
}

// Every value near 0, and the ends of what lies beyond.
inline Intervals rangesOf(::mission::Set set, const ::mission::Record& sample, int field) {
    constexpr int64_t kNear = 40000;
    const Interval room = roomOf(set, field);
    const auto takes = [&](int64_t value) {
        return answerTo(set, with(sample, field, static_cast<int32_t>(value))) == 0;
    };
    std::vector<int64_t> values;
    for (int64_t value = -kNear; value <= kNear; ++value) values.push_back(value);
    for (int64_t value = kNear; value <= room.highest; value += value / 8)
        values.insert(values.end(), {value, -value});
    values.insert(values.end(), {room.lowest, room.highest});
    std::sort(values.begin(), values.end());
    Intervals found;
    bool before = false;
    int64_t last = room.lowest;
    for (const int64_t value : values) {
        if (value < room.lowest || value > room.highest) continue;
        const bool now = takes(value);
        int64_t low = last, high = value;  // the first value that is answered as `value` is
        while (now != before && high - low > 1) {
            const int64_t middle = low + (high - low) / 2;
            (takes(middle) == now ? high : low) = middle;
        }
        const auto end = static_cast<int32_t>(high);
        if (now && !before) found.push_back({end, room.highest});
        if (!now && before) found.back().highest = end - 1;
        before = now;
        last = value;
    }
    return found;
}

inline bool restricted(::mission::Set set, const Intervals& ranges, int field) {
    const Interval room = roomOf(set, field);
    return ranges.size() != 1 || ranges[0].lowest != room.lowest ||
           ranges[0].highest != room.highest;
}

}  // namespace firmware
