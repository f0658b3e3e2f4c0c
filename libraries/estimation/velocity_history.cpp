// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/velocity_history.hpp"

namespace estimation {
namespace {

uint16_t wrapped(float mps) { return static_cast<uint16_t>(core::truncated(mps * 1000.0f)); }
float difference(uint16_t later, uint16_t earlier) {
    return core::thousandths(static_cast<int16_t>(static_cast<uint16_t>(later - earlier)));
}
uint16_t between(uint16_t from, uint16_t to, float share) {
    const int16_t rise = static_cast<int16_t>(static_cast<uint16_t>(to - from));
    return static_cast<uint16_t>(from + static_cast<int16_t>(core::real(rise) * share));
}
// In mm/s: m/s2 times the milliseconds.
uint32_t gain(FineAcceleration acceleration_mss, uint8_t periods) {
    constexpr uint16_t kPeriod_ms = static_cast<uint16_t>(kSamplePeriod_s * 1000 + 0.5f);
    return static_cast<uint32_t>(acceleration_mss.as<16>().raw) * (kPeriod_ms * periods);
}

}  // namespace

VelocityHistory::Moment VelocityHistory::moment(float north_mps, float east_mps) {
    return {wrapped(north_mps), wrapped(east_mps)};
}

core::Vector3 VelocityHistory::difference_mps(const Moment& later, const Moment& earlier) {
    return {difference(later.north, earlier.north), difference(later.east, earlier.east), 0};
}

void VelocityHistory::add(FineAcceleration north, FineAcceleration east, uint8_t periods) {
    north_ += gain(north, periods);
    east_ += gain(east, periods);
    since_entry_ = periods > 0xFF - since_entry_ ? 0xFF : since_entry_ + periods;
    if (since_entry_ < kStepPeriods) return;
    since_entry_ = 0;
    newest_ = newest_ + 1 < kEntries ? newest_ + 1 : 0;
    entries_[newest_] = now();
}

VelocityHistory::Moment VelocityHistory::ago(float age_s) const {
    const float back_s =
        age_s - core::real(since_entry_) * kSamplePeriod_s;  // before the newest entry
    if (!core::isPositive(back_s)) return now();
    float steps = core::limit(back_s * (1.0f / kStep_s), 0.0f, kEntries - 1.001f);
    const uint8_t whole = static_cast<uint8_t>(steps);
    const float share = steps - core::real(whole);
    const uint8_t later = newest_ >= whole ? newest_ - whole : newest_ + kEntries - whole;
    const uint8_t earlier = later > 0 ? later - 1 : kEntries - 1;
    return {between(entries_[later].north, entries_[earlier].north, share),
            between(entries_[later].east, entries_[earlier].east, share)};
}

}  // namespace estimation
