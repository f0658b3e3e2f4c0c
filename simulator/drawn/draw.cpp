// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/drawn/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "simulator/airplane/atmosphere.hpp"
#include "simulator/airplane/earth.hpp"
#include "simulator/devices/random.hpp"
#include "simulator/drawn/estimate.hpp"
#include "simulator/drawn/field.hpp"
#include "toolchain/declination/model.hpp"

namespace simulator::drawn {
namespace {

constexpr double kYear = 2027;
// Nearer to a magnetic pole a compass shows no heading.
constexpr double kLeastLevelField_mg = 80;

class Lot {
public:
    explicit Lot(uint64_t seed) : random_(seed, 20) {}

    double between(double least, double most) { return least + (most - least) * random_.uniform(); }
    // As likely to be near one end as near the other by their ratio.
    double ratioBetween(double least, double most) {
        return least * std::pow(most / least, random_.uniform());
    }
    double about(double value) { return value * between(0.5, 1.5); }
    bool chance(double share) { return random_.uniform() < share; }
    template <size_t Count>
    double of(const std::array<double, Count>& values) {
        return values[std::min(Count - 1, static_cast<size_t>(random_.uniform() * Count))];
    }
    Vec3 direction() {
        const Vec3 any = {random_.normal(), random_.normal(), random_.normal()};
        return any * (1 / std::max(1e-6, length(any)));
    }

private:
    Random random_;
};

Design drawDesign(Lot& lot) {
    constexpr double kStaticMargin = 0.12, kCentreOfGravity = 0.05;
    Design d;
    d.mass_kg = lot.ratioBetween(0.5, 8);
    d.wing_loading_kgm2 = lot.between(3, 9);
    d.aspect_ratio = lot.between(5.5, 10);
    d.static_margin = kStaticMargin + lot.between(-kCentreOfGravity, kCentreOfGravity);
    d.dihedral_deg = lot.between(2, 8);
    d.tail_volume = lot.between(0.4, 0.65);
    d.fin_volume = lot.between(0.032, 0.05);
    d.tail_arm_chords = lot.between(2.8, 4);
    d.thrust_to_weight = lot.between(0.3, 1);
    d.pitch_speed_ratio = lot.between(1.9, 2.6);
    d.thrown = lot.chance(0.35);
    return d;
}

// No airplane is what was estimated.
void spread(AirplaneParameters& p, Lot& lot) {
    for (double* derivative : {&p.lift.pitch_rate, &p.side.beta, &p.side.yaw_rate, &p.side.rudder,
                               &p.roll.beta, &p.roll.roll_rate, &p.roll.yaw_rate, &p.roll.aileron,
                               &p.pitch.alpha, &p.pitch.pitch_rate, &p.pitch.elevator, &p.yaw.beta,
                               &p.yaw.roll_rate, &p.yaw.yaw_rate, &p.yaw.aileron, &p.yaw.rudder})
        *derivative = lot.about(*derivative);
    p.roll.at_zero = lot.between(-0.0015, 0.0015);
    p.pitch.at_zero += lot.between(-0.015, 0.015);
    p.lift.alpha *= lot.between(0.9, 1.1);
    p.lift.at_zero = lot.between(0.1, 0.4);
    p.drag.parasite = lot.between(0.028, 0.05);
    for (double* inertia : {&p.inertia_kgm2.xx, &p.inertia_kgm2.yy, &p.inertia_kgm2.zz})
        *inertia *= lot.between(0.75, 1.25);
    p.motor.throttle_exponent = lot.between(0.9, 1.4);
    p.motor.lag_s = lot.between(0.03, 0.15);
}

void drawControls(AirplaneParameters& p, Lot& lot) {
    constexpr double kTravel_deg = 40;             // of a servo by 400 us
    const double servo_s = lot.between(0.1, 0.4);  // for 60 degrees
    p.controls.rate_per_s = 60 / servo_s / kTravel_deg;
    p.controls.lag_s = lot.between(0.02, 0.05);
    p.controls.aileron_deg = lot.between(15, 25);
    p.controls.elevator_deg = lot.between(18, 30);
    p.controls.rudder_deg = lot.between(18, 30);
    p.linkage.deadband = lot.between(0.002, 0.012);  // 1 to 5 us
    p.linkage.curve = lot.between(-0.2, 0.3);
    p.imu_place_m = lot.direction() * lot.between(0, 0.10);
}

SensorErrors drawErrors(Lot& lot) {
    SensorErrors errors;
    errors.scaleNoise(lot.ratioBetween(0.05, 3));
    errors.gps_rate_hz = lot.of<3>({1, 5, 10});
    errors.gps_age_s = lot.between(0.05, 0.4);
    const double wander = lot.between(0.5, 3);
    errors.gps_horizontal_m *= wander;
    errors.gps_vertical_m *= wander;
    errors.airspeed_ratio = 0.05;  // of one in twenty more than a tenth
    errors.compass_offset_mg = lot.between(0, 50);
    errors.baro_drift_pa *= lot.between(0.5, 2);
    errors.gust_mps = lot.between(0, 2);
    return errors;
}

void drawPlace(WorldOptions& world, Lot& lot, const std::string& magnetic_model) {
    std::ifstream file(magnetic_model);
    if (!file) throw std::runtime_error(magnetic_model + ": cannot be read");
    const declination::Model model(file);
    world.altitude_m = lot.between(0, 3000);
    for (;;) {
        world.latitude_deg = lot.between(-70, 70);
        world.longitude_deg = lot.between(-180, 180);
        const auto field =
            model.at(world.latitude_deg, world.longitude_deg, world.altitude_m / 1000, kYear);
        const double level_mg = field.horizontal_nt() / 100, down_mg = field.down_nt / 100;
        world.declination_deg = field.declination_deg();
        world.inclination_deg = std::atan2(down_mg, level_mg) * 180 / M_PI;
        world.magnetic_field_mg = std::hypot(level_mg, down_mg);
        if (level_mg >= kLeastLevelField_mg) return;
    }
}

WorldOptions drawConditions(Lot& lot, const AirplaneParameters& airplane,
                            const std::string& magnetic_model) {
    constexpr double kMotorField_mg = 60;  // at most, at full throttle
    WorldOptions world;
    world.errors = drawErrors(lot);
    world.gps_latency_s = world.errors->gps_age_s;
    drawPlace(world, lot, magnetic_model);
    world.heading_deg = lot.between(0, 360);
    world.wind_mps = lot.between(0, std::min(10.0, 0.6 * stallSpeed_mps(airplane)));
    // who starts and lands does so into the wind, as far as his field lies that way
    world.wind_from_deg = std::fmod(world.heading_deg + lot.between(-60, 60) + 360, 360);
    world.gusts = true;
    world.thermal_mps = lot.between(0, 2);
    world.board_warmth_c = lot.between(-10, 25);
    world.board_warmth_start_c = world.board_warmth_c - lot.between(0, 10);
    world.board_warmth_start_c = std::max(-10.0, world.board_warmth_start_c);
    const double full_a = airplane.battery.capacity_mah / 1000 / 0.2;
    const Vec3 motor = lot.direction() * (lot.between(0, kMotorField_mg) / full_a);
    world.motor_field_mg_a = {motor.x, motor.y, motor.z};
    return world;
}

double trueBySea(double altitude_m) {
    return std::sqrt(kSeaLevelDensity_kgm3 / atmosphere(altitude_m).density_kgm3);
}

// Nobody flies where his airplane does not climb out of the sinking air.
void giveEnoughPower(DrawnWorld& drawn, Design& design, double cruise_mps) {
    constexpr double kLeastClimb_mps = 1.5, kMore = 1.1, kMaxThrust = 1;
    const double altitude_m = drawn.world.altitude_m + 150;
    const double true_mps = cruise_mps * trueBySea(altitude_m);
    const auto climb_mps = [&] {
        return true_mps *
               climbGradient(drawn.airplane, true_mps, atmosphere(altitude_m).density_kgm3);
    };
    while (climb_mps() < kLeastClimb_mps + drawn.world.thermal_mps) {
        if (design.thrust_to_weight >= kMaxThrust) {
            drawn.world.thermal_mps = std::max(0.0, climb_mps() - kLeastClimb_mps);
            return;
        }
        design.thrust_to_weight = std::min(kMaxThrust, design.thrust_to_weight * kMore);
        const auto motor = drawn.airplane.motor;
        givePropulsion(drawn.airplane, design);
        drawn.airplane.motor.throttle_exponent = motor.throttle_exponent;
        drawn.airplane.motor.lag_s = motor.lag_s;
    }
}

// To whole metres a second, as one reads them off a table or a first flight.
ParameterSettings ownerOf(const AirplaneParameters& airplane, double cruise_mps) {
    const double stall_mps = stallSpeed_mps(airplane);
    const double slowest = std::ceil(1.2 * stall_mps);
    ParameterSettings owner = {
        {"TRIM_ARSPD_CM", std::round(cruise_mps * 2) * 50},
        {"ARSPD_FBW_MIN", slowest},
        {"ARSPD_FBW_MAX", std::max(slowest + 5, std::ceil(cruise_mps * 1.5))},
        {"BATT_CAPACITY", airplane.battery.capacity_mah}};
    if (airplane.launch.speed_mps > 0) owner.push_back({"TKOFF_THR_MINACC", 15});
    return owner;
}

double windAcross_mps(const WorldOptions& world) {
    const double off_deg = world.wind_from_deg - world.heading_deg;
    return std::abs(world.wind_mps * std::sin(off_deg * M_PI / 180));
}

std::string aboutOf(const DrawnWorld& w, const Design& d, const FieldPlan& field) {
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%.1f kg, %.1f kg/m2, span %.1f m, %s, stall %.1f m/s, thrust %.2f of its weight, servos "
        "%.2f s; GPS %.0f Hz %.0f ms; wind %.1f m/s from %.0f, gusts %.1f, thermals %.1f; %.0f m "
        "above the sea, at %.1f, %.1f; slope %.1f %%",
        w.airplane.mass_kg, d.wing_loading_kgm2, w.airplane.span_m, d.thrown ? "thrown" : "wheels",
        stallSpeed_mps(w.airplane), d.thrust_to_weight, 1.5 / w.airplane.controls.rate_per_s,
        w.world.errors->gps_rate_hz, w.world.errors->gps_age_s * 1000, w.world.wind_mps,
        w.world.wind_from_deg, w.world.errors->gust_mps, w.world.thermal_mps, w.world.altitude_m,
        w.world.latitude_deg, w.world.longitude_deg, field.slope * 100);
    return text;
}

std::vector<DrawnValue> valuesOf(const DrawnWorld& w, const Design& d, const FieldPlan& field,
                                 double cruise_mps) {
    const AirplaneParameters& p = w.airplane;
    const SensorErrors& errors = *w.world.errors;
    return {
        {"mass_kg", "mass", "kg", p.mass_kg},
        {"wing_loading_kgm2", "wing loading", "kg/m²", d.wing_loading_kgm2},
        {"span_m", "span", "m", p.span_m},
        {"thrown", "thrown", "", d.thrown ? 1.0 : 0.0},
        {"stall_mps", "stall", "m/s", stallSpeed_mps(p)},
        {"cruise_mps", "cruise", "m/s", cruise_mps},
        {"thrust_to_weight", "thrust by weight", "", d.thrust_to_weight},
        {"servo_s", "servo, 60°", "s", 1.5 / p.controls.rate_per_s},
        {"servo_deadband_us", "servo's deadband", "us", p.linkage.deadband * 400},
        {"imu_from_cg_m", "IMU from CG", "m", length(p.imu_place_m)},
        {"noise", "noise of sensors", "times",
         errors.gyro_noise_dps / SensorErrors{}.gyro_noise_dps},
        {"gps_rate_hz", "GPS rate", "Hz", errors.gps_rate_hz},
        {"gps_age_ms", "age of fixes", "ms", errors.gps_age_s * 1000},
        {"compass_offset_mg", "compass offset", "mG", errors.compass_offset_mg},
        {"board_warmth_c", "board's warmth", "°C", w.world.board_warmth_c},
        {"wind_mps", "wind", "m/s", w.world.wind_mps},
        {"wind_across_mps", "wind across", "m/s", windAcross_mps(w.world)},
        {"gust_mps", "gusts", "m/s", errors.gust_mps},
        {"thermal_mps", "thermals", "m/s", w.world.thermal_mps},
        {"altitude_m", "field above the sea", "m", w.world.altitude_m},
        {"latitude_deg", "latitude", "°", w.world.latitude_deg},
        {"slope_pct", "slope of the approach", "%", field.slope * 100},
    };
}

}  // namespace

