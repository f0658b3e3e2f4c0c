// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>

#include "machine.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/machine/board_wiring.hpp"

using simulator::AvrBoard;
using simulator::BoardFigures;

static constexpr std::array<uint16_t, 8> kSticks_us = {1100, 1234, 1300, 1400,
                                                       1500, 1600, 1700, 1800};

// The programs begin after 65 ms.
static simulator::WorldOptions quickBootloader() {
    simulator::WorldOptions options;
    options.bootloader = simulator::Bootloader::quick;
    return options;
}

static simulator::WorldOptions exactSensors() {
    simulator::WorldOptions options = quickBootloader();
    options.sensor_errors = false;
    return options;
}

class BoardTest : public testing::Test {
protected:
    BoardTest() {
        board.listen([this](int usart, uint8_t byte, uint64_t) { heard[usart] += char(byte); });
        board.world().radio().sticks(kSticks_us, true);
    }
    void run_s(double s) {
        ASSERT_TRUE(board.runUntil(board.time_us() + uint64_t(s * 1e6))) << board.fault();
    }
    int reported(int number) {
        const std::string& text = heard[2];
        for (size_t at = 0; at + 2 < text.size(); at += 3)
            if (text[at] == number) return uint8_t(text[at + 1]) | uint8_t(text[at + 2]) << 8;
        ADD_FAILURE() << "the program has not reported " << number;
        return -1;
    }

    AvrBoard board{program("board.elf"), exactSensors()};
    std::map<int, std::string> heard;
};

TEST_F(BoardTest, the_sensors_answer_on_their_bus) {
    run_s(1);

    EXPECT_EQ(reported(3), 0x68) << "MPU6000";
    EXPECT_GT(reported(2), 20000) << "MS5611";
    EXPECT_LT(reported(2), 65535) << "MS5611";
    EXPECT_EQ(reported(5), 'H' | '4' << 8) << "HMC5883L";
}

TEST_F(BoardTest, the_barometer_is_dumb_unless_the_imu_is_held_deselected) {
    run_s(1);
    EXPECT_EQ(reported(1), 0xFFFF);
}

TEST_F(BoardTest, bytes_to_both_sensors_at_once_are_counted) {
    run_s(1);
    EXPECT_EQ(board.busContentions(), 2u);
}

TEST_F(BoardTest, data_ready_interrupts_at_the_sample_rate) {
    run_s(1);
    EXPECT_NEAR(reported(4), 200 * 0.102, 2);
}

TEST_F(BoardTest, the_battery_is_on_A13) {
    run_s(1);
    EXPECT_NEAR(reported(6) * 5.0 / 1024 * 10.1, board.world().truth().battery_v, 0.1);
}

TEST_F(BoardTest, the_dataflash_answers_on_usart3_unless_it_is_held_in_reset) {
    run_s(1);
    EXPECT_EQ(reported(13), 0x1F27);
    EXPECT_EQ(reported(14), 0xFFFF);
    EXPECT_EQ(reported(15), 0x1F27);
}

TEST_F(BoardTest, the_gps_is_heard_at_its_own_rate_and_is_garbage_at_another) {
    run_s(6);
    EXPECT_GT(reported(7), 2) << "NMEA sentences";
    EXPECT_EQ(reported(8), 0);
    EXPECT_GT(reported(9), 20);
}

TEST_F(BoardTest, the_radio_is_captured_to_half_a_microsecond) {
    run_s(6.5);
    const int ticks = reported(10);
    EXPECT_TRUE(
        std::any_of(kSticks_us.begin(), kSticks_us.end(), [&](int us) { return ticks == 2 * us; }))
        << ticks << ", of whichever channel came";
}

TEST_F(BoardTest, pulses_relay_and_lights_come_out) {
    run_s(0.2);
    EXPECT_NEAR(board.world().servoPulse_us(1), 1500, 0.5);
    EXPECT_NEAR(board.world().servoPulse_us(2), 1100, 0.5);
    EXPECT_EQ(board.world().servoPulse_us(3), 0);
    EXPECT_TRUE(board.world().relayOn());
    EXPECT_TRUE(board.ledOn(AvrBoard::Led::a));
    EXPECT_FALSE(board.ledOn(AvrBoard::Led::b));
}

