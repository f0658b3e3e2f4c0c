// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/rehearse.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "simulator/input_file.hpp"
#include "simulator/open_page.hpp"
#include "simulator/output_file.hpp"
#include "simulator/run_program.hpp"
#include "toolchain/mission_tool/columns.hpp"
#include "toolchain/mission_tool/flight_table.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

namespace fs = std::filesystem;

// The wind of a rehearsal comes from somewhere.
Wind directed(const Wind& wind) {
    constexpr double kWest_deg = 270;
    return {wind.speed_mps, wind.from_deg.value_or(kWest_deg)};
}

// In wind it may take more than twice as long; the simulator's own limit is 20 minutes.
long timeLimit_s(double expected_s) {
    constexpr double kLeast_s = 1200, kMax_s = 100'000, kTimes = 3, kBesides_s = 300;
    return std::lround(
        std::min(kMax_s, std::max(kLeast_s, kTimes * expected_s + kBesides_s)));
}

std::vector<std::string> wordsFor(const Rehearsal& rehearsal, const Wind& wind,
                                  const fs::path& folder) {
    std::vector<std::string> words = {"--native",    "--airplane",     rehearsal.airplane,
                                      "--out",       folder.string(),  "--seed",
                                      std::to_string(rehearsal.seed)};
    words.insert(words.end(), {"--time-limit", std::to_string(timeLimit_s(rehearsal.expected_s))});
    if (wind.speed_mps > 0) {
        words.push_back("--gusts");
        words.push_back("--wind");
        words.push_back(format("%g,%g", wind.speed_mps, *wind.from_deg));
    }
    if (!rehearsal.board.empty()) {
        const fs::path eeprom = folder / "eeprom.bin";
        simulator::writeFile(eeprom, rehearsal.board);
        words.insert(words.end(), {"--eeprom", eeprom.string()});
    }
    if (rehearsal.has_parameters) {
        const fs::path parameters = folder / "none.param";
        simulator::writeFile(parameters, "# the board has its own\n");
        words.insert(words.end(), {"--param", parameters.string()});
    }
    if (!rehearsal.stored_navs.empty()) {
        std::string navs;
        for (const int nav : rehearsal.stored_navs)
            navs += (navs.empty() ? "" : ",") + std::to_string(nav);
        words.insert(words.end(), {"--stored", navs});
    }
    words.push_back(rehearsal.mission);
    return words;
}

// What the program says at its end; the lines on the way are for whoever waits.
std::string verdictIn(const std::string& log) {
    for (const char* begins : {"mission completed", "not completed: "}) {
        const size_t at = log.rfind(begins);
        if (at != std::string::npos) return log.substr(at);
    }
    return "";
}

bool flies(const Rehearsal& rehearsal, const Wind& wind, const char* name, std::ostream& out) {
    const fs::path folder = fs::path(rehearsal.folder) / name, log = folder / "fly.log";
    simulator::makeFolder(folder);
    simulator::Ending ending;
    try {
        ending = simulator::runProgram(MISSION_FLY, wordsFor(rehearsal, wind, folder), log);
    } catch (const simulator::OutputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw WrongInput(std::string(error.what()) + ": toolchain/build host:fly makes it");
    }
    const std::string said = simulator::wholeFile(log).value_or(""), verdict = verdictIn(said);
    if (ending.signal != 0)
        throw WrongInput("the simulator died of signal " + std::to_string(ending.signal) + ": " +
                         log.string());
    if (ending.status > 1 || verdict.empty())
        throw WrongInput(said.empty() ? log.string() + ": the simulator said nothing"
                                      : said.substr(0, said.find_last_not_of('\n') + 1));
    out << windInWords(wind) << (wind.speed_mps > 0 ? ", gusts of 1 m/s" : "") << ": " << verdict;
    return ending.status == 0;
}

// Who runs it by hand wants to see it: of both flights the one in wind.
void showReport(const Rehearsal& rehearsal, const char* name) {
    if (isatty(STDOUT_FILENO) != 0)
        simulator::openPage((fs::absolute(rehearsal.folder) / name / "report.html").string());
}

}  // namespace

bool rehearseFlights(const Rehearsal& rehearsal, std::ostream& out) {
    out << rehearsal.name << ", " << rehearsal.airplane << ", flown by the simulator:\n";
    bool completed = flies(rehearsal, {}, "calm", out);
    const bool windy = rehearsal.wind.speed_mps > 0;
    if (windy) completed = flies(rehearsal, directed(rehearsal.wind), "wind", out) && completed;
    showReport(rehearsal, windy ? "wind" : "calm");
    return completed;
}

}  // namespace mission_tool
