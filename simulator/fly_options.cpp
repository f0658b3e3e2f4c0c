// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fly_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "simulator/devices/gps_kinds.hpp"
#include "simulator/fdm/json_model.hpp"
#include "simulator/live/flightgear.hpp"

namespace simulator {
namespace {

constexpr char kWhat[] =
    "Flies a mission with the autopilot's firmware on a simulated board in a simulated airplane.";
constexpr char kFooter[] =
    "Exit status: 0 when the mission was flown and the airplane stands at its landing point,\n"
    "1 when not (the reason in one line), 2 when the command line or a file is wrong or a file\n"
    "could not be written, which is reported after the verdict.\n"
    "The folder of --out receives report.html, flight.csv, track.kml, track.gpx and\n"
    "summary.json. Without --out each flight has a folder of its own in build/flights, where\n"
    "index.html lists them; build/flight is a link to the newest.";

constexpr char kWindForm[] =
    "expected SPEED,FROM_DEGREES with 0 to 30 m/s and 0 to 360 degrees, like 5,270";

bool parseWind(const std::string& text, FlyOptions& options) {
    char* rest = nullptr;
    options.wind_mps = std::strtod(text.c_str(), &rest);
    if (rest == text.c_str() || *rest != ',') return false;
    const char* from = rest + 1;
    options.wind_from_deg = std::strtod(from, &rest);
    return rest != from && *rest == 0 && options.wind_mps >= 0 && options.wind_mps <= 30 &&
           options.wind_from_deg >= 0 && options.wind_from_deg <= 360;
}

// Two things that cannot both be had, and why.
struct Contradiction {
    bool has;
    std::string why;
};

// Empty: all is well together.
std::string contradiction(const FlyOptions& options, const CLI::App& app) {
    const auto given = [&](const char* name) { return app.count(name) > 0; };
    const char* server = given("--lock-step") ? "--lock-step" : "--serve";
    const Contradiction all[] = {
        {options.native && options.apm1, "--native is an APM 2: no --board apm1"},
        {options.apm1 && given("--telemetry"), "--telemetry is a choice of the APM 2's alone"},
        {options.native && given("--firmware"), "--native flies no --firmware file"},
        {options.native && given("--vcd"), "--vcd needs the emulated chip: no --native"},
        {options.native && given("--profile"), "--profile needs the emulated chip: no --native"},
        {options.native && given("--bootloader"),
         "--bootloader needs the emulated chip: no --native"},
        {options.native && given("--gdb"), "--gdb needs the emulated chip: no --native"},
        {given("--world") && given("--wind"), "--world has the wind: no --wind"},
        {given("--world") && given("--gusts"), "--world has the gusts: no --gusts"},
        {given("--world") && given("--calibrated"), "--world has the errors: no --calibrated"},
        {given("--world") && given("--sensor-noise"), "--world has the noise: no --sensor-noise"},
        {given("--world") && given("--gps-latency"), "--world has the latency: no --gps-latency"},
        {given("--world") && (given("--board-warmth") || given("--board-warmth-start")),
         "--world has the board's warmth: no --board-warmth"},
        {!options.fdm.empty() && given("--world"), "--fdm brings its own air: no --world"},
        {!options.fdm.empty() && given("--wind"), "--fdm brings its own air: no --wind"},
        {!options.fdm.empty() && given("--gusts"), "--fdm brings its own air: no --gusts"},
        {options.fdm.empty() && given("--fdm-wait"), "--fdm-wait needs --fdm"},
        {given("--stored") && options.eeprom.empty(), "--stored needs --eeprom"},
        {options.serve && given("--stored"), " flies no script: leave out --stored"},
        {options.no_dataflash && given("--dataflash"),
         "--dataflash needs the chip: no --no-dataflash"},
        {!options.serve && given("--listen"), "--listen needs --serve or --lock-step"},
        {options.serve && given("MISSION"), " flies no script: leave out MISSION"},
        {options.serve && options.watch, " flies no script: leave out --watch"},
        {options.watch && options.usb, "--watch has a ground station of its own on USB: no --usb"},
        {options.lock_step && (given("--http") || given("--no-http")),
         "--lock-step has no page: no --http or --no-http"},
        {!options.serve && !options.watch && (given("--http") || given("--no-http")),
         "--http and --no-http need --serve or --watch"},
        {given("--http") && given("--no-http"), "--http and --no-http exclude each other"},
        {options.lock_step && given("--flightgear"), "--lock-step sends nothing: no --flightgear"},
        {options.end_with_client && (!options.serve || options.lock_step),
         "--end-with-client needs --serve"},
        {options.usb && options.telemetry_on_uart0, "--usb takes the USART of --telemetry uart0"},
        {!options.serve && given("--bench"), "--bench needs --serve or --lock-step"},
        {options.bench && !options.fdm.empty(), "--bench does not fly: no --fdm"},
        {options.serve && given("--usb"), " is for whoever connects: no --usb"},
        {options.serve && given("--time-limit"), " has no --time-limit"},
        {options.lock_step && given("--out"), " writes no report: leave out --out"},
    };
    for (const auto& [has, why] : all) {
        if (has) return why[0] == ' ' ? server + why : why;
    }
    return "";
}

// strtoull would take -1 for the largest of all numbers, and any that is too large as well.
CLI::Validator wholeNumber(const std::string& most) {
    const auto check = [most](const std::string& text) {
        const bool digits = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
        const std::string value = text.substr(std::min(text.find_first_not_of('0'), text.size()));
        const bool fits =
            value.size() < most.size() || (value.size() == most.size() && value <= most);
        if (digits && fits) return std::string();
        return "expected a whole number up to " + most + ", not '" + text + "'";
    };
    return CLI::Validator(check, "0.." + most);
}

std::string flightModel(const std::string& text) {
    return modelAddress(text) ? "" : "expected json:PORT or json:HOST:PORT, not '" + text + "'";
}

// A forgotten value would take the next option for a file.
std::string fileName(const std::string& text) {
    return !text.empty() && text[0] != '-' ? "" : "expected a path, not '" + text + "'";
}

std::string flightGear(const std::string& text) {
    return live::flightGearAddress(text) ? "" : "expected HOST:PORT, not '" + text + "'";
}

std::string seconds(const std::string& text) {
    constexpr double kLongest_s = 100'000;
    char* rest = nullptr;
    const double value = std::strtod(text.c_str(), &rest);
    if (rest != text.c_str() && *rest == 0 && value >= 1 && value <= kLongest_s) return "";
    return "expected 1 to 100000 seconds, not '" + text + "'";
}

std::string fault(const std::string& text) {
    return parseFault(text)
               ? ""
               : "expected PART:HOW@FROM[-TO], like gps:lost@60-90, not '" + text + "'";
}

// Each adds what belongs together, in the order of the help.
void addImage(CLI::App& app, FlyOptions& o, std::string& board) {
    app.add_option("MISSION", o.mission,
                   "mission file: QGC WPL 110, or a .plan of QGroundControl, whose "
                   "fence and rally points are uploaded too")
        ->capture_default_str();
    app.add_option("--board", board, "board to simulate")
        ->check(CLI::IsMember({"apm1", "apm2"}))
        ->capture_default_str();
    app.add_flag("--native", o.native,
                 "the same firmware compiled for this computer, on the same device models")
        ->disable_flag_override();
    app.add_option("--firmware", o.firmware,
                   ".elf or .hex for this board, ours or not; if not given the image of this build")
        ->check(fileName);
}

void addAirplane(CLI::App& app, FlyOptions& o) {
    app.add_option("--airplane", o.airplane,
                   "what flies: foam_trainer, trainer_6kg or flying_wing of simulator/airplanes, "
                   "or the path of such a .json file; the .param file beside it is set by wire")
        ->check(fileName)
        ->capture_default_str();
    app.add_option("--param", o.parameters, ".param file to set by wire instead of the airplane's")
        ->check(fileName);
    app.add_option(
           "--fdm", o.fdm,
           "json:PORT or json:HOST:PORT: a flight model elsewhere, which speaks ArduPilot's "
           "JSON SITL protocol on that UDP port (9002 as a rule; ours is the next one); of "
           "--airplane only the parameters count")
        ->check(flightModel);
    app.add_option("--fdm-wait", o.fdm_wait_s, "seconds for the flight model to answer first")
        ->check(seconds)
        ->capture_default_str();
}

void addMemories(CLI::App& app, FlyOptions& o) {
    app.add_option("--eeprom", o.eeprom,
                   "4096-byte file: contents at power-on if it exists, rewritten at the end")
        ->check(fileName);
    app.add_option("--dataflash", o.dataflash,
                   "file of all pages of the AT45DB321D (or 161D): as --eeprom is of the EEPROM")
        ->check(fileName);
    app.add_flag("--no-dataflash", o.no_dataflash,
                 "a board without that chip; without a log to write it arms only with LOG_BITMASK "
                 "0, to be set in the --param file")
        ->disable_flag_override();
}

void addConditions(CLI::App& app, FlyOptions& o, std::string& wind) {
    app.add_option(
           "--world", o.world,
           ".json file of the conditions: wind, gusts, thermals, magnetic field, the errors "
           "of every sensor; docs/airplanes.md has its keys")
        ->check(fileName);
    app.add_option("--wind", wind,
                   "SPEED,FROM_DEGREES: mean wind in m/s, up to 30, and where it comes from");
    app.add_flag("--gusts", o.gusts, "Dryden gusts of 1 m/s RMS")->disable_flag_override();
    app.add_flag("--calibrated", o.calibrated,
                 "as after the owner's calibrations: the compass without the airplane's own field, "
                 "the pitot tube's ratio right")
        ->disable_flag_override();
    app.add_option("--sensor-noise", o.sensor_noise,
                   "times the noise of every sensor's readings, 0.05 to 3: boards differ")
        ->check(CLI::Range(0.05, 3.0))
        ->capture_default_str();
    app.add_option("--gps", o.gps, "the receiver on the GPS port, as delivered")
        ->check(CLI::IsMember(gpsKinds()))
        ->capture_default_str();
    app.add_option("--gps-baud", o.gps_baud, "the GPS's rate at power-on instead")
        ->check(CLI::IsMember({4800, 9600, 19200, 38400, 57600, 115200}));
    app.add_option("--seed", o.seed, "of every random error; the same seed gives the same flight")
        ->check(wholeNumber("18446744073709551615"))
        ->capture_default_str();
    app.add_option_function<std::vector<std::string>>(
           "--fault",
           [&o](const std::vector<std::string>& all) {
               for (const std::string& each : all) o.faults.push_back(*parseFault(each));
           },
           "PART:HOW@FROM[-TO], more than once if wanted, in seconds. imu, baro, airspeed, "
           "compass, "
           "gps: lost, stuck, noisy, nonsense, jump or drift (gps: no drift; imu also dead_roll, "
           "dead_pitch, dead_yaw). radio: lost, held, silent, throttle_lost, missed_edge, "
           "extra_edge, nine_channels or wide. supply: cut, sag_3.2v, or sag_3.2v_20ms, which "
           "takes 20 ms to fall. i2c: scl_low, sda_low or noisy; spi: miso_low, miso_high or "
           "noisy. docs/simulator.md explains them")
        ->check(fault);
}

void addHardware(CLI::App& app, FlyOptions& o) {
    app.add_flag("--gps-cold", o.gps_cold,
                 "a GPS without a backup battery: after a cut of the supply it starts cold, 26 s "
                 "instead of 1 s")
        ->disable_flag_override();
    app.add_option("--band-gap", o.band_gap_v,
                   "the chip's reference in volts; if not given 1.1 V, and 1 % off by the seed")
        ->check(CLI::Range(1.0, 1.2));
    app.add_option("--external-compass", o.external_compass_deg,
                   "ROLL,PITCH,YAW: the compass is outside the board, turned so, in degrees; "
                   "180,0,0 is the usual GPS with a compass under its chip")
        ->delimiter(',')
        ->expected(3)
        ->check(CLI::Range(-360.0, 360.0));
    app.add_option("--worn-eeprom", o.worn_cells,
                   "so many bytes of the EEPROM have a bit that stays as it is")
        ->check(CLI::Range(0, 4096));
    app.add_option(
           "--bootloader", o.bootloader,
           "what a reset begins with: stock (what the board has), quick (65 ms), looping (of many "
           "clones: never comes back from a watchdog's reset) or slow (the APM 2's without USB, "
           "1.1 s)")
        ->check(CLI::IsMember({"stock", "quick", "looping", "slow"}))
        ->capture_default_str();
    app.add_option("--board-warmth", o.board_warmth_c,
                   "degrees by which the barometer is warmer than the air once the board is warm")
        ->check(CLI::Range(-20.0, 40.0))
        ->capture_default_str();
    app.add_option("--board-warmth-start", o.board_warmth_start_c, "and at power-on")
        ->check(CLI::Range(-20.0, 40.0))
        ->capture_default_str();
    app.add_option("--gps-latency", o.gps_latency_ms,
                   "milliseconds from a measurement of the GPS to its message")
        ->check(CLI::Range(50.0, 400.0))
        ->capture_default_str();
}

// Whole numbers from 1 to 255 with commas between; of anything else nothing.
std::vector<int> itemsIn(const std::string& text) {
    std::vector<int> items;
    for (size_t at = 0; at <= text.size();) {
        const size_t end = std::min(text.find(',', at), text.size());
        const std::string word = text.substr(at, end - at);
        const bool is_number = !word.empty() && word.size() <= 3 &&
                               word.find_first_not_of("0123456789") == std::string::npos;
        const int item = is_number ? std::stoi(word) : 0;
        if (item < 1 || item > 255) return {};
        items.push_back(item);
        at = end + 1;
    }
    return items;
}

std::string itemList(const std::string& text) {
    return itemsIn(text).empty() ? "expected ITEM,ITEM..., not '" + text + "'" : "";
}

void addFlight(CLI::App& app, FlyOptions& o) {
    app.add_flag("--usb", o.usb, "a second ground station on USB, which asks for all streams too")
        ->disable_flag_override();
    app.add_option_function<std::string>(
           "--stored", [&o](const std::string& items) { o.stored_navs = itemsIn(items); },
           "ITEM,ITEM...: nothing is uploaded, the mission is that in the EEPROM. MISSION says "
           "where it leads; these of its NAVs are to be reached, in this order")
        ->check(itemList);
    app.add_option("--time-limit", o.time_limit_s, "emulated seconds until the flight is given up")
        ->check(seconds)
        ->capture_default_str();
    app.add_option("--out", o.out, "folder for the report; if not given a new one in build/flights")
        ->check(fileName);
    app.add_option("--flightgear", o.flightgear,
                   "HOST:PORT: also send the airplane's state there as FlightGear's native-fdm "
                   "packets, 30 a second; fgfs --fdm=null --native-fdm=socket,in,30,,PORT,udp")
        ->check(flightGear);
}

void addServer(CLI::App& app, FlyOptions& o, std::string& telemetry) {
    app.add_flag("--serve", o.serve,
                 "no script: real time for a ground station and the live page, until Ctrl-C; TCP "
                 "port 5760 is the telemetry on USART2 (APM 1: USART3), 5761 is USB on USART0 with "
                 "the USB sense pin PA1 low")
        ->disable_flag_override();
    app.add_flag("--watch", o.watch,
                 "fly the mission at real time, with the live page, which is opened where there is "
                 "a display")
        ->disable_flag_override();
    app.add_option("--http", o.http,
                   "port of the live page on 127.0.0.1, 0: any; if not given 5770, or any when "
                   "that one is taken or --listen is 0; printed at start")
        ->check(wholeNumber("65535"));
    app.add_flag_callback(
           "--no-http", [&o] { o.page = false; }, "no live page")
        ->disable_flag_override();
    app.add_flag("--end-with-client", o.end_with_client,
                 "end the served flight when the last ground station has gone")
        ->disable_flag_override();
    app.add_option("--telemetry", telemetry,
                   "uart2, or uart0: the factory wiring, telemetry on USART0 with PA1 high")
        ->check(CLI::IsMember({"uart0", "uart2"}))
        ->capture_default_str();
    app.add_flag("--lock-step", o.lock_step,
                 "serve, but the client grants emulated time on a third TCP port (5762): "
                 "'advance MS', 'state'; simulator/ground/server.hpp has the protocol")
        ->disable_flag_override();
    app.add_flag("--bench", o.bench,
                 "the airplane is held on the bench and not flown; with --lock-step the client "
                 "turns and lifts it")
        ->disable_flag_override();
    app.add_option("--listen", o.listen, "first TCP port instead of 5760; 0: any, printed at start")
        ->check(wholeNumber("65535"))
        ->capture_default_str();
}

void addWatchers(CLI::App& app, FlyOptions& o) {
    app.add_option("--vcd", o.vcd,
                   "write servos, PPM, data ready and the trace of tasks as a VCD file")
        ->check(fileName);
    app.add_option("--profile", o.profile,
                   "write where the cycles went, for toolchain/profile; slower by half")
        ->check(fileName);
    app.add_option("--gdb", o.gdb, "wait for avr-gdb on this TCP port")
        ->check(wholeNumber("65535"))
        ->check(CLI::Range(1, 65535));
}

}  // namespace

Parsed parseFlyOptions(int count, char** words) {
    Parsed parsed;
    FlyOptions& options = parsed.options;
    options.words.assign(words + 1, words + count);
    options.mission = FLY_MISSION;
    std::string board = "apm2", wind, telemetry = "uart2";
    CLI::App app(kWhat, "fly");
    app.footer(kFooter);
    addImage(app, options, board);
    addAirplane(app, options);
    addMemories(app, options);
    addConditions(app, options, wind);
    addHardware(app, options);
    addFlight(app, options);
    addServer(app, options, telemetry);
    addWatchers(app, options);
    std::string wrong;
    try {
        app.parse(count, words);
        if (!wind.empty() && !parseWind(wind, options)) {
            wrong = std::string("--wind: ") + kWindForm + ", not '" + wind + "'";
        } else {
            options.serve = options.serve || options.lock_step;
            options.apm1 = board == "apm1";
            options.telemetry_on_uart0 = telemetry == "uart0";
            if (options.firmware.empty()) options.firmware = options.apm1 ? FLY_IMAGE_1 : FLY_IMAGE;
            wrong = contradiction(options, app);
        }
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        parsed.exit_status = 0;
    } catch (const CLI::ParseError& error) {
        wrong = error.what();
    }
    if (!wrong.empty()) {
        std::cerr << "fly: " << wrong << " (--help explains)\n";
        parsed.exit_status = 2;
    }
    return parsed;
}

}  // namespace simulator
