// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/notify/text_queue.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/file_state.hpp"

using namespace firmware::notify;

namespace {

constexpr uint8_t kLinkReader = 0, kOtherLink = 1;

class TextQueue : public testing::Test {
protected:
    void SetUp() override { core::resetFileStates(); }

    // All that wait for the reader, taken.
    static std::vector<std::string> taken(uint8_t reader) {
        std::vector<std::string> texts;
        Severity severity;
        char text[kTextSize + 1] = {};
        while (readText(reader, severity, text)) {
            texts.emplace_back(text);
            textTaken(reader);
        }
        return texts;
    }
    static void say(int count) {
        for (int i = 0; i < count; ++i) sendStatusText(Severity::info, STATUS_TEXT("text #"), i);
    }
};

}  // namespace

TEST_F(TextQueue, keeps_a_text_until_every_reader_that_listens_has_taken_it) {
    setTextReader(kLogReader, true);
    say(1);
    EXPECT_EQ(taken(kLinkReader).size(), 1u);
    EXPECT_TRUE(textWaits(kOtherLink));
    EXPECT_TRUE(textWaits(kLogReader));
    EXPECT_FALSE(textWaits(kLinkReader));
    EXPECT_EQ(taken(kOtherLink), std::vector<std::string>{"text 0"});
    EXPECT_EQ(taken(kLogReader), std::vector<std::string>{"text 0"});
}

// The DataFlash fails with the queue full of what both links have sent: it was full for ever.
TEST_F(TextQueue, goes_on_when_the_log_stops_listening_while_it_is_full) {
    setTextReader(kLogReader, true);
    say(20);
    for (const uint8_t link : {kLinkReader, kOtherLink}) (void)taken(link);
    setTextReader(kLogReader, false);
    say(1);
    const auto texts = taken(kLinkReader);
    ASSERT_FALSE(texts.empty());
    EXPECT_EQ(texts[0], "text 0");
}

TEST_F(TextQueue, gives_the_log_nothing_that_was_said_before_it_listens) {
    say(2);
    setTextReader(kLogReader, true);
    EXPECT_FALSE(textWaits(kLogReader));
}
