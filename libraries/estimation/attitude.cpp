// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/attitude.hpp"

#include "estimation/arc.hpp"

namespace estimation {
namespace {

constexpr float kGravity = core::kGravity_mss;
constexpr uint8_t kAlignFrames = 25;

// Time constants of the corrections, settled; found by flying host_tests/estimation/flight.hpp.
// The gyros are good for a minute, so the references may be averaged for long; an accelerometer's
// bias shows when the airplane turns, because its tilt stays behind over the ground.
constexpr float kTilt_s = 12.0f;
constexpr float kCompass_s = 15.0f;
constexpr float kBiasShare = 1.0f / 100.0f;  // bias taken over, per second of tilt corrected
constexpr float kQuick = 8.0f;               // so much faster at first
constexpr float kSettle_s = 10.0f;

// In a turn a small error of heading or of the fix's age shows as acceleration along the path, not
// towards the centre: beyond this horizontal acceleration the part along the path counts less.
constexpr float kTurning_mss = 2.5f;
constexpr float kYawFromTurn = 0.04f;  // of the heading error a turn shows, each fix

constexpr float kMostBias_rads = 0.05f;      // 3 deg/s beyond the start-up zero
constexpr float kMostBiasStep_rads = 2e-4f;  // in one correction
constexpr float kForceBias_s = 40.0f;        // an accelerometer's bias is learnt in this time
constexpr float kMostForceBias_mss = 0.3f;   // 0.03 g
constexpr float kMostForceStep_mss = 0.005f;
constexpr float kMostTime_s = 1.1f;   // between two fixes that are compared
constexpr uint8_t kCompassEvery = 5;  // 10 Hz of 50
constexpr float kCompassStep_s = 0.2f;

void add(core::Vector3& to, const core::Vector3& v) {
    to.x += v.x;
    to.y += v.y;
    to.z += v.z;
}
void stretch(core::Vector3& v, float by) {
    v.x *= by;
    v.y *= by;
    v.z *= by;
}
// What stands still over the ground, seen from a body that has turned by a small angle.
void turn(core::Vector3& v, const core::Vector3& by_rad) {
    const float x = v.x, y = v.y, z = v.z;
    v.x = x + (y * by_rad.z - z * by_rad.y);
    v.y = y + (z * by_rad.x - x * by_rad.z);
    v.z = z + (x * by_rad.y - y * by_rad.x);
}
core::Vector3 unit(const core::Vector3& v) { return v * (1.0f / sqrtf(core::dot(v, v))); }
float nudged(float bias, float by, float step, float most) {
    return core::limit(bias + core::limit(by, -step, step), -most, most);
}
}  // namespace

void Attitude::propagate(const core::Vector3& rate_rads, const core::Vector3& force_mss,
                         float dt_s) {
    add(force_sum_, force_mss);
    ++forces_;
    time_s_ += dt_s;
    rate_.x = rate_rads.x - bias_.x;
    rate_.y = rate_rads.y - bias_.y;
    rate_.z = rate_rads.z - bias_.z;
    frame_ = (frame_ + 1) & 7;
    if (phase_ == Phase::falling) {
        if (forces_ == kAlignFrames) alignUpright();
        return;
    }
    const core::Vector3 turned = {rate_.x * dt_s, rate_.y * dt_s, rate_.z * dt_s};
    add(turned_, turned);
    if (!(frame_ & 1)) {
        turnMatrix();
        return workOutAngles();
    }
    carryAnglesOn(turned);
    // What need not be done every frame is spread over eight.
    if (frame_ == 3) return keepUpright();
    if (frame_ == 7) return pointYaw();
    accelerate();
}

void Attitude::turnMatrix() {
    turn(down_, turned_);
    turn(north_, turned_);
    turned_ = {0, 0, 0};
}

void Attitude::alignUpright() {
    const core::Vector3 force_sum = force_sum_;
    const float squared = core::dot(force_sum, force_sum);
    forgetForces();
    if (squared < kGravity) return;  // no accelerometer, or falling indeed: look again
    down_ = unit(force_sum * -1.0f);
    const core::Vector3 along = {1, 0, 0}, below = {0, 0, 1};
    const core::Vector3& level = fabsf(down_.x) < 0.9f ? along : below;
    north_ = unit(level - down_ * core::dot(level, down_));
    turned_ = {0, 0, 0};
    phase_ = Phase::upright;
}

void Attitude::forgetForces() {
    force_sum_ = {0, 0, 0};
    forces_ = 0;
    time_s_ = 0;
}

// Both rows of length one and square to each other.
void Attitude::keepUpright() {
    const float squared = core::dot(down_, down_);
    if (!(squared > 0.5f && squared < 2.0f)) return start();  // no matrix any more: begin again
    stretch(down_, 1.5f - 0.5f * squared);
    const float skew = core::dot(north_, down_);
    north_.x -= down_.x * skew;
    north_.y -= down_.y * skew;
    north_.z -= down_.z * skew;
    stretch(north_, 1.5f - 0.5f * core::dot(north_, north_));
}

void Attitude::pointYaw() {
    const float east = noseEast();
    const float inverse = 1.0f / sqrtf(north_.x * north_.x + east * east + 1e-12f);
    yaw_rad_ = arc_rad(east * inverse, north_.x * inverse);
    yaw_rate_ = core::dot(down_, rate_);
}

// The mean force of the last four frames, turned into north, east, down.
void Attitude::accelerate() {
    if (forces_ == 0) return;
    const float share = forces_ == 4 ? 0.25f : 1.0f / forces_;
    const core::Vector3 force = {force_sum_.x * share - force_bias_x_,
                                 force_sum_.y * share - force_bias_y_, force_sum_.z * share};
    const float north = core::dot(north_, force);
    const float east = core::dot(core::cross(down_, north_), force);
    // They were felt, on the mean, two frames ago, and the matrix is one frame old: the nose was
    // this much behind it.
    const float behind_rad = 0.25f * yaw_rate_ * time_s_;
    acceleration_.x = north + behind_rad * east;
    acceleration_.y = east - behind_rad * north;
    acceleration_.z = core::dot(down_, force) + kGravity;
    history_.add(acceleration_.x * time_s_, acceleration_.y * time_s_, time_s_);
    since_fix_s_ = since_fix_s_ < 1e3f ? since_fix_s_ + time_s_ : 1e3f;
    forgetForces();
}

// About the vertical, by any angle.
void Attitude::turnTo(float sine, float cosine) {
    const core::Vector3 east = core::cross(down_, north_);
    north_ = north_ * cosine - east * sine;
    if (phase_ == Phase::upright) phase_ = Phase::pointed;
}

// `missing`: acceleration the reference saw and the accelerometers did not, over time_s. A tilt of
// one radian would turn gravity into one g of it.
void Attitude::correct(const core::Vector3& missing_mss, const core::Vector3& felt_mss,
                       float time_s, float yaw_share) {
    const float quick = 1.0f + (kQuick - 1.0f) * settling_;
    settling_ = core::limit(settling_ - time_s * (1.0f / kSettle_s), 0.0f, 1.0f);
    const core::Vector3& a = felt_mss;
    const float horizontal = a.x * a.x + a.y * a.y;
    // Split into towards the centre (along a) and along the path.
    core::Vector3 used = missing_mss;
    float yaw = 0;
    if (horizontal > 0.25f) {
        const float inverse = 1.0f / horizontal;
        const float path = (a.x * missing_mss.y - a.y * missing_mss.x) * inverse;
        const float doubt = horizontal / (horizontal + kTurning_mss * kTurning_mss);
        used.x += a.y * path * doubt;
        used.y -= a.x * path * doubt;
        yaw = path * doubt * yaw_share * quick;
    }
    const float gain =
        quick * core::limit(time_s * (1.0f / kTilt_s), 0.0f, 0.1f) * (1.0f / kGravity);
    const core::Vector3 east = core::cross(down_, north_);
    const core::Vector3 by =
        north_ * (used.y * gain) - east * (used.x * gain) + down_ * core::limit(yaw, -0.05f, 0.05f);
    learn(by, used, east, time_s);
    add(turned_, by);  // taken over when the matrix is turned next
}

// What had to be corrected again and again is the sensors' own.
void Attitude::learn(const core::Vector3& turn_rad, const core::Vector3& missing_mss,
                     const core::Vector3& east, float time_s) {
    bias_.x = nudged(bias_.x, -turn_rad.x * kBiasShare, kMostBiasStep_rads, kMostBias_rads);
    bias_.y = nudged(bias_.y, -turn_rad.y * kBiasShare, kMostBiasStep_rads, kMostBias_rads);
    bias_.z = nudged(bias_.z, -turn_rad.z * kBiasShare, kMostBiasStep_rads, kMostBias_rads);
    const float share = core::limit(time_s * (1.0f / kForceBias_s), 0.0f, 0.01f);
    const float x = north_.x * missing_mss.x + east.x * missing_mss.y;
    const float y = north_.y * missing_mss.x + east.y * missing_mss.y;
    force_bias_x_ = nudged(force_bias_x_, -x * share, kMostForceStep_mss, kMostForceBias_mss);
    force_bias_y_ = nudged(force_bias_y_, -y * share, kMostForceStep_mss, kMostForceBias_mss);
}

void Attitude::useGps(const core::Vector3& velocity_mps, const AttitudeSettings& settings) {
    catchUp();
    const VelocityHistory::Moment then = history_.ago(settings.gps_age_s);
    const VelocityHistory::Moment ground = VelocityHistory::moment(velocity_mps.x, velocity_mps.y);
    const float time_s = since_fix_s_;
    if (phase_ != Phase::falling && time_s < kMostTime_s && time_s > 0.05f) {
        const core::Vector3 seen = VelocityHistory::difference_mps(ground, fix_ground_);
        const core::Vector3 felt = VelocityHistory::difference_mps(then, fix_);
        const float inverse = 1.0f / time_s;
        correct((seen - felt) * inverse, felt * inverse, time_s, kYawFromTurn);
    }
    fix_ = then;
    fix_ground_ = ground;
    since_fix_s_ = 0;
    if (phase_ == Phase::upright && !settings.use_compass) pointAlong(velocity_mps);
}

// The first heading where there is no compass: the course, when there is one.
void Attitude::pointAlong(const core::Vector3& velocity_mps) {
    const float fast = velocity_mps.x * velocity_mps.x + velocity_mps.y * velocity_mps.y;
    if (fast <= 25.0f) return;
    const float inverse = 1.0f / sqrtf(fast);
    const float east = velocity_mps.y * inverse, north = velocity_mps.x * inverse;
    const float nose_inverse = 1.0f / sqrtf(north_.x * north_.x + noseEast() * noseEast() + 1e-6f);
    const float nose_north = north_.x * nose_inverse, nose_east = noseEast() * nose_inverse;
    turnTo(east * nose_north - north * nose_east, north * nose_north + east * nose_east);
}

core::Vector3 Attitude::gainedSinceFix_mps() const {
    return VelocityHistory::difference_mps(history_.now(), fix_);
}

void Attitude::useAirspeed(float true_airspeed_mps) {
    if (phase_ == Phase::falling) return;
    catchUp();
    // Its own velocity swings round with the nose; changes of speed are not known.
    const core::Vector3 east = core::cross(down_, north_);
    const float yaw_rate = core::dot(down_, rate_);
    const float north_mps = true_airspeed_mps * north_.x, east_mps = true_airspeed_mps * east.x;
    const core::Vector3 swung = {-yaw_rate * east_mps, yaw_rate * north_mps, 0};
    core::Vector3 missing = swung - acceleration_;
    missing.z = 0;
    correct(missing, acceleration_, 0.2f, 0);
}

void Attitude::useCompass(const core::Vector3& reading_mg, const AttitudeSettings& settings) {
    if (phase_ == Phase::falling || !settings.use_compass) return;
    if (phase_ == Phase::pointed && ++compass_reading_ < kCompassEvery) return;
    compass_reading_ = 0;
    catchUp();
    const core::Vector3 field_mg = field_.earths(reading_mg);
    const core::Vector3 east = core::cross(down_, north_);
    const float m_north = core::dot(north_, field_mg), m_east = core::dot(east, field_mg);
    const float length = sqrtf(m_north * m_north + m_east * m_east);
    if (length < 30.0f) return;  // near a magnetic pole, or no field at all: no direction
    // Declination is small enough on every inhabited place for its cosine's second order.
    const float d = settings.declination_rad;
    const float sin_d = d * (1.0f - d * d * (1.0f / 6.0f)), cos_d = 1.0f - 0.5f * d * d;
    const float along_mg = m_north * cos_d + m_east * sin_d;
    const float across_mg = m_east * cos_d - m_north * sin_d;
    const float inverse = 1.0f / length;
    if (phase_ == Phase::upright) {
        field_.start(length, core::dot(down_, field_mg));
        return turnTo(-across_mg * inverse, along_mg * inverse);
    }
    if (along_mg > 0) {
        const core::Vector3 odd =
            field_.unexpected({along_mg, across_mg, core::dot(down_, field_mg)}, kCompassStep_s);
        const float odd_north = odd.x * cos_d - odd.y * sin_d;
        const float odd_east = odd.y * cos_d + odd.x * sin_d;
        field_.learn(north_ * odd_north + east * odd_east + down_ * odd.z, kCompassStep_s);
    }
    const float error = along_mg > 0 ? -across_mg * inverse : (across_mg < 0 ? 1.0f : -1.0f);
    const float quick = 1.0f + (kQuick - 1.0f) * settling_;
    const float by = error * core::limit(quick * (kCompassStep_s / kCompass_s), 0.0f, 0.5f);
    north_.x -= east.x * by;
    north_.y -= east.y * by;
    north_.z -= east.z * by;
    const float step = core::limit(by * kBiasShare, -kMostBiasStep_rads, kMostBiasStep_rads);
    bias_.x -= down_.x * step;
    bias_.y -= down_.y * step;
    bias_.z -= down_.z * step;
}

// sqrt(1 - sine^2) of an angle below 20 degrees is quicker by its series, and so is its inverse.
void Attitude::workOutAngles() {
    Angles& a = angles_;
    a.sin_pitch = core::limit(-down_.x, -1.0f, 1.0f);
    const float squared = a.sin_pitch * a.sin_pitch;
    float inverse;
    if (squared < 0.1f) {
        const float half = 0.5f * squared;
        const float fourth = half * half;
        a.cos_pitch = 1.0f - half - 0.5f * fourth;
        inverse = 1.0f + half + 1.5f * fourth;
    } else {
        a.cos_pitch = sqrtf(down_.y * down_.y + down_.z * down_.z);
        inverse = a.cos_pitch > 1e-3f ? 1.0f / a.cos_pitch : 1e3f;
    }
    a.sin_roll = down_.y * inverse;
    a.cos_roll = down_.z * inverse;
    a.roll_rad = arc_rad(a.sin_roll, a.cos_roll);
    a.pitch_rad = arc_rad(a.sin_pitch, a.cos_pitch);
    // pointYaw() saw the matrix of the sixth frame
    a.yaw_rad = core::wrapPi(yaw_rad_ + yaw_rate_ * (0.01f * (frame_ + 2)));
    tan_pitch_ = a.sin_pitch * inverse;
}

// One frame on, by the rates of Euler's angles. Near the vertical roll has no rate of its own.
void Attitude::carryAnglesOn(const core::Vector3& turned_rad) {
    Angles& a = angles_;
    a.roll_rad += turned_rad.x;
    a.pitch_rad += turned_rad.y * a.cos_roll - turned_rad.z * a.sin_roll;
    if (fabsf(tan_pitch_) < 5.0f)
        a.roll_rad += tan_pitch_ * (turned_rad.y * a.sin_roll + turned_rad.z * a.cos_roll);
}

}  // namespace estimation
