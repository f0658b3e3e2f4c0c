// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/flight_provenance.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace simulator {
namespace {

// Where the results go is no part of the flight.
constexpr const char* kResults[] = {"--out", "--vcd", "--profile"};

bool isResult(const std::string& word) {
    return std::any_of(std::begin(kResults), std::end(kResults), [&](const std::string& option) {
        return word == option || word.rfind(option + "=", 0) == 0;
    });
}

std::vector<std::string> flightWords(const std::vector<std::string>& words) {
    std::vector<std::string> kept;
    for (size_t i = 0; i < words.size(); ++i) {
        if (!isResult(words[i]))
            kept.push_back(words[i]);
        else if (words[i].find('=') == std::string::npos)
            ++i;  // its value
    }
    return kept;
}

// As a shell takes it for one word.
std::string quoted(const std::string& word) {
    constexpr char kPlain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=@%+";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
    return text + "'";
}

std::string windText(const FlyOptions& options) {
    if (options.wind_mps <= 0) return options.gusts ? "gusts only" : "calm air";
    char text[64];
    std::snprintf(text, sizeof text, "wind %g m/s from %g°%s", options.wind_mps,
                  options.wind_from_deg, options.gusts ? " with gusts" : "");
    return text;
}

std::string spanText(const FaultSpan& span) {
    char text[64];
    std::snprintf(text, sizeof text, span.to_s < 1e9 ? "@%g-%g" : "@%g", span.from_s, span.to_s);
    return span.name + text;
}

}  // namespace

std::vector<FaultSpan> faultSpans(const std::vector<Fault>& faults) {
    std::vector<FaultSpan> spans;
    for (const Fault& fault : faults) spans.push_back({faultName(fault), fault.from_s, fault.to_s});
    return spans;
}

std::vector<std::string> faultTexts(const std::vector<Fault>& faults) {
    std::vector<std::string> texts;
    for (const FaultSpan& span : faultSpans(faults)) texts.push_back(spanText(span));
    return texts;
}

std::map<std::string, double> parametersOf(const ParameterSettings& settings,
                                           const std::map<std::string, double>& set) {
    std::map<std::string, double> all;
    for (const ParameterSetting& setting : settings) all[setting.name] = setting.value;
    for (const auto& [name, value] : set) {
        const auto known = all.find(name);
        const auto real = static_cast<float>(value);
        if (known != all.end() && static_cast<float>(known->second) == real) continue;
        char shortest[32];
        std::snprintf(shortest, sizeof shortest, "%.7g", value);
        all[name] = std::strtod(shortest, nullptr);
    }
    return all;
}

Provenance provenanceOf(const FlyOptions& options, const ParameterSettings& settings) {
    Provenance from;
    from.command = "toolchain/fly";
    from.options = flightWords(options.words);
    for (const std::string& word : *from.options) from.command += " " + quoted(word);
    from.mission = options.mission;
    from.airplane = options.airplane;
    from.board = options.apm1 ? "apm1" : "apm2";
    from.native = options.native;
    from.seed = options.seed;
    from.wind = windText(options);
    from.faults = faultTexts(options.faults);
    from.parameters = parametersOf(settings, {});
    takeCommit(from);
    return from;
}

}  // namespace simulator
