// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <thread>

namespace simulator {
namespace {

constexpr char kWhat[] =
    "Flies every mission with every airplane in every wind with every seed, natively, and shows "
    "how well.";
constexpr char kFooter[] =
    "Exit status: 0 when every flight was flown to its end without a crash and without a broken\n"
    "frame, 1 when not or when it was interrupted, 2 when the command line or a file is wrong or\n"
    "the page could not be written. The folder of --out receives campaign.html, campaign.json\n"
    "(docs/campaign_document.md) and flights/ with the summary of each, in drawn worlds also the\n"
    "reports of ten that failed and the ten worst. 1,000 flights: --seeds 84.";
constexpr char kEnding[] = ".waypoints";
constexpr uint64_t kMaxFlights = 1'000'000;

class Wrong : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

bool wholeNumber(const std::string& text, uint64_t& value) {
    constexpr size_t kMaxDigits = 18;
    if (text.empty() || text.size() > kMaxDigits) return false;
    if (text.find_first_not_of("0123456789") != text.npos) return false;
    value = std::stoull(text);
    return true;
}

// N: 1 to N; or A-B.
void readSeeds(const std::string& option, const std::string& text, CampaignOptions& options) {
    const size_t dash = text.find('-');
    const std::string first = dash == text.npos ? "1" : text.substr(0, dash);
    const std::string last = dash == text.npos ? text : text.substr(dash + 1);
    if (!wholeNumber(first, options.first_seed) || !wholeNumber(last, options.last_seed) ||
        options.last_seed < options.first_seed || options.last_seed == 0)
        throw Wrong(option + ": expected how many, like 84, or a range, like 5-9, not '" + text +
                    "'");
}

CampaignWind readWind(const std::string& text) {
    if (text == "calm") return {};
    CampaignWind wind;
    char* rest = nullptr;
    wind.mps = std::strtod(text.c_str(), &rest);
    const bool comma = rest != text.c_str() && *rest == ',';
    const char* from = comma ? rest + 1 : rest;
    wind.from_deg = std::strtod(from, &rest);
    if (!comma || rest == from || *rest != 0 || !(wind.mps > 0 && wind.mps <= 30) ||
        !(wind.from_deg >= 0 && wind.from_deg <= 360))
        throw Wrong(
            "--wind: expected calm or SPEED,FROM_DEGREES with up to 30 m/s and 0 to 360 degrees, "
            "like 5,320, not '" +
            text + "'");
    return wind;
}

void readJobs(const std::string& text, CampaignOptions& options) {
    constexpr uint64_t kMax = 256;
    uint64_t jobs = 0;
    if (!wholeNumber(text, jobs) || jobs == 0 || jobs > kMax)
        throw Wrong("--jobs: expected 1 to 256, not '" + text + "'");
    options.jobs = static_cast<unsigned>(jobs);
}

struct Words {
    std::vector<std::string> winds = {"calm", "5,320"};
    std::string seeds = "10", drawn,
                jobs = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
};

void addOptions(CLI::App& app, CampaignOptions& o, Words& words) {
    app.add_option("MISSION", o.missions, "mission files; if not given first_flight and box_600");
    app.add_option("--airplane", o.airplanes,
                   "one of simulator/airplanes, or a .json file; several times for several; if not "
                   "given all three")
        ->allow_extra_args(false);
    app.add_option("--wind", words.winds,
                   "calm, or SPEED,FROM_DEGREES with gusts; several times for several winds")
        ->allow_extra_args(false)
        ->capture_default_str();
    app.add_option("--seeds", words.seeds, "how many, or a range FIRST-LAST")
        ->capture_default_str();
    app.add_option("--drawn", words.drawn,
                   "instead: how many drawn worlds, or a range FIRST-LAST. Each draws an airplane, "
                   "its sensors, the air and the field; AUTOTUNE flies first, then a box and a "
                   "landing; goes with --jobs and --out alone");
    app.add_option("--jobs", words.jobs, "flights at the same time; if not given as many as cores");
    app.add_option("--out", o.out, "folder for the page and the summaries")->capture_default_str();
}

void mustNotContradict(const CLI::App& app) {
    if (app.count("--drawn") == 0) return;
    for (const auto& [option, drawn] : {std::pair{"MISSION", "mission"},
                                        {"--airplane", "airplane"},
                                        {"--wind", "wind"},
                                        {"--seeds", "seeds"}})
        if (app.count(option) > 0)
            throw Wrong(std::string("--drawn draws the ") + drawn + " itself: no " + option);
}

void readWords(const Words& words, CampaignOptions& options) {
    for (const auto& wind : words.winds) options.winds.push_back(readWind(wind));
    if (options.drawn)
        readSeeds("--drawn", words.drawn, options);
    else
        readSeeds("--seeds", words.seeds, options);
    readJobs(words.jobs, options);
    const uint64_t seeds = options.last_seed - options.first_seed + 1;
    const uint64_t groups =
        options.drawn ? 1
                      : options.missions.size() * options.airplanes.size() * options.winds.size();
    if (seeds > kMaxFlights / groups)
        throw Wrong(std::string(options.drawn ? "--drawn" : "--seeds") +
                    ": more than 1000000 flights are asked for");
}

}  // namespace

ParsedCampaign parseCampaignOptions(int count, char** arguments) {
    ParsedCampaign parsed;
    CampaignOptions& options = parsed.options;
    options.out = CAMPAIGN_OUT;
    Words words;
    CLI::App app(kWhat, "campaign");
    app.footer(kFooter);
    addOptions(app, options, words);
    try {
        app.parse(count, arguments);
        mustNotContradict(app);
        options.drawn = app.count("--drawn") > 0;
        if (options.missions.empty())
            for (const char* name : {"first_flight", "box_600"})
                options.missions.push_back(std::filesystem::proximate(CAMPAIGN_MISSIONS) /
                                           (name + std::string(kEnding)));
        if (options.airplanes.empty())
            options.airplanes = {"foam_trainer", "trainer_6kg", "flying_wing"};
        readWords(words, options);
        return parsed;
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        parsed.exit_status = 0;
        return parsed;
    } catch (const CLI::ParseError& error) {
        std::cerr << "campaign: " << error.what() << " (--help explains)\n";
    } catch (const Wrong& error) {
        std::cerr << "campaign: " << error.what() << " (--help explains)\n";
    }
    parsed.exit_status = 2;
    return parsed;
}

std::vector<CampaignFlight> flightsOf(const CampaignOptions& options) {
    std::vector<CampaignFlight> flights;
    if (options.drawn) {
        for (uint64_t seed = options.first_seed; seed <= options.last_seed; ++seed)
            flights.push_back({"drawn", "box", {}, seed, true});
        return flights;
    }
    for (uint64_t seed = options.first_seed; seed <= options.last_seed; ++seed)
        for (const auto& airplane : options.airplanes)
            for (const auto& mission : options.missions)
                for (const auto& wind : options.winds)
                    flights.push_back({airplane, mission, wind, seed, false});
    return flights;
}

}  // namespace simulator
