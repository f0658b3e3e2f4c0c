// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says while it flies and at the end. On a terminal one line is rewritten; into
// a file or a pipe goes a line for every 30 emulated seconds.
#pragma once
#include <string>

#include "simulator/board.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

class StatusLine {
public:
    explicit StatusLine(bool terminal) : terminal_(terminal) {}
    void show(const Board& board, const Telemetry& telemetry, const Sample& sample, size_t items,
              double wall_s);
    void end();

private:
    bool due(double emulated_s, double wall_s);

    const bool terminal_;
    double shown_s_ = 0;
    bool line_open_ = false;
};

std::string statusText(const Telemetry& telemetry, const Sample& sample, size_t items,
                       double speedup, std::optional<double> cpu_load);
std::string closingWords(const Summary& summary);
std::string reportLine(const std::string& folder);  // when all of the report is written

}  // namespace simulator
