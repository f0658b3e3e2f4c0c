// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the self-test. Each measures and writes its lines of the report; which figures pass
// is decided by toolchain/self_test. None touches what the firmware has stored.
#pragma once

namespace self_test {

void startSensors();

void testSupply();     // the band gap against the supply, 200 readings
void testSensors();    // ten seconds of inertial sensor and barometer, and how long interrupts take
void testCompass();    // its identification, 100 times over I2C
void testPulses();     // widths and periods of all outputs, seen at their pins
void testEeprom();     // cells that nothing uses
void testDataflash();  // both buffers; no page is erased or programmed
void testRam();        // what is free
void testWatchdog();   // hangs; after the restart wasBitten()
bool wasBitten();

}  // namespace self_test
