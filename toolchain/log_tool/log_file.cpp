// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/log_file.hpp"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "toolchain/log_tool/names.hpp"

namespace log_tool {
namespace {

template <class T>
T load(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

std::string print(const char* form, double value) {
    char text[40];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

template <class T>
Value whole(const uint8_t* at) {
    const T value = load<T>(at);
    return {static_cast<double>(value), std::to_string(value)};
}

template <class T>
Value scaled(const uint8_t* at, double scale, const char* form) {
    const double value = static_cast<double>(load<T>(at)) * scale;
    return {value, print(form, value)};
}

template <size_t N>
Value text(const uint8_t* at) {
    const char* letters = reinterpret_cast<const char*>(at);
    std::string shown(letters, strnlen(letters, N));
    for (char& letter : shown)
        if (letter < 32 || letter > 126) letter = '?';  // a terminal would execute it
    return {NAN, shown};
}

struct FieldType {
    char letter;
    size_t size;
    Value (*read)(const uint8_t* at);
};

constexpr FieldType kTypes[] = {
    {'b', 1, whole<int8_t>},
    {'B', 1, whole<uint8_t>},
    {'M', 1, whole<uint8_t>},
    {'h', 2, whole<int16_t>},
    {'H', 2, whole<uint16_t>},
    {'i', 4, whole<int32_t>},
    {'I', 4, whole<uint32_t>},
    {'q', 8, whole<int64_t>},
    {'Q', 8, whole<uint64_t>},
    {'c', 2, [](const uint8_t* at) { return scaled<int16_t>(at, 0.01, "%.2f"); }},
    {'C', 2, [](const uint8_t* at) { return scaled<uint16_t>(at, 0.01, "%.2f"); }},
    {'e', 4, [](const uint8_t* at) { return scaled<int32_t>(at, 0.01, "%.2f"); }},
    {'E', 4, [](const uint8_t* at) { return scaled<uint32_t>(at, 0.01, "%.2f"); }},
    {'L', 4, [](const uint8_t* at) { return scaled<int32_t>(at, 1e-7, "%.7f"); }},
    {'f', 4, [](const uint8_t* at) { return scaled<float>(at, 1, "%.7g"); }},
    {'d', 8, [](const uint8_t* at) { return scaled<double>(at, 1, "%.15g"); }},
    {'n', 4, text<4>},
    {'N', 16, text<16>},
    {'Z', 64, text<64>},
    {'a', 64,
     [](const uint8_t*) {
         return Value{NAN, ""};
     }},
};

const FieldType* typeOf(char letter) {
    for (const FieldType& type : kTypes)
        if (type.letter == letter) return &type;
    return nullptr;
}

constexpr int kFormat = 128;
constexpr size_t kHead = 3;

// 0: a letter is unknown.
size_t lengthOf(const std::string& fields) {
    size_t length = kHead;
    for (const char letter : fields) {
        const FieldType* type = typeOf(letter);
        if (type == nullptr) return 0;
        length += type->size;
    }
    return length;
}

std::vector<std::string> split(const std::string& labels) {
    std::vector<std::string> found;
    std::istringstream stream(labels);
    for (std::string label; std::getline(stream, label, ',');) found.push_back(label);
    return found;
}

Record recordAt(const uint8_t* at, const Kind& kind) {
    Record record{&kind, {}};
    at += kHead;
    for (const char letter : kind.fields) {
        const FieldType& type = *typeOf(letter);
        record.values.push_back(type.read(at));
        at += type.size;
    }
    return record;
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

}  // namespace

int Kind::column(const std::string& label) const {
    for (size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == label) return static_cast<int>(i);
    return -1;
}

double Record::operator[](const std::string& label) const {
    const int column = kind->column(label);
    return column < 0 ? NAN : values[static_cast<size_t>(column)].number;
}

std::string Record::text(const std::string& label) const {
    const int column = kind->column(label);
    return column < 0 ? "" : values[static_cast<size_t>(column)].text;
}

LogFile::LogFile(const Bytes& bytes) {
    kinds_[kFormat] = {"FMT", "BBnNZ", {"Type", "Length", "Name", "Format", "Columns"}, 89};
    for (size_t at = 0; at < bytes.size();) {
        const bool head = at + kHead <= bytes.size() && bytes[at] == 0xA3 && bytes[at + 1] == 0x95;
        const auto kind = head ? kinds_.find(bytes[at + 2]) : kinds_.end();
        if (kind == kinds_.end() || at + kind->second.length > bytes.size()) {
            ++at;
            ++skipped_;
            continue;
        }
        records_.push_back(recordAt(&bytes[at], kind->second));
        at += kind->second.length;
        if (kind->first == kFormat) learn(records_.back());
    }
}

// As ArduPilot has them. A name becomes a file's: it must not lead out of a folder.
bool LogFile::isName(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || (letter >= '0' && letter <= '9') ||
               (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
    });
}

// A format that is repeated, as in a log without its beginning, changes nothing.
void LogFile::learn(const Record& format) {
    const auto type = static_cast<int>(format["Type"]);
    const Kind kind = {format.text("Name"), format.text("Format"), split(format.text("Columns")),
                       static_cast<size_t>(format["Length"])};
    if (lengthOf(kind.fields) != kind.length || kind.labels.size() != kind.fields.size()) return;
    if (!isName(kind.name)) return;
    kinds_.emplace(type, kind);
}

std::vector<const Record*> LogFile::named(const std::string& name) const {
    std::vector<const Record*> found;
    for (const Record& record : records_)
        if (record.kind->name == name) found.push_back(&record);
    return found;
}

std::string csv(const LogFile& log, const Kind& kind) {
    std::string out;
    for (size_t i = 0; i < kind.labels.size(); ++i) out += (i == 0 ? "" : ",") + kind.labels[i];
    out += '\n';
    for (const Record& record : log.records()) {
        if (record.kind != &kind) continue;
        for (size_t i = 0; i < record.values.size(); ++i)
            out += (i == 0 ? "" : ",") + quoted(record.values[i].text);
        out += '\n';
    }
    return out;
}

namespace {

struct Range {
    double least = INFINITY, most = -INFINITY;
    void take(double value) {
        if (std::isnan(value)) return;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    bool any() const { return least <= most; }
};

Range rangeOf(const LogFile& log, const std::string& name, const std::string& label) {
    Range range;
    for (const Record* record : log.named(name)) range.take((*record)[label]);
    return range;
}

struct Line {
    const char *what, *name, *label, *form;
};

constexpr Line kLines[] = {
    {"height above home", "POS", "RelHomeAlt", "%.1f to %.1f m"},
    {"airspeed", "CTUN", "As", "%.1f to %.1f m/s"},
    {"ground speed", "GPS", "Spd", "%.1f to %.1f m/s"},
    {"roll", "ATT", "Roll", "%.1f to %.1f deg"},
    {"pitch", "ATT", "Pitch", "%.1f to %.1f deg"},
    {"battery", "BAT", "Volt", "%.2f to %.2f V"},
    {"used", "BAT", "CurrTot", "%.0f to %.0f mAh"},
    {"satellites", "GPS", "NSats", "%.0f to %.0f"},
    {"processor load", "PM", "Load", "%.0f to %.0f permille"},
    {"late frames", "PM", "NLon", "%.0f to %.0f"},
    {"records dropped", "PM", "LogDrop", "%.0f to %.0f"},
};

bool isListed(const std::string& kind) {
    constexpr const char* kListed[] = {"MSG", "MODE", "EV", "ERR", "LIST"};
    return std::any_of(std::begin(kListed), std::end(kListed),
                       [&](const char* each) { return kind == each; });
}

}  // namespace

std::string summary(const LogFile& log) {
    Range time_us;
    std::map<std::string, size_t> counts;
    for (const Record& record : log.records()) {
        time_us.take(record["TimeUS"]);
        ++counts[record.kind->name];
    }
    std::ostringstream out;
    char text[160];
    if (time_us.any()) {
        std::snprintf(text, sizeof text, "%-18s%.1f s, from %.1f s after the start\n", "time",
                      (time_us.most - time_us.least) * 1e-6, time_us.least * 1e-6);
        out << text;
    }
    for (const Line& line : kLines) {
        const Range range = rangeOf(log, line.name, line.label);
        if (!range.any()) continue;
        std::snprintf(text, sizeof text, line.form, range.least, range.most);
        char whole[220];
        std::snprintf(whole, sizeof whole, "%-18s%s\n", line.what, text);
        out << whole;
    }
    out << "records          ";
    for (const auto& [name, count] : counts) out << ' ' << name << ' ' << count;
    out << '\n';
    if (log.skippedBytes() > 0) out << "no record         " << log.skippedBytes() << " bytes\n";
    const Firmware firmware = firmwareOf(log);
    for (const Record& record : log.records()) {
        const std::string& name = record.kind->name;
        if (!isListed(name)) continue;
        std::snprintf(text, sizeof text, "%10.2f s  %-5s ", record["TimeUS"] * 1e-6, name.c_str());
        out << text << meaningOf(record, firmware) << '\n';
    }
    return out.str();
}

}  // namespace log_tool
