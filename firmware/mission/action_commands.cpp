// SPDX-License-Identifier: GPL-3.0-or-later
// DO commands of the APM 2.0 set: done at once.
#include <string.h>

#include "firmware/actuators/camera.hpp"
#include "firmware/actuators/relay.hpp"
#include "firmware/control/inverted.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/mission/servo_relay_events.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;
using namespace control;
using namespace actuators;

Jump jumpCounted(const Record& record) { return {record.p1, static_cast<int16_t>(record.p3)}; }

void changeSpeed(const Record& record) {
    const int32_t speed_cms = record.p4 != 0 ? record.p4 : record.p2 * 100;
    if (record.p2 >= 0) record.p1 == 0 ? setAirSpeed(speed_cms) : setGroundSpeed(speed_cms);
    if (record.p3 >= 0) setCruiseThrottle(static_cast<int8_t>(record.p3));
}

void setHomeAction(const Record& record) {
    if (record.p1 == 0)
        setHome({record.p3, record.p4}, record.p2);
    else if (!setHomeHere())
        sendStatusText(Severity::warning, STATUS_TEXT("Mission: no fix, home not set"));
}

float parameterValue(const Record& record) {
    if (record.p3 == 0) return static_cast<float>(record.p2);
    float exact;
    memcpy(&exact, &record.p3, sizeof exact);
    return exact;
}

void setParameterAction(const Record& record) { setSlot(record.p1, parameterValue(record)); }

void setRelay(const Record& record) { relaySet(record.p2 != 0); }

void repeatRelay(const Record& record) {
    repeatCycles(kRelayOutput, 0, static_cast<uint16_t>(record.p2),
                 static_cast<uint8_t>(record.p3));
}

void setServo(const Record& record) { holdOutput(record.p1, servoPulse_us(record.p1, record.p2)); }

void repeatServo(const Record& record) {
    const int32_t pulse_us = record.p4 != 0 ? record.p4 : 1;
    repeatCycles(record.p1, servoPulse_us(record.p1, pulse_us), static_cast<uint16_t>(record.p2),
                 static_cast<uint8_t>(record.p3));
}

// A mark for whoever looks for it, or what this board has no hardware for.
void nothingToDo(const Record&) {}

void triggerCamera(const Record&) { cameraTrigger(); }

int32_t triggerDistance_cm(const Record& record) {
    return record.p3 != 0 ? record.p3 : record.p2 * 100;
}
void triggerByDistance(const Record& record) { cameraEvery(triggerDistance_cm(record)); }

void enableFence(const Record& record) { (void)host.enableFence(record.p1); }

void flyInverted(const Record& record) { requestInverted(record.p1 != 0); }

}  // namespace mission
}  // namespace firmware
