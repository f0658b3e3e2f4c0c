// SPDX-License-Identifier: GPL-3.0-or-later
// ORACLE_STEPS=n flies n passes instead of the usual number, ORACLE_SEED=n begins at another seed.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <map>

#include "trial.hpp"

namespace {

constexpr long kPasses = ORACLE_PASSES;

long fromEnvironment(const char* name, long otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::atol(text) : otherwise;
}

// How often each thing happened: what never happens is not tested.
class Said {
public:
    void add(std::string& said) {
        size_t at = 0;
        while (at < said.size()) {
            size_t end = said.find(' ', at);
            if (end == std::string::npos) end = said.size();
            ++words_[kindOf(said.substr(at, end - at))];
            at = end + 1;
        }
        said.clear();
    }
    void print() const {
        for (const auto& word : words_) printf("%s %ld  ", word.first.c_str(), word.second);
        printf("\n");
    }

private:
    static std::string kindOf(const std::string& word) {
        std::string kind;
        for (char c : word.substr(0, word.find('(')))
            if (c < '0' || c > '9') kind += c;
        return kind;
    }
    std::map<std::string, long> words_;
};

TEST(Oracle, and_engine_agree_on_every_step_of_random_missions) {
    const long wanted = fromEnvironment("ORACLE_STEPS", kPasses);
    auto seed = static_cast<uint64_t>(fromEnvironment("ORACLE_SEED", 1));
    long passes = 0, flights = 0;
    std::string said;
    Said counted;
    const auto begin = std::chrono::steady_clock::now();
    for (; passes < wanted; ++seed, ++flights) {
        const oracle::Trial trial = oracle::randomTrial(seed);
        if (oracle::fly(trial, &said, &passes).empty()) {
            counted.add(said);
            continue;
        }
        const oracle::Trial least = oracle::minimise(trial);
        FAIL() << "ORACLE_SEED=" << seed << "\n" << readable(least) << oracle::fly(least);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    printf("%ld passes of %ld flights, %.0f passes a second\n", passes, flights,
           static_cast<double>(passes) / took.count());
    counted.print();
}

}  // namespace
