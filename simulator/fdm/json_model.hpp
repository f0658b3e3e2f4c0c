// SPDX-License-Identifier: GPL-3.0-or-later
// A flight model in another program, in lock step: it is sent the servo pulses, and emulated time
// goes on by what its answer's timestamp has gone on. The program listens on the port that is
// given; answers may go to the sender's port or to the port above its own, which is the same.
#pragma once
#include <chrono>

#include "simulator/fdm/protocol.hpp"
#include "simulator/fdm/udp_peer.hpp"
#include "simulator/flight_model.hpp"

namespace simulator {

// "json:PORT" or "json:HOST:PORT"; empty when it is neither.
struct ModelAddress {
    std::string host;
    uint16_t port;
};
std::optional<ModelAddress> modelAddress(const std::string& text);

class JsonModel final : public FlightModel {
public:
    explicit JsonModel(const WorldOptions& options);  // throws UdpError

    void step(const ServoPulses& pulses) override;
    const Truth& truth() const override { return truth_; }
    Vec3 toBody(const Vec3& earth) const override { return Rotation(attitude_).toBody(earth); }
    std::optional<std::array<uint16_t, 8>> radio_us() const override { return radio_us_; }
    std::string fault() const override { return fault_; }
    uint64_t answersSkipped() const override { return skipped_; }
    uint64_t timesBegunAnew() const override { return begun_anew_; }

private:
    void ask(const ServoPulses& pulses);
    bool exchange(const ServoPulses& pulses, ModelState& to);
    bool understand(const std::string& datagram, ModelState& to);
    void askLessOften();
    void take(const ModelState& state);
    void beginAnew(double gone_s);
    void moveSticks(const std::array<uint16_t, 8>& sent_us);
    void publish(const ModelState& state);
    void stop(const std::string& why);

    const WorldOptions options_;
    const std::string name_;  // for messages
    UdpPeer peer_;
    uint32_t frames_ = 0;
    uint64_t skipped_ = 0;  // answers that were not understood
    int skipped_in_a_row_ = 0;
    std::string complaint_;            // about the last of them
    std::chrono::milliseconds again_;  // after which a question is repeated
    bool heard_ = false;
    uint64_t begun_anew_ = 0;
    int begun_anew_in_a_row_ = 0;
    double last_timestamp_s_ = 0, elapsed_s_ = 0;
    double standing_down_m_ = 0;  // where it stood when first heard
    Quaternion attitude_;
    std::optional<std::array<uint16_t, 8>> radio_us_;
    Truth truth_{};
    std::string fault_;
};

}  // namespace simulator
