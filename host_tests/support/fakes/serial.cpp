// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/serial.hpp"

#include <algorithm>

#include "core/crc.hpp"

namespace {
fakes::Serial ports[hal::kPorts];
bool usb = false;
}  // namespace

namespace fakes {

Serial& serial(hal::Port port) { return ports[static_cast<uint8_t>(port)]; }
void setUsb(bool connected) { usb = connected; }

void resetSerial() {
    for (Serial& port : ports) port = Serial();
    usb = false;
}

}  // namespace fakes

namespace hal {

void serialOpen(Port port, uint32_t baud) {
    fakes::Serial& s = fakes::serial(port);
    s.in.clear();
    s.baud = baud;
    s.opened.push_back(baud);
}

uint8_t serialAvailable(Port port) {
    return static_cast<uint8_t>(std::min<size_t>(fakes::serial(port).in.size(), 255));
}

bool serialRead(Port port, uint8_t& byte) {
    fakes::Serial& s = fakes::serial(port);
    if (s.in.empty()) return false;
    byte = s.in.front();
    s.in.pop_front();
    return true;
}

uint8_t serialRoom(Port port) { return fakes::serial(port).room; }

bool serialWrite(Port port, const void* bytes, uint8_t size) {
    fakes::Serial& s = fakes::serial(port);
    if (size > s.room) return false;
    const uint8_t* from = static_cast<const uint8_t*>(bytes);
    s.out.insert(s.out.end(), from, from + size);
    if (!s.endless) s.room = static_cast<uint8_t>(s.room - size);
    return true;
}

void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra) {
    crc = core::crc16(crc, head.bytes, head.size);
    crc = core::crc16(core::crc16(crc, body.bytes, body.size), extra);
    serialWrite(link, head.bytes, head.size);
    serialWrite(link, body.bytes, body.size);
    serialWrite(link, &crc, sizeof crc);  // least byte first
}

uint16_t serialLost(Port port) { return fakes::serial(port).lost; }
bool usbConnected() { return usb; }

}  // namespace hal
