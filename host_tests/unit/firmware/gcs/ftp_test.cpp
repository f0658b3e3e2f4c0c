// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/ftp.hpp"

#include <algorithm>

#include "firmware/state/parameter_file.hpp"
#include "ground.hpp"

using ground::Telemetry;

namespace {

using firmware::gcs::FtpHeader;
using firmware::gcs::kFtpData;
using mavlink::FileTransferProtocol;
using Error = mavlink::MavFtpErr;
using Opcode = mavlink::MavFtpOpcode;

struct Answer {
    FtpHeader header;
    std::vector<uint8_t> data;
};

Answer read(const FileTransferProtocol& message) {
    Answer answer = {};
    memcpy(&answer.header, &message, sizeof answer.header);
    const uint8_t* data = reinterpret_cast<const uint8_t*>(&message) + sizeof answer.header;
    answer.data.assign(data, data + answer.header.size);
    return answer;
}

class Ftp : public Telemetry {
protected:
    void SetUp() override {
        Telemetry::SetUp();
        station.framing = second.framing = ground::Framing::v2;
    }
    FileTransferProtocol request(uint8_t opcode, uint32_t offset, uint8_t size,
                                 const std::string& data = "") {
        FileTransferProtocol message = {};
        FtpHeader header = {};
        header.target_system = header.target_component = 1;
        header.sequence = sequence_++;
        header.opcode = opcode;
        header.size = data.empty() ? size : static_cast<uint8_t>(data.size());
        header.offset = offset;
        memcpy(&message, &header, sizeof header);
        memcpy(message.payload + sizeof header - 3, data.data(), data.size());
        return message;
    }
    std::vector<Answer> heard(ground::Station& by) {
        std::vector<Answer> answers;
        for (const auto& message : by.all<FileTransferProtocol>()) answers.push_back(read(message));
        return answers;
    }
    std::vector<Answer> answers(const FileTransferProtocol& question, uint32_t wait_ms = 20) {
        station.send(question);
        run_ms(wait_ms);
        return heard(station);
    }
    void open() {
        const auto opened = answers(request(Opcode::openfilero, 0, 0, "@PARAM/param.pck"));
        ASSERT_EQ(opened.size(), 1u);
        ASSERT_EQ(opened[0].header.opcode, Opcode::ack);
    }
    uint8_t errorOf(const FileTransferProtocol& question) {
        const auto answered = answers(question);
        if (answered.size() != 1 || answered[0].header.opcode != Opcode::nak) return Error::none;
        return answered[0].data.at(0);
    }

private:
    uint16_t sequence_ = 7;
};

TEST_F(Ftp, a_burst_has_the_whole_file_in_order_and_ends_with_its_end) {
    open();
    const auto parts = answers(request(Opcode::burstreadfile, 0, 239), 2000);

    ASSERT_GT(parts.size(), 2u);
    size_t at = 0;
    for (size_t i = 0; i + 1 < parts.size(); ++i) {
        EXPECT_EQ(parts[i].header.opcode, Opcode::ack);
        EXPECT_EQ(parts[i].header.requested_opcode, Opcode::burstreadfile);
        EXPECT_EQ(parts[i].header.sequence, parts[0].header.sequence + i);
        EXPECT_EQ(parts[i].header.offset, at);
        at += parts[i].data.size();
        const bool last = i + 2 == parts.size();
        EXPECT_TRUE(last || parts[i].data.size() == kFtpData) << i;
    }
    EXPECT_EQ(at, firmware::state::parameterFileSize());
    EXPECT_EQ(parts.back().header.opcode, Opcode::nak);
    EXPECT_EQ(parts.back().data, std::vector<uint8_t>{Error::eof});
    run_ms(500);
    EXPECT_TRUE(heard(station).empty()) << "and nothing more";
}

TEST_F(Ftp, a_read_is_one_message_of_the_bytes_asked_for) {
    open();
    for (const int size : {1, 80, 110}) {
        const auto parts = answers(request(Opcode::readfile, 100, static_cast<uint8_t>(size)), 200);
        ASSERT_EQ(parts.size(), 1u);
        EXPECT_EQ(parts[0].header.requested_opcode, Opcode::readfile);
        EXPECT_EQ(parts[0].header.offset, 100u);
        EXPECT_EQ(parts[0].data.size(), static_cast<size_t>(size));
    }
    for (const int size : {0, 111, 255}) {
        const auto parts = answers(request(Opcode::readfile, 100, static_cast<uint8_t>(size)), 200);
        ASSERT_EQ(parts.size(), 1u);
        EXPECT_EQ(parts[0].data.size(), kFtpData) << "as many as a message has";
    }
    const uint16_t size = firmware::state::parameterFileSize();
    const auto last = answers(request(Opcode::readfile, size - 3u, 80), 200);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].data.size(), 3u);
    EXPECT_EQ(errorOf(request(Opcode::readfile, size, 80)), Error::eof);
    EXPECT_EQ(errorOf(request(Opcode::readfile, 0x10064, 80)), Error::eof);
}

