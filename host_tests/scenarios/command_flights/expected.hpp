// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of the two missions must do to the board's pins and to what it reports.
#pragma once
#include <string>
#include <vector>

#include "mission/record.hpp"
#include "simulator/ground/parameter_upload.hpp"

enum Channel {
    kOutput1,  // pulse, us; 0: silent
    kOutput8 = kOutput1 + 7,
    kRelay,           // 0, 1
    kHeight,          // above home as reported, m
    kTelemetryBytes,  // in the last second
    kUsbBytes,
    kTelemetrySent,  // PARAM_VALUE of WP_RADIUS since the start
    kUsbSent,
    kChannels,
};
constexpr Channel output(int number) { return static_cast<Channel>(kOutput1 + number - 1); }

struct Expected {
    const char* what;
    std::string word;  // of the log, its first time
    double after_s;
    Channel channel;
    double lowest, highest;
};

struct ExpectedParameter {
    const char* name;
    double value;
};

const std::vector<Expected>& expectedOf(mission::Set set);
const std::vector<ExpectedParameter>& parametersOf(mission::Set set);  // after the flight
// What is rigged on the ground; missions in flight may not.
const simulator::ParameterSettings& settingsOf(mission::Set set);
const std::vector<std::string>& textsOf(mission::Set set);  // STATUSTEXT that must come
