// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/load.hpp"

#include "simulator/ground/plan_file.hpp"
#include "simulator/ground/text_file.hpp"
#include "simulator/input_file.hpp"
#include "toolchain/mission_tool/arduplane.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/expectations.hpp"
#include "toolchain/mission_tool/text_form.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

Document fromImage(const std::string& contents, const std::string& name, const Reading& reading) {
    const Image image = imageOf(contents, name);
    Document document;
    if (reading.records15) {
        document = readRecords15(image, name, reading.count);
        powerUp(reading.onto);
    } else {
        document = storedMission(image, name);
    }
    checkAll(document);
    return document;
}

std::string textOf(const std::string& bytes, const std::string& name) {
    const std::string why = simulator::whyNoText(bytes);
    if (!why.empty()) throw WrongInput(name + ": " + why);
    return simulator::decodedText(bytes);
}

[[noreturn]] void refuseUnknown(const std::string& contents, const std::string& name) {
    const std::string kinds =
        "'QGC WPL 110', a .plan, 'APM 1.0', 'APM 2.0', Intel hex or a 4096-byte image";
    const std::string kind = simulator::foreignMission(contents);
    if (!kind.empty()) throw WrongInput(placed(name, 1, 1, "expected " + kinds + ", found " + kind));
    throw WrongInput(placed(
        name, 1, 1, expected(kinds, contents.substr(0, contents.find_first_of("\r\n")))));
}

}  // namespace

std::string readFile(const std::string& path) {
    auto contents = simulator::wholeFile(path);
    if (!contents) throw WrongInput(path + ": cannot be read");
    return *contents;
}

bool looksLikeGroundStations(const std::string& contents) {
    if (isImage(contents)) return false;
    const std::string text = simulator::decodedText(contents);
    return looksLikeWaypoints(text) || simulator::looksLikeJson(text);
}

bool isImage(const std::string& contents) {
    if (looksLikeHex(contents)) return true;
    if (contents.size() != blankImage().size()) return false;
    const std::string text = simulator::decodedText(contents);
    const bool json = simulator::looksLikeJson(text) && simulator::whyNoText(contents).empty();
    return !looksLikeWaypoints(text) && !looksLikeRecords(text) && !json;
}

Image imageOf(const std::string& contents, const std::string& name) {
    if (looksLikeHex(contents)) return parseHex(contents, name);
    if (contents.size() != blankImage().size()) {
        throw WrongInput(name + ": expected an image of 4096 bytes or Intel hex, found " +
                         std::to_string(contents.size()) + " bytes");
    }
    return {contents.begin(), contents.end()};
}

Document load(const std::string& bytes, const std::string& name, const Reading& reading) {
    Document document;
    powerUp(reading.onto);
    const bool is_image = isImage(bytes);
    if (!is_image && reading.prepare) reading.prepare();
    const std::string contents = is_image ? bytes : textOf(bytes, name);
    if (is_image) {
        document = fromImage(contents, name, reading);
    } else if (looksLikeWaypoints(contents)) {
        document = parseWaypointFile(contents, name, reading.set.value_or(mission::Set::apm2));
    } else if (looksLikeRecords(contents)) {
        document = parseRecords(contents, name);
    } else if (simulator::looksLikeJson(contents)) {
        document = parsePlan(contents, name, reading.set.value_or(mission::Set::apm2));
    } else {
        refuseUnknown(contents, name);
    }
    if (reading.set && *reading.set != document.set) {
        throw WrongInput(name + ": expected the set that --set names, found the other");
    }
    return document;
}

}  // namespace mission_tool
