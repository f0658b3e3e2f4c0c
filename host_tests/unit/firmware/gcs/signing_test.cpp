// SPDX-License-Identifier: GPL-3.0-or-later
// What is received: the radio is link1, `second`; USB is link0, `station`.
#include <algorithm>
#include <cstdlib>

#include "signing_ground.hpp"

namespace ground {
namespace {

TEST_F(Signing, without_a_key_everything_is_obeyed_as_it_was) {
    EXPECT_EQ(answers(kPublished), 1u);
    EXPECT_EQ(answers(kPublished), 1u);
    EXPECT_EQ(answers(signedPing(1, 3, keyOf(9))), 1u);
    EXPECT_EQ(ask<mavlink::Ping>(mavlink::Ping{}).size(), 1u);
}

TEST_F(Signing, the_signature_of_another_implementation_is_right) {
    setKey();
    EXPECT_EQ(answers(kPublished), 1u);
    for (size_t at = 10; at < kPublished.size(); ++at) {
        setKey(keyOf(), 0);  // else it were too old
        Bytes changed = kPublished;
        changed[at] ^= 0x10;
        EXPECT_EQ(answers(changed, 1500), 0u) << at;
    }
}

TEST_F(Signing, over_the_radio_nothing_unsigned_is_obeyed) {
    setKey();
    second.send(mavlink::Ping{});
    second.framing = Framing::v1;
    second.send(mavlink::Ping{});
    run_ms(100);
    EXPECT_TRUE(second.all<mavlink::Ping>().empty());
    EXPECT_EQ(answers(signedPing(kPublishedTime, 3, keyOf(9))), 0u) << "another key";
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
}

TEST_F(Signing, a_heartbeat_and_what_a_radio_says_need_no_signature) {
    setKey();
    const uint32_t before_ms = firmware::state::vehicle.ground_heard_ms;
    second.send(mavlink::Heartbeat{});
    mavlink::RadioStatus full = {};
    full.txbuf = 10;
    second.send(full);
    run_ms(100);
    EXPECT_GT(firmware::state::vehicle.ground_heard_ms, before_ms);
    EXPECT_GT(firmware::gcs::links[1].slowdown_pct, 0);
}

TEST_F(Signing, the_policy_says_what_unsigned_frames_may_do) {
    setKey();
    const auto overUsb = [this] { return ask<mavlink::Ping>(mavlink::Ping{}, 100).size(); };
    const auto overRadio = [this] {
        second.send(mavlink::Ping{});
        run_ms(100);
        return second.all<mavlink::Ping>().size();
    };
    EXPECT_EQ(firmware::state::parameters.sign_policy, 1);
    EXPECT_EQ(overUsb(), 1u);
    EXPECT_EQ(overRadio(), 0u);
    firmware::state::parameters.sign_policy = 2;
    EXPECT_EQ(overUsb(), 0u);
    EXPECT_EQ(overRadio(), 0u);
    firmware::state::parameters.sign_policy = 0;
    EXPECT_EQ(overUsb(), 1u);
    EXPECT_EQ(overRadio(), 1u);
}

TEST_F(Signing, nothing_is_heard_twice) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime - 1)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 1)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + (1 << 16))), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 2)), 0u);
}

TEST_F(Signing, a_new_stream_may_be_a_minute_behind) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime, 1)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime - kMinute - kSecond, 2)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime - kMinute + kSecond, 2)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime - kMinute + kSecond, 2)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 1, 1)), 1u) << "the first goes on";
}

TEST_F(Signing, what_gave_way_to_a_third_stream_is_not_heard_again) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime, 1)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kSecond, 2)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 2 * kSecond, 1, keyOf(), 254)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime, 1)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 3 * kSecond, 1)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kSecond, 2)), 0u);
}

