// SPDX-License-Identifier: GPL-3.0-or-later
// What lets the airplane fly on after a restart in the air, in memory that a reset leaves alone. A
// checksum, begun with a number of its own (kLayout), distinguishes a valid record from chance,
// from one that a reset cut short and from one of another firmware.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"
#include "estimation/attitude.hpp"
#include "geo/position.hpp"

namespace firmware {
namespace state {

// What changes seldom.
struct SlowRecord {
    geo::Position home;
    int32_t home_altitude_cm;
    float home_height_m;       // above where the barometer was zeroed
    float home_above_field_m;  // above where it was armed
    float ground_pressure_pa, ground_temperature_c;
    float height_scale;
    float airspeed_offset_v;
    estimation::SavedDeltaAngle gyro_zero_rad[3];  // in a sample period
    estimation::SavedBiases learnt;
    int16_t wind_cms[2];  // north, east
    uint32_t checksum;
};

struct FastRecord {
    estimation::SavedAttitude pose;
    core::BodyRates rate_rads;
    geo::Position position;
    float north_mps, east_mps, climb_mps;
    float height_m;  // above home
    uint16_t at_ms;  // lower half of now_ms()
    uint8_t mode;
    uint8_t in_the_air : 1, home_set : 1, place_known : 1, wind_known : 1;
    uint8_t number;  // counts up
    uint32_t checksum;
};

// How far the airplane has turned, and in how many sample periods, since the program hangs: kept
// by an interrupt, made radians of after the restart, when the zero is known again.
struct HangDeltaAngle {
    int16_t turned[3];
    uint8_t periods;
};

// What came after a fast record; under one checksum with it.
struct HangGyroRecord {
    HangDeltaAngle turn;
    uint32_t checksum;
};
void updateChecksum(HangGyroRecord& hang, const FastRecord& after);
bool isValid(const HangGyroRecord& hang, const FastRecord& after);

void updateChecksum(SlowRecord& record);
void updateChecksum(FastRecord& record);
bool isValid(const SlowRecord& record);
bool isValid(const FastRecord& record);
// Not valid any more. Nor is what is being written: what has changed does not fit the checksum.
void invalidate(SlowRecord& record);
void invalidate(FastRecord& record);

// Two in turn, so that a reset while one is written leaves the other: the newest valid one;
// nullptr: neither is.
const FastRecord* newest(const FastRecord (&two)[2]);

// Armed alone is not in the air, nor a wind into the pitot tube of an airplane that stands.
struct FlightSigns {
    bool armed, flying;  // by the airspeed, where there is a sensor
    float ground_speed_mps, height_m;
};
bool inTheAir(const FlightSigns& signs);

// From the record to the first new sample: `record_ms` and `ended_ms` by the clock of the run that
// ended, what followed by the one that began. At most 3 s are accepted.
float lost_s(uint16_t record_ms, uint16_t ended_ms, uint16_t since_ms);

}  // namespace state
}  // namespace firmware
