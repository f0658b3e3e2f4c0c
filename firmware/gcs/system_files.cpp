// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/system_files.hpp"

#include <string.h>

#include "core/rom.hpp"
#include "firmware/gcs/host.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/logger/log.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/state/processor_figures.hpp"
#include "hal/memory.hpp"
#include "hal/serial.hpp"

namespace firmware {
namespace gcs {

namespace {

constexpr uint8_t kLine = 32;
constexpr uint8_t kNameEnds = 18, kValueEnds = 25, kBudgetEnds = kLine - 1;

struct Figure {
    notify::TextField<kNameEnds> name;
    uint16_t (*value)();
};

template <uint8_t link>
uint16_t badFrames() {
    return links[link].parser.rejected();
}
template <uint8_t link>
uint16_t lostBytes() {
    return hal::serialLost(portOf(links[link]));
}
uint16_t lostGpsBytes() { return hal::serialLost(hal::Port::gps); }
uint16_t lostTexts() { return notify::textsLost(); }
uint16_t lateFrames() { return state::processor_figures.late_frames; }

// clang-format off
constexpr Figure kMemory[] ROM = {
    {"free below stack",  hal::freeMemory},
};
constexpr Figure kErrors[] ROM = {
    {"late frames",       lateFrames},
    {"log records lost",  logger::logDropped},
    {"texts lost",        lostTexts},
    {"link0 bad frames",  badFrames<0>},
    {"link0 bytes lost",  lostBytes<0>},
    {"link1 bad frames",  badFrames<1>},
    {"link1 bytes lost",  lostBytes<1>},
    {"GPS bytes lost",    lostGpsBytes},
};
// clang-format on

void writeNumber(char* end, uint16_t number) {
    do {
        *--end = static_cast<char>('0' + number % 10);
        number /= 10;
    } while (number != 0);
}

void writeName(char* line, notify::StatusText name) {
    core::Unpacker letters = name.letters();
    char letter;
    for (uint8_t i = 0; i < kNameEnds && (letter = letters.next()) != 0; ++i) line[i] = letter;
}

void writeFigure(char* line, const Figure& in_flash) {
    writeName(line, in_flash.name);
    writeNumber(line + kValueEnds, core::romRead(in_flash.value)());
}

void writeTask(char* line, uint8_t number) {
    const TaskFigures task = host.taskFigures(number);
    writeName(line, task.name);
    writeNumber(line + kValueEnds, task.longest_us);
    writeNumber(line + kBudgetEnds, task.budget_us);
}

void writeLine(SystemFile file, uint8_t number, char (&line)[kLine]) {
    memset(line, ' ', sizeof line);
    line[kLine - 1] = '\n';
    if (file == SystemFile::tasks)
        writeTask(line, number);
    else
        writeFigure(line, file == SystemFile::memory ? kMemory[number] : kErrors[number]);
}

}  // namespace

uint16_t systemFileSize(SystemFile file) {
    const uint8_t lines = file == SystemFile::tasks    ? host.taskCount()
                          : file == SystemFile::memory ? core::count(kMemory)
                                                       : core::count(kErrors);
    return static_cast<uint16_t>(lines * kLine);
}

uint8_t systemFileRead(SystemFile file, uint16_t offset, uint8_t* to, uint8_t size) {
    const uint16_t end = systemFileSize(file);
    uint8_t copied = 0;
    while (copied < size && offset < end) {
        char line[kLine];
        writeLine(file, static_cast<uint8_t>(offset / kLine), line);
        const uint8_t skipped = offset % kLine;
        uint8_t part = kLine - skipped;
        if (part > size - copied) part = static_cast<uint8_t>(size - copied);
        memcpy(to + copied, line + skipped, part);
        copied = static_cast<uint8_t>(copied + part);
        offset = static_cast<uint16_t>(offset + part);
    }
    return copied;
}

}  // namespace gcs
}  // namespace firmware
