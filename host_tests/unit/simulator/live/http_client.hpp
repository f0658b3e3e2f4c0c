// SPDX-License-Identifier: GPL-3.0-or-later
// A client of the HTTP server in the same thread: what is read here was written by poll().
#pragma once
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include "simulator/live/http_server.hpp"

class HttpClient {
public:
    explicit HttpClient(simulator::live::HttpServer& server, int receive_buffer = 0)
        : server_(server), socket_(socket(AF_INET, SOCK_STREAM, 0)) {
        if (receive_buffer > 0)
            setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(server.port());
        EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        fcntl(socket_, F_SETFL, fcntl(socket_, F_GETFL, 0) | O_NONBLOCK);
    }
    ~HttpClient() { close(socket_); }

    void write(const std::string& bytes) {
        (void)!send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        poll();
    }
    void poll(int times = 4) {
        for (int i = 0; i < times; ++i) server_.poll(std::chrono::milliseconds(2));
    }
    // Everything that has come so far; gone() says whether that is all that will come.
    std::string read() {
        poll();
        char part[4096];
        for (ssize_t size; (size = recv(socket_, part, sizeof part, 0)) != -1;) {
            if (size == 0) {
                gone_ = true;
                break;
            }
            read_.append(part, static_cast<size_t>(size));
        }
        return read_;
    }
    bool gone() {
        read();
        return gone_;
    }

private:
    simulator::live::HttpServer& server_;
    int socket_;
    std::string read_;
    bool gone_ = false;
};
