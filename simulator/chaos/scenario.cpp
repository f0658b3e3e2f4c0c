// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/scenario.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

#include "simulator/devices/faults.hpp"

namespace simulator::chaos {
namespace {

const Conditions kUsual;

// How many words an event has at least, its name included.
const std::map<std::string, size_t> kWords = {
    {"fault", 3},       {"restart", 2},   {"sticks", 5},  {"switch", 2},
    {"transmitter", 2}, {"usb", 2},       {"param", 4},   {"mode", 3},
    {"command", 10},    {"override", 10}, {"current", 3}, {"count", 3},
    {"clear", 2},       {"item", 12},     {"frame", 4},   {"noise", 3},
};

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string textOf(const WaypointItem& item) {
    std::string line = "item " + std::to_string(item.command) + " " + std::to_string(item.frame);
    for (const double value : item.params) line += " " + number(value);
    char place[80];
    std::snprintf(place, sizeof place, " %.7f %.7f %s", item.latitude_deg, item.longitude_deg,
                  number(item.altitude_m).c_str());
    return line + place;
}

std::string textOf(const Place& place) {
    char text[60];
    std::snprintf(text, sizeof text, " %.7f %.7f", place.latitude_deg, place.longitude_deg);
    return text;
}

std::string textOf(const Fence& fence) {
    std::string text;
    for (const FenceArea& area : fence.areas) {
        text += std::string("zone ") + (area.inclusion ? "in " : "out ") + number(area.radius_m);
        for (const Place& corner : area.rim) text += textOf(corner);
        text += "\n";
    }
    if (fence.way_back) text += "return" + textOf(*fence.way_back) + "\n";
    return text;
}

[[noreturn]] void wrong(int line, const std::string& why) {
    throw ScenarioError("line " + std::to_string(line) + ": " + why);
}

class Reader {
public:
    explicit Reader(const std::string& text) : lines_(text) {}

