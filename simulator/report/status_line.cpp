// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/status_line.hpp"

#include <cstdarg>
#include <cstdio>

namespace simulator {

constexpr double kTerminalEvery_s = 0.1, kFileEvery_s = 30;

__attribute__((format(printf, 1, 2))) static std::string print(const char* format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

std::string statusText(const Telemetry& telemetry, const Sample& sample, size_t items,
                       double speedup, std::optional<double> cpu_load) {
    std::string line = print("%6.1f s  x%-5.1f", sample.time_s, speedup);
    if (!telemetry.heard()) return line + " no heartbeat yet";
    line += print(" %-10s item %2d/%-2zu", modeName(telemetry.mode()).c_str(), telemetry.current(),
                  items);
    if (sample.height_m) line += print("  %5.1f m", *sample.height_m);
    if (sample.airspeed_mps) line += print("  %4.1f m/s", *sample.airspeed_mps);
    const bool under_way = sample.item > 0 && sample.distance_m.value_or(0) > 0;  // not a take-off
    if (under_way) line += print("  %4.0f m to go", *sample.distance_m);
    if (cpu_load) line += print("  CPU %4.1f %%", *cpu_load * 100);
    return line;
}

bool StatusLine::due(double emulated_s, double wall_s) {
    const double now_s = terminal_ ? wall_s : emulated_s;
    if (now_s - shown_s_ < (terminal_ ? kTerminalEvery_s : kFileEvery_s)) return false;
    shown_s_ = now_s;
    return true;
}

void StatusLine::show(const Board& board, const Telemetry& telemetry, const Sample& sample,
                      size_t items, double wall_s) {
    if (!due(sample.time_s, wall_s)) return;
    const std::string line =
        statusText(telemetry, sample, items, sample.time_s / wall_s, board.figures().cpu_load);
    std::printf(terminal_ ? "\r\x1b[K%s" : "%s\n", line.c_str());
    std::fflush(stdout);
    line_open_ = terminal_;
}

void StatusLine::end() {
    if (line_open_) std::printf("\n");
    line_open_ = false;
}

std::string closingWords(const Summary& s) {
    std::string words = s.completed ? "mission completed" : "not completed: " + s.reason;
    words += "\n";
    if (s.flight_time_s) words += print("  flight time     %.0f s\n", *s.flight_time_s);
    if (s.landed_distance_m) {
        words += print("  touch-down      %.1f m from the landing point", *s.landed_distance_m);
        if (s.standing_distance_m) words += print(", stands at %.1f m", *s.standing_distance_m);
        words += "\n";
    }
    if (s.crosstrack_rms_m) {
        words += print("  crosstrack      %.2f m RMS, %.2f m at most\n", *s.crosstrack_rms_m,
                       s.crosstrack_max_m.value_or(0));
    }
    if (s.altitude_rms_m) words += print("  altitude        %.2f m RMS\n", *s.altitude_rms_m);
    if (s.airspeed_rms_mps) words += print("  airspeed        %.2f m/s RMS\n", *s.airspeed_rms_mps);
    if (s.figures.cpu_load) {
        words += print("  processor       %.1f %% busy", *s.figures.cpu_load * 100);
        if (s.figures.frame_max_us)
            words += print(", longest frame %u us", *s.figures.frame_max_us);
        if (s.figures.frame_overruns) words += print(", %u late", *s.figures.frame_overruns);
        words += "\n";
    }
    if (s.model_answers_skipped > 0)
        words += print("  flight model    %llu answers skipped: not understood\n",
                       static_cast<unsigned long long>(s.model_answers_skipped));
    if (s.model_begun_anew > 0)
        words += print("  flight model    begun anew %llu times in flight\n",
                       static_cast<unsigned long long>(s.model_begun_anew));
    return words + print("  emulated        %.1f min at %.1f times real time\n", s.emulated_s / 60,
                         s.speedup.value_or(0));
}

std::string reportLine(const std::string& folder) {
    return "  report          " + folder + "/report.html\n";
}

}  // namespace simulator
