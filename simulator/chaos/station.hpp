// SPDX-License-Identifier: GPL-3.0-or-later
// The ground station of a scenario's events: makes frames of their words, for either link.
#pragma once
#include "simulator/chaos/scenario.hpp"
#include "simulator/ground/link.hpp"

namespace simulator::chaos {

class EventStation {
public:
    EventStation(Board& board, int telemetry_usart);

    static bool sends(const Event& event);  // it is one of those
    void send(const Event& event);

private:
    Link& on(const std::string& link) { return link == "usb" ? usb_ : telemetry_; }
    void sendRaw(const Event& event);

    Board& board_;
    Link telemetry_, usb_;
};

}  // namespace simulator::chaos