TEST_F(Signing, nothing_is_heard_twice_over_a_restart) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kSecond)), 1u);
    restart();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kSecond, 9)), 0u);
    second.send(mavlink::Ping{});
    run_ms(100);
    EXPECT_TRUE(second.all<mavlink::Ping>().empty()) << "the key is still there";
    EXPECT_EQ(answers(signedPing(kPublishedTime + 40 * kSecond)), 1u) << "half a minute later";
}

TEST_F(Signing, the_time_is_written_once_in_half_a_minute) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
    const uint32_t before = fakes::eepromWrites();
    for (int i = 1; i < 250; ++i)
        EXPECT_EQ(answers(signedPing(kPublishedTime + static_cast<uint64_t>(i) * kSecond)), 1u);
    EXPECT_LE(fakes::eepromWrites() - before, 2u * 6 * 9) << "received, and that of what is sent";
}

TEST_F(Signing, a_time_whose_writing_was_cut_short_does_not_count) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
    const uint16_t times = storage::kSigning.begin + 34;
    for (uint16_t i = 0; i < 24; i += 6) {  // the one that was written gets noise in its top byte
        if (fakes::eepromCell(static_cast<uint16_t>(times + i + 3)) == 0) continue;
        fakes::setEepromCell(static_cast<uint16_t>(times + i + 3), 0xFF);
    }
    restart();
    EXPECT_EQ(answers(signedPing(kPublishedTime + 40 * kSecond)), 1u);
}

TEST_F(Signing, a_signature_may_come_late_or_not_at_all) {
    setKey();
    Bytes first = signedPing(kPublishedTime);
    const Bytes rest(first.end() - 9, first.end());
    first.resize(first.size() - 9);
    EXPECT_EQ(answers(first), 0u);
    EXPECT_EQ(answers(rest), 1u);
    EXPECT_EQ(answers(first, 2000), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kSecond)), 1u);
}

TEST_F(Signing, both_links_get_their_turn) {
    setKey();
    firmware::state::parameters.sign_policy = 2;
    station.line().receive(signedPing(kPublishedTime, 1));
    second.line().receive(signedPing(kPublishedTime, 2));
    run_ms(100);
    EXPECT_EQ(station.all<mavlink::Ping>().size(), 1u);
    EXPECT_EQ(second.all<mavlink::Ping>().size(), 1u);
}

TEST_F(Signing, a_signed_frame_behind_noise_is_found) {
    setKey();
    Bytes bytes = {0xfd, 30, 1, 0, 1, 255, 190, 4, 0, 0, 1, 2};
    const Bytes frame = signedPing(kPublishedTime);
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    bytes.insert(bytes.end(), 12, 0);
    EXPECT_EQ(answers(bytes, 2000), 1u);
}

TEST_F(Signing, a_key_comes_over_usb_and_disarmed_alone) {
    const Texts refused = {"Signing key refused: only over USB, disarmed"};
    second.send(setup(keyOf()));
    run_ms(500);
    EXPECT_EQ(second.texts(), refused);
    station.forget();
    firmware::state::mutable_vehicle.armed = true;
    station.send(setup(keyOf()));
    run_ms(500);
    EXPECT_EQ(station.texts(), refused);
    second.send(mavlink::Ping{});
    run_ms(100);
    EXPECT_EQ(second.all<mavlink::Ping>().size(), 1u) << "there is no key";
}

TEST_F(Signing, a_key_of_zeros_clears_and_leaves_nothing_behind) {
    setKey();
    firmware::state::parameters.sign_policy = 2;
    station.send(setup(Bytes(32, 0)));
    run_ms(1000);
    EXPECT_EQ(station.texts(), Texts{"Signing: no key"});
    second.send(mavlink::Ping{});
    run_ms(100);
    EXPECT_EQ(second.all<mavlink::Ping>().size(), 1u);
    for (uint16_t i = 0; i < 32; ++i)
        EXPECT_EQ(fakes::eepromCell(static_cast<uint16_t>(storage::kSigning.begin + i)), 0);
}

