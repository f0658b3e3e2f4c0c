// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/world.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/airplane/atmosphere.hpp"
#include "simulator/airplane/bench_model.hpp"
#include "simulator/airplane/earth.hpp"
#include "simulator/builtin_model.hpp"
#include "simulator/devices/ads7844.hpp"
#include "simulator/devices/analog_imu.hpp"
#include "simulator/devices/analog_sensors.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/devices/bmp085.hpp"
#include "simulator/devices/gps_kinds.hpp"
#include "simulator/devices/hmc5883l.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ms5611.hpp"
#include "simulator/devices/output_switch.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/devices/supply.hpp"
#include "simulator/fdm/json_model.hpp"

namespace simulator {
namespace {

constexpr int kOutputs = 8;
constexpr uint64_t kSilent_us = 100'000;
constexpr double kCentre_us = 1500;
constexpr double kWarming_s = 240;  // assumed: a board in its box of foam

// u-blox 6 data sheet, table 1: a hot start takes 1 s, a cold one 26 s.
constexpr double kHotStart_s = 1, kColdStart_s = 26;
// Assumed: how long a receiver takes to find its transmitter again.
constexpr uint64_t kReceiverLinks_us = 500'000;
// IDG-500: start-up time, to within 1 deg/s.
constexpr uint64_t kGyrosStart_us = 200'000;
// ATmega2560, 31.5: the band gap is 1.0 to 1.2 V, of one chip constant.
constexpr double kBandGap_v = 1.1, kBandGapSpread = 0.01;

double bandGapFor(const WorldOptions& options) {
    if (options.band_gap_v > 0) return options.band_gap_v;
    if (!options.sensor_errors) return kBandGap_v;
    Random random(options.seed, 14);
    return kBandGap_v * (1 + kBandGapSpread * random.normal());
}

std::vector<Sag> sagsOf(const std::vector<Fault>& faults) {
    std::vector<Sag> sags;
    const auto us = [](double s) { return static_cast<uint64_t>(s * 1e6 + 0.5); };
    for (const Fault& fault : faults)
        if (fault.sensor == Faulty::supply)
            sags.push_back(
                {fault.volts, us(fault.from_s), us(fault.to_s), us(fault.fall_ms / 1e3)});
    return sags;
}

SensorErrors errorsFor(const WorldOptions& options) {
    if (options.errors) return *options.errors;
    SensorErrors errors = options.sensor_errors ? SensorErrors{} : SensorErrors::none();
    errors.gps_age_s = options.gps_latency_s;
    if (!options.sensor_errors) return errors;
    errors.accel_bias_g = options.accel_bias_g;
    errors.accel_scale = options.accel_scale;
    errors.scaleNoise(options.sensor_noise);
    if (options.calibrated) errors.compass_offset_mg = errors.airspeed_ratio = 0;
    return errors;
}

struct GpsPlug {
    std::string kind;
    uint32_t baud;
    uint64_t seed;
};

std::unique_ptr<GpsReceiver> gpsFor(const GpsPlug& plug, const SensorErrors& errors,
                                    double acquire_s, uint64_t powered_us) {
    GpsOptions gps;
    gps.acquire_s = acquire_s;
    gps.powered_us = powered_us;
    return makeGps(plug.kind, plug.baud, plug.seed, errors, gps);
}

At45dbOptions dataflashFor(const WorldOptions& options) {
    At45dbOptions dataflash;
    dataflash.fitted = options.dataflash;
    return dataflash;
}

std::unique_ptr<FlightModel> modelFor(const WorldOptions& options, const SensorErrors& errors) {
    if (options.bench_model) return std::make_unique<BenchModel>(options);
    if (!options.fdm.empty()) return std::make_unique<JsonModel>(options);
    return std::make_unique<BuiltinModel>(options, errors.gust_mps);
}

CompassMount compassFor(const WorldOptions& options) {
    CompassMount compass;
    compass.kind = options.hmc5843 ? CompassKind::hmc5843 : CompassKind::hmc5883l;
    if (options.compass_upside_down) compass.roll_deg = 180;
    if (const auto& turned_deg = options.external_compass_deg) {
        compass.roll_deg = (*turned_deg)[0];
        compass.pitch_deg = (*turned_deg)[1];
        compass.yaw_deg = (*turned_deg)[2];
    }
    return compass;
}

}  // namespace

struct World::Parts {
    explicit Parts(const WorldOptions& options)
        : errors(errorsFor(options)),
          faults(options.faults),
          field_mg(northEastDown_mg(
              {options.declination_deg, options.inclination_deg, options.magnetic_field_mg})),
          motor_field_mg_a(options.motor_field_mg_a),
          model(modelFor(options, errors)),
          band_gap_v(bandGapFor(options)),
          warmth_start_c(options.board_warmth_start_c),
          warmth_end_c(options.board_warmth_c),
          gps_plug{options.gps, options.gps_baud, options.seed},
          gps_restart_s(options.gps_backup ? kHotStart_s : kColdStart_s),
          imu(options.seed, errors),
          barometer(options.seed, errors),
          compass(options.seed, errors, compassFor(options)),
          gps(gpsFor(gps_plug, errors, options.gps_acquire_s, 0)),
          analog(options.seed, errors),
          analog_imu(options.seed, errors),
          i2c_barometer(options.seed, errors),
          dataflash(options.seed, dataflashFor(options)),
          radio(options.seed),
          has_output_switch(options.output_switch) {
        converter.volts = [this](int input) { return converterVolts(input); };
        supply.set(sagsOf(faults));
        addPowered();
        sense();
    }

