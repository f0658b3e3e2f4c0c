// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/gate.hpp"

#include <gtest/gtest.h>

using namespace simulator::live;

namespace {

Request request(const std::string& method, const std::string& path) {
    Request request;
    request.method = method;
    request.path = path;
    request.headers["host"] = "127.0.0.1:5770";
    if (method == "POST") request.headers["content-type"] = "application/json";
    return request;
}

int statusOf(const Request& request) {
    const auto refused = refusal(request, 5770);
    return refused ? refused->status : 200;
}

int withHeader(Request request, const std::string& name, const std::string& value) {
    request.headers[name] = value;
    return statusOf(request);
}

}  // namespace

TEST(Gate, lets_the_page_and_its_commands_through) {
    EXPECT_EQ(statusOf(request("GET", "/")), 200);
    EXPECT_EQ(statusOf(request("GET", "/live")), 200);
    EXPECT_EQ(statusOf(request("POST", "/command")), 200);
    EXPECT_EQ(withHeader(request("GET", "/"), "host", "localhost:5770"), 200);
    EXPECT_EQ(withHeader(request("POST", "/command"), "origin", "http://127.0.0.1:5770"), 200);
    EXPECT_EQ(
        withHeader(request("POST", "/command"), "content-type", "application/json; charset=utf-8"),
        200);
}

TEST(Gate, refuses_another_name_for_this_computer) {
    for (const char* host : {"evil.example", "evil.example:5770", "127.0.0.1", "127.0.0.1:5771",
                             "localhost.evil.example:5770", "[::1]:5770"})
        EXPECT_EQ(withHeader(request("GET", "/live"), "host", host), 403) << host;
    Request none = request("GET", "/");
    none.headers.clear();
    EXPECT_EQ(statusOf(none), 400);
}

TEST(Gate, refuses_what_another_page_sends) {
    for (const char* origin : {"http://evil.example", "null", "http://localhost:5770",
                               "https://127.0.0.1:5770", "http://127.0.0.1:5771"}) {
        EXPECT_EQ(withHeader(request("POST", "/command"), "origin", origin), 403) << origin;
        EXPECT_EQ(withHeader(request("GET", "/live"), "origin", origin), 403) << origin;
    }
}

// What a form of another page can send without asking first.
TEST(Gate, wants_commands_as_json) {
    for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded",
                             "text/application/json", "application/jsonx"})
        EXPECT_EQ(withHeader(request("POST", "/command"), "content-type", type), 415) << type;
}

TEST(Gate, knows_its_paths_and_their_methods) {
    EXPECT_EQ(statusOf(request("GET", "/etc/passwd")), 404);
    EXPECT_EQ(statusOf(request("GET", "/live/")), 404);
    EXPECT_EQ(statusOf(request("GET", "/command")), 405);
    EXPECT_EQ(statusOf(request("POST", "/live")), 405);
    EXPECT_EQ(statusOf(request("DELETE", "/")), 405);
    EXPECT_EQ(refusal(request("GET", "/command"), 5770)->more_headers, "Allow: POST\r\n");
}

TEST(Gate, answers_bytes_that_are_no_text_all_the_same) {
    EXPECT_EQ(answerJson(200, true, "a\"b").body, "{\"ok\":true,\"text\":\"a\\\"b\"}\n");
    EXPECT_NE(answerJson(200, false, "\xFF").body, "");
}
