// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string contentsOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// No file of this process may grow beyond so many bytes, as on a full disk.
class DiskWith {
public:
    explicit DiskWith(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit = {bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~DiskWith() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_ = {};
};

struct OutputFile : testing::Test {
    const fs::path folder = fs::path(testing::TempDir()) / "output_file_test";
    const fs::path file = folder / "eeprom.bin";
    void SetUp() override {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
};

TEST_F(OutputFile, replaces_what_the_file_held) {
    simulator::writeFile(file, "old");
    simulator::writeFile(file, "new");

    EXPECT_EQ(contentsOf(file), "new");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(OutputFile, keeps_the_old_contents_when_the_disk_is_full) {
    simulator::writeFile(file, "old");
    {
        const DiskWith full(100);
        EXPECT_THROW(simulator::writeFile(file, std::string(4096, 'x')), simulator::OutputError);
    }
    EXPECT_EQ(contentsOf(file), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(OutputFile, a_device_is_written_as_it_is) {
    EXPECT_NO_THROW(simulator::writeFile("/dev/null", "x"));
    EXPECT_THROW(simulator::writeFile("/dev/full", "x"), simulator::OutputError);
    EXPECT_FALSE(fs::exists("/dev/full.new"));
}

}  // namespace
