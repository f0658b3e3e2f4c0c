// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/gps_receiver.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/airplane/earth.hpp"
#include "simulator/world.hpp"

namespace simulator {
namespace {

constexpr size_t kLineLimit = 1024;  // the module drops what its buffer does not hold
constexpr double kBaudTolerance = 0.04;

bool sameRate(double a, double b) { return std::fabs(a / b - 1) < kBaudTolerance; }

uint64_t microseconds(double seconds) { return static_cast<uint64_t>(seconds * 1e6); }

}  // namespace

GpsReceiver::GpsReceiver(uint64_t seed, const SensorErrors& errors, const GpsOptions& options,
                         uint32_t baud, uint16_t period_ms)
    : errors_(errors),
      options_(options),
      random_(seed, 5),
      wander_{Wander(errors.gps_horizontal_m, errors.gps_wander_s, random_),
              Wander(errors.gps_horizontal_m, errors.gps_wander_s, random_),
              Wander(errors.gps_vertical_m, errors.gps_wander_s, random_)},
      baud_(baud),
      period_ms_(period_ms),
      next_measurement_us_(options.powered_us + period_ms * 1000u),
      last_measurement_us_(options.powered_us) {}

// ---- the line

uint64_t GpsReceiver::byteEnd_us(uint64_t bytes) const {
    return line_start_us_ + (bytes * 10 * 1'000'000 + baud_ - 1) / baud_;
}

uint64_t GpsReceiver::nextByte_us() const {
    return line_.empty() ? UINT64_MAX : byteEnd_us(line_sent_ + 1);
}

std::optional<uint8_t> GpsReceiver::nextByte(uint64_t now_us) {
    if (now_us < nextByte_us()) return std::nullopt;
    const uint8_t byte = line_.front();
    line_.pop_front();
    ++line_sent_;
    return byte;
}

void GpsReceiver::send(const std::vector<uint8_t>& bytes, uint64_t now_us) {
    if (fault_ == FaultKind::lost) return;
    if (line_.size() + bytes.size() > kLineLimit) return;
    if (line_.empty()) {
        line_start_us_ = std::max(now_us, byteEnd_us(line_sent_));
        line_sent_ = 0;
    }
    line_.insert(line_.end(), bytes.begin(), bytes.end());
}

void GpsReceiver::setBaud(uint32_t baud, uint64_t now_us) {
    if (baud == baud_) return;
    line_start_us_ = std::max(now_us, byteEnd_us(line_sent_));
    line_sent_ = 0;
    baud_ = baud;
}

void GpsReceiver::receive(uint8_t byte, uint32_t baud, uint64_t now_us) {
    // Sampled at the wrong times, the bits of a byte are as good as random.
    take(sameRate(baud, baud_) ? byte : static_cast<uint8_t>(random_.bits()), now_us);
}

// ---- navigation

void GpsReceiver::setPeriod(uint16_t period_ms, uint64_t now_us) {
    period_ms_ = period_ms;
    const uint64_t period_us = period_ms_ * 1000u;
    next_measurement_us_ = (now_us / period_us + 1) * period_us;
}

uint64_t GpsReceiver::nextEvent_us() const {
    const uint64_t report_us =
        waiting_.empty() ? UINT64_MAX : waiting_.front().time_us + microseconds(errors_.gps_age_s);
    return std::min(report_us, next_measurement_us_);
}

void GpsReceiver::run(const Truth& truth, uint64_t now_us) {
    while (!waiting_.empty() &&
           waiting_.front().time_us + microseconds(errors_.gps_age_s) <= now_us) {
        report(waiting_.front(), now_us);
        waiting_.pop_front();
    }
    if (now_us < next_measurement_us_) return;
    measure(truth, next_measurement_us_);
    next_measurement_us_ += period_ms_ * 1000u;
}

void GpsReceiver::measure(const Truth& truth, uint64_t now_us) {
    const double dt_s = static_cast<double>(now_us - last_measurement_us_) * 1e-6;
    last_measurement_us_ = now_us;
    const double north_m = wander_[0].advance(dt_s, random_);
    const double east_m = wander_[1].advance(dt_s, random_);
    const double up_m = wander_[2].advance(dt_s, random_);
    const auto noise = [this] { return errors_.gps_velocity_mps * random_.normal(); };
    GpsFix fix{};
    fix.time_us = now_us;
    fix.valid = !covered_ && now_us >= options_.powered_us + microseconds(options_.acquire_s);
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
    if (fault_ == FaultKind::none)
        held_.reset();
    else
        addErrors(fix);
    waiting_.push_back(fix);
}

void GpsReceiver::addErrors(GpsFix& fix) {
    if (fault_ == FaultKind::stuck) {
        if (!held_) held_ = fix;
        held_->time_us = fix.time_us;
        fix = *held_;
    }
    if (fault_ == FaultKind::jump) fix.latitude_deg += 0.005;
    if (fault_ == FaultKind::noisy) {
        fix.latitude_deg += 1e-3 * random_.normal();
        fix.longitude_deg += 1e-3 * random_.normal();
        fix.velocity_north_mps += 20 * random_.normal();
        fix.velocity_east_mps += 20 * random_.normal();
    }
    if (fault_ != FaultKind::nonsense) return;
    const auto random = [this](double most) { return most * (2 * random_.uniform() - 1); };
    fix.latitude_deg = random(90);
    fix.longitude_deg = random(180);
    fix.velocity_north_mps = random(200);
    fix.velocity_east_mps = random(200);
}

}  // namespace simulator
