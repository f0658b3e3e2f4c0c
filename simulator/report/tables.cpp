// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simulator/devices/errors.hpp"
#include "simulator/report/chart.hpp"

namespace simulator {
namespace {

constexpr double kCycles_s = 16e6;

class Table {
public:
    explicit Table(const std::vector<std::string>& heads) {
        text_ = "<div class=\"wide\"><table><thead><tr>";
        for (const auto& head : heads) cell("th", head, &head != &heads.front());
        text_ += "</tr></thead><tbody>\n";
    }
    void row(const std::vector<std::string>& cells) {
        text_ += "<tr>";
        for (const auto& words : cells) cell("td", words, &words != &cells.front());
        text_ += "</tr>\n";
    }
    std::string done() const { return text_ + "</tbody></table></div>\n"; }

private:
    void cell(const std::string& tag, const std::string& words, bool number) {
        text_ += "<" + tag + (number ? " class=\"n\">" : ">") + escaped(words) + "</" + tag + ">";
    }
    std::string text_;
};

std::string number(double value, int decimals) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

// Vectors of the ATmega2560, datasheet table 14-1, counted from 0 = reset.
struct Vector {
    int number;
    const char* name;
};
constexpr Vector kVectors[] = {{1, "INT0"},
                               {7, "INT6 data ready"},
                               {12, "watchdog"},
                               {13, "timer 2 compare A"},
                               {14, "timer 2 compare B"},
                               {15, "timer 2 overflow"},
                               {16, "timer 1 capture"},
                               {17, "timer 1 compare A"},
                               {20, "timer 1 overflow"},
                               {21, "timer 0 compare A"},
                               {22, "timer 0 compare B"},
                               {23, "timer 0 overflow"},
                               {24, "SPI"},
                               {25, "USART0 receive"},
                               {26, "USART0 transmit"},
                               {27, "USART0 sent"},
                               {29, "ADC"},
                               {30, "EEPROM ready"},
                               {31, "timer 3 capture"},
                               {32, "timer 3 compare A"},
                               {35, "timer 3 overflow"},
                               {36, "USART1 receive"},
                               {37, "USART1 transmit"},
                               {38, "USART1 sent"},
                               {39, "TWI"},
                               {41, "timer 4 capture"},
                               {42, "timer 4 compare A"},
                               {45, "timer 4 overflow"},
                               {46, "timer 5 capture"},
                               {47, "timer 5 compare A"},
                               {48, "timer 5 compare B"},
                               {49, "timer 5 compare C"},
                               {50, "timer 5 overflow"},
                               {51, "USART2 receive"},
                               {52, "USART2 transmit"},
                               {53, "USART2 sent"}};

std::string vectorName(int vector) {
    const auto found = std::find_if(std::begin(kVectors), std::end(kVectors),
                                    [&](const Vector& v) { return v.number == vector; });
    return found == std::end(kVectors) ? "vector " + std::to_string(vector) : found->name;
}

struct Row {
    const char* name;
    std::optional<double> value;
    const char* unit;
    int decimals;
};

std::optional<double> share(const std::optional<double>& value) {
    return value ? std::optional<double>(*value * 100) : std::nullopt;
}

}  // namespace

std::string summaryTable(const Summary& s) {
    const BoardFigures& f = s.figures;
    // clang-format off
    const Row rows[] = {
        {"Touch-down from landing point",   s.landed_distance_m,     "m",    1},
        {"Stands from landing point",       s.standing_distance_m,   "m",    1},
        {"Flight time",                     s.flight_time_s,         "s",    1},
        {"Crosstrack, RMS",                 s.crosstrack_rms_m,      "m",    2},
        {"Crosstrack, largest",             s.crosstrack_max_m,      "m",    2},
        {"Altitude, RMS",                   s.altitude_rms_m,        "m",    2},
        {"Altitude, largest",               s.altitude_max_m,        "m",    2},
        {"Airspeed, RMS",                   s.airspeed_rms_mps,      "m/s",  2},
        {"Processor load",                  share(f.cpu_load),       "%",    1},
        {"of it interrupts",                share(f.interrupt_load), "%",    1},
        {"Frame, mean",                     f.frame_mean_us,         "µs",   0},
        {"Frame, 99 of 100",                f.frame_p99_us,          "µs",   0},
        {"Frame, longest",                  f.frame_max_us,          "µs",   0},
        {"Frames late",                     f.frame_overruns,        "",     0},
        {"Flash",                           f.flash_bytes,           "bytes", 0},
        {"Static RAM",                      f.ram_static_bytes,      "bytes", 0},
        {"Deepest stack seen",              f.stack_max_bytes,       "bytes", 0},
        {"Emulated time",                   s.emulated_s,            "s",    1},
        {"Speed over real time",            s.speedup,               "times", 1},
    };
    // clang-format on
    Table table({"", "value", "unit"});
    for (const Row& row : rows) {
        if (row.value) table.row({row.name, number(*row.value, row.decimals), row.unit});
    }
    return table.done();
}

std::string eventTable(const Summary& summary) {
    if (summary.events.empty()) return "";
    Table table({"event", "time, s"});
    for (const Event& event : summary.events) table.row({event.text, number(event.time_s, 1)});
    return table.done();
}

std::string taskTable(const BoardFigures& figures) {
    if (figures.tasks.empty()) return "";
    Table table({"task", "runs", "mean, µs", "longest, µs"});
    for (const auto& task : figures.tasks) {
        table.row({std::to_string(task.number), std::to_string(task.runs),
                   number(task.mean_cycles / 16, 1), number(task.max_cycles / 16.0, 1)});
    }
    return table.done();
}

std::string interruptTable(const BoardFigures& figures, double emulated_s) {
    if (figures.interrupts.empty()) return "";
    Table table({"interrupt", "runs", "mean, µs", "longest, µs", "load, %"});
    for (const auto& i : figures.interrupts) {
        if (i.runs == 0) continue;
        const auto cycles = static_cast<double>(i.cycles);
        table.row({vectorName(i.vector), std::to_string(i.runs),
                   number(cycles / static_cast<double>(i.runs) / 16, 1),
                   number(i.max_cycles / 16.0, 1),
                   number(cycles / (emulated_s * kCycles_s) * 100, 2)});
    }
    return table.done();
}

std::string errorTable() {
    const SensorErrors errors;
    Table table({"error", "value", "unit"});
    for (const ErrorRow& row : kErrorRows) {
        char text[32];
        std::snprintf(text, sizeof text, "%g", errors.*row.value);
        table.row({row.name, text, row.unit});
    }
    return table.done();
}

}  // namespace simulator
