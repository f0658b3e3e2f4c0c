// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/program.hpp"

#include <algorithm>
#include <filesystem>

#include "simulator/ground/points_file.hpp"
#include "simulator/ground/text_file.hpp"
#include "toolchain/mission_tool/airplane.hpp"
#include "toolchain/mission_tool/arduplane.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/command_line.hpp"
#include "toolchain/mission_tool/findings.hpp"
#include "toolchain/mission_tool/flight_findings.hpp"
#include "toolchain/mission_tool/flight_table.hpp"
#include "toolchain/mission_tool/load.hpp"
#include "toolchain/mission_tool/page.hpp"
#include "toolchain/mission_tool/rehearse.hpp"
#include "toolchain/mission_tool/table.hpp"
#include "toolchain/mission_tool/text_form.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

constexpr char kWhat[] = "Missions as files and as EEPROM images for the board.";
constexpr char kFooter[] =
    "FILE is a QGC WPL 110 file, a .plan of QGroundControl, a .mission of Mission Planner, the\n"
    "text form of docs/mission.md, or an image: Intel hex or 4096 raw bytes. Exit status: 0 when all is well (there may\n"
    "be warnings), 1 when the mission is wrong, 2 when the command line is.";

constexpr char kTextForm[] = "the text form";
constexpr size_t kMaxWarnings = 20;

struct Options {
    std::string file, out, set, onto, airplane;
    std::string fence, rally, html, reports = MISSION_OUT;
    double range_m = Conditions().range_m;
    uint64_t seed = 1;
    Wind wind;
    bool wind_given = false;
    int records = 14;
    size_t count = 0;
    bool raw = false;
};

class Program {
public:
    Program(const Options& options, std::ostream& out, std::ostream& err)
        : options_(options), out_(out), err_(err) {}

    int check() {
        load();
        std::vector<Finding> all = findings(document_);
        const bool refused = hasError(all);
        if (!refused) addFlight(all);
        const bool wrong = printFindings(all, err_, [&](const Finding& each) {
            return document_.at(each.index, (each.error ? "" : "warning: ") + each.text);
        });
        if (!refused)
            out_ << options_.file << ": the firmware takes it"
                 << (wrong ? ", but it cannot be flown as it is written\n" : "\n");
        return wrong ? 1 : 0;
    }

    int compile() {
        const std::string contents = load();
        encodedFor(options_.out, blankImage());  // a name that cannot be written to is reported first
        if (reportFindings()) return 1;
        const bool to_arduplane = options_.records == 15 && !isImage(contents);
        const Image image = to_arduplane ? writeRecords15(document_, reading_.onto)
                                         : uploaded(document_, reading_.onto, reading_.onto_name);
        simulator::writeFile(options_.out, encodedFor(options_.out, image));
        if (options_.onto.empty())
            err_ << options_.out
                 << ": a whole EEPROM: flashed, it sets every parameter to its default; --onto "
                    "keeps a board's\n";
        if (to_arduplane)
            err_ << options_.out << ": set CMD_TOTAL to " << document_.entries.size() - 1
                 << " on that board\n";
        return 0;
    }

    int decode() {
        if (!isImage(load())) throw WrongInput(options_.file + ": expected an image of an EEPROM");
        (void)reportFindings();
        std::string text = options_.raw ? "" : recordsAsWaypoints(document_);
        if (text.empty()) {
            if (!options_.raw && document_.set == mission::Set::apm2)
                err_ << options_.file
                     << ": holds what a waypoint file cannot say; written record by record\n";
            text = recordsAsText(document_);
        }
        if (options_.out.empty()) {
            out_ << text;
        } else {
            simulator::writeFile(options_.out, text);
        }
        return 0;
    }

    int convert() {
        load();
        const Form form = formOf(options_.out);
        if (reportFindings()) return 1;
        const std::string text = (*form.write)(document_);
        if (text.empty()) {
            if (!form.leaves_out && form.write != recordsAsPlan)
                throw WrongInput(options_.file + ": has no " + form.name);
            throw WrongInput(options_.file + ": holds what " + form.name +
                             " cannot say; " + kTextForm + " (.txt) can say it");
        }
        simulator::writeFile(options_.out, text);
        const bool around = document_.fence.given() || !document_.rally.empty();
        if (around && form.leaves_out)
            err_ << options_.out << ": has no place for the fence and the rally points of "
                 << options_.file << ": left out\n";
        return 0;
    }

