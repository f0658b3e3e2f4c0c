// SPDX-License-Identifier: GPL-3.0-or-later
// The program: puts a board into a world, and either flies a mission from the ground station's
// chair and reports on it, or serves the board to ground stations.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "simulator/airplane/parameters.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/fdm/udp_peer.hpp"
#include "simulator/fly_options.hpp"
#include "simulator/fly_served.hpp"
#include "simulator/ground/passive_gcs.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/ground/server.hpp"
#include "simulator/ground/thrower.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"
#include "simulator/output_file.hpp"
#include "simulator/parameter_file.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/status_line.hpp"
#include "simulator/report/summary.hpp"
#include "simulator/report/touchdown.hpp"
#include "simulator/report/track_files.hpp"
#include "simulator/world_file.hpp"

namespace simulator {
namespace {

constexpr int kUsbUsart = 0;
constexpr size_t kEepromBytes = 4096;

constexpr unsigned kGrace_s = 5;  // from a signal to the end, whatever the firmware does

volatile std::sig_atomic_t interrupted = 0;

// The flight ends in order at the next step. Should that not come, the alarm ends the program.
void stopSoon(int) {
    interrupted = 1;
    alarm(kGrace_s);
}

void stopNow(int) {
    constexpr char kWhy[] = "fly: interrupted; it did not stop in time, nothing is written\n";
    (void)!write(STDERR_FILENO, kWhy, sizeof kWhy - 1);
    _exit(1);
}

// The runway points at the first place of the mission.
double runwayHeading_deg(const Waypoints& items) {
    const LocalFrame frame(items[0].latitude_deg, items[0].longitude_deg);
    for (const PlannedNav& nav : makePlan(items, frame).navs) {
        if (!nav.place || std::hypot(nav.place->east_m, nav.place->north_m) < 1) continue;
        const double bearing = std::atan2(nav.place->east_m, nav.place->north_m) * 180 / M_PI;
        return bearing < 0 ? bearing + 360 : bearing;
    }
    return 0;
}

WorldOptions worldFor(const FlyOptions& options, const Waypoints& items) {
    WorldOptions world;
    world.airplane = options.airplane;
    world.bench_model = options.bench;
    world.fdm = options.fdm;
    world.fdm_wait_s = options.fdm_wait_s;
    world.latitude_deg = items[0].latitude_deg;
    world.longitude_deg = items[0].longitude_deg;
    world.altitude_m = items[0].altitude_m;
    world.heading_deg = runwayHeading_deg(items);
    world.wind_mps = options.wind_mps;
    world.wind_from_deg = options.wind_from_deg;
    world.gusts = options.gusts;
    world.calibrated = options.calibrated;
    world.sensor_noise = options.sensor_noise;
    world.gps = options.gps;
    world.gps_baud = options.gps_baud;
    world.seed = options.seed;
    world.faults = options.faults;
    world.gps_backup = !options.gps_cold;
    world.band_gap_v = options.band_gap_v;
    if (const auto& turned_deg = options.external_compass_deg; !turned_deg.empty())
        world.external_compass_deg = {turned_deg[0], turned_deg[1], turned_deg[2]};
    world.worn_cells = options.worn_cells;
    world.bootloader = options.bootloader == "looping" ? Bootloader::looping
                       : options.bootloader == "quick" ? Bootloader::quick
                       : options.bootloader == "slow"  ? Bootloader::slow
                                                       : Bootloader::stock;
    world.board_warmth_c = options.board_warmth_c;
    world.board_warmth_start_c = options.board_warmth_start_c;
    world.gps_latency_s = options.gps_latency_ms / 1000;
    world.dataflash = !options.no_dataflash;
    if (!options.world.empty()) readWorldFile(options.world, world);
    return world;
}

ParameterSettings parametersFor(const FlyOptions& options) {
    if (!options.parameters.empty()) return readParameterFile(options.parameters);
    const std::filesystem::path beside =
        std::filesystem::path(airplanePath(options.airplane)).replace_extension(".param");
    return std::filesystem::exists(beside) ? readParameterFile(beside) : ParameterSettings{};
}

// Said before the flight, not after it: the file is written at the end.
void mustBeWritableFor(const std::string& option, const std::filesystem::path& path) {
    try {
        mustBeWritable(path);
    } catch (const OutputError& error) {
        throw WrongInput(option + " " + error.what());
    }
}

// A memory's contents at power-on; nothing where the file is still to be made.
std::optional<std::vector<uint8_t>> readMemory(const std::string& what, const std::string& path) {
    if (path.empty()) return std::nullopt;
    const bool exists = std::filesystem::exists(path);
    if (exists && !std::filesystem::is_regular_file(path))
        throw WrongInput(what + " " + path + ": is no file");
    mustBeWritableFor(what, path);
    if (!exists) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    return std::vector<uint8_t>(std::istreambuf_iterator<char>(file), {});
}

void loadMemories(Board& board, const FlyOptions& options) {
    const auto wrong = [](const std::string& of, const std::string& expected, size_t found) {
        return WrongInput(of + ": expected " + expected + " bytes, found " + std::to_string(found));
    };
    if (const auto eeprom = readMemory("--eeprom", options.eeprom)) {
        if (eeprom->size() != kEepromBytes)
            throw wrong("--eeprom " + options.eeprom, "4096", eeprom->size());
        board.setEeprom(*eeprom);
    }
    if (const auto pages = readMemory("--dataflash", options.dataflash)) {
        if (!board.world().dataflash().setImage(*pages))
            throw wrong("--dataflash " + options.dataflash, "8192 or 4096 pages of 528 or 512",
                        pages->size());
    }
}

void saveMemories(Board& board, const FlyOptions& options, Results& results) {
    const auto save = [&](const std::string& path, const std::vector<uint8_t>& image) {
        if (!path.empty()) results.addFile(path, std::string(image.begin(), image.end()));
    };
    save(options.eeprom, board.eeprom());
    save(options.dataflash, board.world().dataflash().image(board.time_us()));
    results.add([&] { board.closeTrace(); });
    results.add([&] { board.closeProfile(); });
}

// A stopped chip never comes back to look at a flag: Ctrl-C ends the program at once.
void serveGdb(AvrBoard& board, int port) {
    board.serveGdb(port);
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    std::cout << "the chip waits for avr-gdb: target remote :" << port << "; Ctrl-C ends"
              << std::endl;
}

int telemetryUsart(const FlyOptions& options) {
    return options.telemetry_on_uart0 ? 0 : wiringOf(options).telemetry_usart;
}

int otherUsart(const FlyOptions& options) {
    return options.telemetry_on_uart0 ? wiringOf(options).telemetry_usart : 0;
}

std::unique_ptr<Board> makeBoard(const FlyOptions& options, const WorldOptions& world) {
    if (options.native) return std::make_unique<NativeBoard>(world);
    if (!std::filesystem::exists(options.firmware)) {
        throw WrongInput("--firmware " + options.firmware + ": no such file");
    }
    if (!options.profile.empty()) mustBeWritableFor("--profile", options.profile);
    try {
        auto board = std::make_unique<AvrBoard>(options.firmware, world, wiringOf(options));
        if (!options.vcd.empty()) board->traceTo(options.vcd);
        if (!options.profile.empty()) board->profileTo(options.profile);
        if (options.gdb != 0) serveGdb(*board, options.gdb);
        return board;
    } catch (const std::runtime_error& error) {
        throw WrongInput(error.what());
    }
}

bool reportViolations(WatchedBoard& board) {
    for (const invariants::Violation& each : board.violations())
        std::cerr << "fly: violated: " << each.line() << "\n";
    return board.violations().empty();
}

Summary summarize(Summary s, const FlyOptions& options, WatchedBoard& board,
                  const ScriptedFlight& flight, const Recorder& recorder, const Plan& plan) {
    s.completed = flight.completed();
    s.reason = flight.over() ? flight.reason() : "interrupted";
    if (flight.airborne_s() && flight.landed_s()) {
        s.flight_time_s = *flight.landed_s() - *flight.airborne_s();
        s.landed_distance_m = flight.touchdown_distance_m();
        s.standing_distance_m = flight.standing_distance_m();
        s.touchdown_sink_mps = flight.touchdown_sink_mps();
        if (const auto at = touchdownAt(*flight.landed_s(), recorder.samples(), plan)) {
            s.touchdown_long_m = at->long_m;
            s.touchdown_right_m = at->right_m;
        }
    }
    s.loiter_radius_m = flight.loiter_radius_m();
    takeErrors(s, recorder.metrics(), recorder.attitude());
    addTelemetry(s, flight.telemetry());
    for (const PlannedNav& nav : plan.navs) s.items_planned.push_back(nav.item);
    if (ours(options) && interrupted == 0) takeViolations(s, board);
    return s;
}

// Without the chip no log can be written, and the firmware refuses to arm when one is wanted.
void warnWithoutLogChip(const FlyOptions& options, const ParameterSettings& settings) {
    constexpr unsigned kAllChecks = 1, kLogCheck = 1024;
    const auto permits = [](const ParameterSetting& setting) {
        const auto value = static_cast<unsigned>(std::max(setting.value, 0.0));
        return (setting.name == "LOG_BITMASK" && value == 0) ||
               (setting.name == "ARMING_CHECK" && (value & (kAllChecks | kLogCheck)) == 0);
    };
    if (!options.no_dataflash || std::any_of(settings.begin(), settings.end(), permits)) return;
    std::cerr << "fly: --no-dataflash: the firmware does not arm without its log chip; to fly "
                 "without a log, give a --param file that contains LOG_BITMASK,0\n";
}

// No frame passes unseen.
bool runStep(Board& board, uint64_t until_us, Recorder& recorder, const Telemetry& telemetry) {
    bool goes_on = true;
    for (uint64_t rest_us = kStep_us; goes_on && rest_us > 0;) {
        rest_us -= kFrame_us;
        goes_on = board.runUntil(until_us - rest_us);
        recorder.watchFrame(board, telemetry);
    }
    return goes_on;
}

int flyScript(const FlyOptions& options, const MissionFile& mission) {
    const Waypoints& items = mission.items;
    const auto folder = prepareReport(options);
    const ParameterSettings settings = parametersFor(options);
    warnWithoutLogChip(options, settings);
    const LocalFrame frame(items[0].latitude_deg, items[0].longitude_deg);
    const Plan plan = makePlan(items, frame);
    WatchedBoard board(makeBoard(options, worldFor(options, items)));
    loadMemories(board, options);
    const int usart = telemetryUsart(options);
    ScriptedFlight flight(board, usart, mission, options.time_limit_s, settings);
    if (!ours(options)) flight.flyAnother();
    PassiveGcs usb(board, kUsbUsart);
    FlyWatchers watchers(options, board, otherUsart(options), settings);
    board.listen([&](int from, uint8_t byte, uint64_t time_us) {
        if (from == usart) flight.receive(byte, time_us);
        if (from == kUsbUsart && options.usb) usb.receive(byte, time_us);
        watchers.receive(from, byte, time_us);
    });
    board.setUsb(options.usb || (options.watch && !options.telemetry_on_uart0));
    switchTransmitterOn(board.world());
    Recorder recorder(plan, frame);
    StatusLine status(isatty(STDOUT_FILENO) != 0);
    const WallClock clock;
    const auto stop = [] { return interrupted != 0; };
    for (int step = 1; !flight.over() && interrupted == 0; ++step) {
        const uint64_t until_us = static_cast<uint64_t>(step) * kStep_us;
        if (!watchers.awaitStep(until_us, stop)) break;
        if (!runStep(board, until_us, recorder, flight.telemetry())) {
            flight.stop("the firmware stopped: " + board.fault());
        }
        watchers.step();
        if (!board.world().fault().empty()) flight.stop(board.world().fault());
        flight.step(board.time_us());
        usb.step(board.time_us());
        if (step % kStepsPerSample != 0 && !flight.over()) continue;
        recorder.sample(board, flight.telemetry(), flight.cruise_speed_mps(),
                        flight.loiter_radius_m());
        if (watchers.live()) continue;  // which reports what happens
        status.show(board, flight.telemetry(), recorder.samples().back(), items.size() - 1,
                    clock.seconds());
    }
    alarm(0);
    status.end();
    Summary summary = summarize(summaryOf(options, board, recorder, clock), options, board, flight,
                                recorder, plan);
    takeProvenance(summary, options, settings, board);
    watchers.end(summary.completed ? "mission completed" : summary.reason, summary);
    std::cout << closingWords(summary) << std::flush;  // the verdict, whatever becomes of the files
    Results results;
    saveMemories(board, options, results);
    writeReport(options, *folder, summary, recorder.samples(), mission, results);
    if (!results.allWritten()) return 2;
    std::cout << reportLine(folder->path());
    return summary.completed ? 0 : 1;
}

// Whoever connects finds the airplane's parameters set.
void setByWire(Board& board, int usart, const ParameterSettings& settings, FlyWatchers& watchers) {
    constexpr uint8_t kAnyone = 0;
    ParameterUpload* upload = nullptr;
    Link link(board, usart, [&](const mavlink::Frame& frame, uint64_t) { upload->take(frame); });
    ParameterUpload setting(link, settings);
    upload = &setting;
    board.listen([&](int from, uint8_t byte, uint64_t time_us) {
        if (from == usart) link.receive(byte, time_us);
        watchers.receive(from, byte, time_us);
    });
    while (interrupted == 0 && !setting.done() && board.runUntil(board.time_us() + kStep_us)) {
        setting.step(board.time_us(), kAnyone, kAnyone);
        if (!setting.failure().empty()) throw WrongInput(setting.failure());
    }
}

void runServed(const FlyOptions& options, WatchedBoard& board, Server& server,
               FlyWatchers& watchers, ServedRecord& record, Results& results) {
    bool had_client = false;
    const auto stop = [&] {
        had_client = had_client || server.clients() > 0;
        const bool left = options.end_with_client && had_client && server.clients() == 0;
        return interrupted != 0 || left || !board.world().fault().empty();
    };
    server.run([&](uint64_t until_us) { return watchers.awaitStep(until_us, stop); },
               [&] {
                   watchers.live()->setClients(server.clients());
                   watchers.step();
                   record.step(board, *watchers.live());
               });
    alarm(0);
    std::string fault = interrupted != 0 ? "" : board.world().fault();
    if (!board.fault().empty()) fault = "the firmware stopped: " + board.fault();
    record.write(board, watchers, fault, results);
}

void sayPorts(const FlyOptions& options, const Server& server, const FlyWatchers& watchers) {
    const int other = otherUsart(options);
    std::cout << "telemetry (USART" << telemetryUsart(options) << ") on TCP port " << server.port()
              << (other == 0 ? ", USB (USART0) on " : ", USART2 on ") << server.secondPort();
    if (options.lock_step) std::cout << ", time is granted on " << server.controlPort();
    if (!watchers.address().empty()) std::cout << ", page " << watchers.address();
    std::cout << "; Ctrl-C ends" << std::endl;
}

int serve(const FlyOptions& options, const Waypoints& items) {
    const ParameterSettings settings = parametersFor(options);
    const auto record =
        options.lock_step ? nullptr : std::make_unique<ServedRecord>(options, items, settings);
    WatchedBoard board(makeBoard(options, worldFor(options, items)));
    loadMemories(board, options);
    const int telemetry = telemetryUsart(options);
    Server server(board, options.listen, {telemetry, otherUsart(options)}, options.lock_step);
    FlyWatchers watchers(options, board, otherUsart(options), settings);
    board.setUsb(!options.telemetry_on_uart0);
    switchTransmitterOn(board.world());
    setByWire(board, telemetry, settings, watchers);
    Thrower thrower(board, telemetry);
    board.listen([&](int usart, uint8_t byte, uint64_t time_us) {
        server.fromBoard(usart, byte);
        if (usart == telemetry) thrower.receive(byte, time_us);
        watchers.receive(usart, byte, time_us);
    });
    sayPorts(options, server, watchers);
    Results results;
    if (options.lock_step) {
        server.runLockStep([&board] { return interrupted != 0 || !board.world().fault().empty(); });
    } else {
        runServed(options, board, server, watchers, *record, results);
    }
    alarm(0);
    saveMemories(board, options, results);
    if (!board.fault().empty()) std::cerr << "fly: the firmware stopped: " << board.fault() << "\n";
    const std::string fault = interrupted != 0 ? "" : board.world().fault();
    if (!fault.empty()) std::cerr << "fly: " << fault << "\n";
    const bool held = !ours(options) || reportViolations(board);
    if (!results.allWritten()) return 2;
    return board.fault().empty() && fault.empty() && held ? 0 : 1;
}

int fly(const FlyOptions& options) {
    std::signal(SIGINT, stopSoon);
    std::signal(SIGTERM, stopSoon);
    std::signal(SIGALRM, stopNow);
    std::signal(SIGPIPE, SIG_IGN);  // a debugger or ground station that has gone
    try {
        MissionFile mission = readMissionFile(options.mission);
        mission.stored_navs = options.stored_navs;
        for (const Remark& each : mission.remarks)
            std::cerr << "fly: " << options.mission << ':' << each.line << ':' << each.column
                      << ": " << each.text << "\n";
        return options.serve ? serve(options, mission.items) : flyScript(options, mission);
    } catch (const std::runtime_error& error) {  // a file, an airplane, a port
        std::cerr << "fly: " << error.what() << "\n";
    }
    return 2;
}

}  // namespace
}  // namespace simulator

int main(int count, char** words) {
    const simulator::Parsed parsed = simulator::parseFlyOptions(count, words);
    return simulator::finishOutput(
        "fly", parsed.exit_status ? *parsed.exit_status : simulator::fly(parsed.options));
}
