// SPDX-License-Identifier: GPL-3.0-or-later
// Honeywell HMC5883L on I2C (data sheet 900405), or its predecessor HMC5843 (900367), mounted as on
// the APM 2, body x = -chip y, body y = -chip x, body z = -chip z, or turned against that.
#pragma once
#include <array>
#include <cstdint>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

enum class CompassKind { hmc5883l, hmc5843 };
struct CompassMount {
    CompassKind kind = CompassKind::hmc5883l;
    // How it is turned against the airplane, degrees: yawed, then pitched, then rolled.
    double roll_deg = 0, pitch_deg = 0, yaw_deg = 0;
    // Of some clones the coil of the self-test is wound the other way round.
    bool inverted_self_test = false;
};

class Hmc5883l {
public:
    static constexpr uint8_t kAddress = 0x1E;

    explicit Hmc5883l(uint64_t seed = 1, const SensorErrors& errors = {}, CompassMount mount = {});

    // Answers whether it acknowledges: it does unless unplugged.
    bool start(bool read, uint64_t now_us);
    bool write(uint8_t byte, uint64_t now_us);
    uint8_t read(bool ack, uint64_t now_us);
    void stop(uint64_t now_us);

    // The field it is in from now on, milligauss in body axes. World does that.
    void sense(const std::array<double, 3>& body_mg) { body_mg_ = body_mg; }
    const std::array<double, 3>& offset_mg() const { return offset_mg_; }  // body axes

    void unplug(bool unplugged) { unplugged_ = unplugged; }
    void power(bool on, uint64_t now_us);  // on, its registers are at their reset values
    void fail(FaultKind kind, double for_s = 0);

private:
    void advance(uint64_t now_us);
    void begin(uint64_t now_us);
    void measure();
    std::array<double, 3> chipField_mg();
    void writeRegister(uint8_t value, uint64_t now_us);
    uint8_t readRegister();
    uint64_t period_us() const;

    void resetRegisters();
    bool silent() const { return unplugged_ || !powered_; }
    bool old() const { return mount_.kind == CompassKind::hmc5843; }
    std::array<double, 3> chipAxes() const;

    const SensorErrors errors_;
    const CompassMount mount_;
    Random random_;
    std::array<double, 3> body_mg_{}, offset_mg_{};
    std::array<uint8_t, 13> registers_{};
    uint8_t pointer_ = 0;
    bool written_ = false;  // in this transfer
    bool pointer_next_ = false;
    uint8_t read_mask_ = 0;              // data registers read since the last measurement
    uint64_t measured_us_ = UINT64_MAX;  // when the running measurement ends
    bool unplugged_ = false, powered_ = true;
    uint64_t ready_us_ = 0, settled_us_ = 0;  // for commands, for measurements
    std::array<FaultyValue, 3> faults_;
};

}  // namespace simulator
