// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/restart_record.hpp"

#include <stddef.h>
#include <string.h>

namespace firmware {
namespace state {

namespace {

constexpr uint16_t kLayout = 0x5203;  // another one when a record changes

constexpr float kFlyingSpeed_mps = 5.0f;
constexpr float kFlyingHeight_m = 5.0f;  // the barometer's drift is less

// Fletcher's two sums, of 16-bit words and modulo 65536, with the second in the upper half. At 25
// Hz a CRC of the same bytes takes 0.05 % more of the processor.
uint32_t sums(uint32_t begin, const void* data, uint8_t size) {
    const uint8_t* bytes = static_cast<const uint8_t*>(data);
    uint16_t sum = static_cast<uint16_t>(begin), sum_of_sums = static_cast<uint16_t>(begin >> 16);
    for (uint8_t words = size / 2; words > 0; --words, bytes += 2) {
        uint16_t word;
        memcpy(&word, bytes, sizeof word);
        sum += word;
        sum_of_sums += sum;
    }
    if ((size & 1) != 0) {
        sum += *bytes;
        sum_of_sums += sum;
    }
    return static_cast<uint32_t>(sum_of_sums) << 16 | sum;
}

template <class Record>
uint32_t sums(const Record& record) {
    return sums(kLayout, &record, offsetof(Record, checksum));
}
uint32_t sums(const HangGyroRecord& hang, const FastRecord& after) {
    return sums(after.checksum, &hang.turn, sizeof hang.turn);
}

}  // namespace

void updateChecksum(HangGyroRecord& hang, const FastRecord& after) {
    hang.checksum = sums(hang, after);
}
bool isValid(const HangGyroRecord& hang, const FastRecord& after) {
    return hang.checksum == sums(hang, after);
}

void updateChecksum(SlowRecord& record) { record.checksum = sums(record); }
void updateChecksum(FastRecord& record) { record.checksum = sums(record); }
bool isValid(const SlowRecord& record) { return record.checksum == sums(record); }
bool isValid(const FastRecord& record) { return record.checksum == sums(record); }
void invalidate(SlowRecord& record) { record.checksum = ~sums(record); }
void invalidate(FastRecord& record) { record.checksum = ~sums(record); }

const FastRecord* newest(const FastRecord (&two)[2]) {
    const bool first = isValid(two[0]), second = isValid(two[1]);
    if (!first && !second) return nullptr;
    if (!second) return &two[0];
    if (!first) return &two[1];
    return static_cast<int8_t>(two[1].number - two[0].number) > 0 ? &two[1] : &two[0];
}

bool inTheAir(const FlightSigns& signs) {
    const bool moves = signs.ground_speed_mps > kFlyingSpeed_mps;
    const bool high = signs.height_m > kFlyingHeight_m || signs.height_m < -kFlyingHeight_m;
    return signs.armed && signs.flying && (moves || high);
}

float lost_s(uint16_t record_ms, uint16_t ended_ms, uint16_t since_ms) {
    constexpr uint16_t kMax_ms = 3000;
    const uint16_t before_ms = ended_ms - record_ms;
    const uint32_t all_ms = uint32_t{before_ms} + since_ms;
    return all_ms < kMax_ms ? static_cast<float>(all_ms) * 0.001f : kMax_ms * 0.001f;
}

}  // namespace state
}  // namespace firmware
