// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/streams.hpp"

#include <string.h>
#include "firmware/actuators/camera.hpp"

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/ftp.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/messages.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace state;

namespace {

using mavlink::MavDataStream;

// In the order of StreamRates; then what no rate parameter governs.
enum class Stream : uint8_t {
    raw_sensors,
    extended_status,
    rc_channels,
    position,
    extra1,
    extra2,
    extra3,
    always,           // once a second, whatever was asked for
    on_request,       // when asked for, or by an event
    extended_slowly,  // once a second while there is extended_status
    extra3_slowly,    // ... and extra3
};
constexpr uint8_t kRatedStreams = 7;
constexpr uint8_t kStreams = 11;
constexpr uint8_t kAlwaysRate = 4;  // quarters of a hertz

struct OutgoingRow {
    Stream stream;
    mavlink::Layout layout;
    bool (*fill)(const Link& link, void* message);
};

template <class Message>
bool fill(const Link& link, void* message) {
    return fillIn(link, *static_cast<Message*>(message));
}

// Of the streams' messages AUTOPILOT_VERSION is the longest.
constexpr uint8_t kLongestMessage = (sizeof(mavlink::AutopilotVersion) + 3) / 4 * 4;

// Extension fields that nobody fills in would be cleared and then left out as zeros.
template <class Message>
constexpr bool fillsExtensions() {
    return false;
}
template <>
constexpr bool fillsExtensions<mavlink::MissionCurrent>() {
    return true;
}
template <>
constexpr bool fillsExtensions<mavlink::EkfStatusReport>() {
    return true;
}
template <class Message>
constexpr mavlink::Layout layoutToFill() {
    using Wire = mavlink::Wire<Message>;
    return {Wire::id, Wire::length,
            fillsExtensions<Message>() ? Wire::length_with_extensions : Wire::length,
            Wire::crc_extra};
}

template <class Message>
constexpr OutgoingRow row(Stream stream) {
    static_assert(
        mavlink::kHeaderV2 + mavlink::Wire<Message>::length + mavlink::kChecksum <= kLargestFrame,
        "larger than kLargestFrame");
    static_assert(sizeof(Message) <= kLongestMessage, "longer than kLongestMessage");
    return {stream, layoutToFill<Message>(), fill<Message>};
}

constexpr OutgoingRow kOutgoing[] ROM = {
    row<mavlink::Heartbeat>(Stream::always),
    row<mavlink::SysStatus>(Stream::extended_status),
    row<mavlink::PowerStatus>(Stream::extended_slowly),
    row<mavlink::BatteryStatus>(Stream::extended_slowly),
    row<mavlink::Meminfo>(Stream::extended_slowly),
    row<mavlink::GpsRawInt>(Stream::extended_status),
    row<mavlink::NavControllerOutput>(Stream::extended_status),
    row<mavlink::MissionCurrent>(Stream::extended_status),
    row<mavlink::FenceStatus>(Stream::extended_status),
    row<mavlink::ExtendedSysState>(Stream::extended_slowly),
    row<mavlink::MissionItemReached>(Stream::on_request),
    row<mavlink::CameraFeedback>(Stream::on_request),
    row<mavlink::Attitude>(Stream::extra1),
    row<mavlink::GlobalPositionInt>(Stream::position),
    row<mavlink::VfrHud>(Stream::extra2),
    row<mavlink::RawImu>(Stream::raw_sensors),
    row<mavlink::ScaledPressure>(Stream::raw_sensors),
    row<mavlink::ServoOutputRaw>(Stream::rc_channels),
    row<mavlink::RcChannelsRaw>(Stream::rc_channels),
    row<mavlink::RcChannels>(Stream::rc_channels),
    row<mavlink::Ahrs>(Stream::extra3),
    row<mavlink::Wind>(Stream::extra3),
    row<mavlink::Hwstatus>(Stream::extra3_slowly),
    row<mavlink::SystemTime>(Stream::extra3_slowly),
    row<mavlink::Vibration>(Stream::extra3_slowly),
    row<mavlink::EkfStatusReport>(Stream::extra3_slowly),
    row<mavlink::HomePosition>(Stream::on_request),
    row<mavlink::AutopilotVersion>(Stream::on_request),
    row<mavlink::ProtocolVersion>(Stream::on_request),
    row<mavlink::AvailableModes>(Stream::on_request),
    row<mavlink::CurrentMode>(Stream::on_request),
    row<mavlink::ScaledImu>(Stream::on_request),
    row<mavlink::AttitudeQuaternion>(Stream::on_request),
    row<mavlink::RcChannelsScaled>(Stream::on_request),
    row<mavlink::LocalPositionNed>(Stream::on_request),
    row<mavlink::PositionTargetGlobalInt>(Stream::on_request),
};
static_assert(core::count(kOutgoing) == kOutgoingRows, "kOutgoingRows does not fit the table");

constexpr uint8_t kDue = 4 * kTickRate_hz;
constexpr uint8_t kHeartbeatRow = 0;

struct Rates {
    uint8_t of[kStreams];  // by Stream
};

void slowDown(Rates& rates, Stream stream, Stream slowly) {
    const bool sent = rates.of[static_cast<uint8_t>(stream)] != 0;
    rates.of[static_cast<uint8_t>(slowly)] = sent ? kAlwaysRate : 0;
}

Rates ratesOf(const Link& link) {
    Rates rates;
    const int8_t* rates_hz = &parameters.streams[linkNumber(link)].raw_sensors;
    for (uint8_t i = 0; i < kRatedStreams; ++i) {
        const int8_t rate_hz = core::limit<int8_t>(rates_hz[i], 0, kTickRate_hz);
        rates.of[i] = static_cast<uint8_t>(4 * rate_hz);
    }
    rates.of[static_cast<uint8_t>(Stream::always)] = kAlwaysRate;
    rates.of[static_cast<uint8_t>(Stream::on_request)] = 0;
    slowDown(rates, Stream::extended_status, Stream::extended_slowly);
    slowDown(rates, Stream::extra3, Stream::extra3_slowly);
    return rates;
}

uint8_t& ownBits(Streams& streams, uint8_t row) { return streams.own[row / 8]; }
constexpr uint8_t ownBit(uint8_t row) { return static_cast<uint8_t>(1 << row % 8); }

bool ratesHaveChanged(const Link& link) {
    const StreamRates& now = parameters.streams[linkNumber(link)];
    return !link.streams.rates_worked_out ||
           memcmp(&link.streams.worked_out_of, &now, sizeof now) != 0;
}

void workOutRates(Link& link) {
    Streams& streams = core::based(link.streams);
    const Rates rates = ratesOf(link);
    for (uint8_t row = 0; row < kOutgoingRows; ++row)
        if ((ownBits(streams, row) & ownBit(row)) == 0)
            streams.rate[row] =
                rates.of[static_cast<uint8_t>(core::romRead(kOutgoing[row].stream))];
    streams.worked_out_of = parameters.streams[linkNumber(link)];
    streams.rates_worked_out = true;
}

// Time that passes while a message waits for room counts for its next one. 1: it has become due.
uint8_t accumulate(uint8_t& phase, uint8_t by) {
    const uint8_t before = phase;
    uint8_t sum = static_cast<uint8_t>(before + by);
    if (sum < before) sum = 0xFF;
    phase = sum;
    return sum >= kDue && before < kDue;
}

void age(Streams& streams, uint8_t row, uint8_t by) {
    streams.due = static_cast<uint8_t>(streams.due + accumulate(streams.phase[row], by));
}

// A download has the line nearly to itself, as ArduPilot has it.
constexpr uint8_t kSlowdownByDownload_pct = 75;

// The part of a turn the radio and a download leave to the streams; true when they have a whole
// turn together.
bool tickIsDue(Link& link) {
    Streams& streams = link.streams;
    uint8_t slowdown_pct = link.slowdown_pct;
    if (slowdown_pct < kSlowdownByDownload_pct && downloadWaits(link))
        slowdown_pct = kSlowdownByDownload_pct;
    streams.credit_pct = static_cast<uint8_t>(streams.credit_pct + 100 - slowdown_pct);
    if (streams.credit_pct < 100) return false;
    streams.credit_pct = static_cast<uint8_t>(streams.credit_pct - 100);
    return true;
}

// By fours: half the work of memset, which in all would be 0.2 % of the processor.
void clear(uint8_t* bytes, uint8_t size) {
    for (uint8_t fours = static_cast<uint8_t>((size + 3) / 4); fours > 0; --fours) {
        *bytes++ = 0;
        *bytes++ = 0;
        *bytes++ = 0;
        *bytes++ = 0;
    }
}

// One place for all messages, and for their bytes: each with its own would be 2 kB more.
bool fillAndSend(Link& link, const OutgoingRow& row) {
    uint8_t message[kLongestMessage];
    clear(message, core::romRead(row.layout.length_with_extensions));
    if (!core::romRead(row.fill)(link, message)) return true;
    return sendPayload(link, message, row.layout);
}

bool sendRow(Link& link, uint8_t row) {
    if (!fillAndSend(link, kOutgoing[row])) return false;
    link.streams.phase[row] = static_cast<uint8_t>(link.streams.phase[row] - kDue);
    --link.streams.due;
    return true;
}

struct Reported {
    uint16_t triggers;
    uint8_t home_changes;
};
core::FileState<Reported> reported{};

void requestOnAll(uint16_t message_id) {
    for (Link& link : links) requestOnce(link, message_id);
}

}  // namespace