    int rehearse() {
        const std::string contents = load();
        if (reportFindings()) return 1;
        Rehearsal rehearsal;
        rehearsal.name = options_.file;
        rehearsal.folder = options_.reports;
        rehearsal.airplane = airplane();
        if (options_.wind_given) rehearsal.wind = options_.wind;
        rehearsal.seed = options_.seed;
        const FlightOrder order = flightOrder(document_);
        rehearsal.expected_s = reckoned(order).time_s;
        rehearsal.has_parameters = !options_.onto.empty();
        if (document_.set == mission::Set::apm1)
            store(order, rehearsal);
        else
            upload(contents, rehearsal);
        return rehearseFlights(rehearsal, out_) ? 0 : 1;
    }

    int show() {
        load();
        out_ << tableOf(document_);
        showFlight();
        if (!options_.html.empty() && !page_written_)
            throw WrongInput(options_.html + ": not written: there is no flight to draw");
        printFindings(findings(document_), out_, [](const Finding& finding) {
            return (finding.error ? "refused: item " : "warning: item ") +
                   std::to_string(finding.index) + ": " + finding.text;
        });
        return 0;
    }

private:
    std::string airplane() const {
        return options_.airplane.empty() ? kUsualAirplane : options_.airplane;
    }

    static std::string written(const std::string& folder, const char* name,
                               const std::string& text) {
        simulator::makeFolder(folder);
        const std::string path = (std::filesystem::path(folder) / name).string();
        simulator::writeFile(path, text);
        return path;
    }

    // The ground station of the simulator uploads the file, or one that it reads.
    void upload(const std::string& contents, Rehearsal& rehearsal) const {
        if (rehearsal.has_parameters) rehearsal.board = rawOf(reading_.onto);
        rehearsal.mission = options_.file;
        if (looksLikeGroundStations(contents) && options_.fence.empty() && options_.rally.empty())
            return;
        const std::string plan = recordsAsPlan(document_);
        if (plan.empty())
            throw WrongInput(options_.file + ": holds what no ground station can upload");
        rehearsal.mission = written(rehearsal.folder, "mission.plan", plan);
    }

    // The simulated board gets it in its EEPROM, as no ground station knows the 1.0 set.
    void store(const FlightOrder& order, Rehearsal& rehearsal) const {
        if (document_.fence.given() || !document_.rally.empty())
            throw WrongInput(options_.file + ": a mission of the 1.0 set is not uploaded, nor are "
                                             "fence and rally points");
        rehearsal.mission = written(rehearsal.folder, "places.waypoints", placesOf(document_));
        for (const Visit& visit : order.visits)
            rehearsal.stored_navs.push_back(static_cast<int>(visit.nav));
        if (rehearsal.stored_navs.empty())
            throw WrongInput(options_.file + ": has no NAV: there is nothing to fly");
        rehearsal.board = rawOf(uploaded(document_, reading_.onto, reading_.onto_name));
    }

    // What the flight itself is found to be.
    std::vector<Finding> inspected(const FlightOrder& order, const Estimate& flight) const {
        return flightFindings(document_, order, flight,
                              {options_.wind, options_.range_m, document_.fence});
    }

    static simulator::MissionFile pointsOf(const std::string& path) {
        try {
            return simulator::readPointsFile(path);
        } catch (const simulator::WaypointError& error) {
            throw WrongInput(error.what());
        }
    }
    // Those of files of their own instead of FILE's.
    void takePoints() {
        if (!options_.fence.empty()) {
            document_.fence = pointsOf(options_.fence).fence;
            if (!document_.fence.given()) throw WrongInput(options_.fence + ": has no fence");
        }
        if (!options_.rally.empty()) {
            document_.rally = pointsOf(options_.rally).rally;
            if (document_.rally.empty()) throw WrongInput(options_.rally + ": has no rally points");
        }
    }

    Estimate reckoned(const FlightOrder& order) const {
        return estimate(document_, order, Power(airplaneNamed(airplane())), options_.wind);
    }

    static bool hasError(const std::vector<Finding>& all) {
        return std::any_of(all.begin(), all.end(), [](const Finding& each) { return each.error; });
    }

    void addFlight(std::vector<Finding>& all) const {
        const FlightOrder order = flightOrder(document_);
        for (Finding& each : inspected(order, reckoned(order))) {
            const bool named = document_.entries[each.index].line == 0 || document_.names_items;
            if (!named) each.text = "item " + std::to_string(each.index) + ": " + each.text;
            all.push_back(each);
        }
    }

    void writePage(const FlightOrder& order, const Estimate& flight) {
        std::vector<Finding> all = findings(document_);
        for (const Finding& each : inspected(order, flight)) all.push_back(each);
        simulator::writeFile(options_.html,
                             pageOf({document_, order, flight, all, airplane(), options_.wind}));
        page_written_ = true;
    }

