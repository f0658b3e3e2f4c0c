// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <thread>

namespace simulator::chaos {
namespace {

constexpr char kWhat[] =
    "Flies scenarios drawn at random: missions, faults, restarts, sticks, parameters and hostile "
    "ground stations, and holds each flight to the invariants.";
constexpr char kFooter[] =
    "Exit status: 0 when nothing was violated, 1 when something was, 2 when the command line or a\n"
    "file is wrong. A scenario that violates an invariant is cut down to what it needs, written "
    "to\n"
    "the folder of --out, and printed as the command that flies it again. The folder also gets a\n"
    "page, campaign.html, and campaign.json. docs/chaos.md says more.";
constexpr uint64_t kMaxFlights = 10'000'000;
constexpr unsigned kMaxJobs = 256;

}  // namespace

ParsedChaos parseChaosOptions(int count, char** words) {
    ParsedChaos parsed;
    ChaosOptions& o = parsed.options;
    o.out = CHAOS_OUT;
    o.jobs = std::max(1u, std::thread::hardware_concurrency());
    bool elf = false;
    CLI::App app(kWhat, "chaos");
    app.footer(kFooter);
    app.add_option("--flights", o.flights, "how many")
        ->check(CLI::Range(uint64_t{1}, kMaxFlights))
        ->capture_default_str();
    app.add_option("--seed", o.seed, "of the first; the next ones count on from there")
        ->capture_default_str();
    app.add_flag("--elf", elf, "the image on the emulated APM 2 instead of natively compiled")
        ->disable_flag_override();
    app.add_option("--firmware", o.firmware, "another image for that board");
    app.add_option("--jobs", o.jobs, "flights at the same time; if not given as many as cores")
        ->check(CLI::Range(1u, kMaxJobs))
        ->default_str("");
    app.add_option("--replay", o.replay, "a scenario's file: flies it alone and says what happens")
        ->check(CLI::ExistingFile);
    app.add_option("--shrink", o.cut, "a scenario's file that fails: cuts it down")
        ->check(CLI::ExistingFile);
    app.add_option("--until", o.until,
                   "ends with the first flight that violates an invariant of this name");
    app.add_flag("--no-shrink", o.no_shrink, "leaves scenarios as they were drawn")
        ->disable_flag_override();
    app.add_option("--out", o.out, "folder for the page and for scenarios that failed")
        ->capture_default_str();
    try {
        app.parse(count, words);
        if (elf && o.firmware.empty()) o.firmware = CHAOS_IMAGE;
        return parsed;
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        parsed.exit_status = 0;
        return parsed;
    } catch (const CLI::ParseError& error) {
        std::cerr << "chaos: " << error.what() << " (--help explains)\n";
    }
    parsed.exit_status = 2;
    return parsed;
}

}  // namespace simulator::chaos
