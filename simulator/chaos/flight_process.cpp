// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <sstream>
#include <utility>

#include "simulator/chaos/outcome.hpp"

namespace simulator::chaos {
namespace {

constexpr unsigned kLongest_s = 600;  // of the computer's time, then it is taken for hung

std::string written(const Outcome& outcome) {
    std::ostringstream text;
    text << "end " << outcome.emulated_s << " " << outcome.airborne << " " << outcome.crashed
         << "\n";
    for (const auto& each : outcome.violations)
        text << "violation " << each.time_s << " " << each.name << " " << each.numbers << "\n";
    return text.str();
}

Outcome readOutcome(const std::string& text, bool& whole) {
    Outcome outcome;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        if (first == "end") {
            words >> outcome.emulated_s >> outcome.airborne >> outcome.crashed;
            whole = true;
        } else if (first == "violation") {
            invariants::Violation each;
            words >> each.time_s >> each.name;
            std::getline(words >> std::ws, each.numbers);
            outcome.violations.push_back(each);
        }
    }
    return outcome;
}

[[noreturn]] void flyAndEnd(const Scenario& scenario, const std::string& firmware, int to) {
    alarm(kLongest_s);
    std::string text;
    try {
        text = written(flyScenario(scenario, firmware, false));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "chaos: %s\n", error.what());
        _exit(2);
    }
    for (size_t at = 0; at < text.size();) {
        const ssize_t count = write(to, text.data() + at, text.size() - at);
        if (count <= 0) _exit(2);
        at += static_cast<size_t>(count);
    }
    _exit(0);
}

}  // namespace

FlightProcess::FlightProcess(const Scenario& scenario, const std::string& firmware) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process");
    if (pid_ == 0) {
        close(ends[0]);
        flyAndEnd(scenario, firmware, ends[1]);
    }
    close(ends[1]);
    from_ = ends[0];
}

FlightProcess::FlightProcess(FlightProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), from_(std::exchange(other.from_, -1)) {}

FlightProcess::~FlightProcess() {
    if (from_ >= 0) close(from_);
}

// What it had to say fits into the pipe.
Outcome FlightProcess::take(int status) {
    std::string text;
    char part[4096];
    for (ssize_t count; (count = read(from_, part, sizeof part)) > 0;)
        text.append(part, static_cast<size_t>(count));
    bool whole = false;
    Outcome outcome = readOutcome(text, whole);
    if (WIFSIGNALED(status))
        outcome.violations.push_back({0,
                                      WTERMSIG(status) == SIGALRM ? "program_hung" : "program_died",
                                      "signal " + std::to_string(WTERMSIG(status))});
    else if (!whole)
        outcome.violations.push_back({0, "program_died", "without an outcome"});
    return outcome;
}

Outcome FlightProcess::wait() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    return take(status);
}

}  // namespace simulator::chaos
