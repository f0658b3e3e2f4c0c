// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/image.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "simulator/input_file.hpp"
#include "simulator/machine/elf_file.hpp"
#include "simulator/machine/registers.hpp"
#include "simulator/machine/sha256.hpp"

namespace simulator {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw std::runtime_error(path + ": " + why);
}

uint8_t hexByte(const std::string& line, size_t at) {
    return static_cast<uint8_t>(std::stoi(line.substr(at, 2), nullptr, 16));
}

// Intel's format: ":" count address type data... checksum, all in hexadecimal.
std::vector<uint8_t> hexRecord(const std::string& path, int number, const std::string& line) {
    const auto bad = [&] { refuse(path, "line " + std::to_string(number) + " is no Intel hex"); };
    const bool digits = line.find_first_not_of("0123456789ABCDEFabcdef", 1) == std::string::npos;
    if (line[0] != ':' || !digits || line.size() < 11 || line.size() % 2 == 0) bad();
    std::vector<uint8_t> bytes;
    uint8_t sum = 0;
    for (size_t at = 1; at < line.size(); at += 2) {
        bytes.push_back(hexByte(line, at));
        sum = static_cast<uint8_t>(sum + bytes.back());
    }
    if (sum != 0 || bytes.size() != bytes[0] + 5u) bad();
    return bytes;
}

Image readHex(const std::string& path, const std::string& bytes) {
    enum : uint8_t { kData = 0, kEnd = 1, kSegment = 2, kLinear = 4 };
    std::istringstream file(bytes);
    Image image;
    uint32_t base = 0;
    bool ended = false;
    int number = 0;
    for (std::string line; !ended && std::getline(file, line);) {
        number++;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty()) continue;
        const std::vector<uint8_t> record = hexRecord(path, number, line);
        const uint32_t word = record[0] >= 2 ? record[4] << 8 | record[5] : 0;
        const uint64_t address = uint64_t{base} + (record[1] << 8 | record[2]);
        if (record[3] == kData && address + record[0] > kFlashSize)
            refuse(path, "is larger than the 256 KiB of flash");
        if (record[3] == kData) image.place(static_cast<uint32_t>(address), &record[4], record[0]);
        if (record[3] == kSegment) base = word << 4;
        if (record[3] == kLinear) base = word << 16;
        ended = record[3] == kEnd;
    }
    if (!ended) refuse(path, "ends without an end record: cut short, or no Intel hex");
    if (image.flash.empty()) refuse(path, "holds no program");
    return image;
}

}  // namespace

void Image::place(uint32_t address, const void* bytes, size_t size) {
    if (flash.size() < address + size) flash.resize(address + size, 0xFF);
    const auto* from = static_cast<const uint8_t*>(bytes);
    std::copy(from, from + size, flash.begin() + address);
    flash_bytes += static_cast<uint32_t>(size);
}

Image readImage(const std::string& path, uint16_t ram_end) {
    const auto bytes = wholeFile(path);
    if (!bytes) refuse(path, "cannot be opened");
    const bool is_hex = bytes->compare(0, 1, ":") == 0;
    if (!is_hex && !looksLikeElf(*bytes)) refuse(path, "is neither an ELF nor an Intel hex file");
    Image image = is_hex ? readHex(path, *bytes) : readElf(path, *bytes, ram_end);
    image.path = path;
    image.sha256 = sha256(*bytes);
    return image;
}

}  // namespace simulator
