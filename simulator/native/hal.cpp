// SPDX-License-Identifier: GPL-3.0-or-later
// Every contract of libraries/hal, answered by the native board that runs.
#include <vector>

#include "core/crc.hpp"
#include "hal/analog.hpp"
#include "hal/clock.hpp"
#include "hal/eeprom.hpp"
#include "hal/hang_timer.hpp"
#include "hal/i2c.hpp"
#include "hal/interrupts.hpp"
#include "hal/rc_input.hpp"
#include "hal/serial.hpp"
#include "hal/servo_output.hpp"
#include "hal/trace.hpp"
#include "hal/watchdog.hpp"
#include "simulator/native/native_board.hpp"

namespace hal {

static simulator::NativeBoard& board() { return simulator::NativeBoard::running(); }
static int number(Port port) { return static_cast<int>(port); }

// clock
uint32_t now_us() { return static_cast<uint32_t>(board().sinceBegun_us()); }
uint16_t ticks() { return static_cast<uint16_t>(board().sinceBegun_us() * kTicksPerUs); }
uint32_t now_ms() { return static_cast<uint32_t>(board().sinceBegun_us() / 1000); }
// A frame takes no time here; what is read between two frames has its own.
void beginFrame() {}
uint32_t frame_ms() { return now_ms(); }
void idle(bool (*work_waits)()) { board().idle(work_waits); }

// serial
void serialOpen(Port port, uint32_t baud) { board().serial().open(number(port), baud); }
uint8_t serialAvailable(Port port) { return board().serial().available(number(port)); }
bool serialRead(Port port, uint8_t& byte) { return board().serial().read(number(port), byte); }
uint8_t serialRoom(Port port) { return board().serial().room(number(port)); }
bool serialWrite(Port port, const void* bytes, uint8_t size) {
    return board().serial().write(number(port), static_cast<const uint8_t*>(bytes), size);
}
void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra,
                    uint8_t signature) {
    crc = core::crc16(crc, head.bytes, head.size);
    crc = core::crc16(core::crc16(crc, body.bytes, body.size), extra);
    std::vector<uint8_t> frame(head.bytes, head.bytes + head.size);
    frame.insert(frame.end(), body.bytes, body.bytes + body.size);
    frame.push_back(static_cast<uint8_t>(crc));
    frame.push_back(static_cast<uint8_t>(crc >> 8));
    if (signature == 0)
        serialWrite(link, frame.data(), static_cast<uint8_t>(frame.size()));
    else
        board().serial().hold(number(link), frame, signature);
}
uint8_t linkHeldSize(Port link) {
    return static_cast<uint8_t>(board().serial().held(number(link)).size());
}
Runs linkHeld(Port link) {
    std::vector<uint8_t>& held = board().serial().held(number(link));
    return {held.data(), static_cast<uint8_t>(held.size()), nullptr};
}
void linkSendHeld(Port link, uint8_t size) { board().serial().sendHeld(number(link), size); }
uint16_t serialLost(Port port) { return board().serial().lost(number(port)); }
bool usbConnected() { return board().usb(); }

// EEPROM
core::Status eepromRead(uint16_t address, void* to, uint8_t size) {
    return board().eepromRead(address, to, size);
}
core::Status eepromWrite(uint16_t address, const void* from, uint8_t size) {
    return board().eepromChip().write(address, from, size);
}
bool eepromDrained() { return board().eepromChip().drained(); }

// I2C
bool i2cStart(I2cUser, uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t in_size) {
    return board().i2c().start(address, out, out_size, in_size);
}
core::Status i2cResult(I2cUser, uint8_t* in, uint8_t in_size) {
    return board().i2c().result(in, in_size);
}

// analogue inputs
void analogScan() { board().analog().scan(); }
AnalogSum analogTake(Analog input) { return board().analog().take(input); }

// receiver and servos
bool rcRead(uint16_t (&pulse_us)[kRcChannels]) { return board().receiver().read(pulse_us); }
bool rcReadWhole(uint16_t (&pulse_us)[kRcChannels]) {
    return board().receiver().readWhole(pulse_us);
}
uint16_t rcPulse_us(uint8_t channel) { return board().receiver().newest_us(channel); }
uint32_t rcAge_us() { return board().receiver().age_us(); }
void servoStart(uint16_t rate_hz) { board().servos().start(rate_hz); }
void servoWrite(uint8_t output, uint16_t pulse_halfus) {
    board().servos().write(output, pulse_halfus);
}
uint16_t servoRead(uint8_t output) { return board().servos().read(output); }

// The only interrupt that runs firmware code is called between its turns: nothing to hold off.
uint8_t lockInterrupts() { return 0; }
void unlockInterrupts(uint8_t) {}

// watchdog and trace
const LastRun& lastRun() { return board().lastRun(); }
void hangTimerStart() {}
void hangTimerReset() {}  // its interrupt never runs: the firmware always comes round here
void watchdogStart() { board().watchdogStart(); }
void watchdogFeed() { board().watchdogFeed(); }
void reboot() { board().reboot(); }
void trace(uint8_t value) { board().trace(value); }
void traceItem(uint8_t value, uint8_t) { board().trace(value); }

}  // namespace hal
