// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged input of every kind: the program ends with an answer, whatever it is given. Runs under
// the sanitizers, too.
#include <random>

#include "rig.hpp"

namespace param_tool {
namespace {

constexpr char kGood[] =
    "#NOTE: a plane\r\nWP_RADIUS,42\nTHR_MAX 80\nRC1_REV\t-1\nTECS_TIME_CONST,2.5 # s\n";
constexpr const char* kPieces[] = {",",  ",,", "\n", "#", "nan",     "1e308",
                                   "-",  "\t", "\r", " ", "RC1_MIN", "9999999999999999999999",
                                   "0x1"};

std::string damaged(std::mt19937& random) {
    std::string text = kGood;
    for (int times = 1 + static_cast<int>(random() % 4); times > 0; --times) {
        const size_t at = random() % (text.size() + 1);
        switch (random() % 4) {
            case 0:
                text.insert(at, kPieces[random() % std::size(kPieces)]);
                break;
            case 1:
                text.insert(at, 1, static_cast<char>(random()));
                break;
            case 2:
                text.erase(at, random() % 8);
                break;
            default:
                text.resize(at);
        }
    }
    return text;
}

TEST_F(ParamTool, answers_whatever_a_text_holds) {
    std::mt19937 random(7);
    powerUp(mission_tool::blankImage(), "");
    int taken = 0, refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::vector<Finding> findings;
        const std::string text = damaged(random);
        set(parseSettings(text, "f", findings), "f", {}, findings);
        bool wrong = false;
        for (const Finding& finding : findings) {
            wrong |= finding.error;
            EXPECT_EQ(finding.text.rfind("f:", 0), 0u);
            for (const char c : finding.text) ASSERT_TRUE(c >= 32 && c < 127) << finding.text;
        }
        ++(wrong ? refused : taken);
        for (const Parameter& p : parameters())
            ASSERT_TRUE(p.value >= p.lowest && p.value <= p.highest) << p.name;
    }
    EXPECT_GT(taken, 1000);
    EXPECT_GT(refused, 1000);
}

TEST_F(ParamTool, answers_whatever_a_file_holds) {
    std::mt19937 random(8);
    for (int i = 0; i < 300; ++i) {
        std::string bytes(random() % 3 == 0 ? 4096 : random() % 6000, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        if (random() % 4 == 0) bytes = ':' + bytes;
        const std::string name = file("g", bytes);
        for (const char* command : {"check", "decode", "show"}) {
            const int status = param({command, name});
            ASSERT_TRUE(status == 0 || status == 1);
            ASSERT_EQ(err_.empty(), status == 0);
        }
    }
}

TEST_F(ParamTool, reads_a_damaged_image_of_ours_as_the_firmware_would) {
    ASSERT_EQ(param({"compile", file("a.param", kGood), "-o", path("a.bin")}), 0) << err_;
    const std::string good = mission_tool::readFile(path("a.bin"));
    std::mt19937 random(9);
    for (int i = 0; i < 300; ++i) {
        std::string bytes = good;
        for (int times = 0; times < 20; ++times)
            bytes[16 + random() % (bytes.size() - 16)] = static_cast<char>(random());
        const std::string name = file("b.bin", bytes);
        ASSERT_EQ(param({"decode", name}), 0) << err_;
        for (const Parameter& p : parameters())
            ASSERT_TRUE(p.value >= p.lowest && p.value <= p.highest) << p.name;
    }
}

}  // namespace
}  // namespace param_tool
