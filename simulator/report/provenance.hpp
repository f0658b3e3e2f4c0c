// SPDX-License-Identifier: GPL-3.0-or-later
// Where a flight comes from, and the command that flies it again. Empty is not known.
#pragma once
#include <filesystem>
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

// Hash and date of the sources that the program was built of, which the build has left beside it
// (toolchain/cmake/commit.cmake). Unknown where they have no history.
void takeCommit(Provenance& provenance);
void takeCommit(Provenance& provenance, const std::filesystem::path& file);

}  // namespace simulator
