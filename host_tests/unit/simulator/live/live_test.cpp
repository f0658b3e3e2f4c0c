// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/live.hpp"

#include <gmock/gmock.h>

#include <thread>

#include "http_client.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "talking_board.hpp"

using namespace simulator;
using namespace simulator::live;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

class Socket {
public:
    explicit Socket(uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(port);
        EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        fcntl(socket_, F_SETFL, O_NONBLOCK);
        host_ = "Host: 127.0.0.1:" + std::to_string(port) + "\r\n";
    }
    ~Socket() { close(socket_); }
    void get(const std::string& path, const std::string& headers = "") {
        write("GET " + path + " HTTP/1.1\r\n" + host_ + headers + "\r\n");
    }
    void command(const std::string& json) {
        write("POST /command HTTP/1.1\r\n" + host_ + "Content-Type: application/json\r\n" +
              "Content-Length: " + std::to_string(json.size()) + "\r\n\r\n" + json);
    }
    const std::string& read() {
        char part[65536];
        for (ssize_t size; (size = recv(socket_, part, sizeof part, 0)) > 0;)
            read_.append(part, static_cast<size_t>(size));
        return read_;
    }
    void forget() { read_.clear(); }

private:
    void write(const std::string& bytes) {
        EXPECT_EQ(send(socket_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
    }
    int socket_;
    std::string host_, read_;
};

class LiveTest : public testing::Test {
protected:
    static LiveOptions options(std::vector<std::string>* said) {
        LiveOptions options;
        options.http_port = 0;
        options.speed = 0;
        options.page = "<title>the page</title>";
        options.say = [said](const std::string& line) { said->push_back(line); };
        return options;
    }
    LiveTest() : live(board, options(&said)), page(live.port()) {
        board.listen([this](int usart, uint8_t byte, uint64_t time_us) {
            live.receive(usart, byte, time_us);
        });
    }
    // At least that much of emulated time, and until everything was served.
    void run(double seconds) {
        const uint64_t end_us = board.time_us() + static_cast<uint64_t>(seconds * 1e6);
        int served = 0;
        while (board.time_us() < end_us || ++served < 5) {
            ASSERT_TRUE(live.awaitStep(board.time_us() + 10'000, [] { return false; }));
            board.runUntil(board.time_us() + 10'000);
            live.step();
            if (board.time_us() >= end_us)
                std::this_thread::sleep_for(std::chrono::milliseconds(3));
        }
    }
    std::string answerTo(const std::string& json, double within_s = 3) {
        page.forget();
        page.command(json);
        run(within_s);
        const std::string& all = page.read();
        const size_t body = all.find("\r\n\r\n");
        return body == all.npos ? "none" : all.substr(body + 4);
    }
    std::vector<std::string> said;
    TalkingBoard board;
    Live live;
    Socket page;
};

}  // namespace

TEST_F(LiveTest, serves_its_page) {
    page.get("/");
    run(0.1);

    EXPECT_THAT(page.read(), HasSubstr("Content-Type: text/html"));
    EXPECT_THAT(page.read(), EndsWith("\r\n\r\n<title>the page</title>"));
}

TEST_F(LiveTest, streams_document_status_and_ten_samples_a_second) {
    page.get("/live");
    run(0.01);
    page.read();
    page.forget();
    run(2);
    Socket late(live.port());
    late.get("/live");
    run(0.1);

    size_t samples = 0;
    const std::string all = page.read();
    for (size_t at = 0; (at = all.find("event: samples", at)) != all.npos; ++at) ++samples;
    EXPECT_NEAR(static_cast<double>(samples), 21, 2);
    EXPECT_THAT(late.read(), HasSubstr("event: flight\ndata: {\"format\":\"apm-flight\""));
    EXPECT_THAT(late.read(), HasSubstr("event: samples"));  // of before it came
    EXPECT_THAT(late.read(),
                HasSubstr("event: status\ndata: {\"armed\":false,\"mode\":\"MANUAL\""));
    EXPECT_THAT(said, Contains("1 page looks on"));
}

TEST_F(LiveTest, gives_one_that_returns_only_what_it_has_missed) {
    run(5);
    page.get("/live", "Last-Event-ID: 3500\r\n");
    run(0.01);

    EXPECT_THAT(page.read(), Not(HasSubstr("id: 2")));
    EXPECT_THAT(page.read(), HasSubstr("id: 4"));
}

TEST_F(LiveTest, answers_commands_when_the_autopilot_has) {
    run(2);
    board.on_command = [](const mavlink::CommandLong&) { return uint8_t{4}; };

    EXPECT_EQ(answerTo(R"({"do":"arm"})"), "{\"ok\":false,\"text\":\"FAILED\"}\n");
    EXPECT_THAT(page.read(), StartsWith("HTTP/1.1 200"));
}

TEST_F(LiveTest, refuses_what_is_no_request) {
    EXPECT_THAT(answerTo("{}", 0), HasSubstr("\"ok\":false"));
    EXPECT_THAT(page.read(), StartsWith("HTTP/1.1 400"));
}

TEST_F(LiveTest, begins_and_ends_faults) {
    run(1);
    const std::string begin = R"({"do":"fault","name":"gps_lost","on":true})",
                      end = R"({"do":"fault","name":"gps_lost","on":false})";

    EXPECT_THAT(answerTo(end, 0.1), HasSubstr("it does not fail now"));
    EXPECT_THAT(answerTo(begin, 0.1), HasSubstr("\"ok\":true"));
    EXPECT_EQ(board.world().faultOf(Faulty::gps), FaultKind::lost);
    EXPECT_THAT(answerTo(begin, 0.1), HasSubstr("it has failed already"));
    EXPECT_THAT(answerTo(end, 0.1), HasSubstr("\"ok\":true"));
    run(0.1);
    EXPECT_EQ(board.world().faultOf(Faulty::gps), FaultKind::none);
    EXPECT_EQ(live.chronicle().bands().back().name, "gps:lost");
    EXPECT_TRUE(live.chronicle().bands().back().to_s);
}

TEST_F(LiveTest, changes_the_wind_and_records_it) {
    run(1);
    EXPECT_THAT(answerTo(R"({"do":"wind","speed_mps":6,"from_deg":180})", 0.1),
                HasSubstr("\"ok\":true"));
    run(0.1);

    EXPECT_GT(board.world().truth().wind_north_mps, 0.3);  // on the ground it is weak
    EXPECT_EQ(live.chronicle().events().back().text, "wind 6 m/s from 180 deg");
}

TEST_F(LiveTest, moves_the_sticks) {
    answerTo(R"({"do":"sticks","roll":1,"pitch":-0.5,"throttle":0.25,"yaw":0})", 0.1);
    const auto& pulses = board.world().radio().sticks();

    EXPECT_EQ(pulses[0], 1900);
    EXPECT_EQ(pulses[1], 1300);
    EXPECT_EQ(pulses[2], 1300);
    EXPECT_EQ(pulses[3], 1500);
}

TEST_F(LiveTest, stands_still_while_paused_and_still_serves) {
    run(1);
    page.command(R"({"do":"pause"})");
    page.command(R"({"do":"arm"})");
    const uint64_t before_us = board.time_us();
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(150);
    while (live.awaitStep(board.time_us() + 10'000,
                          [&] { return std::chrono::steady_clock::now() > end; })) {
        board.runUntil(board.time_us() + 10'000);
        live.step();
    }

    EXPECT_LT(board.time_us(), before_us + 5'000'000);
    EXPECT_THAT(page.read(), HasSubstr("paused: the autopilot hears nothing"));
    page.command(R"({"do":"resume"})");
    run(1);
    EXPECT_THAT(said, Not(Contains("stop")));
}

TEST_F(LiveTest, says_on_the_terminal_what_happens) {
    live.setClients(1);
    board.sayText("hello");
    board.sayText("\x1b[2J");
    run(1.5);
    board.armed = true;
    run(1);
    live.setClients(0);

    EXPECT_THAT(said, Contains("client connected"));
    EXPECT_THAT(said, Contains("     0.0 s  hello"));
    EXPECT_THAT(said, Contains("     0.0 s  ?[2J"));
    EXPECT_THAT(said, Contains(HasSubstr("mode MANUAL")));
    EXPECT_THAT(said, Contains(HasSubstr("armed")));
    EXPECT_THAT(said, Contains("client disconnected"));
}

TEST_F(LiveTest, says_why_it_has_ended) {
    page.get("/live");
    run(0.1);
    live.end("all done");

    EXPECT_THAT(page.read(), HasSubstr("\"ended\":\"all done\""));
}

TEST(LivePort, is_another_when_the_usual_one_is_taken) {
    HttpServer taken(0);
    TalkingBoard board;
    LiveOptions options;
    options.http_port = taken.port();
    EXPECT_THROW(Live(board, options), std::runtime_error);
    options.any_port = true;
    EXPECT_NE(Live(board, options).port(), taken.port());
    options.http_port.reset();
    EXPECT_EQ(Live(board, options).port(), 0);
}
