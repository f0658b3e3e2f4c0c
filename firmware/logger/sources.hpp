// SPDX-License-Identifier: GPL-3.0-or-later
// What is put into the log: each fills in one record of now and offers it to the chip. False: the
// chip has no time, or what is to be logged cannot be had yet.
#pragma once
#include <stdint.h>

#include "firmware/control/attitude_control.hpp"

namespace firmware {
namespace logger {

bool logRecord(void* record, uint8_t type, uint8_t size);  // with its head and time

bool putFormat(uint8_t index);
bool putUnit(uint8_t index);
bool putMultiplier(uint8_t index);
bool putUnits(uint8_t index);  // of a format
bool putParameter(uint8_t index);
bool putCommand(uint8_t index);
bool putMode();
bool putText();    // the oldest that the log does not have; false also when there is none
bool putBanner();  // what flies
bool putLists();   // which mission, fence and rally points are stored
bool putEvent(uint8_t id);
bool putError(uint8_t subsystem, uint8_t code);
bool putCameraFeedback();

bool putAttitude();
bool putGps();
bool putControl();
bool putNavigation();
bool putPlace();
bool putInertial();
bool putCompass();
bool putBarometer();
bool putBattery();
bool putPower();
bool putRadioIn();
bool putServoOut();
bool putPerformance();
bool putAttitude2();
bool putSpeedHeight();
bool putLoop(control::Loop loop);
bool putAirspeed();
bool putVibration();

}  // namespace logger
}  // namespace firmware
