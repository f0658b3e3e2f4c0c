// SPDX-License-Identifier: GPL-3.0-or-later
// A program run as its user runs it, for tests of command lines.
#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>

namespace program_run {

struct Outcome {
    int status;
    std::string output;  // both streams
};

inline Outcome runCommand(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    Outcome run{0, ""};
    std::array<char, 256> part;
    while (fgets(part.data(), part.size(), pipe)) run.output += part.data();
    run.status = WEXITSTATUS(pclose(pipe));
    return run;
}

inline Outcome run(const std::string& program, const std::string& arguments) {
    return runCommand(program + " " + arguments + " 2>&1 </dev/null");
}

// With a standard output that takes nothing, as on a full disk: the output is what stderr says.
inline Outcome runOnFullDisk(const std::string& program, const std::string& arguments) {
    return runCommand(program + " " + arguments + " 2>&1 >/dev/full </dev/null");
}

inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

// Arguments that are refused, and what the line that says so contains.
struct Wrong {
    const char* arguments;
    const char* says;
};
inline void PrintTo(const Wrong& wrong, std::ostream* to) { *to << wrong.arguments; }

}  // namespace program_run