    void showFlight() {
        const FlightOrder order = flightOrder(document_);
        if (order.visits.empty()) return;
        const Estimate flight = reckoned(order);
        out_ << "\nIn the order of the flight, " << airplane() << ", " << windInWords(options_.wind)
             << ", estimated:\n"
             << flightTableOf(document_, order, flight) << '\n';
        out_ << (flight.stretches.empty() ? "home is no place: nothing can be reckoned\n"
                                          : sumsOf(order, flight));
        if (!options_.html.empty() && !flight.stretches.empty()) writePage(order, flight);
    }

    struct Form {
        const char *ending, *name;
        std::string (*write)(const Document&);
        bool leaves_out;  // fence and rally points
    };
    static std::string fenceAlone(const Document& document) {
        return simulator::fenceAsPoints(document.fence);
    }
    static std::string rallyAlone(const Document& document) {
        return simulator::rallyAsPoints(document.rally);
    }
    static Form formOf(const std::string& path) {
        constexpr Form kForms[] = {{".plan", "a .plan", recordsAsPlan, false},
                                   {".waypoints", "a waypoint file", recordsAsWaypoints, true},
                                   {".txt", kTextForm, recordsAsText, true},
                                   {".fen", "fence of one polygon with a return point", fenceAlone, false},
                                   {".ral", "rally points", rallyAlone, false}};
        for (const Form& form : kForms)
            if (std::filesystem::path(path).extension() == form.ending) return form;
        throw WrongInput(path + ": expected a name that ends in .plan, .waypoints, .txt, .fen or .ral");
    }

    std::string load() {
        reading_.onto = blankImage();
        reading_.records15 = options_.records == 15;
        reading_.count = options_.count;
        if (!options_.onto.empty()) {
            reading_.onto = imageOf(readFile(options_.onto), options_.onto);
            reading_.onto_name = options_.onto;
        }
        if (!options_.airplane.empty() && options_.onto.empty())
            reading_.prepare = [this] { setParametersOf(options_.airplane); };
        if (!options_.set.empty())
            reading_.set = options_.set == "apm1" ? mission::Set::apm1 : mission::Set::apm2;
        const std::string contents = readFile(options_.file);
        document_ = mission_tool::load(contents, options_.file, reading_);
        takePoints();
        for (const simulator::Remark& each : document_.remarks)
            err_ << placed(options_.file, each.line, each.column, "warning: " + each.text) << '\n';
        if (reading_.records15 && reading_.count == 0 && isImage(contents))
            err_ << options_.file << ": taken as " << document_.entries.size()
                 << " items, up to the first never written; --count gives the number for certain\n";
        return contents;
    }

    bool reportFindings() {
        return printFindings(findings(document_), err_, [&](const Finding& finding) {
            return document_.at(finding.index,
                                (finding.error ? "" : "warning: ") + finding.text);
        });
    }

    // Errors come last, where they are seen, however many warnings there are.
    template <class LineOf>
    static bool printFindings(const std::vector<Finding>& all, std::ostream& to, LineOf lineOf) {
        const auto print = [&](bool errors, size_t most, const char* more) {
            size_t found = 0;
            for (const Finding& finding : all)
                if (finding.error == errors && ++found <= most) to << lineOf(finding) << '\n';
            if (found > most) to << "and " << found - most << more << '\n';
            return found;
        };
        print(false, kMaxWarnings, " more warnings");
        return print(true, simulator::kMaxListed, " more") > 0;
    }

    const Options& options_;
    std::ostream& out_;
    std::ostream& err_;
    Reading reading_;
    Document document_;
    bool page_written_ = false;
};

struct Command {
    const char* name;
    const char* what;
    int (Program::*run)();
};
constexpr Command kCommands[] = {
    {"check",
     "checks whether the firmware takes a mission, what it would never run, and whether the airplane "
     "can fly it",
     &Program::check},
    {"compile", "makes an EEPROM image that the board boots with", &Program::compile},
    {"convert", "writes the mission as another kind of file", &Program::convert},
    {"decode", "writes the mission in an image as text", &Program::decode},
    {"rehearse", "flies it natively, in calm air and in wind, and prints how that went",
     &Program::rehearse},
    {"show", "prints a table to be read before the flight", &Program::show},
};

