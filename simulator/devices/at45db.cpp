// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/at45db.hpp"

#include <algorithm>

#include "simulator/devices/random.hpp"

namespace simulator {
namespace {

enum class Does : uint8_t {
    read_page,
    read_array,
    read_buffer,
    write_buffer,
    store,
    add,            // a store without its erase
    write_through,  // the buffer and then the page
    fetch,          // a page into the buffer
    compare,
    rewrite,
    erase,
    erase_sector,
    erase_chip,
    status,
    identify,
    sleep,
    wake,
    set_page_size,
};

// Datasheets, "AC characteristics": typical and longest.
struct Time {
    uint32_t typical_us, longest_us;
};
enum Times : unsigned { kTransfer, kStore, kAdd, kErasePage, kEraseBlock, kEraseSector, kChip };
constexpr Time kTimes[] = {
    {200, 200},                  // tXFR, tCOMP
    {17'000, 40'000},            // tEP
    {3'000, 6'000},              // tP
    {15'000, 35'000},            // tPE
    {45'000, 100'000},           // tBE
    {1'600'000, 5'000'000},      // tSE
    {102'400'000, 320'000'000},  // not given: 64 sectors
};

constexpr uint32_t kEraseChip = 0x94809A, kSetPageSize = 0x2A80A6;  // after 0xC7, after 0x3D
constexpr unsigned kBlock = 8;

}  // namespace

struct At45db::Command {
    uint8_t opcode;
    Does does;
    int8_t buffer;        // -1: none
    uint8_t before_data;  // opcode, address, bytes that do not matter
    uint8_t pages = 1;
    Times times = kTransfer;
};

namespace {

constexpr uint8_t kAddressed = 4;

// clang-format off
constexpr At45db::Command kCommands[] = {
    {0xD2, Does::read_page,    -1, 8},
    {0xE8, Does::read_array,   -1, 8},
    {0x0B, Does::read_array,   -1, 5},
    {0x03, Does::read_array,   -1, 4},
    {0xD4, Does::read_buffer,   0, 5},
    {0xD6, Does::read_buffer,   1, 5},
    {0xD1, Does::read_buffer,   0, 4},
    {0xD3, Does::read_buffer,   1, 4},
    {0x84, Does::write_buffer,  0, 4},
    {0x87, Does::write_buffer,  1, 4},
    {0x83, Does::store,         0, 4, 1, kStore},
    {0x86, Does::store,         1, 4, 1, kStore},
    {0x88, Does::add,           0, 4, 1, kAdd},
    {0x89, Does::add,           1, 4, 1, kAdd},
    {0x82, Does::write_through, 0, 4, 1, kStore},
    {0x85, Does::write_through, 1, 4, 1, kStore},
    {0x53, Does::fetch,         0, 4},
    {0x55, Does::fetch,         1, 4},
    {0x60, Does::compare,       0, 4},
    {0x61, Does::compare,       1, 4},
    {0x58, Does::rewrite,       0, 4, 1, kStore},
    {0x59, Does::rewrite,       1, 4, 1, kStore},
    {0x81, Does::erase,        -1, 4, 1, kErasePage},
    {0x50, Does::erase,        -1, 4, kBlock, kEraseBlock},
    {0x7C, Does::erase_sector, -1, 4},
    {0xC7, Does::erase_chip,   -1, 4},
    {0x3D, Does::set_page_size, -1, 4},
    {0xD7, Does::status,       -1, 1},
    {0x57, Does::status,       -1, 1},
    {0x9F, Does::identify,     -1, 1},
    {0xB9, Does::sleep,        -1, 1},
    {0xAB, Does::wake,         -1, 1},
};
// clang-format on

constexpr size_t imageSize(bool is_161d, bool pages_of_512) {
    return size_t{is_161d ? 4096u : 8192u} * (pages_of_512 ? 512 : 528);
}

}  // namespace

At45db::At45db(uint64_t seed, const At45dbOptions& options)
    : seed_(seed), options_(options), will_be_512_(options.pages_of_512) {
    cells_.assign(imageSize(options.is_161d, options.pages_of_512), 0xFF);
    erases_.resize(pages());
    programs_.resize(pages());
    powerOn();
}

// What the buffers hold is not defined then.
void At45db::powerOn() {
    Random random(seed_, 100 + operations_);
    for (auto& buffer : buffers_) {
        buffer.resize(pageSize());
        for (uint8_t& byte : buffer) byte = static_cast<uint8_t>(random.bits());
    }
    command_ = nullptr;
    busy_until_us_ = 0;
    busy_buffer_ = -1;
    operation_.reset();
    asleep_ = jams_ = differs_ = false;
}

bool At45db::setImage(const std::vector<uint8_t>& image) {
    for (const bool is_161d : {false, true}) {
        for (const bool pages_of_512 : {false, true}) {
            if (image.size() != imageSize(is_161d, pages_of_512)) continue;
            options_.is_161d = is_161d;
            options_.pages_of_512 = will_be_512_ = pages_of_512;
            cells_ = image;
            erases_.assign(pages(), 0);
            programs_.assign(pages(), 0);
            powerOn();
            return true;
        }
    }
    return false;
}

std::vector<uint8_t> At45db::image(uint64_t now_us) const {
    std::vector<uint8_t> cells = cells_;
    if (operation_ && now_us < operation_->end_us) damage(cells);
    return cells;
}

// Datasheets, "Power-up timing": the select may fall after tVCSL, nothing is written before tPUW.
void At45db::power(bool on, uint64_t now_us) {
    constexpr uint64_t kSelectable_us = 70, kWritable_us = 20'000;
    powered_ = on;
    if (!on) return cutPower(now_us);
    ready_us_ = now_us + kSelectable_us;
    writable_us_ = now_us + kWritable_us;
}

void At45db::abort(uint64_t now_us) {
    if (operation_ && now_us < operation_->end_us) damage(cells_);
    operation_.reset();
    busy_until_us_ = 0;
    busy_buffer_ = -1;
    command_ = nullptr;
}

void At45db::cutPower(uint64_t now_us) {
    abort(now_us);
    operations_++;
    if (will_be_512_ && !options_.pages_of_512) {
        std::vector<uint8_t> shortened;
        for (unsigned i = 0; i < pages(); ++i)
            shortened.insert(shortened.end(), cells(i), cells(i) + 512);
        cells_ = shortened;
        options_.pages_of_512 = true;
    }
    powerOn();
}

// Each page in its own way: noise, erased, or half of what was to be there.
void At45db::damage(std::vector<uint8_t>& cells) const {
    Random random(seed_, 1'000'000 + operations_);
    for (unsigned i = 0; i < operation_->pages; ++i) {
        uint8_t* bytes = &cells[size_t{operation_->first_page + i} * pageSize()];
        const uint64_t way = random.bits() % 4, whole = random.bits() % pageSize();
        const uint8_t wanted = bytes[whole];
        for (unsigned k = 0; k < pageSize(); ++k) {
            const auto noise = static_cast<uint8_t>(random.bits());
            if (way == 0) bytes[k] = noise;
            if (way == 1) bytes[k] = 0xFF;
            if (way == 2 && k >= whole) bytes[k] = 0xFF;
            if (way == 3 && k >= whole) bytes[k] |= noise;
        }
        if (bytes[whole] == wanted) bytes[whole] ^= 0x40;  // never by chance what was to be
    }
}

void At45db::resetPin(bool low, uint64_t now_us) {
    if (low && !in_reset_) abort(now_us);
    in_reset_ = low;
}

void At45db::select(bool chosen, uint64_t now_us) {
    const Command* command = command_;
    command_ = nullptr;
    if (chosen_ && !chosen && command && count_ >= command->before_data) execute(*command, now_us);
    chosen_ = chosen;
    count_ = 0;
    address_ = 0;
}

uint8_t At45db::transfer(uint8_t mosi, uint64_t now_us) {
    if (!options_.fitted || !chosen_ || in_reset_) return 0xFF;
    if (!powered_ || now_us < ready_us_) return 0xFF;
    const unsigned at = count_++;
    if (at == 0) {
        begin(mosi, now_us);
        return 0xFF;
    }
    if (!command_) return 0xFF;
    if (at < kAddressed) address_ = address_ << 8 | mosi;
    if (at < command_->before_data) return 0xFF;
    return exchange(mosi, at - command_->before_data, now_us);
}

void At45db::begin(uint8_t opcode, uint64_t now_us) {
    const auto* found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                     [&](const Command& each) { return each.opcode == opcode; });
    if (found == std::end(kCommands) || refuses(*found, now_us)) {
        ignored_++;
    } else {
        command_ = found;
    }
}

