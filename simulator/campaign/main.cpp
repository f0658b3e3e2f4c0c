// SPDX-License-Identifier: GPL-3.0-or-later
// The program: flies all flights of a campaign, as many at a time as there are cores.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <thread>

#include "simulator/airplane/parameters.hpp"
#include "simulator/campaign/document.hpp"
#include "simulator/campaign/options.hpp"
#include "simulator/campaign/progress.hpp"
#include "simulator/campaign/reports_held.hpp"
#include "simulator/campaign/shares.hpp"
#include "simulator/campaign/statistics.hpp"
#include "simulator/ground/waypoints.hpp"
#include "simulator/output_file.hpp"

namespace simulator {
namespace {

namespace fs = std::filesystem;

volatile std::sig_atomic_t interrupted = 0;
constexpr size_t kMaxShown = 10, kReportsHeld = 10;
constexpr const char* kDocuments[] = {"campaign.html", "campaign.json"};

// Said before the first flight, not by each of a thousand.
void mustBeUsable(const CampaignOptions& options) {
    for (const auto& mission : options.missions) readWaypoints(mission);
    for (const auto& airplane : options.airplanes) loadAirplane(airplane);
    try {
        makeFolder(fs::path(options.out) / "flights");
        for (const char* name : kDocuments) mustBeWritable(fs::path(options.out) / name);
    } catch (const OutputError& error) {
        throw std::runtime_error(std::string("--out ") + error.what());
    }
}

std::string folderOf(const CampaignOptions& options, const CampaignFlight& flight) {
    std::string name = flight.group() + " " + std::to_string(flight.seed);
    for (char& letter : name)
        if (letter == ' ' || letter == ',') letter = '-';
    return fs::path(options.out) / "flights" / name;
}

// Of those that failed the first, of the others those that are farthest beyond a goal or a limit.
class Reports {
public:
    // `number`: of the flight in the campaign.
    void add(const CampaignResult& result, size_t number, const fs::path& report) {
        std::error_code ignored;
        if (!fs::exists(report, ignored)) return;
        const std::string goes = result.failure.empty()
                                     ? worst_.add(excessOf(result), report)
                                     : failed_.add(-static_cast<double>(number), report);
        if (!goes.empty()) fs::remove(goes, ignored);
    }

private:
    ReportsHeld failed_{kReportsHeld}, worst_{kReportsHeld};
};

void nameReports(std::vector<CampaignResult>& results, const CampaignOptions& options) {
    std::error_code ignored;
    for (CampaignResult& each : results) {
        const fs::path report = fs::path(folderOf(options, each.flight)) / "report.html";
        if (fs::exists(report, ignored))
            each.report = report.lexically_relative(options.out).generic_string();
    }
}

std::vector<CampaignResult> flyAll(const CampaignOptions& options,
                                   const std::vector<CampaignFlight>& flights) {
    std::vector<CampaignResult> results(flights.size());
    std::atomic<size_t> next{0};
    std::mutex at_once;
    Reports reports;
    Progress progress(flights.size(), isatty(STDOUT_FILENO) != 0);
    const auto work = [&] {
        for (size_t i; interrupted == 0 && (i = next++) < flights.size();) {
            results[i] =
                flyOne({CAMPAIGN_FLY, CAMPAIGN_DRAWN}, flights[i], folderOf(options, flights[i]));
            const std::lock_guard<std::mutex> lock(at_once);
            reports.add(results[i], i, fs::path(folderOf(options, flights[i])) / "report.html");
            if (results[i].flown) progress.flown(results[i].failure.empty());
        }
    };
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < options.jobs; ++i) workers.emplace_back(work);
    for (auto& worker : workers) worker.join();
    progress.end();
    results.erase(std::remove_if(results.begin(), results.end(),
                                 [](const CampaignResult& result) { return !result.flown; }),
                  results.end());
    nameReports(results, options);
    return results;
}

// The flights that did not go well; how many.
size_t reportFailures(const std::vector<CampaignResult>& results) {
    size_t failed = 0;
    for (const auto& result : results) {
        if (result.failure.empty() || failed++ >= kMaxShown) continue;
        std::cout << "\nfailed: " << result.flight.group() << ", seed " << result.flight.seed
                  << ": " << result.failure << "\n  " << result.flight.replay(true) << "\n";
        if (!result.flight.drawn) std::cout << "  " << result.flight.replay(false) << "\n";
    }
    if (failed > kMaxShown) std::cout << "\nand " << failed - kMaxShown << " more\n";
    return failed;
}

int campaign(const CampaignOptions& options) {
    try {
        mustBeUsable(options);
    } catch (const std::exception& error) {
        std::cerr << "campaign: " << error.what() << "\n";
        return 2;
    }
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    const auto begun = std::chrono::steady_clock::now();
    const auto flights = flightsOf(options);
    const auto results = flyAll(options, flights);
    const double wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const fs::path page = fs::path(options.out) / "campaign.html";
    std::cout << (options.drawn ? sharesText(sharesOf(results)) : tableText(results));
    if (options.drawn) std::cout << worstText(results);
    const size_t failed = reportFailures(results);
    std::cout << "\n" << flownText(results.size(), flights.size(), failed) << "\n";
    if (!results.empty()) std::cout << "any again: " << results.front().flight.replay(true) << "\n";
    try {
        writeFile(page, campaignPage(results, flights.size(), wall_s));
        writeFile(fs::path(options.out) / "campaign.json",
                  campaignJson(results, flights.size(), wall_s));
    } catch (const OutputError& error) {
        std::cerr << "campaign: " << error.what() << "\n";
        return 2;
    }
    std::cout << "page: " << page.string() << "\n";
    return failed == 0 && results.size() == flights.size() ? 0 : 1;
}

}  // namespace
}  // namespace simulator

int main(int count, char** words) {
    const auto parsed = simulator::parseCampaignOptions(count, words);
    return simulator::finishOutput(
        "campaign", parsed.exit_status ? *parsed.exit_status : simulator::campaign(parsed.options));
}
