// SPDX-License-Identifier: GPL-3.0-or-later
// What flies in the World: the simulator's own airplane, or a flight model in another program.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "simulator/airplane/vector.hpp"
#include "simulator/world.hpp"

namespace simulator {

struct ServoPulses {
    std::array<double, 8> width_us{};     // 0: the output is silent
    std::array<double, 8> standing_us{};  // where the servo stands all the same
};

class FlightModel {
public:
    virtual ~FlightModel() = default;

    virtual void step(const ServoPulses& pulses) = 0;  // moves truth().time_us on
    virtual const Truth& truth() const = 0;
    virtual Vec3 toBody(const Vec3& earth) const = 0;
    virtual void launch() {}
    // The mean wind from now on; false: the air is not the simulator's to change.
    virtual bool setWind(double /*mps*/, double /*from_deg*/) { return false; }
    // Of one that is held in hands: lays it that way, or turns it at these body rates.
    virtual void turnTo(double /*roll_rad*/, double /*pitch_rad*/, double /*yaw_rad*/) {}
    virtual void turn(double /*roll_rads*/, double /*pitch_rads*/, double /*yaw_rads*/) {}
    // Holds it so high above the bench, and blows so fast at its pitot tube.
    virtual void lift(double /*height_m*/) {}
    virtual void blow(double /*airspeed_mps*/) {}
    // Of a model that has a transmitter of its own.
    virtual std::optional<std::array<uint16_t, 8>> radio_us() const { return std::nullopt; }
    virtual std::string fault() const { return ""; }       // why it stands still for good
    virtual uint64_t answersSkipped() const { return 0; }  // which could not be understood
    virtual uint64_t timesBegunAnew() const { return 0; }  // in the middle of a flight
};

}  // namespace simulator