static bool writes(Does does) {
    constexpr Does kWriting[] = {Does::store,      Does::add,          Does::write_through,
                                 Does::rewrite,    Does::erase,        Does::erase_sector,
                                 Does::erase_chip, Does::set_page_size};
    return std::find(std::begin(kWriting), std::end(kWriting), does) != std::end(kWriting);
}

// Datasheets, "Operation mode summary": beside the self-timed work go status, identity and the
// buffer that takes no part in it.
bool At45db::refuses(const Command& command, uint64_t now_us) const {
    if (asleep_) return command.does != Does::wake;
    if (now_us < writable_us_ && writes(command.does)) return true;
    if (!busy(now_us)) return false;
    if (command.does == Does::status || command.does == Does::identify) return false;
    const bool of_buffer = command.does == Does::read_buffer || command.does == Does::write_buffer;
    return !of_buffer || command.buffer == busy_buffer_;
}

unsigned At45db::addressedPage() const {
    return (address_ >> (options_.pages_of_512 ? 9 : 10)) % pages();
}

unsigned At45db::addressedByte() const {
    return (address_ & (options_.pages_of_512 ? 511 : 1023)) % pageSize();
}

// Bit 7 ready, 6 the last compare differed, 5..2 density, 0 pages of 512.
uint8_t At45db::status(uint64_t now_us) const {
    return static_cast<uint8_t>((busy(now_us) ? 0 : 0x80) | (differs_ ? 0x40 : 0) |
                                (options_.is_161d ? 0x2C : 0x34) | (options_.pages_of_512 ? 1 : 0));
}

