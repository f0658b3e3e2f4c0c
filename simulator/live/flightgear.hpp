// SPDX-License-Identifier: GPL-3.0-or-later
// FlightGear as an outside view: the airplane's state as its "native-fdm" protocol carries it, for
//   fgfs --fdm=null --native-fdm=socket,in,30,,PORT,udp
// The layout is FGNetFDM, version 24, of src/Network/net_fdm.hxx (FlightGear 1.9 to 2020.3, in the
// public domain): 408 bytes, big-endian, no gaps but the one after the version. Feet, knots and
// radians are that file's.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "simulator/fdm/udp_peer.hpp"
#include "simulator/world.hpp"

namespace simulator::live {

constexpr size_t kNativeFdmBytes = 408;
constexpr uint32_t kNativeFdmVersion = 24;

std::vector<uint8_t> nativeFdm(const Truth& truth, uint32_t unix_time_s);

struct FlightGearAddress {
    std::string host;
    uint16_t port;
};
std::optional<FlightGearAddress> flightGearAddress(const std::string& text);  // HOST:PORT

class FlightGear {
public:
    static constexpr uint64_t kEvery_us = 33'333;  // 30 Hz of emulated time

    explicit FlightGear(const FlightGearAddress& address);  // throws UdpError

    void step(const Truth& truth, uint64_t now_us);

private:
    UdpPeer peer_;
    const int64_t start_s_;
    uint64_t due_us_ = 0;
};

}  // namespace simulator::live
