// SPDX-License-Identifier: GPL-3.0-or-later
// A flight log as its records: read from the bytes of a .bin file by the formats it brings along.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace log_tool {

using Bytes = std::vector<uint8_t>;

struct Value {
    double number = 0;
    std::string text;  // as it is printed
};

struct Kind {
    std::string name;
    std::string fields;  // a letter each
    std::vector<std::string> labels;
    size_t length = 0;

    int column(const std::string& label) const;  // -1: none
};

struct Record {
    const Kind* kind;
    std::vector<Value> values;

    // NaN: it has no such field.
    double operator[](const std::string& label) const;
    std::string text(const std::string& label) const;
};

class LogFile {
public:
    // What is no record is passed over and counted.
    explicit LogFile(const Bytes& bytes);
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

    const std::vector<Record>& records() const { return records_; }
    const std::map<int, Kind>& kinds() const { return kinds_; }
    std::vector<const Record*> named(const std::string& name) const;
    size_t skippedBytes() const { return skipped_; }

private:
    void learn(const Record& format);
    static bool isName(const std::string& name);

    std::map<int, Kind> kinds_;  // by type
    std::vector<Record> records_;
    size_t skipped_ = 0;
};

std::string csv(const LogFile& log, const Kind& kind);
std::string summary(const LogFile& log);

}  // namespace log_tool
