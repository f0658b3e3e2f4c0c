// SPDX-License-Identifier: GPL-3.0-or-later
// Where the airplane is, how it lies in the air and where it is going.
#include <math.h>

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/seldom.hpp"
#include "estimation/atan2_table.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/gcs/gps_time.hpp"
#include "firmware/gcs/messages.hpp"
#include "firmware/gcs/mission_transfer.hpp"
#include "firmware/gcs/mission_types.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/vehicle.hpp"
#include "geo/position.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace gcs {

using namespace state;
using namespace estimator;
using namespace actuators;
using namespace mission;

namespace {

int16_t centi(float value) { return static_cast<int16_t>(core::inHundredths(value)); }

// From 0, clockwise.
uint16_t heading_deg() {
    const uint16_t raw = static_cast<uint16_t>(vehicle.attitude.yaw_rad.raw);
    return static_cast<uint16_t>(uint32_t{raw} * 360 >> 16);
}

// MISSION_CURRENT.mission_mode
constexpr uint8_t kInMissionMode = 1, kMissionSuspended = 2;

// `count` has home in it.
uint8_t missionState(uint16_t count) {
    if (count <= 1) return mavlink::MissionState::no_mission;
    if (missionComplete()) return mavlink::MissionState::complete;
    if (vehicle.mode == Mode::automatic) return mavlink::MissionState::active;
    return missionCurrent() == 0 ? mavlink::MissionState::not_started
                                 : mavlink::MissionState::paused;
}

int32_t altitude_mm() {  // above sea level
    if (!vehicle.home.set) return vehicle.gps.altitude_cm * 10;
    return vehicle.home.altitude_cm * 10 + core::rounded(vehicle.estimate.height_m * 1000);
}

SELDOM int16_t degreesOf(int32_t angle_cd) {
    constexpr int16_t kPerCent = 20972;  // 2^21 / 100
    const int16_t wrapped = static_cast<int16_t>(core::wrap180_cd(angle_cd));
    return static_cast<int16_t>((core::upper(core::product(wrapped, kPerCent)) + 16) >> 5);
}

struct HalfTurn {
    explicit HalfTurn(core::Angle angle) {
        const float half_rad = core::half(angle.toFloat());
        sine = sinf(half_rad);
        cosine = cosf(half_rad);
    }
    float sine, cosine;
};

struct WindSent {
    core::Vector3 known_mps;
    float speed_mps, from_deg;
};
core::FileState<WindSent> wind_sent{};

}  // namespace

bool fillIn(const Link&, mavlink::Attitude& to) {
    to.time_boot_ms = hal::frame_ms();
    to.roll = vehicle.attitude.roll_rad.toFloat();
    to.pitch = vehicle.attitude.pitch_rad.toFloat();
    to.yaw = vehicle.attitude.yaw_rad.toFloat();
    to.rollspeed = vehicle.attitude.rate_rads.x.toFloat();
    to.pitchspeed = vehicle.attitude.rate_rads.y.toFloat();
    to.yawspeed = vehicle.attitude.rate_rads.z.toFloat();
    return true;
}

// From the body to north, east, down: yaw, then pitch, then roll.
bool fillIn(const Link&, mavlink::AttitudeQuaternion& to) {
    const HalfTurn roll(vehicle.attitude.roll_rad), pitch(vehicle.attitude.pitch_rad),
        yaw(vehicle.attitude.yaw_rad);
    const float level_cosine = pitch.cosine * yaw.cosine, level_sine = pitch.sine * yaw.sine;
    const float across_cosine = pitch.cosine * yaw.sine, across_sine = pitch.sine * yaw.cosine;
    to.time_boot_ms = hal::frame_ms();
    to.q1 = roll.cosine * level_cosine + roll.sine * level_sine;
    to.q2 = roll.sine * level_cosine - roll.cosine * level_sine;
    to.q3 = roll.cosine * across_sine + roll.sine * across_cosine;
    to.q4 = roll.cosine * across_cosine - roll.sine * across_sine;
    to.rollspeed = vehicle.attitude.rate_rads.x.toFloat();
    to.pitchspeed = vehicle.attitude.rate_rads.y.toFloat();
    to.yawspeed = vehicle.attitude.rate_rads.z.toFloat();
    return true;
}

bool fillIn(const Link&, mavlink::Ahrs& to) {
    const core::Vector3& drift_rads = gyroDrift_rads();
    to.omegaIx = drift_rads.x;
    to.omegaIy = drift_rads.y;
    to.omegaIz = drift_rads.z;
    return true;
}

bool fillIn(const Link&, mavlink::GlobalPositionInt& to) {
    const auto& estimate = core::based(vehicle.estimate);
    to.time_boot_ms = hal::frame_ms();
    to.lat = estimate.position.latitude_e7;
    to.lon = estimate.position.longitude_e7;
    to.alt = altitude_mm();
    to.relative_alt = core::rounded(estimate.height_m * 1000);
    to.vx = centi(estimate.velocity_mps.x);
    to.vy = centi(estimate.velocity_mps.y);
    to.vz = centi(estimate.velocity_mps.z);
    to.hdg = core::wrap360_cd(vehicle.attitude.yaw_rad);
    return true;
}

// From home, which is where height 0 is too.
bool fillIn(const Link&, mavlink::LocalPositionNed& to) {
    const auto& estimate = core::based(vehicle.estimate);
    if (!vehicle.home.set || !estimate.known) return false;
    const geo::Offset away = geo::offset(vehicle.home.position, estimate.position);
    to.time_boot_ms = hal::frame_ms();
    to.x = away.north_m;
    to.y = away.east_m;
    to.z = -estimate.height_m;
    to.vx = estimate.velocity_mps.x;
    to.vy = estimate.velocity_mps.y;
    to.vz = estimate.velocity_mps.z;
    return true;
}

