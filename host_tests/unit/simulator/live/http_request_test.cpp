// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/http_request.hpp"

#include <gmock/gmock.h>

#include <random>

using namespace simulator::live;

namespace {

const std::string kGet = "GET /live?x=1 HTTP/1.1\r\nHost: 127.0.0.1:5770\r\nAccept:  */* \r\n\r\n";
const std::string kPost =
    "POST /command HTTP/1.1\r\nHost: localhost:1\r\nContent-Length: 4\r\n\r\nbody";

int errorOf(const std::string& bytes) {
    RequestParser parser;
    EXPECT_FALSE(parser.put(bytes)) << bytes.substr(0, 60);
    return parser.error();
}

std::string withHeaders(const std::string& lines) { return "GET / HTTP/1.1\r\n" + lines + "\r\n"; }

struct Bad {
    std::string bytes;
    int status;
};
class BadRequest : public testing::TestWithParam<Bad> {};

}  // namespace

TEST(RequestParser, reads_line_and_headers) {
    RequestParser parser;

    ASSERT_TRUE(parser.put(kGet));
    EXPECT_EQ(parser.request().method, "GET");
    EXPECT_EQ(parser.request().path, "/live");
    EXPECT_EQ(parser.request().header("host"), "127.0.0.1:5770");
    EXPECT_EQ(parser.request().header("accept"), "*/*");
    EXPECT_EQ(parser.request().header("origin"), "");
    EXPECT_TRUE(parser.request().keep_alive);
}

TEST(RequestParser, waits_for_every_byte_of_half_a_request) {
    for (const std::string& whole : {kGet, kPost}) {
        RequestParser parser;
        for (size_t i = 0; i + 1 < whole.size(); ++i) {
            ASSERT_FALSE(parser.put(whole.substr(i, 1))) << i;
            ASSERT_EQ(parser.error(), 0) << i;
            EXPECT_TRUE(parser.begun());
        }
        EXPECT_TRUE(parser.put(whole.substr(whole.size() - 1)));
    }
}

TEST(RequestParser, takes_requests_that_came_at_once_in_turn) {
    RequestParser parser;

    ASSERT_TRUE(parser.put(kPost + kGet));
    EXPECT_EQ(parser.request().body, "body");
    ASSERT_TRUE(parser.next());
    EXPECT_EQ(parser.request().path, "/live");
    EXPECT_EQ(parser.request().body, "");
    EXPECT_FALSE(parser.next());
    EXPECT_FALSE(parser.begun());
}

TEST(RequestParser, knows_who_wants_to_go) {
    RequestParser old, closing;

    ASSERT_TRUE(old.put("GET / HTTP/1.0\r\n\r\n"));
    EXPECT_FALSE(old.request().keep_alive);
    ASSERT_TRUE(closing.put(withHeaders("Connection: Close\r\n")));
    EXPECT_FALSE(closing.request().keep_alive);
}

TEST_P(BadRequest, is_answered_with_its_status_and_nothing_more_is_read) {
    EXPECT_EQ(errorOf(GetParam().bytes), GetParam().status);

    RequestParser parser;
    parser.put(GetParam().bytes);
    EXPECT_FALSE(parser.put(kGet));
    EXPECT_FALSE(parser.next());
}

INSTANTIATE_TEST_SUITE_P(
    All, BadRequest,
    testing::Values(Bad{"\r\n\r\n", 400}, Bad{"GET /\r\n\r\n", 400},
                    Bad{"GET / HTTP/2\r\n\r\n", 400}, Bad{"GET  / HTTP/1.1\r\n\r\n", 400},
                    Bad{"GET x HTTP/1.1\r\n\r\n", 400}, Bad{"G(T / HTTP/1.1\r\n\r\n", 400},
                    Bad{" / HTTP/1.1\r\n\r\n", 400}, Bad{"\xFE\x09\x00", 400},
                    Bad{std::string("GET /\0 HTTP", 10), 400},
                    Bad{"GET / HTTP/1.1\r\nno colon\r\n\r\n", 400},
                    Bad{withHeaders(" folded: x\r\n"), 400}, Bad{withHeaders(": x\r\n"), 400},
                    Bad{withHeaders("a: x\rb: y\r\n"), 400},
                    Bad{withHeaders("Host: a\r\nHost: b\r\n"), 400},
                    Bad{withHeaders("Content-Length: 3\r\nContent-Length: 4\r\n"), 400},
                    Bad{withHeaders("Content-Length: -1\r\n"), 400},
                    Bad{withHeaders("Content-Length:\r\n"), 400},
                    Bad{withHeaders("Content-Length: 0x4\r\n"), 400},
                    Bad{withHeaders("Transfer-Encoding: chunked\r\n"), 400},
                    Bad{withHeaders("Content-Length: 16385\r\n"), 413},
                    Bad{withHeaders("Content-Length: 99999999999999999999999999\r\n"), 413},
                    Bad{"GET /" + std::string(3000, 'a'), 414},
                    Bad{"GET /" + std::string(2048, 'a') + " HTTP/1.1\r\n\r\n", 414},
                    Bad{withHeaders("a: " + std::string(RequestParser::kMaxHead, 'x')), 431}));

TEST(RequestParser, limits_the_number_of_headers) {
    std::string lines;
    for (size_t i = 0; i <= RequestParser::kMaxHeaders; ++i)
        lines += "x" + std::to_string(i) + ": 1\r\n";

    EXPECT_EQ(errorOf(withHeaders(lines)), 431);
}

TEST(RequestParser, survives_garbage_and_damaged_requests) {
    std::mt19937 random(7);
    for (int round = 0; round < 3000; ++round) {
        RequestParser parser;
        std::string bytes = round % 2 ? kPost + kGet : std::string(200, 0);
        const int changes = round % 2 ? 3 : 200;
        for (int i = 0; i < changes; ++i)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        for (size_t at = 0; at < bytes.size();) {
            const size_t size = 1 + random() % 40;
            bool whole = parser.put(std::string_view(bytes).substr(at, size));
            for (int i = 0; whole && i < 3; ++i) whole = parser.next();
            at += size;
        }
        EXPECT_LE(parser.request().body.size(), RequestParser::kMaxBody);
    }
}
