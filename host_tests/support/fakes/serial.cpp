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
    s.held.clear();
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

uint8_t serialRoom(Port port) {
    const fakes::Serial& s = fakes::serial(port);
    return static_cast<uint8_t>(s.room - std::min<size_t>(s.held.size(), s.room));
}

bool serialWrite(Port port, const void* bytes, uint8_t size) {
    fakes::Serial& s = fakes::serial(port);
    if (size > s.room) return false;
    const uint8_t* from = static_cast<const uint8_t*>(bytes);
    s.out.insert(s.out.end(), from, from + size);
    if (!s.endless) s.room = static_cast<uint8_t>(s.room - size);
    return true;
}

void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra,
                    uint8_t signature) {
    crc = core::crc16(crc, head.bytes, head.size);
    crc = core::crc16(core::crc16(crc, body.bytes, body.size), extra);
    std::vector<uint8_t> frame(head.bytes, head.bytes + head.size);
    frame.insert(frame.end(), body.bytes, body.bytes + body.size);
    frame.push_back(static_cast<uint8_t>(crc));
    frame.push_back(static_cast<uint8_t>(crc >> 8));
    if (signature == 0) {
        serialWrite(link, frame.data(), static_cast<uint8_t>(frame.size()));
        return;
    }
    std::vector<uint8_t>& held = fakes::serial(link).held;
    held.insert(held.end(), frame.begin(), frame.end());
    held.resize(held.size() + signature);
}
uint8_t linkHeldSize(Port link) { return static_cast<uint8_t>(fakes::serial(link).held.size()); }
Runs linkHeld(Port link) {
    std::vector<uint8_t>& held = fakes::serial(link).held;
    return {held.data(), static_cast<uint8_t>(held.size()), nullptr};
}
void linkSendHeld(Port link, uint8_t size) {
    std::vector<uint8_t>& held = fakes::serial(link).held;
    const std::vector<uint8_t> sent(held.begin(), held.begin() + size);
    held.erase(held.begin(), held.begin() + size);
    serialWrite(link, sent.data(), size);
}

uint16_t serialLost(Port port) { return fakes::serial(port).lost; }
bool usbConnected() { return usb; }

}  // namespace hal
