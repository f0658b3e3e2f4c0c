// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes into a reader of the mission tool, FUZZ_READER by its name: waypoints, plan, records
// (the text form), image (Intel hex, 15-byte records) or eeprom (this firmware's). Whatever they
// were: every item is good or has words that say why not, and what is written of a good mission is
// read back as the same records.
#include <stdlib.h>
#include <string.h>

#include <algorithm>

#include "fakes/fakes.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/state/parameters.hpp"
#include "simulator/ground/plan_file.hpp"
#include "storage/mission_store.hpp"
#include "toolchain/mission_tool/arduplane.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/expectations.hpp"
#include "toolchain/mission_tool/findings.hpp"
#include "toolchain/mission_tool/table.hpp"
#include "toolchain/mission_tool/text_form.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace {

using namespace mission_tool;
using mission::Set;

void require(bool holds) {
    if (!holds) abort();
}

using Bytes = std::vector<uint8_t>;
Bytes packed(const Document& document) {
    Bytes all;
    for (const Entry& entry : document.entries) {
        uint8_t bytes[mission::kRecordSize];
        mission::pack(document.set, entry.record, bytes);
        all.insert(all.end(), bytes, bytes + sizeof bytes);
    }
    return all;
}

void readBack(const Document& document, const std::string& text) {
    const Document again = looksLikeWaypoints(text) ? parseWaypointFile(text, "again", document.set)
                           : simulator::looksLikeJson(text) ? parsePlan(text, "again", document.set)
                                                            : parseRecords(text, "again");
    require(packed(again) == packed(document));
}

void digest(const Document& document) {
    bool good = true;
    for (const Entry& entry : document.entries) {
        require(entry.good() == (entry.result == firmware::mission::MissionResult::accepted));
        good = good && entry.good();
    }
    const std::string text = recordsAsText(document), waypoints = recordsAsWaypoints(document),
                      plan = good ? recordsAsPlan(document) : "";
    if (good) readBack(document, text);
    if (good && !waypoints.empty()) readBack(document, waypoints);
    if (good && !plan.empty()) readBack(document, plan);
    (void)findings(document);
    require(!tableOf(document).empty());
}

void readWaypointFile(const uint8_t* bytes, size_t size) {
    const Set set = size > 0 && bytes[size - 1] == '!' ? Set::apm1 : Set::apm2;
    const auto* text = reinterpret_cast<const char*>(bytes);
    digest(parseWaypointFile(std::string(text, size), "fuzz", set));
}

void readPlan(const uint8_t* bytes, size_t size) {
    digest(parsePlan(std::string(reinterpret_cast<const char*>(bytes), size), "fuzz", Set::apm2));
}

void readText(const uint8_t* bytes, size_t size) {
    digest(parseRecords(std::string(reinterpret_cast<const char*>(bytes), size), "fuzz"));
}

void laid(Image& over, size_t at, const uint8_t* bytes, size_t size) {
    std::copy_n(bytes, std::min(size, over.size() - at), over.begin() + static_cast<long>(at));
}

void decode(const Image& image) {
    Document document = storedMission(image, "fuzz");
    checkAll(document);
    digest(document);
}

void readRecords15(const uint8_t* bytes, size_t size) {
    constexpr size_t kFirst = 0x500;
    Image image = blankImage();
    laid(image, kFirst, bytes + 1, size - 1);
    Document document = mission_tool::readRecords15(image, "fuzz", bytes[0] % 8);
    checkAll(document);
    digest(document);
    require(packed(mission_tool::readRecords15(writeRecords15(document, blankImage()), "fuzz",
                                               document.entries.size())) == packed(document));
}

// What a board that was blank has in its EEPROM when it has started.
const Image& startedImage() {
    static const Image image = [] {
        boot(blankImage(), "fuzz");
        return fakes::eepromCells();
    }();
    return image;
}

// Records with a head and a CRC that are right: any bytes as a mission that was stored. The store
// alone does that, decode() starts the board.
Image storedAs(uint8_t set, const uint8_t* bytes, size_t size) {
    const Image& before = startedImage();
    fakes::reset();
    fakes::setEepromCells(before);
    storage::MissionStore store;
    for (storage::ListKind which; store.open(which) != core::Status::ok;) {
    }
    const auto count = static_cast<uint8_t>(std::min<size_t>(size / mission::kRecordSize, 20));
    require(store.begin(count, set) == core::Status::ok);
    for (uint8_t i = 0; i < count; ++i, bytes += mission::kRecordSize)
        require(store.put(bytes) == core::Status::ok);
    while (store.commit() == core::Status::busy) {
    }
    return fakes::eepromCells();
}

const Image& goodImage() {
    static const Image image = uploaded(parseRecords("APM 1.0\n0x10 0 40000 470000000 80000000\n"
                                                     "0x10 30 6000 470100000 80000000\n",
                                                     "good"),
                                        blankImage(), "");
    return image;
}

void readImage(const uint8_t* bytes, size_t size) {
    if (size < 2) return;
    if (bytes[0] != ':') return readRecords15(bytes, size);
    (void)parseHex({reinterpret_cast<const char*>(bytes), size}, "fuzz");
}

// Of this firmware's own: what was stored, or a good one in which some bytes are others.
void readEeprom(const uint8_t* bytes, size_t size) {
    if (size <= mission::kRecordSize) return;
    if (bytes[0] < 0x80) {
        const auto set = static_cast<uint8_t>(1 + bytes[0] % 3);
        return decode(storedAs(set, bytes + 1, size - 1));
    }
    Image image = goodImage();
    laid(image, (bytes[1] * 256u + bytes[2]) % image.size(), bytes + 3, size - 3);
    decode(image);
}

const struct {
    const char* name;
    void (*read)(const uint8_t* bytes, size_t size);
} kReaders[] = {{"waypoints", readWaypointFile},
                {"plan", readPlan},
                {"records", readText},
                {"image", readImage},
                {"eeprom", readEeprom}};

void (*reader)(const uint8_t* bytes, size_t size);

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    const char* wanted = getenv("FUZZ_READER");
    for (const auto& each : kReaders)
        if (wanted != nullptr && strcmp(each.name, wanted) == 0) reader = each.read;
    require(reader != nullptr);
    powerUp(blankImage());
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    try {
        reader(bytes, size);
    } catch (const WrongInput& error) {
        require(error.what()[0] != 0);
    }
    return 0;
}