std::string parseWind(const std::string& text, Wind& wind) {
    constexpr double kStrongest_mps = 30;
    char* rest = nullptr;
    wind.speed_mps = std::strtod(text.c_str(), &rest);
    bool good = rest != text.c_str() && wind.speed_mps >= 0 && wind.speed_mps <= kStrongest_mps;
    if (good && *rest == ',') {
        const char* from = rest + 1;
        wind.from_deg = std::strtod(from, &rest);
        good = rest != from && *wind.from_deg >= 0 && *wind.from_deg <= 360;
    }
    return good && *rest == 0 ? ""
                              : "expected SPEED or SPEED,FROM_DEGREES with 0 to 30 m/s and 0 to "
                                "360 degrees, like 5,270, not '" + text + "'";
}

void addRehearsal(CLI::App& app, Options& o) {
    app.add_option("--seed", o.seed, "of every random error; the same seed gives the same flight")
        ->capture_default_str();
    app.add_option("-o,--out", o.reports, "folder for the reports of both flights")
        ->capture_default_str();
}

void addAirplane(CLI::App& app, Options& o, const char* no_wind) {
    app.add_option("--airplane", o.airplane,
                   "what flies: a name of simulator/airplanes or the path of a .json file; the "
                   ".param file beside it counts unless --onto gives a board's; else foam_trainer");
    const std::string what =
        "SPEED or SPEED,FROM_DEGREES: mean wind in m/s, up to 30, and where it comes from; else ";
    app.add_option_function<std::string>("--wind", [&o](const std::string&) { o.wind_given = true; },
                                         what + no_wind)
        ->check([&o](const std::string& text) { return parseWind(text, o.wind); });
}

void addPoints(CLI::App& app, Options& o) {
    app.add_option("--fence", o.fence,
                   "file whose fence counts instead of FILE's own: a .plan, Mission Planner's .fen "
                   "or .poly, or a waypoint file of fence items");
    app.add_option("--rally", o.rally,
                   "file whose rally points count instead: a .plan, Mission Planner's .ral, or a "
                   "waypoint file of rally points");
}

void addOptions(CLI::App& app, const Command& command, Options& o) {
    app.add_option(command.run == &Program::decode ? "IMAGE" : "FILE", o.file, "what to read")
        ->required();
    app.add_option("--set", o.set, "apm1 or apm2: the set FILE is in")
        ->check(CLI::IsMember({"apm1", "apm2"}));
    app.add_option("--records", o.records,
                   "15: FILE, or OUT when FILE is text, is the image of an ArduPlane 2.x board; "
                   "FILE of 3.x, too")
        ->check(CLI::IsMember({14, 15}));
    app.add_option("--count", o.count,
                   "items in such an image: the board's CMD_TOTAL, plus home, or MIS_TOTAL");
    app.add_option("--onto", o.onto,
                   "image of the board the mission is for: everything else in it stays, and its "
                   "parameters set the ranges; else a blank EEPROM");
    const bool rehearses = command.run == &Program::rehearse;
    if (rehearses || command.run == &Program::show || command.run == &Program::check)
        addAirplane(app, o, rehearses ? "6,270; always with gusts of 1 m/s" : "calm air");
    if (rehearses) addRehearsal(app, o);
    if (command.run == &Program::show)
        app.add_option("--html", o.html, "page to write as well: map, height profile, findings");
    if (rehearses || command.run == &Program::show || command.run == &Program::check ||
        command.run == &Program::convert)
        addPoints(app, o);
    if (command.run == &Program::check)
        app.add_option("--range", o.range_m, "metres from home beyond which there is a warning")
            ->check(CLI::Range(1.0, 1e7))
            ->capture_default_str();
    if (command.run == &Program::compile)
        app.add_option("-o,--out", o.out, "image to write: .eep or .hex (Intel hex), .bin (raw)")
            ->required();
    if (command.run == &Program::convert)
        app.add_option("-o,--out", o.out,
                       "file to write: .plan (QGroundControl), .waypoints (QGC WPL 110) or .txt "
                       "(the text form); .fen or .ral (Mission Planner): the fence or the rally "
                       "points alone")
            ->required();
    if (command.run == &Program::decode) {
        app.add_option("-o,--out", o.out, "file to write instead of the standard output");
        app.add_flag("--raw", o.raw, "a stored record a line, whatever the set");
    }
}

}  // namespace

int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
    Options options;
    CommandLine line = {"mission", kWhat, kFooter, {}};
    for (const Command& command : kCommands)
        line.subcommands.push_back({command.name, command.what,
                                    [&](CLI::App& app) { addOptions(app, command, options); },
                                    [&] { return (Program(options, out, err).*command.run)(); }});
    return runCommandLine(line, words, out, err);
}

}  // namespace mission_tool
