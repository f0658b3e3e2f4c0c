// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "echo_board.hpp"

using namespace simulator;
using testing::StartsWith;

namespace {

class Client {
public:
    explicit Client(uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(port);
        EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    ~Client() { close(socket_); }

    void write(const std::string& text) {
        EXPECT_EQ(send(socket_, text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
    }
    std::string read(size_t size) {
        std::string bytes(size, 0);
        EXPECT_EQ(recv(socket_, bytes.data(), size, MSG_WAITALL), static_cast<ssize_t>(size));
        return bytes;
    }
    std::string ask(const std::string& line) {
        write(line + "\n");
        std::string answer;
        for (char c; recv(socket_, &c, 1, 0) == 1 && c != '\n';) answer += c;
        return answer;
    }

private:
    int socket_;
};

class LockStep : public testing::Test {
protected:
    LockStep() : server(board, 0, {2, 0}, true) {
        board.listen([this](int usart, uint8_t byte, uint64_t) { server.fromBoard(usart, byte); });
        thread = std::thread([this] { server.runLockStep([this] { return over.load(); }); });
    }
    ~LockStep() override {
        over = true;
        thread.join();
    }

    EchoBoard board;
    Server server;
    std::atomic<bool> over{false};
    std::thread thread;
};

}  // namespace

TEST_F(LockStep, grants_time_and_says_how_much_was_sent) {
    Client control(server.controlPort());

    EXPECT_EQ(control.ask("advance 100"), "at 100 10 10");
    EXPECT_EQ(control.ask("advance 50"), "at 150 15 15");
    EXPECT_EQ(board.time_us(), 150'000u);
}

TEST_F(LockStep, takes_the_orders_of_a_person_at_the_bench) {
    Client control(server.controlPort());

    for (const char* good : {"turn-to 10 -20 30", "turn 1 2 3", "lift 1.5", "blow 12", "reset",
                             "gps nmea 9600", "fault baro:lost 3", "fault supply:sag_1.5v 0.2",
                             "fault none", "supply 5.4", "flash right.elf"}) {
        EXPECT_EQ(control.ask(good), "ok") << good;
    }
    EXPECT_EQ(board.world().supply_v(0), 5.4);
    EXPECT_EQ(control.ask("servos"), "[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]");
    for (const char* wrong : {"turn-to 1 2", "lift", "blow x", "gps none 9600", "gps nmea",
                              "fault baro:lost", "fault baro:cut 3", "fault baro:lost -1",
                              "supply 4", "supply 5.6", "flash", "flash wrong.elf"}) {
        EXPECT_EQ(control.ask(wrong).rfind("error: ", 0), 0u) << wrong;
    }
}

TEST_F(LockStep, fails_a_part_from_now_on_for_as_long_as_asked) {
    Client control(server.controlPort());
    control.ask("advance 2000");
    control.ask("fault baro:lost 3");

    ASSERT_EQ(board.world().faults().size(), 1u);
    EXPECT_NEAR(board.world().faults()[0].from_s, 2, 0.01);
    EXPECT_NEAR(board.world().faults()[0].to_s, 5, 0.01);
    EXPECT_EQ(control.ask("fault none"), "ok");
    EXPECT_TRUE(board.world().faults().empty());
}

TEST_F(LockStep, lets_no_time_pass_by_itself) {
    Client control(server.controlPort());

    EXPECT_EQ(control.ask("advance 0"), "at 0 0 0");
}

TEST_F(LockStep, waits_for_the_bytes_the_client_says_it_has_sent) {
    Client control(server.controlPort()), telemetry(server.port()), usb(server.secondPort());
    std::thread late([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        telemetry.write("hello");
    });
    usb.write("abc");

    EXPECT_EQ(control.ask("advance 10 5 3"), "at 10 1 1");
    EXPECT_EQ(board.sent[2], "hello");
    EXPECT_EQ(board.sent[0], "abc");
    late.join();
}

TEST_F(LockStep, gives_each_line_to_its_port) {
    Client control(server.controlPort()), telemetry(server.port()), usb(server.secondPort());
    control.ask("advance 0");  // lets both in
    control.ask("advance 30");

    EXPECT_EQ(telemetry.read(3), "\2\2\2");
    EXPECT_EQ(usb.read(3), std::string(3, '\0'));
}

TEST_F(LockStep, gives_the_true_state_as_json) {
    Client control(server.controlPort());
    const auto truth = nlohmann::json::parse(control.ask("state"));

    EXPECT_EQ(truth["on_ground"], true);
    EXPECT_NEAR(truth["latitude_deg"], 47.3977, 1e-6);
}

TEST_F(LockStep, sets_usb_and_sticks) {
    Client control(server.controlPort());

    EXPECT_EQ(control.ask("usb in"), "ok");
    EXPECT_TRUE(board.usb);
    EXPECT_EQ(control.ask("sticks 1500 1500 1100 1500 1500 1500 1500 1800"), "ok");
    EXPECT_EQ(control.ask("sticks off"), "ok");
    EXPECT_EQ(control.ask("launch"), "ok");
}

TEST_F(LockStep, refuses_what_it_does_not_understand) {
    Client control(server.controlPort());

    for (const char* line : {"", "advance", "advance -5", "advance x", "advance 99999999", "fly me",
                             "sticks 1 2 3", "usb maybe"}) {
        EXPECT_THAT(control.ask(line), StartsWith("error: ")) << line;
    }
    EXPECT_EQ(control.ask("advance 10"), "at 10 1 1");
}

// A signal must not wait for an hour that was granted at once.
TEST(Server, stops_in_the_middle_of_a_grant) {
    EchoBoard board;
    Server server(board, 0, {2, 0}, true);
    board.listen([&](int usart, uint8_t byte, uint64_t) { server.fromBoard(usart, byte); });
    std::thread thread([&] { server.runLockStep([&] { return board.time_us() >= 500'000; }); });

    EXPECT_EQ(Client(server.controlPort()).ask("advance 3600000"), "error: stopped");
    thread.join();
    EXPECT_LT(board.time_us(), 600'000u);
}

TEST(TcpPort, refuses_a_port_that_is_taken) {
    TcpPort first(0);

    EXPECT_THROW(TcpPort second(first.port()), TcpError);
}
