// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/attitude.hpp"

#include "core/internal_error.hpp"
#include "core/seldom.hpp"
#include "estimation/atan2_table.hpp"

namespace estimation {
namespace {

constexpr float kGravity = core::kGravity_mss;
constexpr uint8_t kAlignFrames = 25;

// Time constants of the corrections, settled; found by flying
// host_tests/unit/libraries/estimation/flight.hpp.
// The gyros are good for a minute, so the references may be averaged for long.
constexpr float kTilt_s = 5.0f;
constexpr float kCompass_s = 20.0f, kCourse_s = 8.0f;
constexpr float kBiasShare = 1.0f / 100.0f;  // bias taken over, per second of tilt corrected
constexpr float kQuick = 8.0f;               // so much faster at first, for a sixth of the time
// The zero of gyros that gusts rocked is 0.1 to 0.2 deg/s wrong at first, and has to be learnt
// soon.
constexpr float kStartupGain = 8.0f;
constexpr float kSettle_s = 60.0f, kQuickEnds = 5.0f / 6;

// In a turn a small error of heading or of the fix's age shows as acceleration along the path, not
// towards the centre: beyond this horizontal acceleration the part along the path counts less.
constexpr float kTurning_mss = 2.5f;
constexpr float kYawFromTurn = 0.04f;  // of the heading error a turn shows, each fix

constexpr float kMaxBias_rads = 0.05f;      // 3 deg/s beyond the start-up zero
constexpr float kMaxBiasStep_rads = 2e-4f;  // in one correction
constexpr float kForceBias_s = 10.0f;       // an accelerometer's bias is learnt in this time
constexpr float kMaxForceBias_mss = 0.3f;   // 0.03 g
constexpr float kMaxForceStep_mss = 0.01f;
constexpr float kMaxTime_s = 1.1f;  // between two fixes that are compared
// Of the angle to where the field should point: 0.15 in the weakest field, 0.8 in the strongest.
constexpr float kResumedShare = 0.4f / (470.0f * 470.0f);
constexpr float kCompassStep_s = 0.2f;
constexpr uint8_t kMaxFrames = 50;     // that are counted: by then nothing is known any more
constexpr float kInconsistent = 0.7f;  // cosine: a compass 45 degrees off is not followed
constexpr float kSlow_mps = 5.0f;      // a slower course is noise
constexpr float kRolls_mps = 4.0f;     // a course within a degree: velocities err by 0.05 m/s

// Between two fixes: a tilt that is 45 degrees wrong. A receiver whose velocity is wrong by 20 m/s
// shows 100 m/s2, more than any tilt can. Less than that, and an airplane whose gyros drift by
// 6 deg/s within a minute loses 10 m more of its height.
constexpr float kMaxMissing_mss = 0.7f * kGravity, kNoTilt_mss = 2 * kGravity;

constexpr int32_t kMaxTurn = Fine::kOne / 5;  // 0.2 rad; more at once would lengthen the rows
constexpr int32_t kMaxTurned = Fine::kOne;    // 1 rad
using RowAngle = core::Fixed<15>;             // rad, that a row is turned by
using ForceSum = core::Fixed32<8>;            // of Accelerations
using HalfForce = core::Fixed<9>;             // m/s2, of which twice the mean force is left
using ForceBias = core::Fixed32<25>;          // m/s2

// Along the nose, more than a motor gives: a throw, a catapult or a blow. Of 30 m/s2 a fix whose
// age is 0.15 s wrong misses 4.5 m/s, and between two fixes that would be a tilt of 45 degrees.
constexpr int16_t kPushed = HalfForce(15).raw;
constexpr uint8_t kPushedFixes = 5;  // and later: at 10 Hz, fixes from before the push come so long

core::Vector3 unit(const core::Vector3& v) { return v * core::inverse(sqrtf(core::dot(v, v))); }

int32_t steps(float value, float most, float a_unit) {
    return static_cast<int32_t>(core::limit(value, -most, most) * a_unit);
}
void accumulate(int32_t& sum, int32_t by, int32_t most) {
    sum = core::limit(sum + by, -most, most);
}
// A RowAngle's steps, as many as can be turned at once; the rest stays for the next time.
int16_t taken(int32_t& turned) {
    const int16_t now = core::upper(2 * core::limit(turned, -kMaxTurn, kMaxTurn));
    constexpr int32_t kTwice = 2 * (Fine::kOne / RowAngle::kOne);  // whole bytes shift for nothing
    turned -= now * kTwice >> 1;
    return now;
}
// From a Fine's steps to an Angle's.
int16_t inRevolutions(int32_t fine) {
    constexpr core::Fixed<15> kTwoOverPi(2 / core::kPi);
    return core::upper(2 * core::times16(fine, kTwoOverPi.raw));
}

// What fixes may show of a wrong tilt at once.
core::Vector3 asTilt_mss(const core::Vector3& missing) {
    const float squared = core::squaredLength(missing.x, missing.y);
    if (squared <= kMaxMissing_mss * kMaxMissing_mss) return missing;
    if (squared > kNoTilt_mss * kNoTilt_mss) return {0, 0, 0};
    return missing * (kMaxMissing_mss / sqrtf(squared));
}
}  // namespace

// A row in steps of a Ratio, for what is not summed up.
struct Attitude::Row16 {
    int16_t x, y, z;

