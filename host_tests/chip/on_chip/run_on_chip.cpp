// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program of tests on libsimavr's bare ATmega2560 and passes on what it prints. The chip
// has 56 KiB of external memory here (datasheet section 9: from 0x2200 on), for the tests' own
// variables and heap; the 8 KiB inside are all stack. Status 0: the program says that all passed.
//   run_on_chip FILE.elf [SECONDS of the chip's time]
#include <simavr/sim_avr.h>
#include <simavr/sim_io.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "simulator/machine/image.hpp"

namespace {

constexpr avr_io_addr_t kGpior0 = 0x3E, kGpior1 = 0x4A;
constexpr uint16_t kRamEnd = 0xFFFF;
constexpr int kRunning = -1;
int result = kRunning;

void end(avr_t*, avr_io_addr_t, uint8_t value, void*) { result = value; }

// Line by line; a test's last line also says how long it took.
void print(avr_t* avr, avr_io_addr_t, uint8_t value, void*) {
    static std::string line;
    static avr_cycle_count_t begun = 0;
    if (value != '\n') {
        line += static_cast<char>(value);
        return;
    }
    if (line.rfind("[ RUN", 0) == 0) begun = avr->cycle;
    const bool over = line.rfind("[      OK", 0) == 0 || line.rfind("[  FAILED", 0) == 0;
    const double taken_s = static_cast<double>(avr->cycle - begun) / avr->frequency;
    printf(over ? "%s (%.2f s)\n" : "%s\n", line.c_str(), taken_s);
    fflush(stdout);
    line.clear();
}

avr_t* chipWith(const simulator::Image& image) {
    avr_t* avr = avr_make_mcu_by_name("atmega2560");
    avr->ramend = kRamEnd;
    avr_init(avr);
    avr->frequency = 16000000;
    avr->log = LOG_ERROR;
    avr_loadcode(avr, const_cast<uint8_t*>(image.flash.data()),
                 static_cast<uint32_t>(image.flash.size()), 0);
    avr->codeend = avr->flashend;
    avr->run_cycle_limit = 100000;
    avr_register_io_write(avr, kGpior0, end, nullptr);
    avr_register_io_write(avr, kGpior1, print, nullptr);
    return avr;
}

int run(const char* file, double seconds) {
    avr_t* avr = chipWith(simulator::readImage(file, kRamEnd));
    const auto limit = static_cast<avr_cycle_count_t>(seconds * avr->frequency);
    while (result == kRunning && avr->cycle < limit) {
        const int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed) break;
    }
    printf("%.2f s of the chip's time\n", static_cast<double>(avr->cycle) / avr->frequency);
    if (result == kRunning) {
        printf("the program %s at 0x%05x, without an end\n",
               avr->cycle < limit ? "stopped" : "still runs", avr->pc);
        return 1;
    }
    return result;
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) {
        fprintf(stderr, "usage: run_on_chip FILE.elf [SECONDS]\n");
        return 2;
    }
    try {
        return run(words[1], count > 2 ? atof(words[2]) : 60);
    } catch (const std::exception& error) {
        fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
