// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/plan_download.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "talking_board.hpp"

using namespace simulator;
using namespace simulator::live;

namespace {

class Download : public testing::Test {
protected:
    Download()
        : link(board, 0,
               [this](const mavlink::Frame& frame, uint64_t time_us) {
                   download.take(frame, time_us);
               }),
          download(link) {
        board.talks = false;
        board.listen([this](int, uint8_t byte, uint64_t time_us) { link.receive(byte, time_us); });
        board.lists[0] = {itemAt(0, 16, 47.3977, 8.5456, 488), itemAt(1, 22, 0, 0, 50),
                          itemAt(2, 16, 47.4, 8.55, 60)};
        board.lists[2] = {itemAt(0, 5100, 47.5, 8.5, 70)};
    }
    void run(double seconds) {
        const uint64_t end_us = board.time_us() + static_cast<uint64_t>(seconds * 1e6);
        for (; board.time_us() < end_us; board.runUntil(board.time_us() + 10'000))
            download.step(board.time_us(), 1, 1);
    }
    TalkingBoard board;
    Link link;
    PlanDownload download;
};

}  // namespace

TEST_F(Download, reads_all_three_lists) {
    EXPECT_FALSE(download.known(0));
    run(1);

    ASSERT_EQ(download.items(0).size(), 3u);
    EXPECT_NEAR(download.items(0)[2].latitude_deg, 47.4, 1e-6);
    EXPECT_EQ(download.items(0)[2].altitude_m, 60);
    EXPECT_EQ(download.items(0)[1].command, 22);
    EXPECT_TRUE(download.known(1));
    EXPECT_TRUE(download.items(1).empty());
    EXPECT_EQ(download.items(2).size(), 1u);
    EXPECT_EQ(download.changes(), 3u);
    EXPECT_FALSE(download.busy());
}

TEST_F(Download, asks_again_for_what_was_lost) {
    board.lose_items = 2;
    run(4);

    EXPECT_EQ(download.items(0).size(), 3u);
}

TEST_F(Download, gives_up_for_a_while_and_tries_anew) {
    board.lose_items = 6;
    run(6);
    EXPECT_FALSE(download.known(0));
    run(10);
    EXPECT_TRUE(download.known(0));
}

TEST_F(Download, counts_what_has_changed_alone) {
    run(1);
    download.askAgain();
    run(1);
    EXPECT_EQ(download.changes(), 3u);
    board.lists[0][2].altitude_m = 90;
    download.askAgain(0);
    run(1);
    EXPECT_EQ(download.changes(), 4u);
    EXPECT_EQ(download.items(0)[2].altitude_m, 90);
    board.lists[0].clear();
    download.askAgain(0);
    run(1);
    EXPECT_TRUE(download.items(0).empty());
}

TEST(SameItems, passes_over_what_is_no_number) {
    Waypoints a = {itemAt(0, 16, 47, 8, 488)}, b = a;
    a[0].params[3] = b[0].params[3] = std::nan("");

    EXPECT_TRUE(sameItems(a, b));
    b[0].params[3] = 0;
    EXPECT_FALSE(sameItems(a, b));
    EXPECT_FALSE(sameItems(a, {}));
}
