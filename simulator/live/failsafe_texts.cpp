// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/failsafe_texts.hpp"

namespace simulator::live {

// Of those without a text of their own the cause is over with what it follows from; a jump that is
// refused is over with the next fix that is not, which no text reports.
const std::vector<FailsafeText>& failsafeTexts() {
    static const std::vector<FailsafeText> kTexts = {
        {"Inertial sensor lost", {"Inertial back"}},
        {"Battery low", {}},
        {"Headwind too strong", {}},
        {"Radio lost: long failsafe", {"Radio back"}},
        {"Ground station lost: failsafe", {"Ground station back"}},
        {"Radio lost: short failsafe", {"Radio back"}},
        {"Position lost", {"GPS back"}},
        {"Height lost: held by throttle", {"Barometer back", "GPS back"}},
        {"GPS lost: dead reckoning", {"GPS back"}},
        {"GPS jump refused", {"GPS back"}},
        {"Barometer lost", {"Barometer back"}},
        {"Airspeed lost", {"Airspeed back"}},
        {"Compass lost", {"Compass back"}},
    };
    return kTexts;
}

const FailsafeText* failsafeBegunBy(const std::string& text) {
    for (const FailsafeText& each : failsafeTexts())
        if (text == each.begins) return &each;
    return nullptr;
}

}  // namespace simulator::live
