// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ublox_gps.hpp"

#include <algorithm>
#include <sstream>

namespace simulator {
namespace {

constexpr uint8_t kAcknowledge = 0x05, kConfigure = 0x06;
constexpr uint8_t kPort = 0x00, kMessage = 0x01, kRate = 0x08, kSave = 0x09, kSbas = 0x16,
                  kNavigation = 0x24, kSetValues = 0x8A;
constexpr uint8_t kNav = 0x01, kSolution = 0x06, kPvt = 0x07;
// No document gives it; an answer is on its way milliseconds after the last byte of the order.
constexpr uint64_t kAnswer_us = 5000;
constexpr uint16_t kUbx = 1, kNmea = 2;  // protocol mask
constexpr uint8_t kUart1 = 1;
constexpr uint16_t kFactoryPeriod_ms = 1000;

// CFG-NAV5 as shipped: portable model, automatic 2D/3D.
constexpr std::array<uint8_t, 36> kFactoryNavigation = {
    0xFF, 0xFF, 0, 3, 0, 0, 0, 0, 0x10, 0x27, 0, 0, 5, 0, 0xFA, 0, 0xFA, 0, 100, 0, 0x2C, 1, 0};

struct MaskedField {
    uint16_t bit;
    size_t offset, size;
};
constexpr MaskedField kNavigationFields[] = {
    {0x01, 2, 1}, {0x02, 12, 1}, {0x04, 3, 1}, {0x10, 14, 8}, {0x20, 22, 1}, {0x40, 23, 1},
};

// Of CFG-VALSET, and of which there are how many bytes (bits 28 to 30 of the key).
enum Key : uint32_t {
    kDynamicModel = 0x20110021,   // CFG-NAVSPG-DYNMODEL
    kMeasurePeriod = 0x30210001,  // CFG-RATE-MEAS, ms
    kBaudRate = 0x40520001,       // CFG-UART1-BAUDRATE
    kUbxOut = 0x10740001,         // CFG-UART1OUTPROT-UBX
    kNmeaOut = 0x10740002,        // CFG-UART1OUTPROT-NMEA
    kPvtOnUart1 = 0x20910007,     // CFG-MSGOUT-UBX_NAV_PVT_UART1
};
constexpr uint8_t kValueBytes[8] = {0, 1, 1, 2, 4, 8, 0, 0};

bool isModel(uint32_t model) { return model <= 8 && model != 1; }

}  // namespace

UbloxGps::UbloxGps(uint64_t seed, const SensorErrors& errors, const UbloxOptions& options)
    : GpsReceiver(
          seed, errors, options, options.baud,
          options.ubx ? static_cast<uint16_t>(1000 / errors.gps_rate_hz) : kFactoryPeriod_ms),
      generation_(options.generation),
      protocols_out_(kUbx | kNmea),
      navigation_(kFactoryNavigation) {
    for (int i = 0; i < kReportCount; ++i) {
        const bool nmea = kReports[i].message_class == kNmeaClass;
        rates_[i] = nmea ? options.nmea : options.ubx && kReports[i].id != kPvt;
    }
}

void UbloxGps::setPort(uint32_t baud, uint16_t protocols_out, uint64_t now_us) {
    protocols_out_ = protocols_out;
    setBaud(baud, now_us);
}

void UbloxGps::take(uint8_t byte, uint64_t now_us) {
    parser_.take(byte);
    if (const auto frame = parser_.frame()) obey(*frame, now_us);
    if (const auto sentence = parser_.sentence()) obey(*sentence, now_us);
}

// ---- configuration

void UbloxGps::obey(const UbxFrame& frame, uint64_t now_us) {
    if (frame.message_class != kConfigure) return;
    const bool good = configure(frame, now_us);
    send(ubxBytes({kAcknowledge, good, {frame.message_class, frame.id}}), now_us + kAnswer_us);
}

bool UbloxGps::knows(const UbxFrame& frame) const {
    if (frame.id == kSetValues) return generation_ != UbloxGeneration::six;
    return generation_ != UbloxGeneration::m10 || frame.id == kSave;
}

bool UbloxGps::sends(uint8_t message_class, uint8_t id) const {
    return message_class != kNav || id != kSolution || generation_ == UbloxGeneration::six;
}

bool UbloxGps::configure(const UbxFrame& frame, uint64_t now_us) {
    if (!knows(frame)) return false;
    if (frame.payload.empty()) return poll(frame, now_us);
    switch (frame.id) {
        case kPort:
            return configurePort(frame, now_us);
        case kMessage:
            return configureMessage(frame);
        case kRate:
            return configureRate(frame, now_us);
        case kNavigation:
            return configureNavigation(frame);
        case kSetValues:
            return setValues(frame, now_us);
        case kSave:
        case kSbas:
            return true;  // accepted, without effect here
        default:
            return false;
    }
}

bool UbloxGps::poll(const UbxFrame& frame, uint64_t now_us) {
    std::vector<uint8_t> answer;
    if (frame.id == kNavigation) answer.assign(navigation_.begin(), navigation_.end());
    if (frame.id == kSbas) answer = {1, 3, 3, 0, 0x51, 0x08, 0, 0};
    if (frame.id == kRate)
        answer = {
            static_cast<uint8_t>(period_ms()), static_cast<uint8_t>(period_ms() >> 8), 1, 0, 1, 0};
    if (answer.empty()) return false;
    send(ubxBytes({kConfigure, frame.id, answer}), now_us + kAnswer_us);
    return true;
}

bool UbloxGps::configurePort(const UbxFrame& frame, uint64_t now_us) {
    constexpr uint32_t kSlowest = 4800, kFastest = 230'400;
    if (frame.payload.size() != 20) return false;
    if (frame.payload[0] != kUart1) return true;  // a port nothing is connected to
    const uint32_t baud = frame.u32(8);
    if (baud < kSlowest || baud > kFastest) return false;
    setPort(baud, frame.u16(14), now_us);
    return true;
}

// Three bytes set the rate on the port the message came by, eight on all ports.
bool UbloxGps::configureMessage(const UbxFrame& frame) {
    const size_t size = frame.payload.size();
    if (size != 3 && size != 8) return false;
    if (!sends(frame.payload[0], frame.payload[1])) return false;
    for (int i = 0; i < kReportCount; ++i) {
        if (kReports[i].message_class != frame.payload[0] || kReports[i].id != frame.payload[1])
            continue;
        rates_[i] = frame.payload[size == 3 ? 2 : 2 + kUart1];
        countdown_[i] = 0;
        return true;
    }
    // The standard sentences that this module never sends may still be turned off.
    return frame.payload[0] == kNmeaClass;
}

bool UbloxGps::configureRate(const UbxFrame& frame, uint64_t now_us) {
    if (frame.payload.size() != 6 || frame.u16(0) * errors_.gps_rate_hz < 1000) return false;
    setPeriod(frame.u16(0), now_us);
    return true;
}

bool UbloxGps::configureNavigation(const UbxFrame& frame) {
    if (frame.payload.size() != navigation_.size()) return false;
    if ((frame.u16(0) & 1) && !isModel(frame.payload[2])) return false;
    for (const MaskedField& field : kNavigationFields)
        if (frame.u16(0) & field.bit)
            std::copy_n(frame.payload.begin() + static_cast<std::ptrdiff_t>(field.offset),
                        field.size, navigation_.begin() + field.offset);
    return true;
}

// Version, layers (bit 0: the RAM), two reserved; then keys with their values.
bool UbloxGps::setValues(const UbxFrame& frame, uint64_t now_us) {
    const auto& payload = frame.payload;
    if (payload.size() < 4 || payload[0] > 1 || !(payload[1] & 1)) return false;
    for (size_t at = 4; at < payload.size();) {
        if (at + 4 > payload.size()) return false;
        const uint32_t key = frame.u32(at);
        const size_t bytes = kValueBytes[key >> 28 & 7];
        at += 4;
        if (bytes == 0 || at + bytes > payload.size()) return false;
        uint32_t value = 0;
        for (size_t i = bytes; i-- > 0;) value = value << 8 | payload[at + i];
        if (!setValue(key, value, now_us)) return false;
        at += bytes;
    }
    return true;
}

bool UbloxGps::setValue(uint32_t key, uint32_t value, uint64_t now_us) {
    const auto protocol = [&](uint16_t bit) {
        protocols_out_ =
            static_cast<uint16_t>(value ? protocols_out_ | bit : protocols_out_ & ~bit);
        return true;
    };
    switch (key) {
        case kUbxOut:
            return protocol(kUbx);
        case kNmeaOut:
            return protocol(kNmea);
        case kBaudRate:
            setBaud(value, now_us);
            return true;
        case kMeasurePeriod:
            if (value * errors_.gps_rate_hz < 1000) return false;
            setPeriod(static_cast<uint16_t>(value), now_us);
            return true;
        case kPvtOnUart1:
            rateOf(kNav, kPvt) = static_cast<uint8_t>(value);
            return true;
        case kDynamicModel:
            navigation_[2] = static_cast<uint8_t>(value);
            return isModel(value);
        default:
            return false;
    }
}

uint8_t& UbloxGps::rateOf(uint8_t message_class, uint8_t id) {
    int i = 0;
    while (kReports[i].message_class != message_class || kReports[i].id != id) ++i;
    return rates_[static_cast<size_t>(i)];
}

// $PUBX,41,port,in,out,baud,autobauding
void UbloxGps::obey(const std::string& sentence, uint64_t now_us) {
    std::vector<std::string> fields;
    std::istringstream text(sentence);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    if (fields.size() < 6 || fields[0] != "PUBX" || fields[1] != "41" || fields[2] != "1") return;
    try {
        setPort(static_cast<uint32_t>(std::stoul(fields[5])),
                static_cast<uint16_t>(std::stoul(fields[4], nullptr, 16)), now_us);
    } catch (const std::exception&) {
        // Not a number: the module ignores the sentence.
    }
}

void UbloxGps::report(const GpsFix& fix, uint64_t now_us) {
    for (int i = 0; i < kReportCount; ++i) {
        const uint16_t protocol = kReports[i].message_class == kNmeaClass ? kNmea : kUbx;
        if (rates_[i] == 0 || !(protocols_out_ & protocol)) continue;
        if (++countdown_[i] < rates_[i]) continue;
        countdown_[i] = 0;
        send(kReports[i].bytes(fix), now_us);
    }
}

}  // namespace simulator
