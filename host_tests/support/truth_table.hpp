// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions of two conditions and more as truth tables: for every combination of its conditions the
// decision is as wanted, and each condition alone turns it at least once (as MC/DC asks for).
#pragma once
#include <gtest/gtest.h>

#include <vector>

namespace bench {

using Bits = std::vector<bool>;
using Set = void (*)(bool holds);

// The conditions are set in their order, then what is taken is compared with what is wanted.
struct Decision {
    const char* what;
    std::vector<Set> conditions;
    bool (*taken)();
    bool (*wanted)(const Bits&);
};

inline bool all(const Bits& bits) {
    for (const bool bit : bits)
        if (!bit) return false;
    return true;
}
inline bool any(const Bits& bits) {
    for (const bool bit : bits)
        if (bit) return true;
    return false;
}

// Each row begins as a test of its own does, with the fixture's SetUp().
template <class Fixture>
class TruthTable : public Fixture {
protected:
    // Without MC/DC: for what one of its conditions is not to turn.
    std::vector<bool> table(const Decision& decision) {
        std::vector<bool> outcomes;
        for (uint32_t row = 0; row < 1u << decision.conditions.size(); ++row) {
            this->TearDown();
            this->SetUp();
            Bits bits;
            for (size_t i = 0; i < decision.conditions.size(); ++i) {
                bits.push_back((row & bitOf(i)) != 0);
                decision.conditions[i](bits[i]);
            }
            outcomes.push_back(decision.taken());
            EXPECT_EQ(outcomes.back(), decision.wanted(bits)) << decision.what << ", row " << row;
        }
        return outcomes;
    }
    void check(const std::vector<Decision>& decisions) {
        for (const Decision& decision : decisions) {
            const std::vector<bool> outcomes = table(decision);
            for (size_t i = 0; i < decision.conditions.size(); ++i)
                EXPECT_TRUE(turnsAlone(outcomes, i)) << decision.what << ", condition " << i;
        }
    }

private:
    static uint32_t bitOf(size_t condition) { return 1u << condition; }
    static bool turnsAlone(const std::vector<bool>& outcomes, size_t condition) {
        for (uint32_t row = 0; row < outcomes.size(); ++row)
            if (outcomes[row] != outcomes[row ^ bitOf(condition)]) return true;
        return false;
    }
};

}  // namespace bench
