// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/board.hpp"

#include "fakes/fakes.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/state/parameters.hpp"
#include "storage/mission_store.hpp"
#include "storage/owner.hpp"
#include "toolchain/mission_tool/arduplane.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

using core::Status;
using firmware::mission::MissionResult;
using mission::Set;

constexpr int kTicks = 10'000;      // far more than a full upload takes
constexpr uint32_t kTurn_ms = 100;  // missionRun is called at 10 Hz

// The board's turns until the call is answered.
template <class Answer, class Call>
Answer whileBusy(Call call) {
    for (int turn = 0; turn < kTicks; ++turn) {
        const Answer answer = call();
        if (answer != Answer::busy) return answer;
        firmware::mission::missionRun();
        fakes::advance_ms(kTurn_ms);
    }
    throw WrongInput("the firmware's mission store does not answer");
}

void refuseForeign(const Image& image, const std::string& name) {
    storage::Owner owner = storage::Owner::blank;
    (void)whileBusy<Status>([&] { return storage::findOwner(owner); });
    if (owner == storage::Owner::ours || owner == storage::Owner::blank) return;
    const std::string maker = arduPlaneIn(image);
    if (!maker.empty()) throw WrongInput(name + ": " + maker);
    throw WrongInput(name + (owner == storage::Owner::other_version
                                 ? ": the EEPROM of another version of this firmware"
                                 : ": not an EEPROM of this firmware"));
}

void waitForBoot() {
    for (int turn = 0; turn < kTicks && !firmware::mission::missionReady(); ++turn)
        firmware::mission::missionRun();
}

void require(MissionResult result, const std::string& name, const char* what) {
    if (result == MissionResult::accepted) return;
    throw WrongInput(name + ": " + what + ": the firmware answers " +
                     std::to_string(static_cast<int>(result)) + " (MAV_MISSION_RESULT)");
}

// As a ground station uploads, except that the records come as they are stored: an item's floats
// do not hold every value of the APM 1.0 set.
void upload(const Document& document) {
    const auto count = static_cast<uint16_t>(document.entries.size());
    if (firmware::mission::missionCount() > 0) {
        require(whileBusy<MissionResult>(firmware::mission::missionClear), document.name, "clear");
    }
    firmware::state::parameters.mission_set = static_cast<int8_t>(document.set);
    require(whileBusy<MissionResult>([&] { return firmware::mission::missionBeginUpload(count); }),
            document.name, "upload");
    for (const Entry& entry : document.entries) {
        uint8_t bytes[mission::kRecordSize];
        mission::pack(document.set, entry.record, bytes);
        if (whileBusy<Status>([&] { return firmware::mission::missionUploadRecord(bytes); }) !=
            Status::ok) {
            throw WrongInput(document.name + ": the firmware's store refuses a record");
        }
    }
    require(whileBusy<MissionResult>(firmware::mission::missionCommit), document.name, "commit");
}

}  // namespace

void powerUp(const Image& image) {
    fakes::reset();
    fakes::setEepromCells(image);
    (void)whileBusy<Status>(firmware::state::parametersLoad);
    firmware::mission::missionBoot();
}

void boot(const Image& image, const std::string& name) {
    powerUp(image);
    refuseForeign(image, name);
    waitForBoot();
}

Document storedMission(const Image& image, const std::string& name) {
    powerUp(image);
    refuseForeign(image, name);
    storage::MissionStore store;
    for (Status status = Status::busy; status != Status::ok;) {
        storage::ListKind which;
        status = whileBusy<Status>([&] { return store.open(which); });
        if (which != storage::ListKind::mission) continue;
        if (status == Status::unsupported) {
            throw WrongInput(name +
                             ": the mission is still in the board's DataFlash: leave the "
                             "board on for half a minute and read its EEPROM again");
        }
        if (status != Status::ok) {
            throw WrongInput(name + ": the stored mission is damaged: its CRC does not match");
        }
    }
    if (store.count() == 0) throw WrongInput(name + ": no mission is stored in it");
    Document document;
    document.name = name;
    document.set = static_cast<Set>(store.set());
    if (document.set != Set::apm1 && document.set != Set::apm2) {
        throw WrongInput(name + ": the stored mission is in an unknown set");
    }
    document.entries.resize(store.count());
    for (uint8_t index = 0; index < store.count(); ++index) {
        uint8_t bytes[mission::kRecordSize] = {};
        (void)whileBusy<Status>([&] { return store.read(index, bytes); });
        document.entries[index].record = mission::unpack(document.set, bytes);
    }
    return document;
}

Image uploaded(const Document& document, const Image& onto, const std::string& onto_name) {
    boot(onto, onto_name);
    upload(document);
    return fakes::eepromCells();
}

}  // namespace mission_tool
