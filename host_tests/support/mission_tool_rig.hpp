// SPDX-License-Identifier: GPL-3.0-or-later
// Missions as texts, and the tool's program with files of its own.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/expectations.hpp"
#include "toolchain/mission_tool/findings.hpp"
#include "toolchain/mission_tool/load.hpp"
#include "toolchain/mission_tool/program.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {

constexpr char kTwoWaypoints[] =
    "QGC WPL 110\n"
    "0\t1\t0\t16\t0\t0\t0\t0\t47.0\t8.0\t400\t1\n"
    "1\t0\t3\t16\t0\t30\t0\t0\t47.01\t8.0\t60\t1\n"
    "2\t0\t3\t16\t0\t30\t0\t0\t47.02\t8.0\t60\t1\n";

// Two waypoints and, between them, this: frame command p1 p2 p3 p4 latitude longitude altitude.
inline std::string between(const std::string& item) {
    return std::string("QGC WPL 110\n") + "0 1 0 16 0 0 0 0 47 8 400 1\n" +
           "1 0 3 16 0 30 0 0 47.01 8 60 1\n" + "2 0 " + item + " 1\n" +
           "3 0 3 16 0 30 0 0 47.02 8 60 1\n";
}
// Home, and these records of the APM 1.0 set.
inline std::string apm1(const std::string& lines) {
    return "APM 1.0\n0x10 0 40000 470000000 80000000\n" + lines;
}

inline Document loaded(const std::string& contents, const std::string& name = "m") {
    Reading reading;
    reading.onto = blankImage();
    return load(contents, name, reading);
}
inline Image compiled(const std::string& contents) {
    return uploaded(loaded(contents), blankImage(), "");
}

inline std::string refusalOf(const std::string& contents) {
    try {
        const Document document = loaded(contents);
        for (const Finding& finding : findings(document))
            if (finding.error) return document.at(finding.index, finding.text);
    } catch (const WrongInput& error) {
        return error.what();
    }
    return "";
}
inline std::string warningsOf(const std::string& contents) {
    std::string all;
    for (const Finding& finding : findings(loaded(contents)))
        all += (finding.error ? "error " : "") + std::to_string(finding.index) + ": " +
               finding.text + '\n';
    return all;
}

class Tool : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("mission_tool." +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string file(const std::string& name, const std::string& contents) const {
        std::ofstream(path(name), std::ios::binary) << contents;
        return path(name);
    }
    int tool(const std::vector<std::string>& words) {
        std::ostringstream out, err;
        const int status = run(words, out, err);
        out_ = out.str();
        err_ = err.str();
        return status;
    }

    std::filesystem::path folder_;
    std::string out_, err_;
};

}  // namespace mission_tool
