// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the fly program.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulator/devices/faults.hpp"

namespace simulator {

struct FlyOptions {
    std::vector<std::string> words;  // of the command line
    std::string airplane = "foam_trainer", parameters;
    std::string mission, firmware, eeprom, dataflash, vcd, profile;
    std::string out;    // empty: a new folder of build/flights
    bool apm1 = false;  // the first board, not an APM 2
    bool native = false;
    bool no_dataflash = false;
    std::string world;  // file of the conditions
    double wind_mps = 0, wind_from_deg = 0;
    bool gusts = false;
    bool calibrated = false;
    double sensor_noise = 1;
    std::string gps = "ublox";
    uint32_t gps_baud = 0;
    uint64_t seed = 1;
    std::vector<Fault> faults;
    bool gps_cold = false;
    double band_gap_v = 0;
    std::vector<double> external_compass_deg;  // roll, pitch, yaw; empty: it is on the board
    unsigned worn_cells = 0;
    std::string bootloader = "stock";
    double board_warmth_c = 10, board_warmth_start_c = 10, gps_latency_ms = 200;
    std::vector<int> stored_navs;
    double time_limit_s = 1200;
    std::string fdm;  // "json:PORT"; empty: the airplane is the simulator's own
    double fdm_wait_s = 30;
    bool serve = false, lock_step = false;
    bool watch = false;            // a script at real time, with the live page
    bool page = true;              // served and watched flights have one
    std::optional<uint16_t> http;  // its port, 0: any; empty: any when the usual one is taken
    bool end_with_client = false;  // of a served flight
    std::string flightgear;        // HOST:PORT; empty: nowhere
    bool bench = false;            // held in hands instead of flown
    bool telemetry_on_uart0 = false;
    bool usb = false;  // plugged in, and all streams there too
    uint16_t listen = 5760;
    int gdb = 0;
};

// The options, or the status to end with: 0 after --help, 2 after one line about what is wrong.
struct Parsed {
    FlyOptions options;
    std::optional<int> exit_status;
};
Parsed parseFlyOptions(int count, char** words);

}  // namespace simulator
