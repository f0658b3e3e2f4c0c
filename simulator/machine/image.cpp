// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/image.hpp"

#include <fcntl.h>
#include <gelf.h>
#include <libelf.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "simulator/machine/registers.hpp"

namespace simulator {
namespace {

constexpr uint32_t kRamBase = 0x800000, kEepromBase = 0x810000;  // avr-gcc's address spaces
constexpr uint32_t kFamilyMask = 0x7F, kFamilyAvr6 = 6;          // e_flags: ATmega2560, 2561

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw std::runtime_error(path + ": " + why);
}

void place(Image& image, const std::string& path, uint32_t address, const uint8_t* bytes,
           size_t size) {
    if (address + size > kFlashSize) refuse(path, "is larger than the 256 KiB of flash");
    if (image.flash.size() < address + size) image.flash.resize(address + size, 0xFF);
    std::copy(bytes, bytes + size, image.flash.begin() + address);
    image.flash_bytes += static_cast<uint32_t>(size);
}

class ElfFile {
public:
    explicit ElfFile(const std::string& path) : ElfFile(path, open(path.c_str(), O_RDONLY)) {
        if (file_ < 0) refuse(path, "cannot be opened");
        elf_version(EV_CURRENT);
        elf_ = elf_begin(file_, ELF_C_READ, nullptr);
        if (!elf_ || !gelf_getehdr(elf_, &header_)) refuse(path, "is not a whole ELF file");
        if (header_.e_machine != EM_AVR) refuse(path, "is an ELF file, but not for an AVR");
        if ((header_.e_flags & kFamilyMask) != kFamilyAvr6)
            refuse(path, "is built for another AVR than the ATmega2560");
    }
    ~ElfFile() {
        elf_end(elf_);
        if (file_ >= 0) close(file_);
    }
    ElfFile(const ElfFile&) = delete;
    ElfFile& operator=(const ElfFile&) = delete;

    void loadFlash(Image& image) {
        size_t size = 0;
        const char* raw = elf_rawfile(elf_, &size);
        for (int i = 0; i < header_.e_phnum; i++) {
            GElf_Phdr part;
            if (!gelf_getphdr(elf_, i, &part)) refuse(path_, "is damaged");
            if (part.p_type != PT_LOAD || part.p_filesz == 0) continue;
            if (part.p_paddr >= kEepromBase) continue;
            if (part.p_offset + part.p_filesz > size) refuse(path_, "is cut short");
            place(image, path_, static_cast<uint32_t>(part.p_paddr),
                  reinterpret_cast<const uint8_t*>(raw) + part.p_offset, part.p_filesz);
        }
        if (image.flash.empty()) refuse(path_, "holds no program");
    }

    uint32_t ramBytes() {
        uint32_t sum = 0;
        for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf_, section));) {
            GElf_Shdr header;
            if (!gelf_getshdr(section, &header) || !(header.sh_flags & SHF_ALLOC)) continue;
            if (header.sh_addr < kRamBase || header.sh_addr >= kEepromBase) continue;
            sum += static_cast<uint32_t>(header.sh_size);
        }
        return sum;
    }

private:
    ElfFile(const std::string& path, int file) : path_(path), file_(file) {}

    std::string path_;
    int file_;
    Elf* elf_ = nullptr;
    GElf_Ehdr header_ = {};
};

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

Image readHex(const std::string& path) {
    enum : uint8_t { kData = 0, kEnd = 1, kSegment = 2, kLinear = 4 };
    std::ifstream file(path);
    if (!file) refuse(path, "cannot be opened");
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
        if (record[3] == kData)
            place(image, path, base + (record[1] << 8 | record[2]), &record[4], record[0]);
        if (record[3] == kSegment) base = word << 4;
        if (record[3] == kLinear) base = word << 16;
        ended = record[3] == kEnd;
    }
    if (!ended) refuse(path, "ends without an end record: cut short, or no Intel hex");
    if (image.flash.empty()) refuse(path, "holds no program");
    return image;
}

}  // namespace

Image readImage(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    char start[4] = {};
    if (!file) refuse(path, "cannot be opened");
    file.read(start, sizeof start);
    if (std::equal(start, start + SELFMAG, ELFMAG)) {
        Image image;
        ElfFile elf(path);
        elf.loadFlash(image);
        image.ram_static_bytes = elf.ramBytes();
        return image;
    }
    if (start[0] == ':') return readHex(path);
    refuse(path, "is neither an ELF nor an Intel hex file");
}

}  // namespace simulator