    void addPowered();
    void powerGps(bool on, uint64_t now_us);
    void powerReceiver(bool on, uint64_t now_us);
    void startReceiver(uint64_t now_us);
    double pitot_v();
    double converterVolts(int input);

    ServoPulses pulses() const;
    void sense();
    void fail();

    const SensorErrors errors;
    std::vector<Fault> faults;
    std::array<FaultKind, kFaulty> failing{};
    const Vec3 field_mg;
    const std::array<double, 3> motor_field_mg_a;
    const std::unique_ptr<FlightModel> model;
    const double band_gap_v;
    const double warmth_start_c, warmth_end_c;
    Supply supply;
    PoweredParts powered{supply};
    GpsPlug gps_plug;
    const double gps_restart_s;
    Mpu6000 imu;
    Ms5611 barometer;
    Hmc5883l compass;
    std::unique_ptr<GpsReceiver> gps;
    AnalogSensors analog;
    AnalogImu analog_imu;
    Ads7844 converter;
    Bmp085 i2c_barometer;
    At45db dataflash;
    PpmEncoder radio;
    const bool has_output_switch;
    OutputSwitch output_switch;
    struct Servo {
        double width_us = 0;
        uint64_t time_us = 0;
        double standing_us = kCentre_us;  // where it stands without pulses
    };
    std::array<Servo, kOutputs> servos;
    uint64_t now_us = 0;
    uint64_t receiver_links_us = UINT64_MAX;  // when it has found its transmitter again
    uint64_t gyros_settle_us = 0;
    bool analog_imu_on = true;
    bool relay = false;

