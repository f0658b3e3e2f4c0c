// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/parameter_guard.hpp"

#include "core/file_state.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameter_slots.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;

namespace {

// All parameters once, and as many again; then one in ten seconds: 100,000 writes take 11 days.
constexpr uint16_t kMaxWrites = 450;
constexpr uint16_t kForgottenEvery = 10 * kTickRate_hz;

struct Writes {
    uint16_t recent;
    uint16_t ticks;
};
core::FileState<Writes> writes{};

}  // namespace

bool parameterMayBeSet(const Link& link, uint16_t index) {
    if (slot::isForUsbAlone(parameterSlot(index)) && !isUsb(link)) {
        sendStatusText(Severity::warning, STATUS_TEXT("Parameter refused: only over USB"));
        return false;
    }
    if (writes.recent < kMaxWrites) return true;
    sendStatusText(Severity::warning, STATUS_TEXT("Parameter refused: too many writes"));
    return false;
}

bool parameterChanges(uint16_t index, float value) {
    char name[16];
    float now;
    uint8_t type;
    return parameterAt(index, name, now, type) && now != value;
}

void parameterWritten() { ++writes.recent; }

void parameterGuardTick() {
    if (++writes.ticks < kForgottenEvery) return;
    writes.ticks = 0;
    if (writes.recent > 0) --writes.recent;
}

}  // namespace gcs
}  // namespace firmware