// Where a mode that guides itself flies to.
bool fillIn(const Link&, mavlink::PositionTargetGlobalInt& to) {
    constexpr uint16_t kPositionAlone = 0xFFF8;  // of type_mask: what is to be ignored
    const auto& demand = core::based(vehicle.demand);
    const bool has_place =
        demand.path == Path::leg || demand.path == Path::circle || demand.path == Path::land;
    if (!guidesItself() || !has_place) return false;
    to.time_boot_ms = hal::frame_ms();
    to.lat_int = demand.to.latitude_e7;
    to.lon_int = demand.to.longitude_e7;
    to.alt = core::hundredths(vehicle.home.altitude_cm) + demand.height_m;
    to.type_mask = kPositionAlone;
    to.coordinate_frame = mavlink::MavFrame::global;
    return true;
}

// Without a sensor it follows from the wind aloft, which hardly blows at the ground.
float reportedAirspeed_mps() {
    const bool known = vehicle.airspeed.healthy || vehicle.estimate.flying;
    return known ? vehicle.estimate.equivalent_airspeed_mps : vehicle.estimate.ground_speed_mps;
}

bool fillIn(const Link&, mavlink::VfrHud& to) {
    to.airspeed = reportedAirspeed_mps();
    to.groundspeed = vehicle.estimate.ground_speed_mps;
    to.alt = core::thousandths(altitude_mm());
    to.climb = vehicle.estimate.climb_mps;
    to.heading = static_cast<int16_t>(heading_deg());
    to.throttle = static_cast<uint16_t>(
        core::inHundredths(core::limit(vehicle.throttle_demand.toFloat(), 0.0f, 1.0f)));
    return true;
}

// Worked out when the wind has changed, five times a second at most, not for each message: 0.15 %
// of the processor with both links at 10 Hz.
bool fillIn(const Link&, mavlink::Wind& to) {
    const core::Vector3& wind_mps = vehicle.estimate.wind_mps;
    if (wind_sent.known_mps.x != wind_mps.x || wind_sent.known_mps.y != wind_mps.y) {
        wind_sent.known_mps = wind_mps;
        wind_sent.speed_mps = sqrtf(core::squaredLength(wind_mps.x, wind_mps.y));
        const float inverse = -1.0f / core::limit(wind_sent.speed_mps, 0.001f, 200.0f);
        wind_sent.from_deg = core::degrees(estimation::tableAtan2(core::Ratio(wind_mps.y * inverse),
                                                                  core::Ratio(wind_mps.x * inverse))
                                               .toFloat());
    }
    to.speed = wind_sent.speed_mps;
    to.direction = wind_sent.from_deg;
    to.speed_z = wind_mps.z;
    return true;
}

bool fillIn(const Link&, mavlink::NavControllerOutput& to) {
    const auto& progress = core::based(vehicle.progress);
    to.nav_roll = core::degrees(vehicle.roll_demand_rad.toFloat());
    to.nav_pitch = core::degrees(vehicle.pitch_demand_rad.toFloat());
    to.nav_bearing = degreesOf(progress.nav_bearing_cd);
    to.target_bearing = degreesOf(progress.target_bearing_cd);
    to.wp_dist = static_cast<uint16_t>(core::limit(progress.distance_m, 0.0f, 65535.0f));
    to.alt_error = progress.height_error_m;
    to.aspd_error = progress.airspeed_error_mps;
    to.xtrack_error = progress.crosstrack_m;
    return true;
}

bool fillIn(const Link&, mavlink::HomePosition& to) {
    if (!vehicle.home.set) return false;
    to.latitude = vehicle.home.position.latitude_e7;
    to.longitude = vehicle.home.position.longitude_e7;
    to.altitude = vehicle.home.altitude_cm * 10;
    to.q[0] = 1;  // level ground
    return true;
}

bool fillIn(const Link&, mavlink::MissionCurrent& to) {
    const uint16_t count = missionCount();  // home is one of them
    to.seq = missionCurrent();
    to.total = count == 0 ? 0xFFFF : static_cast<uint16_t>(count - 1);
    to.mission_state = missionState(count);
    to.mission_mode = vehicle.mode == Mode::automatic ? kInMissionMode : kMissionSuspended;
    to.mission_id = itemsId(mavlink::MavMissionType::mission);
    to.fence_id = itemsId(mavlink::MavMissionType::fence);
    to.rally_points_id = itemsId(mavlink::MavMissionType::rally);
    return true;
}

bool fillIn(const Link&, mavlink::MissionItemReached& to) {
    to.seq = lastReached();
    return true;
}

// The time is that of the log.
bool fillIn(const Link&, mavlink::CameraFeedback& to) {
    constexpr float kDegrees = 180 / core::kPi;
    to.time_usec = micros(hal::now_ms());
    to.lat = vehicle.estimate.position.latitude_e7;
    to.lng = vehicle.estimate.position.longitude_e7;
    to.alt_msl = core::thousandths(altitude_mm());
    to.alt_rel = vehicle.estimate.height_m;
    to.roll = vehicle.attitude.roll_rad.toFloat() * kDegrees;
    to.pitch = vehicle.attitude.pitch_rad.toFloat() * kDegrees;
    to.yaw = vehicle.attitude.yaw_rad.toFloat() * kDegrees;
    to.img_idx = cameraTriggerCount();
    return true;
}

}  // namespace gcs
}  // namespace firmware
