// SPDX-License-Identifier: GPL-3.0-or-later
// Attitude from gyros, held upright by comparing what the accelerometers say the airplane gained
// in speed with what the GPS says, and pointed north by the compass. Two rows of the direction
// cosine matrix are the state: north and down as the body sees them. Roll and pitch are carried on
// in every frame by their rates; the matrix is turned every second frame, by the turns of both, and
// gives all angles anew. What is done so often is fixed point; the corrections, five and ten times
// a second, are floats. Whoever owns it calls the functions as often as they say; one that comes
// later or is left out once costs accuracy, nothing else.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"
#include "estimation/compass_field.hpp"
#include "estimation/gps_delay.hpp"
#include "estimation/motion.hpp"
#include "estimation/velocity_history.hpp"

namespace estimation {

struct AttitudeSettings {
    // Of a fix when it is given to useGps: 0.2 s in the receiver and 43 ms on the line.
    float gps_age_s = 0.243f;
    float declination_rad = 0;  // east positive
    bool use_compass = true;    // false: it is looked at, but not followed
};

struct Angles {
    core::Angle roll_rad, pitch_rad, yaw_rad;
    core::Ratio sin_roll, cos_roll, sin_pitch, cos_pitch;
};

// What it takes to go on after a restart: how the airplane stood, and what was learnt of the
// sensors.
struct SavedAttitude {
    core::Ratio north[3], down[3];
};
struct SavedBiases {
    SavedDeltaAngle bias_rad[3];  // of the gyros, in a sample period
    CompassField::Known field;
};

class Attitude {
public:
    void start();

    void save(SavedAttitude& pose) const;
    void save(SavedBiases& learnt) const;
    // Instead of start(): as it was, and turned on since then, as quick as `turned_rad` says.
    void resume(const SavedAttitude& pose, const SavedBiases& learnt,
                const core::Vector3& turned_rad);

    void propagate(const Motion& motion);  // 100 Hz: sums up the motion, carries roll and pitch on
    void align();                          // 10 Hz: until it is upright
    void rotateDcm();                      // 50 Hz: by what has been summed up; all angles anew
    void accelerate();      // 25 Hz: acceleration over ground, of what has been measured since
    void orthonormalize();  // 10 Hz: the matrix
    void pointYaw();        // 10 Hz: yaw by the matrix, in between it goes on by its rate

    // A compass reading, 5 Hz: body axes, offsets removed; only its direction counts. False: it
    // points far from where the airplane is known to point, and is not followed.
    bool useCompass(const core::Vector3& reading_mg, const AttitudeSettings& settings);

    // How far the last reading's direction was off, as a share of what is followed. In the first
    // seconds more than 1 is followed, too.
    float compassTestRatio() const;

    // Once for every fix: north, east, down. Without a compass its course gives the first heading.
    // What it showed against the accelerometers is added to `seen`.
    void useGps(const core::Vector3& velocity_mps, const AttitudeSettings& settings,
                FixComparison& seen);

    // With every fix while it rolls on its wheels: it points where it goes, from 4 m/s on.
    void pointAlong(const core::Vector3& velocity_mps);

    // While the compass is lost, with every fix: the velocity through the air, which is along the
    // nose.
    void useCourse(const core::Vector3& air_mps);

    // While there is no GPS, five times a second: with the true airspeed, or in flight a guess of
    // it (0: standing), the turn's centripetal acceleration is known well enough to stay upright.
    void useAirspeed(float true_airspeed_mps);

    bool aligned() const { return phase_ >= Phase::pointed; }  // upright and pointed

    // Yaw clockwise from true north, -pi..pi. Roll and pitch are new in every frame, the rest when
    // the matrix has been turned.
    const Angles& angles() const { return angles_; }
    // Where the nose points, for the wind: the first column of the matrix.
    float noseNorth() const { return real(north_.of[0]); }
    float noseEast() const;

    const core::BodyRates& rate_rads() const { return rate_; }  // the last, the bias removed
    core::Vector3 bias_rads() const;                            // of the gyros

    // What the compass reads of the airplane itself, learnt in turns; body axes.
    const core::Vector3& compassOffset_mg() const { return field_.own_mg(); }
    // For one who takes it off the readings from now on, and sets it to 0 here.
    core::Vector3& compassOffset_mg() { return field_.own_mg(); }