    Scenario read() {
        for (std::string line; std::getline(lines_, line);) {
            ++number_;
            std::istringstream words(line.substr(0, line.find('#')));
            std::string first;
            if (words >> first) take(first, words);
        }
        if (scenario_.mission.empty()) wrong(number_, "there is no mission");
        std::stable_sort(scenario_.events.begin(), scenario_.events.end(),
                         [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
        return scenario_;
    }

private:
    template <class Value>
    void get(std::istringstream& words, Value& value) {
        if (!(words >> value)) wrong(number_, "a value is missing");
    }
    void take(const std::string& first, std::istringstream& words) {
        Scenario& s = scenario_;
        if (first == "airplane") return get(words, s.airplane);
        if (first == "wind") return get(words, s.wind_mps), get(words, s.wind_from_deg);
        if (first == "gusts") return get(words, s.gusts);
        if (first == "seed") return get(words, s.seed);
        if (first == "begins") return get(words, s.begins_s);
        if (first == "seconds") return get(words, s.seconds);
        if (first == "item") return item(words);
        if (first == "zone") return zone(words);
        if (first == "return") return get(words, s.fence.way_back.emplace());
        if (first == "at") return event(words);
        for (const Condition& each : kConditions)
            if (first == each.name) return get(words, s.conditions.*each.value);
        wrong(number_, "unknown: " + first);
    }
    void get(std::istringstream& words, Place& place) {
        get(words, place.latitude_deg);
        get(words, place.longitude_deg);
    }
    // Its radius, or 0 and the corners of a polygon.
    void zone(std::istringstream& words) {
        FenceArea area;
        std::string side;
        get(words, side);
        if (side != "in" && side != "out") wrong(number_, "a zone is in or out");
        area.inclusion = side == "in";
        get(words, area.radius_m);
        do get(words, area.rim.emplace_back());
        while (words >> std::ws && !words.eof());
        const size_t size = area.rim.size();
        if (area.isCircle() ? size != 1 : size < 3) wrong(number_, "no circle and no polygon");
        scenario_.fence.areas.push_back(area);
    }
    void item(std::istringstream& words) {
        WaypointItem item;
        unsigned command = 0, frame = 0;
        get(words, command);
        get(words, frame);
        item.command = static_cast<uint16_t>(command);
        item.frame = static_cast<uint8_t>(frame);
        for (double& value : item.params) get(words, value);
        get(words, item.latitude_deg);
        get(words, item.longitude_deg);
        get(words, item.altitude_m);
        item.index = static_cast<int>(scenario_.mission.size());
        item.current = item.index == 0;
        scenario_.mission.push_back(item);
    }
    void event(std::istringstream& words) {
        Event event;
        get(words, event.at_s);
        for (std::string word; words >> word;) event.words.push_back(word);
        if (event.words.empty()) wrong(number_, "what happens?");
        const auto known = kWords.find(event.kind());
        if (known == kWords.end()) wrong(number_, "unknown event: " + event.kind());
        if (event.words.size() < known->second) wrong(number_, "too few words: " + event.kind());
        scenario_.events.push_back(event);
    }

    std::istringstream lines_;
    int number_ = 0;
    Scenario scenario_;
};

}  // namespace

const std::vector<Condition> kConditions = {
    {"tube", &Conditions::tube, false},
    {"gps_latency", &Conditions::gps_latency_s, false},
    {"board_warmth", &Conditions::board_warmth_c, false},
    {"board_warmth_start", &Conditions::board_warmth_start_c, false},
    {"band_gap", &Conditions::band_gap_v, false},
    {"worn_cells", &Conditions::worn_cells, false},
    {"bootloader", &Conditions::bootloader, false},
    {"declination", &Conditions::declination_deg, true},
    {"inclination", &Conditions::inclination_deg, true},
    {"magnetic_field", &Conditions::magnetic_field_mg, true},
};

std::string textOf(const Event& event) {
    char time[40];
    std::snprintf(time, sizeof time, "at %.2f", event.at_s);
    std::string line = time;
    for (const std::string& word : event.words) line += " " + word;
    return line;
}

std::string textOf(const Scenario& s) {
    std::string text = "airplane " + s.airplane + "\nwind " + number(s.wind_mps) + " " +
                       number(s.wind_from_deg) + "\ngusts " + (s.gusts ? "1" : "0") + "\nseed " +
                       std::to_string(s.seed) + "\nbegins " + number(s.begins_s) + "\nseconds " +
                       number(s.seconds) + "\n";
    for (const Condition& each : kConditions)
        if (s.conditions.*each.value != kUsual.*each.value)
            text += std::string(each.name) + " " + number(s.conditions.*each.value) + "\n";
    for (const WaypointItem& item : s.mission) text += textOf(item) + "\n";
    text += textOf(s.fence);
    for (const Event& event : s.events) text += textOf(event) + "\n";
    return text;
}

Scenario parseScenario(const std::string& text) { return Reader(text).read(); }

// Sensors but the inertial one fail, two at a time at most and not in the take-off; the transmitter
// is lost; the processor restarts by itself while all else is well. Whatever is only read, and
// noise on a link, does nothing. More wind than these airplanes take off and land in is no promise.
namespace {
// The inertial sensor, or the bus it is on: then the pilot flies, by MANUAL.
bool failsInertial(const std::string& fault) {
    return fault.rfind("imu", 0) == 0 || fault.rfind("spi", 0) == 0;
}
}  // namespace

bool promisesToSurvive(const Scenario& scenario) {
    constexpr double kMaxWind_mps = 7;
    if (scenario.wind_mps > kMaxWind_mps) return false;
    const double take_off_s = 50 + scenario.begins_s;
    constexpr double kAlone_s = 20;
    struct Span {
        double from_s, to_s;
        bool restart;
    };
    std::vector<Span> spans;
    for (const Event& event : scenario.events) {
        const std::string& kind = event.kind();
        if (kind == "noise" || kind == "transmitter" || kind == "usb") continue;
        if (event.at_s < take_off_s) return false;
        if (kind == "fault") {
            if (failsInertial(event.words[1])) return false;
            spans.push_back({event.at_s, event.at_s + std::stod(event.words[2]) + 10, false});
        } else if (kind == "restart" && event.words[1] != "button") {
            spans.push_back({event.at_s - kAlone_s, event.at_s + kAlone_s, true});
        } else {
            return false;
        }
    }
    for (const Span& one : spans) {
        size_t at_once = 0;
        for (const Span& other : spans) {
            const bool both = other.from_s < one.to_s && one.from_s < other.to_s;
            if (both && &one != &other && (one.restart || other.restart)) return false;
            at_once += both;
        }
        if (at_once > 2) return false;
    }
    return true;
}

}  // namespace simulator::chaos
