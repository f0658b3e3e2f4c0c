// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/home.hpp"

#include "firmware/estimator.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {

bool setHomeHere() {
    if (vehicle.gps.fix != GpsFix::three_d || !vehicle.estimate.known) return false;
    // the height above home stays what the barometer makes of it: in flight home may be set too
    const int32_t above_home_cm =
        vehicle.home.set ? static_cast<int32_t>(vehicle.estimate.height_m * 100.0f) : 0;
    if (!vehicle.home.set) {
        setHome(vehicle.estimate.position, vehicle.gps.altitude_cm);
        zeroHeight();
    } else {
        const int32_t altitude_cm = vehicle.home.altitude_cm + above_home_cm;
        setHome(vehicle.estimate.position, altitude_cm);
        shiftHeight(-above_home_cm * 0.01f);
    }
    return true;
}

void setHome(const geo::Position& position, int32_t altitude_cm) {
    vehicle.home.position = position;
    vehicle.home.altitude_cm = altitude_cm;
    vehicle.home.set = true;
}

}  // namespace firmware
