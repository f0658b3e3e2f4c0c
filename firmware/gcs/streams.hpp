// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that go out by themselves: each belongs to a stream whose rate is a parameter (SRn_)
// and may be given a rate of its own (SET_MESSAGE_INTERVAL).
#pragma once
#include <stdint.h>

#include "firmware/state/parameters.hpp"

namespace firmware {
namespace gcs {

struct Link;

constexpr uint8_t kOutgoingRows = 36;
constexpr uint8_t kTickRate_hz = 50;  // of telemetrySend for each link

struct Streams {
    uint8_t own[(kOutgoingRows + 7) / 8] =
        {};                                 // a bit for each row that does not follow its stream
    uint8_t rate[kOutgoingRows] = {};       // in quarters of a hertz
    state::StreamRates worked_out_of = {};  // these parameters, where it follows
    bool rates_worked_out = false;
    uint8_t phase[kOutgoingRows] = {};  // grows by the rate each turn; due from kDue on
    uint8_t due = 0;                    // how many rows are
    uint8_t last_row = 0;               // the one sent last, so that no row starves another
    uint8_t credit_pct = 0;             // of a turn, while slowed down
};

void streamsStart(Link& link);
void streamsTick(Link& link);  // once a turn: finds what has become due
bool heartbeatDue(const Link& link);
bool streamsSend(Link& link);  // the next due message, the heartbeat first; false: none is due

constexpr uint8_t kNoMessage = 0xFF;
uint8_t outgoingRow(uint16_t message_id);  // kNoMessage: none of ours
void requestOnce(Link& link, uint16_t message_id);
void sendCameraFeedback();  // 50 Hz: CAMERA_FEEDBACK on every link for each new picture
void sendHomePosition();    // 50 Hz: HOME_POSITION on every link for each change of home
bool isDue(const Link& link, uint16_t message_id);
bool setStreamRate(Link& link, uint8_t mav_data_stream, uint16_t rate_hz);  // false: no such stream

// SET_MESSAGE_INTERVAL: -1 never, 0 the stream's rate; false: cannot be had.
bool setInterval(Link& link, uint8_t row, int32_t interval_us);
int32_t interval_us(Link& link, uint8_t row);  // -1: not sent

}  // namespace gcs
}  // namespace firmware
