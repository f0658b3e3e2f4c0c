// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/bus.hpp"

namespace fakes {

std::deque<uint8_t> Bus::replies;
std::function<uint8_t(int, uint8_t)> Bus::device;
std::vector<Transaction> Bus::transactions;
bool Bus::is_fast = false;
int Bus::locks = 0;
int Bus::locks_taken = 0;
int Bus::selected = -1;
int Bus::clashes = 0;

uint8_t Bus::transfer(uint8_t out) {
    if (selected < 0) {
        ++clashes;
    } else {
        Transaction& now = transactions.back();
        now.sent.push_back(out);
        now.fast = is_fast;
        now.locked = now.locked && locks > 0;
    }
    if (device) return device(selected, out);
    if (replies.empty()) return 0;
    const uint8_t in = replies.front();
    replies.pop_front();
    return in;
}

void Bus::reply(std::initializer_list<uint8_t> bytes) {
    replies.insert(replies.end(), bytes.begin(), bytes.end());
}

void Bus::select(int pin) {
    if (selected >= 0) ++clashes;
    selected = pin;
    transactions.push_back({pin, {}, is_fast, true});
}

void Bus::release(int pin) {
    if (selected == pin) selected = -1;
}

void Bus::reset() {
    replies.clear();
    device = nullptr;
    transactions.clear();
    is_fast = false;
    locks = locks_taken = clashes = 0;
    selected = -1;
}

}  // namespace fakes
