// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/camera.hpp"

#include "core/convert.hpp"
#include "core/file_state.hpp"
#include "firmware/actuators/relay.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace actuators {

using namespace notify;
using namespace state;

namespace {

constexpr float kTick_s = 0.1f;

struct Shutter {
    float every_m;       // 0: not by distance
    geo::Position last;  // of the pictures taken by distance
    uint8_t open_ticks;  // left until the shutter is let go
    uint16_t triggers;
};
core::FileState<Shutter> shutter{};

bool onRelay() { return parameters.camera_on_relay != 0; }

bool connected() {
    if (onRelay()) return true;
    for (const int8_t& function : parameters.output_function)
        if (function == kCameraFunction) return true;
    return false;
}

void open() {
    // a second picture needs a shutter that was let go
    shutter.open_ticks = static_cast<uint8_t>(parameters.camera_duration_ds + 1);
    if (onRelay()) relaySet(true);
    ++shutter.triggers;
}

void letGo() {
    if (shutter.open_ticks == 0) return;
    --shutter.open_ticks;
    if (shutter.open_ticks == 0 && onRelay()) relaySet(false);
}

// Half a step early on the average is late by nothing.
bool farEnough() {
    const float half_step_m = vehicle.estimate.ground_speed_mps * (0.5f * kTick_s);
    return geo::distance_m(shutter.last, vehicle.estimate.position) + half_step_m >=
           shutter.every_m;
}

}  // namespace

void cameraStart() {
    shutter.every_m = 0;
    shutter.open_ticks = 0;
    shutter.triggers = 0;
}

void cameraTrigger() {
    if (!connected())
        sendStatusText(Severity::warning, STATUS_TEXT("Camera: no output has its function"));
    else if (shutter.open_ticks != 0)
        sendStatusText(Severity::warning, STATUS_TEXT("Camera: still busy with the last picture"));
    else
        open();
}

void cameraEvery(int32_t distance_cm) {
    shutter.every_m = core::hundredths(distance_cm);
    shutter.last = vehicle.estimate.position;
    if (distance_cm != 0 && !connected())
        sendStatusText(Severity::warning, STATUS_TEXT("Camera: no output has its function"));
}

void runCamera() {
    const bool busy = shutter.open_ticks != 0;
    letGo();
    if (!vehicle.armed) shutter.every_m = 0;
    if (busy || core::isZero(shutter.every_m) || !vehicle.estimate.known || !farEnough()) return;
    shutter.last = vehicle.estimate.position;
    open();
}

uint16_t cameraPulse_us() {
    const int16_t pulse_us =
        shutter.open_ticks != 0 && !onRelay() ? parameters.camera_on_us : parameters.camera_off_us;
    return static_cast<uint16_t>(pulse_us);
}

uint16_t cameraTriggerCount() { return shutter.triggers; }

}  // namespace actuators
}  // namespace firmware