uint8_t At45db::exchange(uint8_t mosi, unsigned at, uint64_t now_us) {
    const unsigned in_page = (addressedByte() + at) % pageSize();
    const size_t in_array = size_t{addressedPage()} * pageSize() + addressedByte() + at;
    const uint8_t identity[] = {0x1F, static_cast<uint8_t>(options_.is_161d ? 0x26 : 0x27),
                                static_cast<uint8_t>(options_.is_161d ? 0x00 : 0x01), 0x00};
    switch (command_->does) {
        case Does::read_page:
            return cells(addressedPage())[in_page];
        case Does::read_array:
            return cells_[in_array % cells_.size()];
        case Does::read_buffer:
            return buffers_[command_->buffer][in_page];
        case Does::write_buffer:
        case Does::write_through:
            buffers_[command_->buffer][in_page] = mosi;
            return 0xFF;
        case Does::status:
            return status(now_us);
        case Does::identify:
            return at < sizeof identity ? identity[at] : 0xFF;
        default:
            return 0xFF;
    }
}

// The work begins when the select rises.
void At45db::execute(const Command& command, uint64_t now_us) {
    const unsigned page = addressedPage();
    if (!busy(now_us)) busy_buffer_ = command.buffer;  // what goes beside the work is none itself
    switch (command.does) {
        case Does::store:
        case Does::write_through:
            return store(command, true, now_us);
        case Does::add:
            return store(command, false, now_us);
        case Does::read_page:
        case Does::read_array:
            if (on_read) on_read(static_cast<uint16_t>(page), now_us);
            return;
        case Does::fetch:
        case Does::rewrite:
            std::copy_n(cells(page), pageSize(), buffers_[command.buffer].begin());
            return command.does == Does::fetch ? occupy(kTransfer, now_us)
                                               : store(command, true, now_us);
        case Does::compare:
            differs_ = !std::equal(cells(page), cells(page) + pageSize(),
                                   buffers_[command.buffer].begin());
            return occupy(kTransfer, now_us);
        case Does::erase:
            return erase(page - page % command.pages, command.pages, command.times, now_us);
        case Does::erase_sector: {
            const unsigned sector = options_.is_161d ? 256 : 128;  // the first is cut after a block
            if (page < kBlock) return erase(0, kBlock, kEraseSector, now_us);
            if (page < sector) return erase(kBlock, sector - kBlock, kEraseSector, now_us);
            return erase(page - page % sector, sector, kEraseSector, now_us);
        }
        case Does::erase_chip:
            return address_ == kEraseChip ? erase(0, pages(), kChip, now_us) : void(ignored_++);
        case Does::set_page_size:
            if (address_ != kSetPageSize) return void(ignored_++);
            will_be_512_ = true;
            return occupy(kStore, now_us);
        case Does::sleep:
        case Does::wake:
            asleep_ = command.does == Does::sleep;
            return;
        default:
            return;
    }
}

void At45db::store(const Command& command, bool erases, uint64_t now_us) {
    const unsigned page = addressedPage();
    const std::vector<uint8_t>& from = buffers_[command.buffer];
    for (unsigned i = 0; i < pageSize(); ++i)
        cells(page)[i] = static_cast<uint8_t>(erases ? from[i] : cells(page)[i] & from[i]);
    occupy(command.times, now_us);
    write({erases, true, static_cast<uint16_t>(page), 1, now_us, busy_until_us_});
}

void At45db::erase(unsigned first_page, unsigned pages, unsigned times, uint64_t now_us) {
    std::fill_n(cells(first_page), size_t{pages} * pageSize(), uint8_t{0xFF});
    occupy(times, now_us);
    write({true, false, static_cast<uint16_t>(first_page), static_cast<uint16_t>(pages), now_us,
           busy_until_us_});
}

// The cells hold the result already; nobody can read them before it is due.
void At45db::write(const Operation& operation) {
    operations_++;
    for (unsigned i = operation.first_page; i < operation.first_page + operation.pages; ++i) {
        erases_[i] += operation.erases;
        programs_[i] += operation.programs;
    }
    operation_ = operation;
    if (on_operation) on_operation(operation);
}

void At45db::occupy(unsigned times, uint64_t now_us) {
    const Time& time = kTimes[times];
    busy_until_us_ =
        jams_ ? UINT64_MAX : now_us + (options_.slowest ? time.longest_us : time.typical_us);
}

}  // namespace simulator
