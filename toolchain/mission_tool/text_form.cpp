// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/text_form.hpp"

#include <array>
#include <cstdlib>
#include <sstream>

#include "toolchain/mission_tool/expectations.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

using mission::Set;

constexpr char kSpace[] = " \t\r";
constexpr char kHeaders[][8] = {"APM 1.0", "APM 2.0"};

std::string withoutComment(const std::string& line) {
    std::string text = line.substr(0, line.find('#'));
    text.erase(text.find_last_not_of(kSpace) + 1);
    return text;
}

class Words {
public:
    Words(const std::string& text, const std::string& name, int line)
        : text_(text), name_(name), line_(line) {}

    int64_t number(const std::string& what, int base, int64_t lowest, int64_t highest) {
        const std::string word = next();
        char* rest = nullptr;
        const bool plain = word.find('x') == std::string::npos || base == 16;
        const int64_t value = std::strtoll(word.c_str(), &rest, base);
        if (word.empty() || *rest != 0 || !plain || value < lowest || value > highest) {
            fail(what, word);
        }
        return value;
    }
    void end() {
        const std::string word = next();
        if (!word.empty()) fail("the end of the line", word);
    }
    int column() const { return static_cast<int>(at_) + 1; }

private:
    std::string next() {
        at_ = std::min(text_.find_first_not_of(kSpace, end_), text_.size());
        end_ = std::min(text_.find_first_of(kSpace, at_), text_.size());
        return text_.substr(at_, end_ - at_);
    }
    [[noreturn]] void fail(const std::string& what, const std::string& found) const {
        throw WrongInput(placed(name_, line_, column(), expected(what, found)));
    }

    const std::string& text_;
    const std::string& name_;
    int line_;
    size_t at_ = 0, end_ = 0;
};

struct Columns {
    int id, options;
    std::array<int, 5> p;  // by number, from 1
};

Entry parseLine(Words& words, Set set, Columns& columns) {
    Entry entry;
    mission::Record& record = entry.record;
    record.id = static_cast<uint8_t>(words.number("the id of a command, 0x00 to 0xFF", 16, 0, 255));
    columns.id = words.column();
    const bool apm2 = set == Set::apm2;
    if (apm2) {
        record.options = static_cast<uint8_t>(words.number("options, 0 to 255", 10, 0, 255));
        columns.options = words.column();
    }
    record.p1 = static_cast<uint8_t>(words.number("p1, 0 to 255", 10, 0, 255));
    columns.p[1] = words.column();
    int32_t* const wide[] = {&record.p2, &record.p3, &record.p4};
    for (size_t i = 0; i < 3; ++i) {
        const int64_t highest = apm2 && i == 0 ? mission::kLargestP2 : INT32_MAX;
        const std::string what = 'p' + std::to_string(i + 2) + ", " + std::to_string(-highest - 1) +
                                 " to " + std::to_string(highest);
        *wide[i] = static_cast<int32_t>(words.number(what, 10, -highest - 1, highest));
        columns.p[i + 2] = words.column();
    }
    words.end();
    return entry;
}

std::string hexOf(uint8_t id) {
    char text[8];
    std::snprintf(text, sizeof text, "0x%02X", id);
    return text;
}

void explain(const Document& document, Entry& entry, const Columns& columns) {
    const int parameter = refusedParameter(entry.result);
    const int field = parameter != 0 ? fieldOf(document.set, entry.row, parameter) : 0;
    entry.column = field != 0 ? columns.p[static_cast<size_t>(field)] : columns.id;
    if (entry.result == firmware::mission::MissionResult::unsupported_frame)
        entry.column = columns.options;
    entry.problem = expected(expectation(document.set, entry), foundInstead(document.set, entry));
}

}  // namespace

bool looksLikeRecords(const std::string& contents) { return contents.rfind("APM ", 0) == 0; }

Document parseRecords(const std::string& contents, const std::string& name) {
    Document document;
    document.name = name;
    std::istringstream lines(contents);
    std::string line;
    std::getline(lines, line);
    line = withoutComment(line);
    if (line != kHeaders[0] && line != kHeaders[1]) {
        throw WrongInput(placed(name, 1, 1, expected("'APM 1.0' or 'APM 2.0'", line)));
    }
    document.set = line == kHeaders[0] ? Set::apm1 : Set::apm2;
    std::vector<Columns> columns;
    std::vector<LineProblem> problems;
    int number = 1;
    while (std::getline(lines, line)) {
        ++number;
        const std::string text = withoutComment(line);
        if (text.find_first_not_of(kSpace) == std::string::npos) continue;
        Words words(text, name, number);
        columns.push_back({});
        try {
            document.entries.push_back(parseLine(words, document.set, columns.back()));
            document.entries.back().column = columns.back().id;
        } catch (const WrongInput& error) {
            problems.push_back({number, words.column(), error.what()});
            document.entries.push_back({});
        }
        document.entries.back().line = number;
    }
    const bool readable = problems.empty();
    if (document.entries.empty()) {
        throw WrongInput(placed(name, number + 1, 1, expected("a command: home comes first", "")));
    }
    const size_t count = document.entries.size();
    for (size_t i = 0; i < count; ++i) {
        Entry& entry = document.entries[i];
        const bool read = entry.column != 0;  // else its line's problem is known
        if (read &&
            check(document.set, i, count, entry) != firmware::mission::MissionResult::accepted) {
            explain(document, entry, columns[i]);
            if (!readable)
                problems.push_back({entry.line, entry.column, document.at(i, entry.problem)});
        }
    }
    if (!readable) throwProblems(problems);
    return document;
}

std::string recordsAsText(const Document& document) {
    const bool apm2 = document.set == Set::apm2;
    std::ostringstream text;
    text << kHeaders[apm2] << "\n# id" << (apm2 ? "\toptions" : "") << "\tp1\tp2\tp3\tp4\n";
    for (size_t i = 0; i < document.entries.size(); ++i) {
        const Entry& entry = document.entries[i];
        const mission::Record& record = entry.record;
        text << hexOf(record.id);
        if (apm2) text << '\t' << int(record.options);
        text << '\t' << int(record.p1) << '\t' << record.p2 << '\t' << record.p3 << '\t'
             << record.p4 << "\t# " << i << ' ' << (i == 0 ? "home" : nameOf(entry));
        if (!entry.good()) text << ": " << entry.problem;
        text << '\n';
    }
    return text.str();
}

}  // namespace mission_tool