    bool silent(const Servo& servo) const {
        return servo.width_us == 0 || now_us > servo.time_us + kSilent_us;
    }
};

void World::Parts::addPowered() {
    const auto part = [this](double at_least_v, auto& device) {
        powered.add(at_least_v, [&device](bool on, uint64_t at_us) { device.power(on, at_us); });
    };
    part(least_v::kMpu6000, imu);
    part(least_v::kMs5611, barometer);
    part(least_v::kHmc5883l, compass);
    part(least_v::kBmp085, i2c_barometer);
    part(least_v::kAt45db, dataflash);
    part(least_v::kEncoder, radio);
    powered.add(least_v::kEncoder, [this](bool, uint64_t) { output_switch.reset(); });
    powered.add(least_v::kPowerOnReset, [this](bool, uint64_t) { radio.forgetBrownOut(); });
    powered.add(least_v::kReceiver, [this](bool on, uint64_t at_us) { powerReceiver(on, at_us); });
    powered.add(least_v::kGps, [this](bool on, uint64_t at_us) { powerGps(on, at_us); });
    powered.add(least_v::kAds7844, [this](bool on, uint64_t) { converter.unplug(!on); });
    powered.add(least_v::kAnalogImu, [this](bool on, uint64_t at_us) {
        analog_imu_on = on;
        gyros_settle_us = at_us + kGyrosStart_us;
    });
}

// Its configuration is gone; with another seed its place wanders anew.
void World::Parts::powerGps(bool on, uint64_t at_us) {
    if (on) ++gps_plug.seed;
    gps =
        on ? gpsFor(gps_plug, errors, gps_restart_s, at_us) : gpsFor({"", 0, 1}, errors, 0, at_us);
}

void World::Parts::powerReceiver(bool on, uint64_t at_us) {
    receiver_links_us = on ? at_us + kReceiverLinks_us : UINT64_MAX;
    if (!on) radio.powerReceiver(false, at_us);
}

void World::Parts::startReceiver(uint64_t at_us) {
    receiver_links_us = UINT64_MAX;
    radio.powerReceiver(true, at_us);
}

// MPXV7002: its output is in proportion to its supply.
double World::Parts::pitot_v() {
    return analog.volts(AnalogSensors::kAirspeedPin, model->truth()) * supply.volts(now_us) /
           Supply::kNominal_v;
}

double World::Parts::converterVolts(int input) {
    constexpr int kPitot = 7;
    if (input == kPitot) return pitot_v();
    const double seen_v = analog_imu.volts(input, model->truth());
    return analog_imu_on && now_us >= gyros_settle_us ? seen_v : 0;
}

ServoPulses World::Parts::pulses() const {
    ServoPulses out;
    for (size_t i = 0; i < servos.size(); ++i) {
        out.width_us[i] = silent(servos[i]) ? 0 : servos[i].width_us;
        out.standing_us[i] = servos[i].standing_us;
    }
    if (!output_switch.toReceiver()) return out;
    for (size_t i = 0; i < OutputSwitch::kOutputs; ++i) {
        out.standing_us[i] = radio.sticks()[i];  // the last that the receiver gave
        out.width_us[i] = radio.heard() ? out.standing_us[i] : 0;
    }
    return out;
}

void World::Parts::sense() {
    const Atmosphere air = atmosphere(model->truth().altitude_m);
    const double warm = 1 - std::exp(-static_cast<double>(now_us) * 1e-6 / kWarming_s);
    const double warmth_c = warmth_start_c + (warmth_end_c - warmth_start_c) * warm;
    const double board_c = air.temperature_k - 273.15 + warmth_c;
    barometer.sense(air.pressure_pa, board_c);
    i2c_barometer.sense(air.pressure_pa, board_c);
    const Vec3 field = model->toBody(field_mg);
    const double motor_a = model->truth().motor_current_a;
    compass.sense({field.x + motor_field_mg_a[0] * motor_a, field.y + motor_field_mg_a[1] * motor_a,
                   field.z + motor_field_mg_a[2] * motor_a});
}

// Two faults of a sensor at once are the later one's.
void World::Parts::fail() {
    std::array<FaultKind, kFaulty>& now = failing;
    now.fill(FaultKind::none);
    std::array<double, kFaulty> since_s{};
    const double now_s = static_cast<double>(now_us) * 1e-6;
    for (const Fault& fault : faults)
        if (now_s >= fault.from_s && now_s < fault.to_s) {
            now[static_cast<size_t>(fault.sensor)] = fault.kind;
            since_s[static_cast<size_t>(fault.sensor)] = now_s - fault.from_s;
        }
    const auto of = [&](Faulty sensor) { return now[static_cast<size_t>(sensor)]; };
    const auto for_s = [&](Faulty sensor) { return since_s[static_cast<size_t>(sensor)]; };
    imu.fail(of(Faulty::imu), now_us, for_s(Faulty::imu));
    analog_imu.fail(of(Faulty::imu), for_s(Faulty::imu));
    barometer.fail(of(Faulty::barometer), for_s(Faulty::barometer));
    i2c_barometer.fail(of(Faulty::barometer), for_s(Faulty::barometer));
    analog.fail(of(Faulty::airspeed), for_s(Faulty::airspeed));
    compass.fail(of(Faulty::compass), for_s(Faulty::compass));
    gps->fail(of(Faulty::gps));
    radio.fail(of(Faulty::radio), now_us);
}

World::World(const WorldOptions& options) : parts_(std::make_unique<Parts>(options)) {}
World::~World() = default;

void World::advanceTo(uint64_t now_us) {
    Parts& p = *parts_;
    for (;;) {
        const uint64_t step_us = p.model->truth().time_us + Airplane::kStep_us;
        const uint64_t imu_us = p.imu.nextSample_us(), gps_us = p.gps->nextEvent_us();
        const uint64_t power_us = p.powered.nextEvent_us(p.now_us);
        const uint64_t next_us = std::min({step_us, imu_us, gps_us, power_us, p.receiver_links_us});
        if (next_us > now_us) break;
        p.now_us = std::max(p.now_us, next_us);
        if (next_us == power_us) {
            p.powered.run(next_us);
        } else if (next_us == p.receiver_links_us) {
            p.startReceiver(next_us);
        } else if (next_us == step_us) {
            p.fail();
            if (p.has_output_switch)
                p.output_switch.run(p.radio.sent_us(OutputSwitch::kChannel), next_us);
            p.model->step(p.pulses());
            p.sense();
            if (const auto pulses = p.model->radio_us()) p.radio.sticks(*pulses, true);
        } else if (next_us == imu_us) {
            p.imu.sample(p.model->truth(), next_us);
        } else {
            p.gps->run(p.model->truth(), next_us);
        }
    }
    p.now_us = std::max(p.now_us, now_us);
    p.radio.advanceTo(p.now_us);
}

const Truth& World::truth() const { return parts_->model->truth(); }
void World::turnTo(double roll_rad, double pitch_rad, double yaw_rad) {
    parts_->model->turnTo(roll_rad, pitch_rad, yaw_rad);
}
void World::turn(double roll_rads, double pitch_rads, double yaw_rads) {
    parts_->model->turn(roll_rads, pitch_rads, yaw_rads);
}
void World::lift(double height_m) { parts_->model->lift(height_m); }
void World::blow(double airspeed_mps) { parts_->model->blow(airspeed_mps); }
void World::setFaults(const std::vector<Fault>& faults) {
    parts_->faults = faults;
    parts_->supply.set(sagsOf(faults));
    parts_->powered.run(parts_->now_us);
}
FaultKind World::faultOf(Faulty part) const { return parts_->failing[static_cast<size_t>(part)]; }
const std::vector<Fault>& World::faults() const { return parts_->faults; }
void World::launch() { parts_->model->launch(); }
bool World::setWind(double mps, double from_deg) { return parts_->model->setWind(mps, from_deg); }
std::string World::fault() const { return parts_->model->fault(); }
uint64_t World::modelAnswersSkipped() const { return parts_->model->answersSkipped(); }
uint64_t World::modelBegunAnew() const { return parts_->model->timesBegunAnew(); }

void World::servoPulse(int output, double width_us, uint64_t now_us) {
    if (output < 1 || output > kOutputs || width_us <= 0) return;
    parts_->servos[output - 1] = {width_us, now_us, width_us};
}

double World::servoPulse_us(int output) const {
    if (output < 1 || output > kOutputs) return 0;
    const auto& servo = parts_->servos[output - 1];
    return parts_->silent(servo) ? 0 : servo.width_us;
}

void World::relay(bool on) { parts_->relay = on; }
bool World::relayOn() const { return parts_->relay; }

Mpu6000& World::imu() { return parts_->imu; }
Ms5611& World::barometer() { return parts_->barometer; }
Hmc5883l& World::compass() { return parts_->compass; }
GpsReceiver& World::gps() { return *parts_->gps; }
void World::plugGps(const std::string& kind, uint32_t baud) {
    parts_->gps_plug = {kind, baud, 1};
    parts_->gps = gpsFor(parts_->gps_plug, parts_->errors, 1, parts_->now_us);
}
PpmEncoder& World::radio() { return parts_->radio; }
Supply& World::supply() { return parts_->supply; }
double World::supply_v(uint64_t now_us) const { return parts_->supply.volts(now_us); }
double World::bandGap_v() const { return parts_->band_gap_v; }
At45db& World::dataflash() { return parts_->dataflash; }
const At45db& World::dataflash() const { return parts_->dataflash; }

Ads7844& World::converter() { return parts_->converter; }
Bmp085& World::barometerOnI2c() { return parts_->i2c_barometer; }

double World::analog_v(int pin, uint64_t now_us) {
    advanceTo(now_us);
    return pin == AnalogSensors::kAirspeedPin ? parts_->pitot_v()
                                              : parts_->analog.volts(pin, truth());
}

}  // namespace simulator