    // Acceleration over ground, as accelerate() found it, gravity removed: north, east, down.
    const core::Vector3& acceleration_mss() const { return acceleration_; }
    // Gained by the accelerometers since the time of the last fix given to useGps.
    core::Vector3 gainedSinceFix_mps() const;

private:
    enum class Phase : uint8_t { falling, upright, pointed, resumed };
    struct Row {  // a unit vector in body axes, as a Fine's steps
        int32_t of[3];
    };
    struct DeltaAngle16 {  // steps of a Fixed<15> of radians for the matrix, of an Angle for the
                           // angles
        int16_t of[3];
    };

    struct Row16;

    static float real(int32_t component);
    static core::Vector3 real(const Row& row);
    static Row row(const core::Vector3& unit);
    static void turn(Row& row, const DeltaAngle16& by);
    static void add(Row& row, const Row& other, int16_t share);
    static void normalizeRow(Row& row, int32_t squared);
    static int32_t dot(const Row& a, const Row& b);

    core::Vector3 east() const;
    void turnTo(float sine, float cosine);
    void turnBy(const core::Vector3& by_rad);
    void pointBy(float error, float share);
    bool turnByDeclination(float declination_rad);
    static void turnBy(int32_t& turned, float by_rad);
    void rotateRows();
    void catchUp() {
        if (behind_ != 0) rotateRows();
    }
    void workOutAngles();
    void carryAnglesOn(const DeltaAngle16& turned);
    core::Ratio levelled(int16_t component) const;
    void forgetForces();
    float quick() const;
    void correct(const core::Vector3& missing_mss, const core::Vector3& felt_mss, float time_s,
                 bool by_fix);
    void learnRates(const core::Vector3& turn_rad);
    static void learnRate(int32_t& bias, core::BodyRate& rate, float turned_rad);
    void learnForces(const core::Vector3& missing_mss, float nose_east, float trust);
    static void learnForce(int32_t& bias, float missing_mss);

    Row north_ = {{kOne, 0, 0}}, down_ = {{0, 0, kOne}};
    DeltaAngle bias_ = {};                             // of the gyros, in a sample period
    core::BodyRates rate_bias_ = {};                   // the same
    int32_t force_bias_x_ = 0, force_bias_y_ = 0;      // of the accelerometers, a ForceBias' steps
    core::Ratio mean_nose_[2] = {core::Ratio(1), {}};  // north and east of it lately
    core::BodyRates rate_ = {};
    DeltaAngle turned_ = {};     // since the matrix was last turned
    int32_t force_sum_[3] = {};  // of forces_ frames that took periods_
    core::Vector3 acceleration_ = {0, 0, 0};
    Angles angles_ = {{}, {}, {}, {}, core::Ratio(1), {}, core::Ratio(1)};
    core::Gain inverse_cos_pitch_{1}, tan_pitch_ = {};
    core::Angle yaw_rad_ = {};     // when pointYaw looked
    DeltaAngle16 last_turn_ = {};  // of the last frame
    int16_t yaw_step_ = 0;         // in a frame, in a quarter of an Angle's step
    CompassField field_;
    VelocityHistory history_;
    VelocityHistory::Moment fix_ = {};         // the accelerometers' velocity at the last fix
    VelocityHistory::Moment fix_ground_ = {};  // and the GPS's
    uint8_t pushed_fixes_ = 0;                 // that are still left out after a push
    uint8_t since_fix_ = 0xFF;                 // periods, 1.28 s at most
    float settling_ = 1;                       // 1 at start, 0 when settled
    float declination_rad_ = 0;                // that the heading has been turned by
    float cos_declination_ = 1, sin_declination_ = 0;
    float compass_off_ = 0;  // 1 - cosine of the angle of the last reading
    Phase phase_ = Phase::falling;
    uint8_t forces_ = 0, periods_ = 0;
    uint8_t behind_ = 0;     // frames that the matrix has not been turned by
    uint8_t since_yaw_ = 0;  // frames since the matrix that pointYaw looked at

    static constexpr int32_t kOne = 1L << 30;
};

}  // namespace estimation