TEST_F(BoardTest, the_sense_pin_is_low_while_usb_is_plugged) {
    run_s(5);
    board.setUsb(true);
    run_s(1.5);
    EXPECT_EQ(reported(11), 2);
    EXPECT_EQ(reported(12), 0);
}

TEST_F(BoardTest, bytes_go_both_ways_at_the_rate_of_the_line) {
    run_s(0.08);  // past the bootloader
    const std::string text(100, 'a');
    board.send(0, reinterpret_cast<const uint8_t*>(text.data()), text.size());
    EXPECT_EQ(board.unsent(0), 100u);
    run_s(0.0043);  // a byte takes 85 us
    EXPECT_NEAR(double(board.unsent(0)), 50, 2);
    run_s(0.01);
    EXPECT_EQ(heard[0], std::string(100, 'b'));
}

TEST_F(BoardTest, frames_tasks_and_load_are_measured_from_the_marks) {
    run_s(7.5);
    const BoardFigures figures = board.figures();

    ASSERT_TRUE(figures.frames);
    EXPECT_GT(*figures.frames, 30u);
    EXPECT_EQ(*figures.frame_overruns, 1u);
    EXPECT_NEAR(*figures.frame_max_us, 12500, 20);
    EXPECT_NEAR(*figures.frame_mean_us, 505 + 12000 / (*figures.frames - 1.0), 450);
    ASSERT_EQ(figures.tasks.size(), 1u);
    EXPECT_EQ(figures.tasks[0].number, 2);
    EXPECT_NEAR(figures.tasks[0].max_cycles, 8000, 20);
    EXPECT_GT(*figures.cpu_load, 0.5);
    EXPECT_LT(*figures.cpu_load, 1.0);
    EXPECT_GT(*figures.interrupt_load, 0.0);
    EXPECT_FALSE(figures.interrupts.empty());
    EXPECT_GT(*figures.stack_max_bytes, 10u);
    EXPECT_GT(*figures.flash_bytes, 1000u);
    EXPECT_EQ(*figures.ram_static_bytes, 9u);
}

TEST(Board, a_firmware_without_marks_or_symbols_has_no_such_figures) {
    AvrBoard board(program("usart.hex"), exactSensors());
    ASSERT_TRUE(board.runUntil(100000));
    const BoardFigures figures = board.figures();

    EXPECT_FALSE(figures.ram_static_bytes);
    EXPECT_FALSE(AvrBoard(program("stack.hex"), exactSensors()).figures().frames);
    EXPECT_TRUE(figures.flash_bytes);
}

// By which another firmware knows that the APM 1's barometer has measured.
TEST(Board, the_end_of_a_conversion_is_on_PC7_of_an_apm_1) {
    AvrBoard board(program("conversion_end.elf"), exactSensors(), simulator::kApm1Wiring);
    uint64_t low_us = 0, us = 70'000;
    for (; us < 200'000; us += 100) {
        ASSERT_TRUE(board.runUntil(us));
        if (us > 85'000 && !board.world().relayOn()) low_us += 100;
    }
    EXPECT_NEAR(static_cast<double>(low_us), 25'500, 300) << "data sheet, table 8";
    EXPECT_TRUE(board.world().relayOn());
}

TEST(Board, the_trace_holds_servo_edges) {
    const std::string path = testing::TempDir() + "board.vcd";
    {
        AvrBoard board(program("board.elf"), exactSensors());
        board.traceTo(path);
        ASSERT_TRUE(board.runUntil(100000));
    }
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    EXPECT_NE(text.str().find("$var wire 1 ! servo1 $end"), std::string::npos);
    EXPECT_NE(text.str().find("\n1!\n"), std::string::npos);
}

TEST(Board, two_boards_with_the_same_seed_do_the_same) {
    const auto heardAfter = [](double step_us) {
        AvrBoard board(program("board.elf"), quickBootloader());
        std::vector<std::pair<uint8_t, uint64_t>> bytes;
        board.listen([&](int, uint8_t byte, uint64_t us) { bytes.push_back({byte, us}); });
        for (double t = 0; t < 1e6; t += step_us) board.runUntil(uint64_t(t));
        return bytes;
    };
    EXPECT_EQ(heardAfter(1000), heardAfter(1000));
    EXPECT_EQ(heardAfter(1000), heardAfter(50000)) << "however it is sliced";
}