void streamsStart(Link& link) {
    link.streams.rates_worked_out = false;
    memset(link.streams.own, 0, sizeof link.streams.own);
    for (uint8_t row = 0; row < kOutgoingRows; ++row) {
        // spread, so that messages of one rate do not all fall into one turn
        link.streams.phase[row] = static_cast<uint8_t>(row * 77U % kDue);
    }
    link.streams.phase[kHeartbeatRow] = kDue;
    link.streams.due = 1;
}

void streamsTick(Link& link) {
    if (!tickIsDue(link)) return age(link.streams, kHeartbeatRow, kAlwaysRate);
    if (ratesHaveChanged(link)) workOutRates(link);
    const uint8_t* by = link.streams.rate;
    uint8_t due = 0;
    for (uint8_t& phase : link.streams.phase)
        if (accumulate(phase, *by++)) ++due;
    link.streams.due = static_cast<uint8_t>(link.streams.due + due);
}

bool heartbeatDue(const Link& link) { return link.streams.phase[kHeartbeatRow] >= kDue; }

bool streamsSend(Link& link) {
    Streams& streams = core::based(link.streams);
    if (streams.due == 0) return false;
    if (heartbeatDue(link)) return sendRow(link, kHeartbeatRow);
    uint8_t row = streams.last_row;  // stored at each step it would take 0.1 % of the processor
    const uint8_t* phase = &streams.phase[row];
    do {
        ++row;
        ++phase;
        if (row == kOutgoingRows) {
            row = 0;
            phase = streams.phase;
        }
    } while (*phase < kDue);
    streams.last_row = row;
    return sendRow(link, row);
}

