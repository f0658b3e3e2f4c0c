// SPDX-License-Identifier: GPL-3.0-or-later
// Where a flight comes from, and the command that flies it again. Empty is not known.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simulator {

struct Provenance {
    std::string command, mission, airplane, board, wind, log;
    std::optional<uint64_t> seed;
    bool native = false;
    std::optional<std::vector<std::string>> faults, options;  // as on the command line
    std::optional<std::map<std::string, double>> parameters;  // changed; of a log all
    std::string firmware, commit, date;                       // date: of the commit, ISO 8601
    std::optional<double> flash_bytes, ram_bytes;
};

std::string provenanceJson(const Provenance& provenance);

// What toolchain/fly has put into the environment: APM_COMMIT, "HASH DATE", of the sources that it
// has built. A program that is run without it does not know.
void takeCommit(Provenance& provenance);

}  // namespace simulator
