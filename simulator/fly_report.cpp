// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fly_report.hpp"

#include <cmath>

#include "simulator/built_image.hpp"
#include "simulator/flight_provenance.hpp"
#include "simulator/fly_live.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/report/page.hpp"
#include "simulator/report/recorded_flight.hpp"
#include "simulator/report/task_names.hpp"
#include "simulator/report/track_files.hpp"

namespace simulator {

const BoardWiring& wiringOf(const FlyOptions& options) {
    return options.apm1 ? kApm1Wiring : kApm2Wiring;
}

bool ours(const FlyOptions& options) {
    return options.native || options.firmware == FLY_IMAGE || options.firmware == FLY_IMAGE_1;
}

std::string missionName(const FlyOptions& options) {
    return options.serve ? "served" : std::filesystem::path(options.mission).filename().string();
}

Summary summaryOf(const FlyOptions& options, WatchedBoard& board, const Recorder& recorder,
                  const WallClock& clock) {
    Summary s;
    s.mission = missionName(options);
    s.firmware = options.native ? "natively compiled"
                                : std::filesystem::path(options.firmware).filename().string();
    s.board = options.native ? "native" : wiringOf(options).name;
    s.wind_mps = options.wind_mps;
    s.wind_from_deg = options.wind_from_deg;
    s.gusts = options.gusts;
    s.calibrated = options.calibrated;
    s.seed = options.seed;
    if (const auto imu = recorder.imuSamples()) s.setSamples(*imu);
    s.model_answers_skipped = board.world().modelAnswersSkipped();
    s.model_begun_anew = board.world().modelBegunAnew();
    s.figures = board.figures();
    if (!options.native) s.task_names = readTaskNames(options.firmware);
    s.emulated_s = static_cast<double>(board.time_us()) * 1e-6;
    s.speedup = s.emulated_s / clock.seconds();
    return s;
}

void takeErrors(Summary& s, const Metrics& m, const AttitudeErrors& attitude) {
    s.crosstrack_rms_m = m.crosstrack.rms();
    s.crosstrack_settled_rms_m = m.settled.rms();
    s.crosstrack_max_m = m.crosstrack.max();
    s.altitude_rms_m = m.altitude.rms();
    s.altitude_level_rms_m = m.level.rms();
    s.altitude_sloped_rms_m = m.sloped.rms();
    s.altitude_max_m = m.altitude.max();
    s.airspeed_rms_mps = m.airspeed.rms();
    s.airspeed_min_mps = m.slowest_mps;
    s.loiter_radius_rms_m = m.radius.rms();
    s.roll_error_rms_deg = attitude.roll_deg.rms();
    s.pitch_error_rms_deg = attitude.pitch_deg.rms();
    s.yaw_error_rms_deg = attitude.yaw_deg.rms();
}

void addTelemetry(Summary& s, const Telemetry& telemetry) {
    // firmware that flies from item to item and never says that it reached one does not report it
    if (!telemetry.reached.empty() || telemetry.visited.size() < 2)
        s.items_reached = telemetry.reached;
    s.events = telemetry.events;
    s.texts = telemetry.texts;
}

void takeViolations(Summary& s, WatchedBoard& board) {
    for (const invariants::Violation& each : board.violations())
        s.violations.push_back({each.time_s, each.name + ": " + each.numbers});
    if (s.violations.empty()) return;
    s.completed = false;
    if (s.reason.empty()) s.reason = "violated: " + board.violations().front().line();
}

void takeProvenance(Summary& s, const FlyOptions& options, const ParameterSettings& settings,
                    WatchedBoard& board) {
    Provenance& from = s.provenance;
    from = provenanceOf(options, settings);
    from.parameters = parametersOf(settings, board.parametersSet().values());
    from.faults = faultTexts(board.world().faults());
    from.firmware = s.firmware;
    from.flash_bytes = s.figures.flash_bytes;
    from.ram_bytes = s.figures.ram_static_bytes;
    s.faults = faultSpans(board.world().faults());
    if (!options.native) return;
    if (const auto image = imageOfSources(FLY_IMAGE, FLY_SOURCES)) {
        from.flash_bytes = image->flash_bytes;
        from.ram_bytes = image->ram_static_bytes;
    }
}

std::unique_ptr<FlightFolder> prepareReport(const FlyOptions& options) {
    try {
        auto folder = options.out.empty() ? std::make_unique<FlightFolder>(FLY_FLIGHTS, FLY_OUT,
                                                                           missionName(options))
                                          : std::make_unique<FlightFolder>(options.out);
        for (const char* name :
             {"summary.json", "flight.csv", "track.kml", "track.gpx", "report.html"})
            mustBeWritable(folder->path() / name);
        return folder;
    } catch (const OutputError& error) {
        throw WrongInput(std::string("--out ") + error.what());
    }
}

static bool endedWell(const Summary& s) {
    return s.completed || (s.violations.empty() && s.reason.rfind(kServedEnd, 0) == 0);
}

void writeReport(const FlyOptions& options, const FlightFolder& folder, const Summary& summary,
                 const std::vector<Sample>& samples, const MissionFile& mission, Results& results) {
    const std::filesystem::path& path = folder.path();
    const FlightDocument document = documentOf(summary, samples, mission);
    results.addFile(path / "summary.json", summaryJson(summary));
    results.addFile(path / "flight.csv", flightCsv(samples));
    results.addFile(path / "track.kml",
                    trackKml(samples, document.plan, summary.mission, kSimulatedEpoch_s));
    results.addFile(path / "track.gpx",
                    trackGpx(samples, document.plan, summary.mission, kSimulatedEpoch_s));
    results.addFile(path / "report.html", flightPage(document));
    const std::string airplane = std::filesystem::path(options.airplane).stem();
    const std::string result = summary.completed ? "mission completed" : summary.reason;
    results.add([&] {
        folder.enter(
            {dateNow(), airplane, summary.mission, summary.board, result, endedWell(summary)});
    });
}

}  // namespace simulator
