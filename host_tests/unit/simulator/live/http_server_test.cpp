// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/http_server.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "http_client.hpp"
#include "simulator/ground/tcp_port.hpp"

using namespace simulator::live;
using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

const std::string kGet = "GET / HTTP/1.1\r\nHost: x\r\n\r\n";

class Http : public testing::Test {
protected:
    Http() {
        setClock(server);
        server.on_request = [this](HttpServer::Client client, const Request& request) {
            last = client;
            if (request.path == "/live") return server.stream(client, "event: first\n\n");
            if (request.path != "/later") server.respond(client, {200, "text/plain", "hello"});
        };
    }
    HttpServer server{0, {4, 4000, 1000, milliseconds(50), milliseconds(300), milliseconds(80)}};
    HttpServer::Client last = 0;

    // Time passes when a test says so.
    void setClock(HttpServer& of) {
        of.now = [this] { return HttpServer::Clock::time_point() + milliseconds(time_ms); };
    }
    void rest(int ms) { time_ms += ms; }
    int time_ms = 1000;
};

}  // namespace

TEST_F(Http, answers_and_keeps_the_connection) {
    HttpClient client(server);

    client.write(kGet);
    EXPECT_THAT(client.read(), StartsWith("HTTP/1.1 200 OK\r\n"));
    EXPECT_THAT(client.read(),
                HasSubstr("Content-Length: 5\r\nConnection: keep-alive\r\n\r\nhello"));
    const size_t first = client.read().size();
    client.write(kGet + kGet);
    EXPECT_EQ(client.read().size(), 3 * first);
    EXPECT_FALSE(client.gone());
}

TEST_F(Http, closes_when_the_client_asks_for_it) {
    HttpClient client(server);

    client.write("GET / HTTP/1.0\r\n\r\n");
    EXPECT_THAT(client.read(), HasSubstr("Connection: close\r\n\r\nhello"));
    EXPECT_TRUE(client.gone());
}

TEST_F(Http, answers_later_and_reads_nothing_until_then) {
    HttpClient client(server);

    client.write("GET /later HTTP/1.1\r\n\r\n" + kGet);
    EXPECT_EQ(client.read(), "");
    server.respond(last, {200, "text/plain", "now"});
    EXPECT_THAT(client.read(), HasSubstr("now"));
    EXPECT_THAT(client.read(), HasSubstr("hello"));
    server.respond(999, {200, "text/plain", "to nobody"});
}

TEST_F(Http, refuses_garbage_and_goes) {
    HttpClient client(server);

    client.write("\x16\x03\x01\x02 is TLS");
    EXPECT_THAT(client.read(), StartsWith("HTTP/1.1 400 Bad Request\r\n"));
    EXPECT_TRUE(client.gone());
}

TEST_F(Http, drops_half_a_request_in_time) {
    HttpClient client(server);

    client.write("GET / HT");
    EXPECT_FALSE(client.gone());
    rest(80);
    EXPECT_THAT(client.read(), StartsWith("HTTP/1.1 408 "));
    EXPECT_TRUE(client.gone());
}

TEST_F(Http, drops_who_asks_nothing) {
    HttpClient client(server);
    client.poll();

    rest(350);
    client.poll();
    EXPECT_TRUE(client.gone());
}

TEST_F(Http, sends_events_to_every_stream_alone) {
    HttpClient a(server), b(server), other(server);

    a.write("GET /live HTTP/1.1\r\n\r\n");
    b.write("GET /live HTTP/1.1\r\n\r\n");
    other.write(kGet);
    EXPECT_EQ(server.streams(), 2u);
    server.broadcast("event: second\n\n");
    for (HttpClient* each : {&a, &b}) {
        EXPECT_THAT(each->read(), HasSubstr("Content-Type: text/event-stream\r\n"));
        EXPECT_THAT(each->read(), HasSubstr("event: first\n\nevent: second\n\n"));
    }
    EXPECT_THAT(other.read(), Not(HasSubstr("second")));
}

TEST_F(Http, does_not_drop_a_stream_that_is_silent) {
    HttpClient client(server);
    client.write("GET /live HTTP/1.1\r\n\r\n");

    rest(350);
    server.broadcast("event: late\n\n");
    EXPECT_THAT(client.read(), HasSubstr("late"));
}

TEST_F(Http, leaves_samples_out_for_a_slow_client_and_drops_one_that_reads_nothing) {
    HttpServer wide(0,
                    {4, 32 << 20, 100'000, milliseconds(50), milliseconds(300), milliseconds(80)});
    setClock(wide);
    wide.on_request = [&](HttpServer::Client client, const Request&) { wide.stream(client, ""); };
    HttpClient slow(wide, 4096);
    slow.write("GET /live HTTP/1.1\r\n\r\n");
    const std::string event(10'000, 'x');

    for (int i = 0; i < 3000; ++i) {
        wide.broadcast(event, true);
        wide.poll();
    }
    EXPECT_EQ(wide.streams(), 1u);  // 30 MB would not have fitted into its limit of 100 kB
    for (int i = 0; i < 500 && wide.streams() > 0; ++i) {  // until the system takes no more
        rest(10);
        wide.broadcast(event, true);
        wide.poll();
    }
    EXPECT_EQ(wide.streams(), 0u);
}

TEST_F(Http, drops_a_stream_beyond_its_backlog) {
    HttpClient client(server);
    client.write("GET /live HTTP/1.1\r\n\r\n");

    server.broadcast(std::string(5000, 'x'));
    server.poll();
    EXPECT_EQ(server.streams(), 0u);
}

TEST_F(Http, has_room_for_so_many) {
    std::vector<std::unique_ptr<HttpClient>> clients;
    for (int i = 0; i < 5; ++i) clients.push_back(std::make_unique<HttpClient>(server));
    clients[0]->poll();

    EXPECT_THAT(clients[4]->read(), StartsWith("HTTP/1.1 503 "));
    clients[0]->write(kGet);
    EXPECT_THAT(clients[0]->read(), HasSubstr("hello"));
}

TEST_F(Http, forgets_who_has_gone) {
    {
        HttpClient client(server);
        client.write("GET /live HTTP/1.1\r\n\r\n");
        EXPECT_EQ(server.streams(), 1u);
    }
    server.poll(milliseconds(20));
    EXPECT_EQ(server.streams(), 0u);
}

TEST_F(Http, refuses_a_port_that_is_taken) {
    EXPECT_THROW(HttpServer second(server.port()), simulator::TcpError);
}
