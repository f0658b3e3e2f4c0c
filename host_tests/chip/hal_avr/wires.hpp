// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tests find the servo outputs and the receiver on the chip of each board. The same
// programs and the same tests run on both; CHIP_BOARD names the one that is tested.
#pragma once

namespace wires {

struct Output {
    char timer;
    int compare;  // 0 is A
};

// clang-format off
namespace apm2 {
constexpr Output kServos[8] = {{'1', 1}, {'1', 0}, {'4', 2}, {'4', 1},
                               {'4', 0}, {'3', 2}, {'3', 1}, {'3', 0}};
constexpr char kReceiverTimer = '5';
constexpr int kReceiverVector = 46;
}  // namespace apm2

// The receiver is captured by the timer that two of the outputs share.
namespace apm1 {
constexpr Output kServos[8] = {{'5', 1}, {'5', 2}, {'1', 1}, {'1', 2},
                               {'4', 2}, {'4', 1}, {'3', 2}, {'3', 1}};
constexpr char kReceiverTimer = '4';
constexpr int kReceiverVector = 41;
}  // namespace apm1
// clang-format on

using namespace CHIP_BOARD;

}  // namespace wires
