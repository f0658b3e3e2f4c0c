// SPDX-License-Identifier: GPL-3.0-or-later
// JSON in which every object and list knows where it stands in the text.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace simulator {

using Json = nlohmann::ordered_json;

struct TextPlace {
    int line = 1, column = 1;
};

class PlacedJson {
public:
    // Not JSON: root() is discarded, and problem() says what is wrong at problemPlace().
    explicit PlacedJson(const std::string& text);
    PlacedJson(const PlacedJson&) = delete;  // it remembers addresses
    PlacedJson& operator=(const PlacedJson&) = delete;

    const Json& root() const { return root_; }
    const std::string& problem() const { return problem_; }
    TextPlace problemPlace() const { return problem_place_; }
    // Of an object or a list of this document; the beginning of the text for all else.
    TextPlace placeOf(const Json& value) const;

private:
    Json root_;
    std::map<const Json*, TextPlace> places_;
    std::string problem_;
    TextPlace problem_place_;
};

}  // namespace simulator
