// SPDX-License-Identifier: GPL-3.0-or-later
// How each section of the shared state has one writer. Everybody reads `vehicle`, which is const. A
// section is written through Publisher<Section>, which one file defines, beside the code that
// writes:
//
//     template <>
//     struct Publisher<BatteryState> : Writable<BatteryState> {
//         using Writable::state;
//     };
//     constexpr BatteryState& battery = Publisher<BatteryState>::state();
//
// The compiler refuses a write from elsewhere; toolchain/check/layering.mjs refuses a second
// definition.
#pragma once
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace state {

template <class Section>
class Writable {
    friend struct Publisher<Section>;
    static constexpr Section& state() {
        return VehicleStorage::section(static_cast<Section*>(nullptr));
    }
};

}  // namespace state
}  // namespace firmware
