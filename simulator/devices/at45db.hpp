// SPDX-License-Identifier: GPL-3.0-or-later
// Atmel AT45DB321D or AT45DB161D DataFlash on SPI (datasheets 3597 and 3500): opcodes, the two
// buffers, ready and busy with their times, what is ignored while busy, and what a power cut or
// the reset pin leaves of the pages being written: garbage. Sector protection is not modelled.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace simulator {

struct At45dbOptions {
    bool fitted = true;  // else nobody answers: the bus reads 0xFF
    bool is_161d = false;
    bool pages_of_512 = false;  // the chip was set to powers of two
    bool slowest = false;       // takes the datasheet's longest times, not its typical ones
};

class At45db {
public:
    struct Command;  // a row of the table of opcodes

    explicit At45db(uint64_t seed = 1, const At45dbOptions& options = {});

    void select(bool chosen, uint64_t now_us);
    uint8_t transfer(uint8_t mosi, uint64_t now_us);
    void resetPin(bool low, uint64_t now_us);

    // An erase or program, reported when it begins; a power cut before `end_us` damages its pages.
    struct Operation {
        bool erases, programs;
        uint16_t first_page, pages;
        uint64_t begin_us, end_us;
    };
    std::function<void(const Operation&)> on_operation;
    std::function<void(uint16_t page, uint64_t now_us)> on_read;  // of the array, when it ends

    // The power fails and comes back: pages being written are garbage, so are the buffers.
    void cutPower(uint64_t now_us);
    // As above in two steps: without power it answers nothing.
    void power(bool on, uint64_t now_us);

    // All pages, one after the other, as a cut now would leave them.
    std::vector<uint8_t> image(uint64_t now_us) const;
    // Power-on with these pages. Chip and page size follow from the size; false: no chip has it.
    bool setImage(const std::vector<uint8_t>& image);

    bool fitted() const { return options_.fitted; }
    uint16_t pages() const { return options_.is_161d ? 4096 : 8192; }
    uint16_t pageSize() const { return options_.pages_of_512 ? 512 : 528; }
    const uint8_t* page(uint16_t page) const { return &cells_[size_t{page} * pageSize()]; }
    bool busy(uint64_t now_us) const { return now_us < busy_until_us_; }
    uint32_t erases(uint16_t page) const { return erases_[page]; }
    uint32_t programs(uint16_t page) const { return programs_[page]; }
    uint64_t ignored() const { return ignored_; }  // commands unknown, or given while busy

    // For tests: the work begun next never ends; the chip comes loose.
    void jam() { jams_ = true; }
    void remove() { options_.fitted = false; }

private:
    void begin(uint8_t opcode, uint64_t now_us);
    bool refuses(const Command& command, uint64_t now_us) const;
    uint8_t exchange(uint8_t mosi, unsigned at, uint64_t now_us);
    void execute(const Command& command, uint64_t now_us);
    void store(const Command& command, bool erases, uint64_t now_us);
    void erase(unsigned first_page, unsigned pages, unsigned times, uint64_t now_us);
    void write(const Operation& operation);
    void occupy(unsigned times, uint64_t now_us);
    void abort(uint64_t now_us);
    void damage(std::vector<uint8_t>& cells) const;
    void powerOn();

    uint8_t status(uint64_t now_us) const;
    unsigned addressedPage() const;
    unsigned addressedByte() const;
    uint8_t* cells(unsigned page) { return &cells_[size_t{page} * pageSize()]; }

    uint64_t seed_;
    At45dbOptions options_;
    std::vector<uint8_t> cells_;
    std::array<std::vector<uint8_t>, 2> buffers_;
    std::vector<uint32_t> erases_, programs_;
    std::optional<Operation> operation_;  // the newest that writes pages; done at its end_us
    uint64_t operations_ = 0, ignored_ = 0;
    uint64_t busy_until_us_ = 0;
    int busy_buffer_ = -1;  // takes part in the work under way
    const Command* command_ = nullptr;
    unsigned count_ = 0;  // bytes since the select
    uint32_t address_ = 0;
    bool chosen_ = false, in_reset_ = false, asleep_ = false, jams_ = false;
    bool powered_ = true;
    uint64_t ready_us_ = 0, writable_us_ = 0;  // after power-on
    bool differs_ = false;                     // what the last compare found
    bool will_be_512_ = false;                 // from the next power-on on
};

}  // namespace simulator