// After each the key holds and nothing is heard twice, or it is said. STORAGE_BITS=1 changes every
// bit; without it every seventh.
TEST_F(Signing, any_changed_or_worn_bit_of_what_is_stored_is_of_no_effect_or_reported) {
    const int step = std::getenv("STORAGE_BITS") != nullptr ? 1 : 7;
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 40 * kSecond)), 1u);
    const auto cells = fakes::eepromCells();
    startAgain();
    EXPECT_FALSE(saysDamaged());
    int flips = 0, reported = 0;
    for (int bit = 0; bit < 8 * storage::kSigning.size; bit += step) {
        const uint16_t at = static_cast<uint16_t>(storage::kSigning.begin + bit / 8);
        const uint8_t mask = static_cast<uint8_t>(1 << bit % 8);
        fakes::resetEeprom();
        fakes::setEepromCells(cells);
        fakes::wearEepromCell(at, mask, (cells[at] & mask) == 0);
        startAgain();
        const bool said = saysDamaged();
        second.forget();
        second.send(mavlink::Ping{});
        run_ms(100);
        ASSERT_TRUE(second.all<mavlink::Ping>().empty()) << at << ", " << bit << ": unsigned";
        const bool again = answers(signedPing(kPublishedTime + 40 * kSecond)) != 0;
        second.forget();
        const bool later = answers(signedPing(kPublishedTime + 3 * kMinute)) != 0;
        second.forget();
        ASSERT_TRUE((!again && later) || said) << at << ", " << bit;
        ++flips;
        reported += said;
    }
    EXPECT_LT(reported, flips) << "the mark's and the blanks'";
    printf("%d changed bits, %d of them reported, none silent\n", flips, reported);
}

TEST_F(Signing, a_key_of_the_first_boards_without_a_check_is_in_force) {
    setKey();
    fakes::setEepromCell(storage::kSigning.begin + 32, 0x5A);
    fakes::setEepromCell(storage::kSigning.begin + 33, 0xC3);
    for (uint16_t at = storage::kSigning.begin + 58; at < storage::kSigning.end(); ++at)
        fakes::setEepromCell(at, 0xFF);
    startAgain();
    EXPECT_FALSE(saysDamaged());
    second.forget();
    second.send(mavlink::Ping{});
    run_ms(100);
    EXPECT_TRUE(second.all<mavlink::Ping>().empty());
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
}

TEST_F(Signing, a_new_key_is_in_force_at_once_and_begins_at_its_time) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime + kMinute)), 1u);
    setKey(keyOf(9), kPublishedTime);
    EXPECT_EQ(answers(signedPing(kPublishedTime + 2 * kMinute)), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime - kSecond, 3, keyOf(9))), 0u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kSecond, 3, keyOf(9))), 1u);
}

TEST_F(Signing, a_slow_eeprom_takes_a_key_and_hears_on) {
    fakes::setEepromSlow(true);
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime), 500), 1u);
    EXPECT_EQ(answers(signedPing(kPublishedTime + kMinute), 500), 1u);
    run_ms(500);
    restart();
    EXPECT_EQ(answers(signedPing(kPublishedTime + kMinute), 500), 0u);
    station.send(setup(Bytes(32, 0)));
    run_ms(1500);
    EXPECT_EQ(station.texts(), Texts{"Signing: no key"});
}

TEST_F(Signing, the_policy_is_set_over_usb_alone) {
    mavlink::ParamSet message = {};
    message.target_system = message.target_component = 1;
    memcpy(message.param_id, "SIGN_POLICY", 11);
    message.param_value = 0;
    message.param_type = mavlink::MavParamType::int8;
    second.send(message);
    run_ms(100);
    EXPECT_EQ(firmware::state::parameters.sign_policy, 1);
    EXPECT_EQ(second.texts(), Texts{"Parameter refused: only over USB"});
    station.send(message);
    run_ms(100);
    EXPECT_EQ(firmware::state::parameters.sign_policy, 0);
    EXPECT_FALSE(firmware::state::parameterSlotTakes(174, 0)) << "a mission's command";
}

}  // namespace
}  // namespace ground
