// SPDX-License-Identifier: GPL-3.0-or-later
// What lets the airplane fly on after a restart in the air, in memory that a reset leaves alone. A
// seal, begun with a number of its own (kLayout), distinguishes a whole record from chance, from
// one that a reset cut short and from one of another firmware.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"
#include "estimation/attitude.hpp"
#include "geo/position.hpp"

namespace firmware {
namespace state {

// What changes seldom.
struct SteadyRecord {
    geo::Position home;
    int32_t home_altitude_cm;
    float home_height_m;  // above where the barometer was zeroed
    float ground_pressure_pa, ground_temperature_c;
    float airspeed_offset_v;
    estimation::KeptTurn gyro_zero_rad[3];  // in a sample period
    estimation::Learnt learnt;
    int16_t wind_cms[2];  // north, east
    uint32_t seal;
};

struct MovingRecord {
    estimation::Pose pose;
    core::BodyRates rate_rads;
    geo::Position position;
    float north_mps, east_mps, climb_mps;
    float height_m;  // above home
    uint16_t at_ms;  // lower half of now_ms()
    uint8_t mode;
    uint8_t in_the_air : 1, home_set : 1, place_known : 1, wind_known : 1;
    uint8_t number;  // counts up
    uint32_t seal;
};

// How far the airplane has turned, and in how many sample periods, since the program hangs: kept
// by an interrupt, made radians of after the restart, when the zero is known again.
struct BlindTurn {
    int16_t turned[3];
    uint8_t periods;
};

// What came after a moving record; sealed together with it.
struct BlindRecord {
    BlindTurn turn;
    uint32_t seal;
};
void seal(BlindRecord& blind, const MovingRecord& after);
bool whole(const BlindRecord& blind, const MovingRecord& after);

void seal(SteadyRecord& record);
void seal(MovingRecord& record);
bool whole(const SteadyRecord& record);
bool whole(const MovingRecord& record);
// Not whole any more. What is being written is not either: what has changed does not fit the seal.
void invalidate(SteadyRecord& record);
void invalidate(MovingRecord& record);

// Two in turn, so that a reset while one is written leaves the other: the newest whole one;
// nullptr: neither is.
const MovingRecord* newest(const MovingRecord (&two)[2]);

// Armed alone is not in the air, nor a wind into the pitot tube of an airplane that stands.
struct FlightSigns {
    bool armed, flying;  // by the airspeed, where there is a sensor
    float ground_speed_mps, height_m;
};
bool inTheAir(const FlightSigns& signs);

// From the record to the first new sample: `record_ms` and `ended_ms` by the clock of the run that
// ended, what followed by the one that began. At most a second is accepted.
float lost_s(uint16_t record_ms, uint16_t ended_ms, uint16_t since_ms);

}  // namespace state
}  // namespace firmware
