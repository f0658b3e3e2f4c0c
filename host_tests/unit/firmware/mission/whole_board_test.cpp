// SPDX-License-Identifier: GPL-3.0-or-later
// Whole boards as versions of this firmware have left them, EEPROM and DataFlash: images/board_*.
// Whatever was stored there is found by the version that is flashed over it. What that is stands
// beside the image as text, a thing a line.
//
// UPGRADE_WRITE=PREFIX writes such a board: PREFIX.eeprom, .dataflash and .holds. Where a layout
// changes, the version before it and the new one each leave one.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

#include "firmware/app/dataflash.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/logger/log.hpp"
#include "firmware/safety/saved_home.hpp"
#include "hal/page_flash.hpp"
#include "mavlink/peer.hpp"
#include "mission_flight.hpp"
#include "points_rig.hpp"
#include "simulator/devices/at45db.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/index_store.hpp"

namespace firmware {
using namespace mission;
namespace {

using Bytes = std::vector<uint8_t>;
using Holds = std::map<std::string, std::string>;  // what, its value

constexpr uint8_t kFence = 1, kRally = 2;
// Key 1, 8, 15 and so on; PING by node-mavlink with it, and one that is half an
// hour too old.
constexpr uint64_t kSigned = 0x1f92d63ce000, kMinute = 60 * 100'000;
const Bytes kPing = {0xfd, 0x09, 0x01, 0x00, 0x05, 0xff, 0xbe, 0x04, 0x00, 0x00, 0x89, 0x67,
                     0x45, 0x23, 0x01, 0x00, 0x00, 0x00, 0x07, 0xab, 0x4a, 0x03, 0x00, 0xe0,
                     0x3c, 0xd6, 0x92, 0x1f, 0x13, 0x52, 0xf0, 0x0f, 0xf9, 0x75};
const Bytes kOldPing = {0xfd, 0x09, 0x01, 0x00, 0x05, 0xff, 0xbe, 0x04, 0x00, 0x00, 0x89, 0x67,
                        0x45, 0x23, 0x01, 0x00, 0x00, 0x00, 0x07, 0xab, 0x4a, 0x03, 0x00, 0xb6,
                        0xc7, 0xc0, 0x92, 0x1f, 0xf9, 0xcb, 0x8e, 0x6a, 0x00, 0x77};

std::filesystem::path images() { return std::filesystem::path(__FILE__).parent_path() / "images"; }

std::string hexOf(const uint8_t* bytes, size_t count) {
    std::ostringstream out;
    out << std::hex << std::setfill('0');
    for (size_t i = 0; i < count; ++i) out << std::setw(2) << +bytes[i];
    return out.str();
}
Bytes bytesOf(const std::string& digits) {
    Bytes bytes;
    for (size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes.push_back(static_cast<uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
    return bytes;
}
bool blank(const uint8_t* bytes, size_t count) {
    return std::all_of(bytes, bytes + count, [](uint8_t byte) { return byte == 0xFF; });
}

// Lines of a place in hex and the bytes there, where they are not blank.
void writeParts(const std::string& path, const Bytes& all, size_t part) {
    std::ofstream file(path);
    for (size_t at = 0; at < all.size(); at += part)
        if (!blank(&all[at], part))
            file << std::hex << at / part << ' ' << hexOf(&all[at], part) << '\n';
}
Bytes readParts(const std::filesystem::path& path, size_t size, size_t part) {
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    Bytes all(size, 0xFF);
    std::string digits;
    for (size_t at; file >> std::hex >> at >> digits;) {
        const Bytes bytes = bytesOf(digits);
        EXPECT_EQ(bytes.size(), part);
        std::copy(bytes.begin(), bytes.end(), all.begin() + static_cast<long>(at * part));
    }
    return all;
}

class WholeBoard : public Points {
protected:
    static constexpr size_t kRow = 32, kPage = 528, kPages = 8192;

    void SetUp() override {
        fakes::FlashBus::device = [this](uint8_t out) {
            return chip.transfer(out, fakes::time_us());
        };
        fakes::FlashBus::on_select = [this](bool low) { chip.select(low, fakes::time_us()); };
    }
    // As a start does it.
    void boot() {
        app::dataflashStart();
        settle(10);
        Rig::SetUp();
        mutable_vehicle.armed = false;
        logger::logStart();
        for (int i = 0; i < 1000; ++i)
            if (!logger::logFind()) fakes::advance_us(100);
        telemetryStart();
        settle(100);
    }
    static void settle(int tenths) {
        for (int i = 0; i < 5 * tenths; ++i) {
            fakes::advance_ms(20);
            if (i % 5 == 0) app::dataflashStep();
            if (missionReady()) missionRun();
            parametersRun();
            logger::runLog();
            telemetrySend();
            for (int k = 0; k < 200 && telemetryPump(); ++k) {
            }
        }
    }

    // ---- what is stored
    static void fill() {
        writeLog();
        logger::logErase();  // the ring begins elsewhere now
        settle(700);
        writeLog();
        writeLog();
        Items items = {takeoff()};
        for (int i = 1; i < 60; ++i) items.push_back(waypoint(20 * i, 60));
        items[7] = command(181, 0, 1);
        ASSERT_EQ(upload(items), MissionResult::accepted);
        Items fence;
        for (int corner = 0; corner < 4; ++corner)
            fence.push_back(placed(5001, corner < 2 ? 2000 : -2000,
                                   corner == 1 || corner == 2 ? 2000 : -2000, 0, 4));
        ASSERT_EQ(store(kFence, fence), MissionResult::accepted);
        ASSERT_EQ(store(kRally, {placed(5100, 200, 100, 60), placed(5100, -300, 50, 80)}),
                  MissionResult::accepted);
        storeKey();
        changeParameters();
        settle(200);
        ASSERT_TRUE(requestMode(Mode::automatic, ModeReason::ground));
        ASSERT_TRUE(missionSetCurrent(9));
        pass(3);
        ASSERT_EQ(safety::saveHome({473977000, 85456000}, 48800), core::Status::ok);
        settle(100);
    }
    static void writeLog() {
        mutable_vehicle.armed = true;
        settle(30);
        mutable_vehicle.armed = false;
        settle(20);
    }
    static void storeKey() {
        mavlink::SetupSigning message = {};
        message.target_system = message.target_component = 1;
        message.initial_timestamp = kSigned - 30 * kMinute;
        for (uint8_t i = 0; i < 32; ++i) message.secret_key[i] = static_cast<uint8_t>(i * 7 + 1);
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size = mavlink::encode({mavlink::Framing::v2, 0, 255, 190}, message, bytes);
        fakes::setUsb(true);
        settle(10);
        fakes::serial(hal::Port::link0).receive(Bytes(bytes, bytes + size));
        settle(20);
    }
    // Each to a value that is not its default, the calibrations' among them.
    static void changeParameters() {
        for (int slot = 0; slot < storage::kParameterSlots; ++slot) {
            float before, now;
            const auto number = static_cast<uint8_t>(slot);
            if (!parameterGet(number, before)) continue;
            const std::string name = nameOfSlot(number);
            if (name == "FORMAT_VERSION" || name == "SIGN_POLICY") continue;
            for (const float value :
                 {before + 1.5f, before + 1, before - 1, before / 2, before + 0.05f, -before}) {
                (void)parameterSet(number, value);
                settle(1);
                if (parameterGet(number, now) && now != before) break;
            }
        }
    }

    // ---- what is found
    static Holds found() {
        Holds holds;
        putParameters(holds);
        for (const auto& [kind, name] :
             std::map<ListKind, std::string>{{ListKind::mission, "mission"},
                                             {ListKind::fence, "fence"},
                                             {ListKind::rally, "rally"}}) {
            holds["id of the " + name] = std::to_string(listId(kind));
            for (uint8_t i = 0; i < listCount(kind); ++i) {
                uint8_t record[storage::kLargestRecord] = {};
                EXPECT_EQ(listRead(kind, i, record), core::Status::ok);
                holds[name + ' ' + std::to_string(i)] =
                    hexOf(record, storage::shapeOf(kind).record_size);
            }
        }
        putLogs(holds);
        return holds;
    }
    static void putParameters(Holds& holds) {
        for (int slot = 0; slot < storage::kParameterSlots; ++slot) {
            float value;
            if (!parameterGet(static_cast<uint8_t>(slot), value)) continue;
            std::ostringstream text;
            text << std::setprecision(9) << value;
            holds["parameter " + nameOfSlot(static_cast<uint8_t>(slot))] = text.str();
        }
    }
    static void putLogs(Holds& holds) {
        const auto& logs = logger::flight_logs;
        holds["newest log"] = std::to_string(logs.last());
        std::map<uint16_t, Bytes> all;
        for (uint16_t page = 0; page < logs.pages(); ++page) {
            logging::PageHead head;
            if (logs.readHead(page, head) != core::Status::ok) continue;
            Bytes& bytes = all[head.key.log];
            for (uint16_t at = 0; at < head.used; ++at) {
                uint8_t byte = 0;
                EXPECT_EQ(logs.read(page, at, &byte, 1), core::Status::ok);
                bytes.push_back(byte);
            }
        }
        for (const auto& [number, bytes] : all) {
            const auto crc =
                core::crc16(core::kCrcStart, bytes.data(), static_cast<uint16_t>(bytes.size()));
            holds["log " + std::to_string(number)] =
                std::to_string(bytes.size()) + " bytes, CRC " + std::to_string(crc);
        }
    }
    // What a start on the ground forgets: it is looked at beside one.
    static void putInFlight(Holds& holds) {
        safety::SavedHome home = {};
        if (safety::readHome(home) == core::Status::ok)
            holds["home"] = std::to_string(home.position.latitude_e7) + ' ' +
                            std::to_string(home.position.longitude_e7) + ' ' +
                            std::to_string(home.altitude_cm);
        storage::IndexStore store;
        uint8_t index = 0;
        bool damaged = false;
        const auto generation = static_cast<uint8_t>(mission_store.generation());
        EXPECT_EQ(store.open(generation, index, damaged), core::Status::ok);
        holds["goes on at item"] = std::to_string(index);
    }
    // By this version, which is started with them.
    Holds foundBy(const Bytes& cells, const Bytes& pages) {
        fakes::reset();
        SetUp();
        fakes::setEepromCells(cells);
        EXPECT_TRUE(chip.setImage(pages));
        boot();
        Holds holds = found();
        putKey(holds);
        fakes::setEepromCells(cells);
        putInFlight(holds);
        return holds;
    }
    static bool answers(const Bytes& frame) {
        auto& radio = fakes::serial(hal::Port::link1);
        radio.out.clear();
        radio.receive(frame);
        settle(10);
        mavlink::PeerParser parser;
        bool answered = false;
        for (const uint8_t byte : radio.out)
            for (bool whole = parser.put(byte); whole; whole = parser.next())
                answered |= parser.frame().id == mavlink::Wire<mavlink::Ping>::id;
        return answered;
    }
    static void putKey(Holds& holds) {
        Bytes wrong = kPing;
        wrong.back() ^= 1;
        if (!answers(wrong) && !answers(kOldPing) && answers(kPing))
            holds["key"] = "signed frames are obeyed that are newer";
    }

    simulator::At45db chip;
};

std::vector<std::string> boards() {
    std::vector<std::string> names;
    for (const auto& each : std::filesystem::directory_iterator(images()))
        if (each.path().extension() == ".holds") names.push_back(each.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Holds readHolds(const std::string& name) {
    std::ifstream file(images() / (name + ".holds"));
    Holds holds;
    for (std::string line; std::getline(file, line);) {
        const size_t colon = line.find(": ");
        holds[line.substr(0, colon)] = line.substr(colon + 2);
    }
    return holds;
}

// All of `wanted` in what is found.
void expectAll(const Holds& wanted, const Holds& found) {
    for (const auto& [what, value] : wanted) {
        const auto now = found.find(what);
        EXPECT_EQ(now == found.end() ? "gone" : now->second, value) << what;
    }
}

TEST_F(WholeBoard, keeps_all_that_it_holds_over_a_start) {
    boot();
    fill();
    const Bytes cells = fakes::eepromCells(), pages = chip.image(fakes::time_us());
    Holds holds = found();
    putInFlight(holds);
    putKey(holds);
    ASSERT_EQ(holds.count("home") + holds.count("key"), 2u);
    ASSERT_EQ(holds["newest log"], "2");
    ASSERT_EQ(holds["goes on at item"], "9");
    expectAll(holds, foundBy(cells, pages));
    const char* prefix = std::getenv("UPGRADE_WRITE");
    if (prefix == nullptr) return;
    writeParts(prefix + std::string(".eeprom"), cells, kRow);
    writeParts(prefix + std::string(".dataflash"), pages, kPage);
    std::ofstream file(prefix + std::string(".holds"));
    for (const auto& [what, value] : holds) file << what << ": " << value << '\n';
}

class Flashed : public WholeBoard, public testing::WithParamInterface<std::string> {};

TEST_P(Flashed, keeps_all_that_the_board_holds) {
    const Holds wanted = readHolds(GetParam());
    EXPECT_GT(wanted.size(), 250u);
    expectAll(wanted,
              foundBy(readParts(images() / (GetParam() + ".eeprom"), hal::kEepromSize, kRow),
                      readParts(images() / (GetParam() + ".dataflash"), kPages * kPage, kPage)));
}

INSTANTIATE_TEST_SUITE_P(Board, Flashed, testing::ValuesIn(boards()),
                         [](const auto& board) { return board.param; });

TEST_F(WholeBoard, of_the_present_layout_is_among_those) {
    const std::string layout = "board_layout" + std::to_string(storage::kLayoutVersion);
    const std::vector<std::string> all = boards();
    EXPECT_TRUE(std::any_of(
        all.begin(), all.end(),
        [&](const std::string& name) { return name.compare(0, layout.size(), layout) == 0; }))
        << layout << ": write one with UPGRADE_WRITE";
}

}  // namespace
}  // namespace firmware
