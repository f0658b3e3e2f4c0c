// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/param_tool/settings.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

#include "simulator/ground/text_file.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace param_tool {
namespace {

using mission_tool::expected;
using mission_tool::placed;

constexpr char kSpace[] = " \t\r";
constexpr char kParting[] = " \t\r,";

struct Word {
    std::string text;
    int column;
};

// One comma may part two words; a second one is an empty word.
std::vector<Word> wordsOf(const std::string& line) {
    std::vector<Word> words;
    size_t at = line.find_first_not_of(kSpace);
    while (at != std::string::npos) {
        const size_t end = std::min(line.find_first_of(kParting, at), line.size());
        words.push_back({line.substr(at, end - at), static_cast<int>(at) + 1});
        at = line.find_first_not_of(kSpace, end);
        if (at != std::string::npos && line[at] == ',') at = line.find_first_not_of(kSpace, at + 1);
    }
    return words;
}

// A decimal number from its first letter to its last.
bool numberOf(const std::string& text, double& value) {
    const char* const begin = text.data() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(begin, end, value);
    return read.ec == std::errc() && read.ptr == end && std::isfinite(value);
}

}  // namespace

std::vector<Setting> parseSettings(const std::string& contents, const std::string& file,
                                   std::vector<Finding>& findings) {
    std::vector<Setting> settings;
    if (const std::string why = simulator::whyNoText(contents); !why.empty()) {
        findings.push_back({1, true, file + ": " + why});
        return settings;
    }
    std::istringstream lines(simulator::decodedText(contents));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const auto wrong = [&](int column, const std::string& what, const std::string& found) {
            findings.push_back({number, true, placed(file, number, column, expected(what, found))});
        };
        line.erase(std::min(line.find('#'), line.size()));
        line.erase(line.find_last_not_of(kSpace) + 1);
        const std::vector<Word> words = wordsOf(line);
        if (words.empty()) continue;
        const int behind = static_cast<int>(line.size()) + 1;
        double value = 0;
        if (words[0].text.empty()) {
            wrong(words[0].column, "the name of a parameter", ",");
        } else if (words.size() < 2) {
            wrong(behind, "a number behind the name", "");
        } else if (!numberOf(words[1].text, value)) {
            wrong(words[1].column, "a finite decimal number", words[1].text);
        } else if (words.size() > 2) {
            wrong(words[2].column, "the end of the line", words[2].text);
        } else {
            settings.push_back({words[0].text, value, number, words[0].column, words[1].column});
        }
    }
    return settings;
}

std::string spelled(float value) {
    char text[32];
    const float size = std::abs(value);
    const auto form = size == 0 || (size >= 1e-6f && size < 1e9f) ? std::chars_format::fixed
                                                                  : std::chars_format::scientific;
    const auto written = std::to_chars(text, text + sizeof text, value, form);
    return {text, written.ptr};
}

}  // namespace param_tool
