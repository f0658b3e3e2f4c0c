// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/page.hpp"

#include <stdexcept>

#include "simulator/report/page_bytes.hpp"

namespace simulator {
namespace {

std::string replaced(std::string_view page, const std::string& what, const std::string& by) {
    const size_t at = page.find(what);
    if (at == page.npos) throw std::logic_error("the page has no place for " + what);
    return std::string(page.substr(0, at)) + by + std::string(page.substr(at + what.size()));
}

// No text in it may end the element.
std::string inElement(const std::string& json) {
    std::string text;
    text.reserve(json.size());
    for (const char letter : json) {
        if (letter == '<')
            text += "\\u003c";
        else
            text += letter;
    }
    return text;
}

std::string withDocument(std::string_view page, const std::string& id, const std::string& json) {
    const std::string element = "<script type=\"application/json\" id=\"" + id + "\">";
    return replaced(page, element + "{}", element + inElement(json));
}

}  // namespace

std::string flightPage(const FlightDocument& document) {
    return withDocument(flightPageTemplate(), "flight", flightJson(document));
}

std::string livePage() {
    const std::string source = "<meta name=\"source\" content=\"";
    return replaced(flightPageTemplate(), source + "document", source + "live");
}

std::string campaignPageOf(const std::string& json) {
    return withDocument(campaignPageTemplate(), "campaign", json);
}

}  // namespace simulator
