// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong the sensors are: the figures the device models draw from, and the same figures as a
// table for reports.
#pragma once
#include <iterator>

namespace simulator {

// Deviations are one sigma, per axis. Noise is of every value the device gives, whatever its
// filter; vibration is added to the noise (in quadrature) and grows linearly with the throttle.
struct SensorErrors {
    double gyro_bias_dps = 0.6;
    double gyro_noise_dps = 0.12;
    double gyro_vibration_dps = 0.8;  // at full throttle
    double accel_bias_g = 0.004;
    double accel_scale = 0;  // relative
    double accel_noise_g = 0.006;
    double accel_vibration_g = 0.08;  // at full throttle
    double compass_noise_mg = 2;
    double compass_offset_mg = 50;
    double baro_noise_pa = 2;
    double baro_drift_pa = 4;
    double baro_drift_s = 300;
    double airspeed_noise_v = 0.003;
    double airspeed_offset_v = 0.02;
    double airspeed_ratio = 0.02;  // relative, of the pressure
    double gps_horizontal_m = 0.6;
    double gps_vertical_m = 1.5;
    double gps_wander_s = 60;
    double gps_velocity_mps = 0.05;
    double gps_age_s = 0.2;
    double gps_rate_hz = 5;  // the fastest the module can
    double gust_mps = 1;     // of the air, when gusts are on

    static constexpr SensorErrors none();
    void scaleNoise(double factor);  // of one reading against the next; offsets and drift stay
};

constexpr SensorErrors SensorErrors::none() {
    SensorErrors errors{};
    errors.gyro_bias_dps = errors.gyro_noise_dps = errors.gyro_vibration_dps = 0;
    errors.accel_bias_g = errors.accel_scale = errors.accel_noise_g = errors.accel_vibration_g = 0;
    errors.compass_noise_mg = errors.compass_offset_mg = 0;
    errors.baro_noise_pa = errors.baro_drift_pa = 0;
    errors.airspeed_noise_v = errors.airspeed_offset_v = errors.airspeed_ratio = 0;
    errors.gps_horizontal_m = errors.gps_vertical_m = errors.gps_velocity_mps = 0;
    return errors;
}

inline void SensorErrors::scaleNoise(double factor) {
    for (double* noise : {&gyro_noise_dps, &gyro_vibration_dps, &accel_noise_g, &accel_vibration_g,
                          &compass_noise_mg, &baro_noise_pa, &airspeed_noise_v, &gps_velocity_mps})
        *noise *= factor;
}

struct ErrorRow {
    const char* name;
    double SensorErrors::*value;
    const char* unit;
};

// clang-format off
constexpr ErrorRow kErrorRows[] = {
    {"Gyro bias, 1 sigma",                        &SensorErrors::gyro_bias_dps,      "deg/s"},
    {"Gyro noise",                                &SensorErrors::gyro_noise_dps,     "deg/s"},
    {"Gyro vibration at full throttle",           &SensorErrors::gyro_vibration_dps, "deg/s"},
    {"Accelerometer bias, 1 sigma",               &SensorErrors::accel_bias_g,       "g"},
    {"Accelerometer scale, 1 sigma",              &SensorErrors::accel_scale,        ""},
    {"Accelerometer noise",                       &SensorErrors::accel_noise_g,      "g"},
    {"Accelerometer vibration at full throttle",  &SensorErrors::accel_vibration_g,  "g"},
    {"Compass noise",                             &SensorErrors::compass_noise_mg,   "mG"},
    {"Compass offset, each axis either way",      &SensorErrors::compass_offset_mg,  "mG"},
    {"Barometer noise",                           &SensorErrors::baro_noise_pa,      "Pa"},
    {"Barometer drift",                           &SensorErrors::baro_drift_pa,      "Pa"},
    {"Barometer drift, correlation time",         &SensorErrors::baro_drift_s,       "s"},
    {"Airspeed noise",                            &SensorErrors::airspeed_noise_v,   "V"},
    {"Airspeed zero offset, 1 sigma",             &SensorErrors::airspeed_offset_v,  "V"},
    {"Airspeed ratio error, 1 sigma",             &SensorErrors::airspeed_ratio,     ""},
    {"GPS wander, horizontal",                    &SensorErrors::gps_horizontal_m,   "m"},
    {"GPS wander, vertical",                      &SensorErrors::gps_vertical_m,     "m"},
    {"GPS wander, correlation time",              &SensorErrors::gps_wander_s,       "s"},
    {"GPS velocity noise",                        &SensorErrors::gps_velocity_mps,   "m/s"},
    {"GPS age of data",                           &SensorErrors::gps_age_s,          "s"},
    {"GPS rate, at most",                         &SensorErrors::gps_rate_hz,        "Hz"},
    {"Gusts (Dryden), RMS",                       &SensorErrors::gust_mps,           "m/s"},
};
// clang-format on
constexpr int kErrorCount = static_cast<int>(std::size(kErrorRows));

}  // namespace simulator