TEST_F(Ftp, a_part_waits_for_room_and_none_is_lost) {
    open();
    station.line().endless = false;
    station.line().room = hal::kLinkRoom;
    station.send(request(Opcode::burstreadfile, 0, 0));
    size_t at = 0;
    for (uint32_t ms = 0; ms < 3000; ms += 10) {
        run_ms(10);
        auto& room = station.line().room;
        room = static_cast<uint8_t>(std::min<int>(hal::kLinkRoom, room + 40));
        for (const auto& part : heard(station)) {
            if (part.header.opcode != Opcode::ack) continue;
            EXPECT_EQ(part.header.offset, at);
            at += part.data.size();
        }
    }
    EXPECT_EQ(at, firmware::state::parameterFileSize());
}

TEST_F(Ftp, the_file_of_the_first_link_is_not_the_second_s) {
    open();
    station.line().endless = false;
    station.line().room = 100;  // its burst cannot go on
    station.send(request(Opcode::burstreadfile, 0, 80));
    run_ms(20);
    second.send(request(Opcode::openfilero, 0, 0, "@PARAM/param.pck"));
    second.send(request(Opcode::burstreadfile, 0, 80));
    second.send(request(Opcode::resetsession, 0, 0));
    run_ms(50);
    const auto refused = heard(second);
    ASSERT_EQ(refused.size(), 3u);
    EXPECT_EQ(refused[0].data, std::vector<uint8_t>{Error::nosessionsavailable});
    EXPECT_EQ(refused[1].data, std::vector<uint8_t>{Error::invalidsession});
    EXPECT_EQ(refused[2].header.opcode, Opcode::ack);
    station.line().room = hal::kLinkRoom;
    run_ms(20);
    EXPECT_FALSE(heard(station).empty()) << "it goes on";
}

TEST_F(Ftp, the_figures_are_lines_of_a_name_a_value_and_a_task_s_budget) {
    const auto read_all = [this](const char* path) {
        std::string text;
        const auto opened = answers(request(Opcode::openfilero, 0, 0, path));
        EXPECT_EQ(opened.at(0).header.opcode, Opcode::ack);
        const uint32_t size = opened[0].data[0] | opened[0].data[1] << 8;
        for (const auto& part : answers(request(Opcode::burstreadfile, 0, 0), 1000))
            if (part.header.opcode == Opcode::ack) text.append(part.data.begin(), part.data.end());
        EXPECT_EQ(text.size(), size);
        return text;
    };
    const std::string tasks = read_all("@SYS/tasks.txt");
    EXPECT_EQ(tasks,
              "runInertial           823  1050\n"
              "orthonormalizeMatr  65535   330\n");
    firmware::state::processor_figures.late_frames = 65535;
    fakes::serial(hal::Port::gps).lost = 102;
    const std::string errors = read_all("@SYS/errors.txt");
    EXPECT_EQ(errors.substr(0, 64),
              "late frames         65535      \n"
              "log records lost        0      \n");
    EXPECT_EQ(errors.substr(errors.size() - 32), "GPS bytes lost        102      \n");
    EXPECT_EQ(read_all("@SYS/memory.txt").substr(0, 18), "free below stack  ");
    open();
    EXPECT_EQ(errorOf(request(Opcode::readfile, 10000, 80)), Error::eof);
}

TEST_F(Ftp, there_is_no_other_file) {
    for (const char* path : {"@PARAM/param.pc", "@PARAM/param.pckx", "/etc/passwd", "@", "?",
                             "@SYS/tasks.txt1", "@SYS/", "@SYS/tasks"})
        EXPECT_EQ(errorOf(request(Opcode::openfilero, 0, 0, path)), Error::filenotfound) << path;
    for (const char* path : {"@PARAM/param.pck?withdefaults=1", "@PARAM/param.pck?"})
        EXPECT_EQ(errorOf(request(Opcode::openfilero, 0, 0, path)), Error::none) << path;
    for (const int opcode : {0, 3, 6, 7, 8, 9, 10, 11, 12, 13, 14, 16, 128, 255})
        EXPECT_EQ(errorOf(request(static_cast<uint8_t>(opcode), 0, 0)), Error::unknowncommand)
            << opcode;
}

TEST_F(Ftp, nothing_is_read_from_a_session_that_is_closed) {
    EXPECT_EQ(errorOf(request(Opcode::readfile, 0, 80)), Error::invalidsession);
    open();
    station.send(request(Opcode::burstreadfile, 0, 80));
    station.send(request(Opcode::terminatesession, 0, 0));
    run_ms(20);
    heard(station);
    run_ms(200);
    EXPECT_TRUE(heard(station).empty()) << "the burst has ended";
    EXPECT_EQ(errorOf(request(Opcode::burstreadfile, 0, 80)), Error::invalidsession);
}

TEST_F(Ftp, a_link_that_is_opened_anew_is_not_sent_the_rest) {
    open();
    station.line().endless = false;
    station.line().room = 100;  // its burst cannot go on
    station.send(request(Opcode::burstreadfile, 0, 80));
    run_ms(20);
    fakes::setUsb(true);
    run_ms(40);
    station.line().endless = true;
    station.line().room = hal::kLinkRoom;
    run_ms(100);
    EXPECT_TRUE(heard(station).empty());
    EXPECT_EQ(station.broken(), 0);
    second.send(request(Opcode::openfilero, 0, 0, "@PARAM/param.pck"));
    run_ms(20);
    EXPECT_EQ(heard(second).at(0).header.opcode, Opcode::ack);
}

}  // namespace
