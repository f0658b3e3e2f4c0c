// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ublox_gps.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "simulator/airplane/earth.hpp"
#include "simulator/world.hpp"

namespace simulator {
namespace {

constexpr uint8_t kAcknowledge = 0x05, kConfigure = 0x06;
constexpr uint8_t kPort = 0x00, kMessage = 0x01, kRate = 0x08, kSave = 0x09, kSbas = 0x16,
                  kNavigation = 0x24;
constexpr uint16_t kUbx = 1, kNmea = 2;  // protocol mask
constexpr uint8_t kUart1 = 1;
constexpr uint16_t kFactoryPeriod_ms = 1000;
constexpr size_t kLineLimit = 1024;  // the module drops what its buffer does not hold
constexpr double kBaudTolerance = 0.04;

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

bool sameRate(double a, double b) { return std::fabs(a / b - 1) < kBaudTolerance; }

uint64_t microseconds(double seconds) { return static_cast<uint64_t>(seconds * 1e6); }

}  // namespace

UbloxGps::UbloxGps(uint64_t seed, const SensorErrors& errors, const UbloxOptions& options)
    : errors_(errors),
      options_(options),
      random_(seed, 5),
      wander_{Wander(errors.gps_horizontal_m, errors.gps_wander_s, random_),
              Wander(errors.gps_horizontal_m, errors.gps_wander_s, random_),
              Wander(errors.gps_vertical_m, errors.gps_wander_s, random_)},
      baud_(options.baud),
      protocols_out_(kUbx | kNmea),
      period_ms_(options.ubx ? static_cast<uint16_t>(1000 / errors.gps_rate_hz)
                             : kFactoryPeriod_ms),
      navigation_(kFactoryNavigation) {
    for (int i = 0; i < kReportCount; ++i) {
        const bool nmea = kReports[i].message_class == kNmeaClass;
        const bool pvt = kReports[i].id == 0x07;  // not of the u-blox 6
        rates_[i] = nmea ? options.nmea : options.ubx && !pvt;
    }
    next_measurement_us_ = period_ms_ * 1000u;
}

// ---- the line

uint64_t UbloxGps::byteEnd_us(uint64_t bytes) const {
    return line_start_us_ + (bytes * 10 * 1'000'000 + baud_ - 1) / baud_;
}

uint64_t UbloxGps::nextByte_us() const {
    return line_.empty() ? UINT64_MAX : byteEnd_us(line_sent_ + 1);
}

std::optional<uint8_t> UbloxGps::nextByte(uint64_t now_us) {
    if (now_us < nextByte_us()) return std::nullopt;
    const uint8_t byte = line_.front();
    line_.pop_front();
    ++line_sent_;
    return byte;
}

void UbloxGps::send(const std::vector<uint8_t>& bytes, uint64_t now_us) {
    if (line_.size() + bytes.size() > kLineLimit) return;
    if (line_.empty()) {
        line_start_us_ = std::max(now_us, byteEnd_us(line_sent_));
        line_sent_ = 0;
    }
    line_.insert(line_.end(), bytes.begin(), bytes.end());
}

void UbloxGps::setPort(uint32_t baud, uint16_t protocols_out, uint64_t now_us) {
    protocols_out_ = protocols_out;
    if (baud == baud_) return;
    line_start_us_ = std::max(now_us, byteEnd_us(line_sent_));
    line_sent_ = 0;
    baud_ = baud;
}

void UbloxGps::receive(uint8_t byte, uint32_t baud, uint64_t now_us) {
    // Sampled at the wrong times, the bits of a byte are as good as random.
    parser_.take(sameRate(baud, baud_) ? byte : static_cast<uint8_t>(random_.bits()));
    if (const auto frame = parser_.frame()) obey(*frame, now_us);
    if (const auto sentence = parser_.sentence()) obey(*sentence, now_us);
}

// ---- configuration

void UbloxGps::obey(const UbxFrame& frame, uint64_t now_us) {
    if (frame.message_class != kConfigure) return;
    const bool good = configure(frame, now_us);
    send(ubxBytes({kAcknowledge, good, {frame.message_class, frame.id}}), now_us);
}

bool UbloxGps::configure(const UbxFrame& frame, uint64_t now_us) {
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
            static_cast<uint8_t>(period_ms_), static_cast<uint8_t>(period_ms_ >> 8), 1, 0, 1, 0};
    if (answer.empty()) return false;
    send(ubxBytes({kConfigure, frame.id, answer}), now_us);
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
    period_ms_ = frame.u16(0);
    const uint64_t period_us = period_ms_ * 1000u;
    next_measurement_us_ = (now_us / period_us + 1) * period_us;
    return true;
}

bool UbloxGps::configureNavigation(const UbxFrame& frame) {
    if (frame.payload.size() != navigation_.size()) return false;
    constexpr uint8_t kModels[] = {0, 2, 3, 4, 5, 6, 7, 8};
    const bool model =
        std::find(std::begin(kModels), std::end(kModels), frame.payload[2]) != std::end(kModels);
    if ((frame.u16(0) & 1) && !model) return false;
    for (const MaskedField& field : kNavigationFields)
        if (frame.u16(0) & field.bit)
            std::copy_n(frame.payload.begin() + static_cast<std::ptrdiff_t>(field.offset),
                        field.size, navigation_.begin() + field.offset);
    return true;
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

// ---- navigation

uint64_t UbloxGps::nextEvent_us() const {
    const uint64_t report_us =
        waiting_.empty() ? UINT64_MAX : waiting_.front().time_us + microseconds(errors_.gps_age_s);
    return std::min(report_us, next_measurement_us_);
}

void UbloxGps::run(const Truth& truth, uint64_t now_us) {
    while (!waiting_.empty() &&
           waiting_.front().time_us + microseconds(errors_.gps_age_s) <= now_us) {
        report(waiting_.front(), now_us);
        waiting_.pop_front();
    }
    if (now_us < next_measurement_us_) return;
    measure(truth, next_measurement_us_);
    next_measurement_us_ += period_ms_ * 1000u;
}

void UbloxGps::measure(const Truth& truth, uint64_t now_us) {
    const double dt_s = static_cast<double>(now_us - last_measurement_us_) * 1e-6;
    last_measurement_us_ = now_us;
    const double north_m = wander_[0].advance(dt_s, random_);
    const double east_m = wander_[1].advance(dt_s, random_);
    const double up_m = wander_[2].advance(dt_s, random_);
    const auto noise = [this] { return errors_.gps_velocity_mps * random_.normal(); };
    GpsFix fix{};
    fix.time_us = now_us;
    fix.valid = !covered_ && now_us >= microseconds(options_.acquire_s);
    fix.satellites = fix.valid ? options_.satellites : 0;
    const Place place =
        moved({truth.latitude_deg, truth.longitude_deg}, truth.altitude_m, north_m, east_m);
    fix.latitude_deg = place.latitude_deg;
    fix.longitude_deg = place.longitude_deg;
    fix.altitude_m = truth.altitude_m + up_m;
    fix.velocity_north_mps = truth.velocity_north_mps + noise();
    fix.velocity_east_mps = truth.velocity_east_mps + noise();
    fix.velocity_down_mps = truth.velocity_down_mps + noise();
    if (!fix.valid) fix = {now_us, false, 0, 0, 0, 0, 0, 0, 0};
    waiting_.push_back(fix);
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