uint8_t outgoingRow(uint16_t message_id) {
    for (uint8_t row = 0; row < kOutgoingRows; ++row)
        if (core::romRead(kOutgoing[row].layout.id) == message_id) return row;
    return kNoMessage;
}

void requestOnce(Link& link, uint16_t message_id) {
    const uint8_t row = outgoingRow(message_id);
    if (row != kNoMessage) age(link.streams, row, kDue);
}

void sendCameraFeedback() {
    const uint16_t taken = actuators::cameraTriggerCount();
    if (taken == reported.triggers) return;
    reported.triggers = taken;
    if (taken == 0) return;  // counted anew
    requestOnAll(mavlink::Wire<mavlink::CameraFeedback>::id);
}

void sendHomePosition() {
    if (vehicle.home.changes == reported.home_changes) return;
    reported.home_changes = vehicle.home.changes;
    requestOnAll(mavlink::Wire<mavlink::HomePosition>::id);
}

bool isDue(const Link& link, uint16_t message_id) {
    const uint8_t row = outgoingRow(message_id);
    return row != kNoMessage && link.streams.phase[row] >= kDue;
}

bool setStreamRate(Link& link, uint8_t mav_data_stream, uint16_t rate_hz) {
    // the place of each MAV_DATA_STREAM in StreamRates
    static constexpr uint8_t kOrder[] ROM = {
        MavDataStream::raw_sensors, MavDataStream::extended_status, MavDataStream::rc_channels,
        MavDataStream::position,    MavDataStream::extra1,          MavDataStream::extra2,
        MavDataStream::extra3,
    };
    int8_t* rates_hz = &parameters.streams[linkNumber(link)].raw_sensors;
    bool known = false;
    for (uint8_t i = 0; i < core::count(kOrder); ++i) {
        if (mav_data_stream != MavDataStream::all && mav_data_stream != core::romRead(kOrder[i]))
            continue;
        rates_hz[i] = static_cast<int8_t>(rate_hz < kTickRate_hz ? rate_hz : kTickRate_hz);
        known = true;
    }
    return known;
}

bool setInterval(Link& link, uint8_t row, int32_t interval_us) {
    constexpr int32_t kSecond_us = 1000000;
    if (row == kHeartbeatRow) return interval_us == 0 || interval_us == kSecond_us;  // always
    uint8_t quarters = 0;
    if (interval_us > 0) {
        const int32_t whole = (4000000 + interval_us / 2) / interval_us;
        if (whole < 1) return false;  // slower than one in eight seconds
        quarters = static_cast<uint8_t>(whole < kDue ? whole : kDue);
    }
    uint8_t& own = ownBits(link.streams, row);
    own |= ownBit(row);
    link.streams.rate[row] = quarters;
    if (interval_us == 0) {
        own = static_cast<uint8_t>(own & ~ownBit(row));
        workOutRates(link);
    }
    return true;
}

int32_t interval_us(Link& link, uint8_t row) {
    if (ratesHaveChanged(link)) workOutRates(link);
    const uint8_t quarters = link.streams.rate[row];
    return quarters == 0 ? -1 : 4000000 / quarters;
}

}  // namespace gcs
}  // namespace firmware
