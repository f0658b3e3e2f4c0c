// SPDX-License-Identifier: GPL-3.0-or-later
// The program: draws scenarios, flies as many at a time as there are cores, cuts down what fails.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

#include "simulator/chaos/document.hpp"
#include "simulator/chaos/generator.hpp"
#include "simulator/chaos/options.hpp"
#include "simulator/chaos/outcome.hpp"
#include "simulator/chaos/shrink.hpp"
#include "simulator/chaos/totals.hpp"
#include "simulator/input_file.hpp"
#include "simulator/output_file.hpp"

namespace simulator::chaos {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kMaxTries = 120;   // of one shrinking
constexpr size_t kShrunkPerName = 3;  // scenarios of the same invariant that are cut down
constexpr size_t kListed = 5000;      // flights that the document names; those that violate all
constexpr const char* kPage = "campaign.html";
constexpr const char* kDocument = "campaign.json";

volatile std::sig_atomic_t interrupted = 0;

struct Failure {
    Scenario scenario;
    Outcome outcome;
};

class Run {
public:
    explicit Run(const ChaosOptions& options)
        : options_(options), parameters_(readParameterRows(CHAOS_PARAMETERS)) {}

    int all() {
        const auto begun = std::chrono::steady_clock::now();
        makeFolder(options_.out);
        for (const char* name : {kPage, kDocument}) mustBeWritable(fs::path(options_.out) / name);
        for (uint64_t next = 0; (next < options_.flights && goesOn()) || !flying_.empty();) {
            while (flying_.size() < options_.jobs && next < options_.flights && goesOn())
                begin(options_.seed + next++);
            end();
        }
        for (const auto& [seed, failure] : failures_) report(seed, failure);
        std::cout << "\n" << totals_.text();
        write(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
        return totals_.violated() == 0 && interrupted == 0 ? 0 : 1;
    }

private:
    struct Flying {
        uint64_t seed;
        Scenario scenario;
        FlightProcess process;
    };

    bool goesOn() const {
        return interrupted == 0 &&
               std::none_of(options_.until.begin(), options_.until.end(), [&](const auto& name) {
                   return totals_.violations().count(name) != 0;
               });
    }

    void begin(uint64_t seed) {
        Scenario scenario = drawScenario(seed, parameters_);
        FlightProcess process(scenario, options_.firmware);
        const int pid = process.pid();
        flying_.emplace(pid, Flying{seed, std::move(scenario), std::move(process)});
    }

    void end() {
        int status = 0;
        const int pid = waitpid(-1, &status, 0);
        const auto found = flying_.find(pid);
        if (found == flying_.end()) return;
        Flying& flown = found->second;
        const Outcome outcome = flown.process.take(status);
        totals_.add(flown.scenario, outcome);
        if (!outcome.violations.empty())
            std::cout << "seed " << flown.seed << ": " << outcome.violations.front().line()
                      << std::endl;
        if (!outcome.violations.empty()) failures_[flown.seed] = {flown.scenario, outcome};
        if (!outcome.violations.empty() || listed_.size() < kListed)
            listed_[flown.seed] = flownScenario(flown.seed, flown.scenario, outcome);
        flying_.erase(found);
        if (++flown_ % 100 == 0)
            std::cout << flown_ << " flights, " << failures_.size() << " failed" << std::endl;
    }

    void report(uint64_t seed, const Failure& failure) {
        const invariants::Violation& first = failure.outcome.violations.front();
        std::cout << "\nseed " << seed << ": " << first.line() << "\n";
        Scenario least = failure.scenario;
        const bool shrinks = !options_.no_shrink && shrunk_[first.name]++ < kShrunkPerName;
        if (shrinks && interrupted == 0)
            least = shrink(
                least,
                [&](const Scenario& scenario) {
                    return FlightProcess(scenario, options_.firmware).wait().violates(first.name);
                },
                kMaxTries);
        const fs::path file =
            fs::path(options_.out) / (first.name + "_" + std::to_string(seed) + ".scenario");
        writeFile(file, "# " + first.line() + "\n" + textOf(least));
        listed_[seed].file = file.filename();
        std::cout << "  toolchain/chaos" << firmwareOption() << " --replay " << file.string()
                  << "\n";
        if (shrinks) std::cout << textOf(least);
    }

    std::string firmwareOption() const {
        if (options_.firmware.empty()) return "";
        return options_.firmware == CHAOS_IMAGE ? " --elf" : " --firmware " + options_.firmware;
    }

    void write(double wall_s) const {
        const std::string firmware = options_.firmware.empty()
                                         ? "natively compiled firmware"
                                         : fs::path(options_.firmware).filename().string();
        const ChaosRun run{options_.flights, firmware, firmwareOption(), options_.out, wall_s};
        std::vector<FlownScenario> flights;
        for (const auto& [seed, flown] : listed_) flights.push_back(flown);
        const fs::path page = fs::path(options_.out) / kPage;
        writeFile(page, chaosPage(run, totals_, flights));
        writeFile(fs::path(options_.out) / kDocument, chaosJson(run, totals_, flights));
        std::cout << "page: " << page.string() << "\n";
    }

    const ChaosOptions& options_;
    const std::vector<ParameterRow> parameters_;
    std::map<int, Flying> flying_;
    std::map<uint64_t, Failure> failures_;
    std::map<uint64_t, FlownScenario> listed_;
    std::map<std::string, size_t> shrunk_;
    Totals totals_;
    uint64_t flown_ = 0;
};

int replay(const ChaosOptions& options) {
    const Scenario scenario = parseScenario(wholeFile(options.replay).value_or(""));
    const Outcome outcome = flyScenario(scenario, options.firmware, true);
    for (const auto& each : outcome.violations) std::cout << "VIOLATED  " << each.line() << "\n";
    std::cout << (outcome.violations.empty() ? "nothing was violated in " : "in ")
              << outcome.emulated_s << " s" << (outcome.crashed ? ", crashed" : "")
              << (promisesToSurvive(scenario) ? ", which must not crash" : "") << "\n";
    return outcome.violations.empty() ? 0 : 1;
}

int cutDown(const ChaosOptions& options) {
    constexpr unsigned kTries = 1000;
    const Scenario scenario = parseScenario(wholeFile(options.cut).value_or(""));
    const auto fly = [&](const Scenario& each) {
        return FlightProcess(each, options.firmware).wait();
    };
    const Outcome outcome = fly(scenario);
    if (outcome.violations.empty()) throw std::runtime_error("it violates nothing");
    const std::string name = outcome.violations.front().name;
    const Scenario least = shrink(
        scenario, [&](const Scenario& each) { return fly(each).violates(name); }, kTries);
    std::cout << "# " << fly(least).violations.front().line() << "\n" << textOf(least);
    return 1;
}

int chaos(const ChaosOptions& options) {
    std::signal(SIGINT, [](int) { interrupted = 1; });
    try {
        if (!options.cut.empty()) return cutDown(options);
        return options.replay.empty() ? Run(options).all() : replay(options);
    } catch (const std::exception& error) {
        std::cerr << "chaos: " << error.what() << "\n";
    }
    return 2;
}

}  // namespace
}  // namespace simulator::chaos

int main(int count, char** words) {
    const auto parsed = simulator::chaos::parseChaosOptions(count, words);
    return simulator::finishOutput("chaos", parsed.exit_status
                                                ? *parsed.exit_status
                                                : simulator::chaos::chaos(parsed.options));
}