    explicit Row16(const Row& row)
        : x(core::upper(row.of[0])), y(core::upper(row.of[1])), z(core::upper(row.of[2])) {}
    Row16(int32_t east_x, int32_t east_y, int32_t east_z)  // from products of two
        : x(core::upperOf4(east_x)), y(core::upperOf4(east_y)), z(core::upperOf4(east_z)) {}

    Row16 cross(const Row16& v) const {
        return Row16(core::product(y, v.z) - core::product(z, v.y),
                     core::product(z, v.x) - core::product(x, v.z),
                     core::product(x, v.y) - core::product(y, v.x));
    }
    int32_t dot(int16_t a, int16_t b, int16_t c) const {
        return core::product(x, a) + core::product(y, b) + core::product(z, c);
    }
};

float Attitude::real(int32_t component) {
    static_assert(DeltaAngle::kSteps == 1L << 30, "or another conversion");
    return core::fromFixed30(component);
}
core::Vector3 Attitude::real(const Row& row) {
    return {real(row.of[0]), real(row.of[1]), real(row.of[2])};
}
Attitude::Row Attitude::row(const core::Vector3& unit) {
    constexpr float kMax = 1.5f;
    return {{steps(unit.x, kMax, DeltaAngle::kSteps), steps(unit.y, kMax, DeltaAngle::kSteps),
             steps(unit.z, kMax, DeltaAngle::kSteps)}};
}

void Attitude::propagate(const Motion& motion) {
    force_sum_[0] += motion.force_mss.x.raw;
    force_sum_[1] += motion.force_mss.y.raw;
    force_sum_[2] += motion.force_mss.z.raw;
    ++forces_;
    periods_ = motion.periods > 0xFF - periods_ ? 0xFF : periods_ + motion.periods;
    using Rate = core::BodyRate;
    rate_.x = Rate::fromRaw(int32_t{motion.rate_rads.x.raw} - rate_bias_.x.raw);
    rate_.y = Rate::fromRaw(int32_t{motion.rate_rads.y.raw} - rate_bias_.y.raw);
    rate_.z = Rate::fromRaw(int32_t{motion.rate_rads.z.raw} - rate_bias_.z.raw);
    if (phase_ == Phase::falling) return;
    DeltaAngle turned;
    for (uint8_t i = 0; i < 3; ++i) {
        const int32_t bias = bias_.of[i];
        turned.of[i] =
            motion.turned.of[i] - (motion.periods == 2 ? bias * 2 : bias * motion.periods);
        accumulate(turned_.of[i], turned.of[i], kMaxTurned);
    }
    if (behind_ != kMaxFrames) ++behind_;
    if (since_yaw_ != kMaxFrames) ++since_yaw_;
    last_turn_ = {
        {inRevolutions(turned.of[0]), inRevolutions(turned.of[1]), inRevolutions(turned.of[2])}};
    carryAnglesOn(last_turn_);
}

void Attitude::rotateDcm() {
    if (phase_ == Phase::falling) return;
    rotateRows();
    workOutAngles();
}

// What stands still over the ground, seen from a body that has turned by a small angle.
void Attitude::turn(Row& row, const DeltaAngle16& by) {
    const int32_t x = row.of[0], y = row.of[1], z = row.of[2];
    row.of[0] += 2 * (core::times16(y, by.of[2]) - core::times16(z, by.of[1]));
    row.of[1] += 2 * (core::times16(z, by.of[0]) - core::times16(x, by.of[2]));
    row.of[2] += 2 * (core::times16(x, by.of[1]) - core::times16(y, by.of[0]));
}

void Attitude::rotateRows() {
    DeltaAngle16 by;
    for (uint8_t i = 0; i < 3; ++i) by.of[i] = taken(turned_.of[i]);
    turn(down_, by);
    turn(north_, by);
    behind_ = 0;
}

void Attitude::start() { *this = Attitude(); }

void Attitude::align() {
    if (phase_ != Phase::falling || forces_ < kAlignFrames) return;
    const core::Vector3 force_sum = {static_cast<float>(force_sum_[0]),
                                     static_cast<float>(force_sum_[1]),
                                     static_cast<float>(force_sum_[2])};
    const float squared = core::dot(force_sum, force_sum) * (1.0f / core::square(ForceSum::kSteps));
    forgetForces();
    if (squared < kGravity) return;  // no accelerometer, or falling indeed: look again
    const core::Vector3 down = unit(force_sum * -1.0f);
    const core::Vector3 along = {1, 0, 0}, below = {0, 0, 1};
    const core::Vector3& level = fabsf(down.x) < 0.9f ? along : below;
    down_ = row(down);
    north_ = row(unit(level - down * core::dot(level, down)));
    turned_ = {};
    phase_ = Phase::upright;
}

void Attitude::forgetForces() {
    for (int32_t& sum : force_sum_) sum = 0;
    forces_ = 0;
    periods_ = 0;
}

// In steps of a Fixed32<28>.
int32_t Attitude::dot(const Row& a, const Row& b) {
    int32_t sum = 0;
    for (uint8_t i = 0; i < 3; ++i) sum += core::timesUpper(a.of[i], b.of[i]);
    return sum;
}

// A share of another row, a Ratio's steps, is added.
void Attitude::add(Row& row, const Row& other, int16_t share) {
    for (uint8_t i = 0; i < 3; ++i) row.of[i] += 4 * core::times16(other.of[i], share);
}

// By half of what the square of its length lacks.
void Attitude::normalizeRow(Row& row, int32_t squared) {
    add(row, row, core::upper(((kOne >> 2) - squared) * 2));
}

// Both rows of length one and square to each other.
void Attitude::orthonormalize() {
    if (phase_ == Phase::falling) return;
    const int32_t squared = dot(down_, down_), along = dot(north_, north_);
    constexpr int32_t kHalf = kOne >> 3, kDouble = kOne >> 1;
    const bool rotates =
        squared >= kHalf && squared <= kDouble && along >= kHalf && along <= kDouble;
    if (!core::check(rotates, core::InternalError::attitude_matrix, __LINE__)) return start();
    normalizeRow(down_, squared);
    const int16_t skew = core::upperOf4(dot(north_, down_));
    add(north_, down_, static_cast<int16_t>(-skew));
    normalizeRow(north_, dot(north_, north_));
}

// What the nose has of north and east is as long as the pitch's cosine.
void Attitude::pointYaw() {
    if (phase_ == Phase::falling) return;
    const Row16 n(north_), d(down_);
    yaw_rad_ = tableAtan2(levelled(d.cross(n).x), levelled(n.x));
    since_yaw_ = behind_;
    const int32_t step = d.dot(last_turn_.of[0], last_turn_.of[1], last_turn_.of[2]);
    yaw_step_ = core::upperOf16(core::limit(step, -core::kMaxOf16, core::kMaxOf16));
}

// Of a row in the level: over the pitch's cosine.
core::Ratio Attitude::levelled(int16_t component) const {
    const int32_t share = core::product(component, inverse_cos_pitch_.raw);
    return core::Ratio::fromRaw(
        core::upperOf16(core::limit(share, -core::kMaxOf16, core::kMaxOf16)));
}

// The mean force since the last time, of four frames, turned into north, east, down.
void Attitude::accelerate() {
    if (phase_ == Phase::falling || forces_ == 0) return;
    const auto mean = [this](int32_t sum, int32_t bias) {
        const int32_t doubled = forces_ == 4 ? (sum + 1) >> 1 : sum * 2 / forces_;
        return HalfForce::fromRaw(doubled - core::upper(bias)).raw;
    };
    const int16_t x = mean(force_sum_[0], force_bias_x_), y = mean(force_sum_[1], force_bias_y_),
                  z = mean(force_sum_[2], 0);
    if (x > kPushed) pushed_fixes_ = kPushedFixes;
    const Row16 n(north_), d(down_);
    const Row16 e = d.cross(n);
    const int32_t north = n.dot(x, y, z), east = e.dot(x, y, z);
    // They were measured, on the mean, half of the time ago, and the matrix may be some frames old:
    // the nose was this much behind it. A yaw step is a quarter of an Angle's, in two periods.
    constexpr core::Fixed<16> kBehind(RowAngle::kSteps / core::Angle::kSteps / 4 / 4);
    const int16_t older = static_cast<int16_t>(periods_ - 4 * behind_);
    const int16_t behind = static_cast<int16_t>(
        core::limit<int32_t>(core::times16(int32_t{yaw_step_} * older, kBehind.raw),
                             -RowAngle::kOne / 4, RowAngle::kOne / 4));
    const int32_t then_north = north + 2 * core::times16(east, behind);
    const int32_t then_east = east - 2 * core::times16(north, behind);
    constexpr float kStep_mss = 1.0f / FineAcceleration::kSteps;
    acceleration_.x = static_cast<float>(then_north) * kStep_mss;
    acceleration_.y = static_cast<float>(then_east) * kStep_mss;
    acceleration_.z = static_cast<float>(d.dot(x, y, z)) * kStep_mss + kGravity;
    history_.add(FineAcceleration{then_north}, FineAcceleration{then_east}, periods_);
    since_fix_ = periods_ > 0xFF - since_fix_ ? 0xFF : since_fix_ + periods_;
    forgetForces();
}

core::Vector3 Attitude::east() const { return core::cross(real(down_), real(north_)); }

float Attitude::noseEast() const {  // a component of east()
    const core::Vector3 down = real(down_), north = real(north_);
    return down.y * north.z - down.z * north.y;
}

core::Vector3 Attitude::bias_rads() const {
    constexpr float kPerPeriod = 1.0f / kSamplePeriod_s;
    return core::Vector3{real(bias_.of[0]), real(bias_.of[1]), real(bias_.of[2])} * kPerPeriod;
}

// About the vertical, by any angle.
void Attitude::turnTo(float sine, float cosine) {
    north_ = row(real(north_) * cosine - east() * sine);
    if (phase_ == Phase::upright) phase_ = Phase::pointed;
}

// Taken over when the matrix is turned next.
void Attitude::turnBy(const core::Vector3& by_rad) {
    turnBy(turned_.of[0], by_rad.x);
    turnBy(turned_.of[1], by_rad.y);
    turnBy(turned_.of[2], by_rad.z);
}
void Attitude::turnBy(int32_t& turned, float by_rad) {
    accumulate(turned, steps(by_rad, 0.5f, DeltaAngle::kSteps), kMaxTurned);
}

// `missing`: acceleration the reference saw and the accelerometers did not, over time_s. A tilt of
// one radian would turn gravity into one g of it.
void Attitude::correct(const core::Vector3& missing_mss, const core::Vector3& felt_mss,
                       float time_s, bool by_fix) {
    const float quick = this->quick();
    settling_ = core::limit(settling_ - time_s * (1.0f / kSettle_s), 0.0f, 1.0f);
    const core::Vector3& a = felt_mss;
    const float horizontal = a.x * a.x + a.y * a.y;
    // Split into towards the centre (along a) and along the path.
    core::Vector3 used = missing_mss;
    float yaw = 0, turning_share = 0;
    if (horizontal > 0.25f) {
        const float inverse = 1.0f / horizontal;
        const float path = (a.x * missing_mss.y - a.y * missing_mss.x) * inverse;
        turning_share = horizontal / (horizontal + kTurning_mss * kTurning_mss);
        used.x += a.y * path * turning_share;
        used.y -= a.x * path * turning_share;
        if (by_fix) yaw = path * turning_share * quick * kYawFromTurn;
    }
    const float gain =
        quick * core::limit(time_s * (1.0f / kTilt_s), 0.0f, 0.1f) * (1.0f / kGravity);
    const core::Vector3 north = real(north_), down = real(down_);
    const core::Vector3 east = core::cross(down, north);
    core::Vector3 by = north * (used.y * gain) - east * (used.x * gain);
    if (by_fix) by = by + down * core::limit(yaw, -0.05f, 0.05f);
    const float startup_gain = 1.0f + kStartupGain * settling_;
    learnRates({by.x * startup_gain, by.y * startup_gain, by.z});
    if (by_fix) learnForces(used, east.x, (1.0f - turning_share) * (1.0f - settling_));
    turnBy(by);
}

// What had to be corrected again and again is the sensors' own.
void Attitude::learnRates(const core::Vector3& turn_rad) {
    learnRate(bias_.of[0], rate_bias_.x, turn_rad.x);
    learnRate(bias_.of[1], rate_bias_.y, turn_rad.y);
    learnRate(bias_.of[2], rate_bias_.z, turn_rad.z);
}

void Attitude::learnRate(int32_t& bias, core::BodyRate& rate, float turned_rad) {
    constexpr float kPeriod = DeltaAngle::kSteps * kSamplePeriod_s;
    constexpr int32_t kMax = static_cast<int32_t>(kMaxBias_rads * kPeriod);
    accumulate(bias, -steps(turned_rad * kBiasShare, kMaxBiasStep_rads, kPeriod), kMax);
    constexpr int16_t kPeriodsASecond = static_cast<int16_t>(1 / kSamplePeriod_s + 0.5f);
    const int32_t rounded = core::times16(bias, kPeriodsASecond * 64) + 512;  // a Fixed32<20>
    rate.raw = static_cast<int16_t>(core::Fixed32<20>{rounded}.as<10>().raw);
}

// A tilt is found where the accelerometers' bias is taken for a part of gravity. When the airplane
// turns, the bias turns with it, over the ground, and the tilt does not: what is missing then shows
// of it, as far as the nose has turned from where it pointed while the tilt was found. In a steep
// turn other errors are larger; while the gyros' zero is learnt nothing distinguishes the two.
void Attitude::learnForces(const core::Vector3& missing_mss, float nose_east, float trust) {
    constexpr float kNose = 1.0f / core::Ratio::kSteps;
    constexpr int16_t kStraight = 500;                          // 2 degrees
    constexpr float kMean = kSamplePeriod_s / kTilt_s / kNose;  // a period's share
    const int16_t recent = since_fix_ * static_cast<int16_t>(kMean + 0.5f);
    const auto turned = [recent](core::Ratio& mean, int32_t now) {
        const int16_t by = core::narrowed(now - mean.raw);
        mean.raw += core::times14(by, recent);
        return by;
    };
    const int16_t by_north = turned(mean_nose_[0], core::upper(north_.of[0]));
    const int16_t by_east = turned(mean_nose_[1], static_cast<int16_t>(nose_east * 16383.0f));
    const auto slight = [](int16_t by) { return by > -kStraight && by < kStraight; };
    if (slight(by_north) && slight(by_east)) return;
    constexpr float kShare = kNose * kSamplePeriod_s / kForceBias_s;
    const float share = trust * (kShare * core::real(since_fix_));
    const float north = core::real(by_north) * share, east = core::real(by_east) * share;
    learnForce(force_bias_x_, north * missing_mss.x + east * missing_mss.y);
    learnForce(force_bias_y_, north * missing_mss.y - east * missing_mss.x);
}

void Attitude::learnForce(int32_t& bias, float missing_mss) {
    constexpr float kSteps = ForceBias::kSteps;
    constexpr int32_t kMax = static_cast<int32_t>(kMaxForceBias_mss * kSteps);
    accumulate(bias, -steps(missing_mss, kMaxForceStep_mss, kSteps), kMax);
}

void Attitude::useGps(const core::Vector3& velocity_mps, const AttitudeSettings& settings,
                      FixComparison& seen) {
    catchUp();
    // what has been measured since is not in the history yet
    const VelocityHistory::Moment then =
        history_.ago(settings.gps_age_s - core::real(periods_) * kSamplePeriod_s);
    const VelocityHistory::Moment ground = VelocityHistory::moment(velocity_mps.x, velocity_mps.y);
    const float time_s = core::real(since_fix_) * kSamplePeriod_s;
    const bool comparable = time_s < kMaxTime_s && time_s > 0.05f && pushed_fixes_ == 0;
    if (phase_ != Phase::falling && comparable) {
        const core::Vector3 flown = VelocityHistory::difference_mps(ground, fix_ground_);
        const core::Vector3 measured = VelocityHistory::difference_mps(then, fix_);
        const float inverse = core::inverse(time_s);
        const core::Vector3 missing_mss = (flown - measured) * inverse;
        const core::Vector3 mean_mss = measured * inverse;
        seen.add(missing_mss, mean_mss, inverse);
        correct(asTilt_mss(missing_mss), mean_mss, time_s, true);
    } else {
        seen = {};
    }
    if (pushed_fixes_ != 0) --pushed_fixes_;
    fix_ = then;
    fix_ground_ = ground;
    since_fix_ = 0;
    if (phase_ == Phase::upright && !settings.use_compass) pointAlong(velocity_mps);
}

void Attitude::pointAlong(const core::Vector3& velocity_mps) {
    if (core::squaredLength(velocity_mps.x, velocity_mps.y) <= kRolls_mps * kRolls_mps) return;
    const float nose_north = noseNorth(), nose_east = noseEast();
    const float sine = velocity_mps.y * nose_north - velocity_mps.x * nose_east;
    const float cosine = velocity_mps.x * nose_north + velocity_mps.y * nose_east;
    const float inverse = core::inverse(sqrtf(core::squaredLength(sine, cosine) + 1e-6f));
    turnTo(sine * inverse, cosine * inverse);
}

core::Vector3 Attitude::gainedSinceFix_mps() const {
    return VelocityHistory::difference_mps(history_.now(), fix_);
}

void Attitude::useAirspeed(float true_airspeed_mps) {
    if (phase_ == Phase::falling) return;
    catchUp();
    // Its own velocity swings round with the nose; changes of speed are not known.
    const float yaw_rate =
        core::dot(real(down_), {rate_.x.toFloat(), rate_.y.toFloat(), rate_.z.toFloat()});
    const float swing_mss = yaw_rate * true_airspeed_mps;
    const core::Vector3 missing = {-(swing_mss * noseEast() + acceleration_.x),
                                   swing_mss * noseNorth() - acceleration_.y, 0};
    correct(asTilt_mss(missing), acceleration_, 0.2f, false);
}

float Attitude::quick() const {
    constexpr float kSlope = (kQuick - 1) / (1 - kQuickEnds);
    return 1 + core::limit((settling_ - kQuickEnds) * kSlope, 0.0f, kQuick - 1);
}

// By a share of the sine of the angle that is missing.
void Attitude::pointBy(float error, float share) {
    const float by = error * core::limit(quick() * share, 0.0f, 0.5f);
    const core::Vector3 turn_rad = real(down_) * by;
    learnRates(turn_rad);
    turnBy(turn_rad);
}

void Attitude::useCourse(const core::Vector3& air_mps) {
    const float squared = core::squaredLength(air_mps.x, air_mps.y);
    if (phase_ < Phase::pointed || squared < kSlow_mps * kSlow_mps) return;
    catchUp();
    const float north = noseNorth(), east = noseEast();
    const float across = north * air_mps.y - east * air_mps.x;
    const bool ahead = core::isPositive(north * air_mps.x + east * air_mps.y);
    pointBy(ahead        ? across / sqrtf(squared)
            : across < 0 ? -1.0f
                         : 1.0f,
            kCompassStep_s / kCourse_s);
}

// A heading by the compass turns along with what is known of the declination: nothing before the
// first fix. Pulled there slowly, the compass would be taken for off by it. One that has been
// resumed is true already.
bool Attitude::turnByDeclination(float declination_rad) {
    const float by_rad = declination_rad - declination_rad_;
    if (core::isZero(by_rad)) return false;
    declination_rad_ = declination_rad;
    cos_declination_ = cosf(declination_rad);
    sin_declination_ = sinf(declination_rad);
    if (phase_ == Phase::pointed) turnTo(sinf(by_rad), cosf(by_rad));
    return true;
}

bool Attitude::useCompass(const core::Vector3& reading_mg, const AttitudeSettings& settings) {
    if (phase_ == Phase::falling) return true;
    catchUp();
    if (turnByDeclination(settings.declination_rad)) return true;  // this run has no time for more
    const core::Vector3 field_mg = field_.earths(reading_mg);
    const core::Vector3 north = real(north_), down = real(down_);
    const core::Vector3 east = core::cross(down, north);
    const float m_north = core::dot(north, field_mg), m_east = core::dot(east, field_mg);
    const float length = sqrtf(core::squaredLength(m_north, m_east));
    if (length < 30.0f) return true;  // near a magnetic pole, or no field at all: no direction
    const float sin_d = sin_declination_, cos_d = cos_declination_;
    const float along_mg = m_north * cos_d + m_east * sin_d;
    const float across_mg = m_east * cos_d - m_north * sin_d;
    const float inverse = core::inverse(length);
    if (phase_ == Phase::upright) {
        if (!settings.use_compass) return true;
        field_.start(length, core::dot(down, field_mg));
        turnTo(-across_mg * inverse, along_mg * inverse);
        return true;
    }
    compass_off_ = 1 - along_mg * inverse;
    const bool elsewhere = settling_ < kQuickEnds && compass_off_ > 1 - kInconsistent;
    if (elsewhere || !settings.use_compass) return !elsewhere;
    // after a restart it is the attitude that is wrong, most of all the roll, and not the field
    const bool resumed = phase_ == Phase::resumed && settling_ > kQuickEnds;
    if (core::isPositive(along_mg) || resumed) {
        const core::Vector3 odd =
            field_.unexpected({along_mg, across_mg, core::dot(down, field_mg)}, kCompassStep_s);
        const float odd_north = odd.x * cos_d - odd.y * sin_d;
        const float odd_east = odd.y * cos_d + odd.x * sin_d;
        const core::Vector3 odd_mg = north * odd_north + east * odd_east + down * odd.z;
        if (resumed) {
            turnBy(core::cross(odd_mg, field_mg) * kResumedShare);
            return true;
        }
        field_.learn(odd_mg, kCompassStep_s);
    }
    const float error = core::isPositive(along_mg) ? -across_mg * inverse
                                                   : (core::isNegative(across_mg) ? 1.0f : -1.0f);
    pointBy(error, kCompassStep_s / kCompass_s);
    return true;
}

// The sine of half the angle over that of half the limit: of angles as these, one as the other.
float Attitude::compassTestRatio() const {
    return sqrtf(core::limit(compass_off_ * (1 / (1 - kInconsistent)), 0.0f, 10.0f));
}

// sqrt(1 - sine^2) of an angle below 20 degrees is quicker by its series, and so is its inverse.
void Attitude::workOutAngles() {
    using Part = core::Ratio;
    constexpr int16_t kOne16 = Part::kOne;
    constexpr Part kSmall(0.1f);
    Angles& a = angles_;
    a.sin_pitch = Part::fromRaw(core::limit<int16_t>(-core::upper(down_.of[0]), -kOne16, kOne16));
    const int16_t squared = core::times14(a.sin_pitch.raw, a.sin_pitch.raw);
    if (squared < kSmall.raw) {
        const int16_t half = squared >> 1;
        const int16_t fourth = core::times14(half, half);
        a.cos_pitch = Part::fromRaw(kOne16 - half - (fourth >> 1));
        inverse_cos_pitch_.raw = (kOne16 + half + fourth + (fourth >> 1) + 2) >> 2;
    } else {
        const float sine = a.sin_pitch.toFloat();
        const float cosine = sqrtf(core::limit(1.0f - sine * sine, 1e-6f, 1.0f));
        a.cos_pitch = Part(cosine);
        inverse_cos_pitch_ = core::Gain(core::inverse(cosine));
    }
    a.sin_roll = levelled(core::upper(down_.of[1]));
    a.cos_roll = levelled(core::upper(down_.of[2]));
    a.roll_rad = tableAtan2(a.sin_roll, a.cos_roll);
    a.pitch_rad = tableAtan2(a.sin_pitch, a.cos_pitch);
    const int32_t since = core::product(yaw_step_, since_yaw_) >> 2;
    a.yaw_rad.raw = static_cast<int16_t>(static_cast<uint16_t>(yaw_rad_.raw + since));
    tan_pitch_.raw = core::times14(inverse_cos_pitch_.raw, a.sin_pitch.raw);
}

// One frame on, by the rates of Euler's angles. Near the vertical roll has no rate of its own.
void Attitude::carryAnglesOn(const DeltaAngle16& turned) {
    Angles& a = angles_;
    const int16_t sine = a.sin_roll.raw, cosine = a.cos_roll.raw;
    const int16_t up =
        core::upperOf4(core::product(turned.of[1], cosine) - core::product(turned.of[2], sine));
    int16_t over = turned.of[0];
    if (tan_pitch_.raw < 5 * 4096 && tan_pitch_.raw > -5 * 4096) {
        const int16_t along =
            core::upperOf4(core::product(turned.of[1], sine) + core::product(turned.of[2], cosine));
        over += core::times12(tan_pitch_.raw, along);
    }
    a.roll_rad.raw = static_cast<int16_t>(static_cast<uint16_t>(a.roll_rad.raw) + over);
    a.pitch_rad.raw = static_cast<int16_t>(static_cast<uint16_t>(a.pitch_rad.raw) + up);
}

}  // namespace estimation
