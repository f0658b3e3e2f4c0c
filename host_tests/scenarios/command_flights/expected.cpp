// SPDX-License-Identifier: GPL-3.0-or-later
#include "expected.hpp"

namespace {

constexpr double kMany = 1e9;
constexpr double kSwitch_us = 1425;  // output 8 follows the mode switch
constexpr double kReported_s = 1.2;  // by then the height, sent once a second, is the new one

// A pulse is known 20 ms after it was written, and is measured to 1 us.
Expected pulse(const char* what, const char* word, double after_s, int number, double us) {
    return {what, word, after_s, output(number), us - 2, us + 2};
}
Expected relay(const char* what, const char* word, double after_s, int on) {
    return {what, word, after_s, kRelay, double(on), double(on)};
}

// clang-format off
const std::vector<Expected> kApm2 = {
    relay("SET_RELAY 1",                        "a5",  -0.05, 0),
    relay("SET_RELAY 1",                        "a5",   0.1, 1),
    relay("it stays",                           "a10", -0.1, 1),
    relay("SET_RELAY 0",                        "a10",  0.1, 0),
    pulse("SET_SERVO 1 is the maximum",         "a6",  -0.05, 5, 1500),
    pulse("SET_SERVO 1 is the maximum",         "a6",   0.1, 5, 1900),
    pulse("it is held",                         "a25", -0.1, 5, 1900),
    pulse("SET_SERVO 0 is the minimum",         "a25",  0.1, 5, 1100),
    pulse("REPEAT_SERVO: before",               "a8",  -0.05, 6, 1500),
    pulse("REPEAT_SERVO: at the value",         "a8",   0.1, 6, 1700),
    pulse("for half a cycle",                   "a8",   1.9, 6, 1700),
    pulse("and half back",                      "a8",   2.2, 6, 1500),
    pulse("and half back",                      "a8",   3.9, 6, 1500),
    pulse("the second cycle",                   "a8",   4.2, 6, 1700),
    pulse("the second cycle",                   "a8",   5.9, 6, 1700),
    pulse("counted out",                        "a8",   6.2, 6, 1500),
    pulse("counted out",                        "a8",   8.5, 6, 1500),
    relay("REPEAT_RELAY: inverted",             "a15",  0.1, 1),
    relay("for half a cycle",                   "a15",  0.9, 1),
    relay("and half back",                      "a15",  1.2, 0),
    relay("the second cycle",                   "a15",  2.2, 1),
    relay("counted out",                        "a15",  3.2, 0),
    relay("counted out",                        "a15",  4.5, 0),
    pulse("a taken jump passes SET_SERVO over", "+24",  0.0, 6, 1500),
    pulse("SET_SERVO behind the jump",          "a21",  0.1, 8, 1200),
    {"SET_HOME here: it flies at 0 m",          "a12",  1.0, kHeight, -6, 6},
    {"SET_HOME as given: 488 m again",          "a14",  1.0, kHeight, 45, 75},
    {"CHANGE_ALT ends near 50 m",               "-16",  kReported_s, kHeight, 47, 53},
    pulse("RC7_FUNCTION 10: let go",            "a29", -0.05, 7, 1100),
    pulse("DIGICAM_CONTROL: the shutter",       "a36",  0.15, 7, 1300),
    pulse("for CAM_DURATION",                   "a36",  0.9, 7, 1300),
    pulse("and let go",                         "a36",  1.4, 7, 1100),
    pulse("SET_CAM_TRIGG_DIST: after 25 m",     "a35",  2.6, 7, 1300),
    pulse("and let go",                         "a35",  3.4, 7, 1100),
    pulse("SET_CAM_TRIGG_DIST 0: no more",      "a38",  4.0, 7, 1100),
    pulse("SET_CAM_TRIGG_DIST 0: no more",      "a38",  7.0, 7, 1100),
    pulse("IMAGE_START_CAPTURE: the shutter",   "a46",  0.15, 7, 1300),
    pulse("and let go",                         "a46",  1.4, 7, 1100),
};

const std::vector<Expected> kApm1 = {
    pulse("SET_SERVO: before",                  "a17", -0.05, 8, kSwitch_us),
    pulse("SET_SERVO: output 8",                "a17",  0.1, 8, 1300),
    relay("SET_RELAY 1",                        "a19", -0.05, 0),
    relay("SET_RELAY 1",                        "a19",  0.1, 1),
    relay("RESET_INDEX leads to SET_RELAY 0",   "a1",   0.1, 0),
    {"RESET_HOME here: it flies at 0 m",        "a22",  1.0, kHeight, -6, 6},
    {"RESET_HOME as given: 488 m again",        "a24",  1.0, kHeight, 40, 75},
    {"CHANGE_ALT ends near 70 m",               "-26",  kReported_s, kHeight, 66, 74},
    {"QUERY_VARIABLE: not sent before",         "a25", -0.1, kUsbSent, 0, 0},
    {"QUERY_, BROADCAST_VARIABLE over USB",     "c31",  0.5, kUsbSent, 2, 2},
    {"and over the telemetry port",             "c34",  1.0, kTelemetrySent, 2, 2},
    {"RADIO 1: it talks",                       "a30",  0.0, kTelemetryBytes, 500, kMany},
    {"RADIO 0: silence",                        "a30",  2.0, kTelemetryBytes, 0, 0},
    {"RADIO 0: USB is never off",               "a30",  2.0, kUsbBytes, 10, kMany},
    {"RADIO 1: it talks",                       "a32",  1.5, kTelemetryBytes, 500, kMany},
    pulse("CH_4_TOGGLE",                        "a33",  0.1, 4, 1600),
    pulse("CH_4_TOGGLE: for a second",          "a33",  0.9, 4, 1600),
    {"CH_4_TOGGLE: put back, flies again",      "a33",  1.2, output(4), 1400, 1590},
    pulse("CH_5_TOGGLE",                        "a35", -0.05, 5, 1500),
    pulse("CH_5_TOGGLE",                        "a35",  0.1, 5, 1700),
    pulse("CH_5_TOGGLE: for a second",          "a35",  0.9, 5, 1700),
    pulse("CH_5_TOGGLE: put back",              "a35",  1.2, 5, 1500),
    pulse("CH_5_TOGGLE: put back",              "a35",  1.9, 5, 1500),
    pulse("CH_5_TOGGLE: after the delay again", "a35",  2.2, 5, 1700),
    pulse("CH_5_TOGGLE: counted out",           "a35",  3.2, 5, 1500),
    pulse("CH_6_TOGGLE",                        "a37",  0.1, 6, 1300),
    pulse("CH_6_TOGGLE: for a second",          "a37",  0.9, 6, 1300),
    pulse("CH_6_TOGGLE: put back",              "a37",  1.2, 6, 1500),
    pulse("CH_7_TOGGLE",                        "a39",  0.1, 7, 1650),
    pulse("CH_7_TOGGLE: for a second",          "a39",  0.9, 7, 1650),
    pulse("CH_7_TOGGLE: put back",              "a39",  1.2, 7, 1500),
    pulse("CH_8_TOGGLE: still as set",          "a41", -0.05, 8, 1300),
    pulse("CH_8_TOGGLE",                        "a41",  0.1, 8, 1850),
    pulse("CH_8_TOGGLE: for a second",          "a41",  0.9, 8, 1850),
    pulse("CH_8_TOGGLE: back to what was set",  "a41",  1.2, 8, 1300),
    relay("RELAY_TOGGLE: inverted",             "a43",  0.1, 1),
    relay("RELAY_TOGGLE: for a second",         "a43",  0.9, 1),
    relay("RELAY_TOGGLE: put back",             "a43",  1.2, 0),
    relay("RELAY_TOGGLE: again",                "a43",  2.2, 1),
    relay("RELAY_TOGGLE: for ever",             "a43",  4.2, 1),
    relay("stopped",                            "a45",  0.1, 0),
    relay("stopped",                            "a45",  3.0, 0),
    pulse("SET_SERVO: output 5",                "a46",  0.1, 5, 1234),
    pulse("until the mode changes",             "a48",  0.3, 5, 1500),
    pulse("until the mode changes",             "a48",  0.3, 8, kSwitch_us),
    pulse("SET_SERVO after coming back",        "a49",  0.1, 6, 1999),
};
// clang-format on

const std::vector<ExpectedParameter> kApm2Parameters = {
    {"WP_RADIUS", 35}, {"YAW2SRV_DAMP", 0.35}, {"RC7_FUNCTION", 10}};
const std::vector<ExpectedParameter> kApm1Parameters = {
    {"RLL2SRV_P", 0.8},    {"RLL2SRV_I", 0.25},  {"PTCH2SRV_D", 0.04},
    {"YAW2SRV_IMAX", 125}, {"KFF_RDDRMIX", 0.4}, {"RC5_TRIM", 1510},
    {"RC5_MAX", 1910},     {"RC5_MIN", 1090},    {"THR_FS_VALUE", 960},
};

const simulator::ParameterSettings kApm2Settings = {{"RC7_FUNCTION", 10}}, kNoSettings;

const std::vector<std::string> kApm2Texts = {"Mission: parameter 218 not set"};  // RC7_FUNCTION
const std::vector<std::string> kApm1Texts;

}  // namespace

const std::vector<Expected>& expectedOf(mission::Set set) {
    return set == mission::Set::apm1 ? kApm1 : kApm2;
}
const std::vector<ExpectedParameter>& parametersOf(mission::Set set) {
    return set == mission::Set::apm1 ? kApm1Parameters : kApm2Parameters;
}
const simulator::ParameterSettings& settingsOf(mission::Set set) {
    return set == mission::Set::apm1 ? kNoSettings : kApm2Settings;
}
const std::vector<std::string>& textsOf(mission::Set set) {
    return set == mission::Set::apm1 ? kApm1Texts : kApm2Texts;
}