DrawnWorld drawWorld(uint64_t seed, const std::string& magnetic_model) {
    Lot lot(seed);
    Design design = drawDesign(lot);
    DrawnWorld drawn;
    drawn.airplane = estimate(design);
    spread(drawn.airplane, lot);
    drawControls(drawn.airplane, lot);
    drawn.world = drawConditions(lot, drawn.airplane, magnetic_model);
    drawn.world.seed = seed;
    const double cruise_mps = lot.between(1.45, 1.75) * stallSpeed_mps(drawn.airplane);
    giveEnoughPower(drawn, design, cruise_mps);
    drawn.airplane.launch.speed_mps *= trueBySea(drawn.world.altitude_m);
    drawn.owner = ownerOf(drawn.airplane, cruise_mps);
    FieldPlan field;
    field.slope = lot.between(0.02, 0.08);
    field.approach_mps =
        std::max(1.35 * stallSpeed_mps(drawn.airplane), drawn.owner[1].value + 0.5);
    const double altitude_m = drawn.world.altitude_m + 150;
    field.climb =
        std::max(0.0, 0.5 * climbGradient(drawn.airplane, cruise_mps * trueBySea(altitude_m),
                                          atmosphere(altitude_m).density_kgm3));
    drawn.mission = boxMission(drawn.world, field);
    drawn.tuning = tuningMission(drawn.world);
    drawn.about = aboutOf(drawn, design, field);
    drawn.values = valuesOf(drawn, design, field, cruise_mps);
    return drawn;
}

}  // namespace simulator::drawn
