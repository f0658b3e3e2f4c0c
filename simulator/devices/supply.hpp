// SPDX-License-Identifier: GPL-3.0-or-later
// The board's supply of 5 V as a curve over time, and the parts that lose their power when it
// falls under what they need and start anew when it is back.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace simulator {

// It falls at `from_us`, within `fall_us`, from what is set to `volts`, and comes back from `to_us`
// on by 5 V in a millisecond, as a regulator starts. Where the fall is longer than that it turns
// early.
struct Sag {
    double volts;
    uint64_t from_us, to_us, fall_us;
};

class Supply {
public:
    static constexpr double kNominal_v = 5.0;
    // What a supply on the bench may be set to: below it is a sag, above ends what the chip may
    // have (ATmega2560, 31.1).
    static constexpr double kLowest_v = 4.5, kHighest_v = 5.5;

    void adjust(double volts) { level_v_ = volts; }
    void set(const std::vector<Sag>& sags) { sags_ = sags; }  // instead of those there were
    void add(const Sag& sag) { sags_.push_back(sag); }

    double volts(uint64_t now_us) const;  // of two sags at once the deeper one's
    bool below(double level_v, uint64_t now_us) const;
    // The first time after `now_us` at which below() may change; UINT64_MAX: never.
    uint64_t nextCrossing_us(double level_v, uint64_t now_us) const;

private:
    std::vector<Sag> sags_;
    double level_v_ = kNominal_v;
};

// Parts by the voltage they need. World moves it on.
class PoweredParts {
public:
    explicit PoweredParts(const Supply& supply) : supply_(supply) {}

    using Change = std::function<void(bool on, uint64_t now_us)>;
    void add(double least_v, Change change) { parts_.push_back({least_v, std::move(change)}); }

    uint64_t nextEvent_us(uint64_t now_us) const;
    void run(uint64_t now_us);

private:
    struct Part {
        double least_v;
        Change change;
        bool on = true;
    };
    const Supply& supply_;
    std::vector<Part> parts_;
};

// The least voltage of the 5 V rail at which a part works, by its data sheet. Behind the regulator
// of 3.3 V, which drops 0.2 V, the rail follows once the supply is under 3.5 V.
namespace least_v {
constexpr double kRegulator_v = 0.2;
constexpr double kMpu6000 = 2.375 + kRegulator_v;  // PS-MPU-6000A, 6.3: VDD
constexpr double kMs5611 = 1.8 + kRegulator_v;     // DA5611-01BA03, operating conditions
constexpr double kHmc5883l = 2.16 + kRegulator_v;  // 900405, operating characteristics: VDD
constexpr double kBmp085 = 1.8 + kRegulator_v;     // BST-BMP085-DS000, table 1: VDD
constexpr double kAt45db = 2.7 + kRegulator_v;     // 3597, 3500: DC and AC operating range
constexpr double kAnalogImu = 2.7 + kRegulator_v;  // IDG-500: VDD
constexpr double kAds7844 = 2.7 + kRegulator_v;    // SBAS100: +VCC
constexpr double kGps = 2.7 + kRegulator_v;        // LEA-6, table 9: VCC, behind its own regulator
constexpr double kEncoder = 3.0;                   // ATmega32U2: brown-out fuse of its delivery
constexpr double kReceiver = 3.3;                  // assumed: receivers state 3.2 to 3.6 V
constexpr double kChip = 2.7;                      // ATmega2560: brown-out fuse 0xFD
constexpr double kEepromWrite = 4.5;               // ATmega2560, 31.3: 16 MHz from 4.5 V on
constexpr double kPowerOnReset = 0.9;              // ATmega2560, 31.5: falling, typical
constexpr double kMemory = 1.0;                    // assumed: no data sheet states what RAM needs
}  // namespace least_v

}  // namespace simulator
