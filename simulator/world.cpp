// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/world.hpp"

#include <algorithm>

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
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/fdm/json_model.hpp"

namespace simulator {
namespace {

constexpr int kOutputs = 8;
constexpr uint64_t kSilent_us = 100'000;
constexpr double kCentre_us = 1500;
constexpr double kBoardWarmth_c = 10;  // the board in its box is warmer than the air

SensorErrors errorsFor(const WorldOptions& options) {
    if (!options.sensor_errors) return SensorErrors::none();
    SensorErrors errors;
    errors.accel_bias_g = options.accel_bias_g;
    errors.accel_scale = options.accel_scale;
    errors.scaleNoise(options.sensor_noise);
    if (options.calibrated) errors.compass_offset_mg = errors.airspeed_ratio = 0;
    return errors;
}

std::unique_ptr<GpsReceiver> gpsFor(const WorldOptions& options, const SensorErrors& errors) {
    GpsOptions gps;
    gps.acquire_s = options.gps_acquire_s;
    return makeGps(options.gps, options.gps_baud, options.seed, errors, gps);
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
    compass.upside_down = options.compass_upside_down;
    return compass;
}

}  // namespace

struct World::Parts {
    explicit Parts(const WorldOptions& options)
        : errors(errorsFor(options)),
          faults(options.faults),
          field_mg(northEastDown_mg(
              {options.declination_deg, options.inclination_deg, options.magnetic_field_mg})),
          model(modelFor(options, errors)),
          imu(options.seed, errors),
          barometer(options.seed, errors),
          compass(options.seed, errors, compassFor(options)),
          gps(gpsFor(options, errors)),
          analog(options.seed, errors),
          analog_imu(options.seed, errors),
          i2c_barometer(options.seed, errors),
          dataflash(options.seed, dataflashFor(options)) {
        converter.volts = [this](int input) {
            constexpr int kPitot = 7;
            const Truth& truth = model->truth();
            return input == kPitot ? analog.volts(AnalogSensors::kAirspeedPin, truth)
                                   : analog_imu.volts(input, truth);
        };
        sense();
    }

    ServoPulses pulses() const;
    void sense();
    void fail();

    const SensorErrors errors;
    std::vector<Fault> faults;
    const Vec3 field_mg;
    const std::unique_ptr<FlightModel> model;
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
    struct Servo {
        double width_us = 0;
        uint64_t time_us = 0;
        double standing_us = kCentre_us;  // where it stands without pulses
    };
    std::array<Servo, kOutputs> servos;
    uint64_t now_us = 0;
    bool relay = false;

    bool silent(const Servo& servo) const {
        return servo.width_us == 0 || now_us > servo.time_us + kSilent_us;
    }
};

ServoPulses World::Parts::pulses() const {
    ServoPulses out;
    for (size_t i = 0; i < servos.size(); ++i) {
        out.width_us[i] = silent(servos[i]) ? 0 : servos[i].width_us;
        out.standing_us[i] = servos[i].standing_us;
    }
    return out;
}

void World::Parts::sense() {
    const Atmosphere air = atmosphere(model->truth().altitude_m);
    const double board_c = air.temperature_k - 273.15 + kBoardWarmth_c;
    barometer.sense(air.pressure_pa, board_c);
    i2c_barometer.sense(air.pressure_pa, board_c);
    const Vec3 field = model->toBody(field_mg);
    compass.sense({field.x, field.y, field.z});
}

// Two faults of a sensor at once are the later one's.
void World::Parts::fail() {
    std::array<FaultKind, kFaulty> now{};
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
    radio.jam(of(Faulty::radio) == FaultKind::lost);
}

World::World(const WorldOptions& options) : parts_(std::make_unique<Parts>(options)) {}
World::~World() = default;

void World::advanceTo(uint64_t now_us) {
    Parts& p = *parts_;
    for (;;) {
        const uint64_t step_us = p.model->truth().time_us + Airplane::kStep_us;
        const uint64_t imu_us = p.imu.nextSample_us(), gps_us = p.gps->nextEvent_us();
        const uint64_t next_us = std::min({step_us, imu_us, gps_us});
        if (next_us > now_us) break;
        p.now_us = std::max(p.now_us, next_us);
        if (next_us == step_us) {
            p.fail();
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
void World::setFaults(const std::vector<Fault>& faults) { parts_->faults = faults; }
void World::launch() { parts_->model->launch(); }
std::string World::fault() const { return parts_->model->fault(); }
uint64_t World::modelAnswersSkipped() const { return parts_->model->answersSkipped(); }

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
    GpsOptions options;
    options.acquire_s = 1;
    options.powered_us = parts_->now_us;
    parts_->gps = makeGps(kind, baud, 1, parts_->errors, options);
}
PpmEncoder& World::radio() { return parts_->radio; }
At45db& World::dataflash() { return parts_->dataflash; }
const At45db& World::dataflash() const { return parts_->dataflash; }

Ads7844& World::converter() { return parts_->converter; }
Bmp085& World::barometerOnI2c() { return parts_->i2c_barometer; }

double World::analog_v(int pin, uint64_t now_us) {
    advanceTo(now_us);
    return parts_->analog.volts(pin, truth());
}

}  // namespace simulator
