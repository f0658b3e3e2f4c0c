// SPDX-License-Identifier: GPL-3.0-or-later
// Everything outside the board's pins: the airplane in its air, and the chips that sense it.
// Both kinds of board, the emulated and the native one, hang on the same World.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"

namespace simulator {

// What a reset begins with: the board's own; one that, as those of many clones, does not switch a
// watchdog off and is bitten by it for ever; the second board's with its waiting times.
enum class Bootloader { stock, quick, looping, slow };

struct WorldOptions {
    std::string airplane = "foam_trainer";
    std::string fdm;         // a flight model elsewhere instead: "json:PORT"
    double fdm_wait_s = 30;  // how long it may take to answer first
    double latitude_deg = 47.3977, longitude_deg = 8.5456, altitude_m = 488.0;  // where it stands
    double heading_deg = 0.0;
    double wind_mps = 0.0, wind_from_deg = 0.0;  // mean wind at and above 10 m
    bool gusts = false;                          // Dryden, 1 m/s RMS
    double thermal_mps = 0;                      // the strongest rise, and as much sink
    uint64_t seed = 1;
    bool sensor_errors = true;
    std::optional<SensorErrors> errors;  // instead of those of devices/errors.hpp
    bool calibrated = false;      // compass and pitot: no offsets of the airplane, no scale error
    bool bench_model = false;     // it does not fly, it is held on the bench
    double accel_bias_g = 0.004;  // and how wrong its accelerometers are, one sigma
    double accel_scale = 0;
    double sensor_noise = 1;  // times that of devices/errors.hpp
    // the World Magnetic Model 2025 at this place at the end of 2026
    double declination_deg = 3.67, inclination_deg = 63.54, magnetic_field_mg = 484.1;
    // What the motor's current adds to the field at the compass, body axes, for each ampere.
    std::array<double, 3> motor_field_mg_a{};
    double gps_acquire_s = 3.0;  // from power-on to the first fix
    bool gps_backup = true;      // has a battery of its own: a hot start when power is back
    double band_gap_v = 0;       // of the chip; 0: 1.1 V and 1 % by the seed
    std::string gps = "ublox";   // one of gpsKinds(), as delivered
    uint32_t gps_baud = 0;       // its rate at power-on; 0: the one it comes with
    bool dataflash = true;       // the board has one
    Bootloader bootloader = Bootloader::stock;
    // The barometer above the air around it, once the board is warm and at power-on.
    double board_warmth_c = 10;
    double board_warmth_start_c = 10;
    double gps_latency_s = 0.2;        // from a measurement to its first byte
    unsigned worn_cells = 0;           // bytes of the EEPROM with a bit that stays as it is
    bool hmc5843 = false;              // instead of its successor
    bool compass_upside_down = false;  // on the first board's shield
    bool output_switch = false;        // the first board's: channel 8 gives outputs to the receiver
    // outside the board: rolled, pitched and yawed by so many degrees, as COMPASS_ORIENT has it
    std::optional<std::array<double, 3>> external_compass_deg;
    // Of the I2C lines, from low to high: the longest that 400 kHz allow (UM10204, table 10: t_r).
    double i2c_rise_ns = 300;
    std::vector<Fault> faults;  // of sensors in flight
};

// The truth, in SI units, NED at the start point. Never seen by the firmware.
struct Truth {
    uint64_t time_us;
    double latitude_deg, longitude_deg, altitude_m;  // altitude above sea level
    double north_m, east_m, height_m;                // from the start; height above the ground
    double velocity_north_mps, velocity_east_mps, velocity_down_mps;
    double roll_rad, pitch_rad, yaw_rad;
    double roll_rate_rads, pitch_rate_rads, yaw_rate_rads;  // body
    double force_x_mss, force_y_mss, force_z_mss;           // specific force, body
    double airspeed_mps;                                    // true
    double equivalent_airspeed_mps;
    double alpha_rad, beta_rad;
    double wind_north_mps, wind_east_mps, wind_down_mps;  // air's velocity, gusts too
    double throttle, aileron, elevator, rudder;  // 0..1, -1..1 after the servos' own motion
    double motor_current_a, battery_v, battery_used_mah;
    bool on_ground;
    bool crashed;  // hit the ground harder or steeper than the airframe stands
};

class Mpu6000;
class Ms5611;
class Hmc5883l;
class GpsReceiver;
class PpmEncoder;
class Supply;
class At45db;
class Ads7844;
class Bmp085;

class World {
public:
    explicit World(const WorldOptions& options);
    ~World();

    // Moves airplane, air and sensors on to `now_us`; calls with an earlier time do nothing.
    void advanceTo(uint64_t now_us);
    const Truth& truth() const;
    void launch();  // lets an airplane go that is thrown
    // The mean wind at and above 10 m from now on; false: the flight model brings its own air.
    bool setWind(double mps, double from_deg);
    // With bench_model: lays it that way, or turns it about at these body rates.
    void turnTo(double roll_rad, double pitch_rad, double yaw_rad);
    void turn(double roll_rads, double pitch_rads, double yaw_rads);
    // Likewise: so high above the bench, and what blows at its pitot tube.
    void lift(double height_m);
    void blow(double airspeed_mps);
    void setFaults(const std::vector<Fault>& faults);  // instead of those there were
    FaultKind faultOf(Faulty part) const;              // now
    const std::vector<Fault>& faults() const;
    std::string fault() const;  // why the flight model cannot go on; empty when it can
    // Of a flight model elsewhere: not understood; and how often it was begun anew in flight.
    uint64_t modelAnswersSkipped() const;
    uint64_t modelBegunAnew() const;

    // Servo output 1..8: the width of a pulse that has just ended. An output without a pulse for
    // 100 ms lets its servo stand where it is and stops the motor.
    void servoPulse(int output, double width_us, uint64_t now_us);
    void relay(bool on);
    bool relayOn() const;
    double servoPulse_us(int output) const;  // last width, 0 when silent

    Mpu6000& imu();
    Ms5611& barometer();
    Hmc5883l& compass();
    GpsReceiver& gps();
    // Another receiver in the GPS's place, switched on now and with a fix in a second; none where
    // the kind has no name.
    void plugGps(const std::string& kind, uint32_t baud = 0);
    PpmEncoder& radio();
    // The 5 V of the board and all that is plugged into it. Faults of the supply are sags of it.
    Supply& supply();
    double supply_v(uint64_t now_us) const;
    double bandGap_v() const;
    At45db& dataflash();
    const At45db& dataflash() const;
    // Of the first board: the converter with its gyros, accelerometer and pitot sensor, and the
    // barometer. They sense whether a board asks them or not.
    Ads7844& converter();
    Bmp085& barometerOnI2c();

    // What the ADC pin A0..A15 of the board sees, in volts.
    double analog_v(int pin, uint64_t now_us);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace simulator
