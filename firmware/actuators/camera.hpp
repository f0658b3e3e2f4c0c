// SPDX-License-Identifier: GPL-3.0-or-later
// A camera's shutter: for CAM_DURATION the outputs whose RCn_FUNCTION is the camera's go to
// CAM_SERVO_ON, or the relay is switched on (CAM_TRIGG_TYPE).
#pragma once
#include <stdint.h>

namespace firmware {
namespace actuators {

constexpr int8_t kCameraFunction = 10;  // RCn_FUNCTION

void cameraStart();
void cameraTrigger();
void cameraEvery(int32_t distance_cm);  // flown over the ground; 0: no more
void runCamera();                       // 10 Hz

uint16_t cameraPulse_us();
uint16_t cameraTriggerCount();  // since the start

}  // namespace actuators
}  // namespace firmware
