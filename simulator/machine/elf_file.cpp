// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/elf_file.hpp"

#include <elf.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "simulator/machine/registers.hpp"

namespace simulator {
namespace {

constexpr uint32_t kFamilyMask = 0x7F, kFamilyAvr6 = 6;  // e_flags: ATmega2560, 2561

// avr-gcc gives every memory of the chip a place of its own among the addresses.
struct Memory {
    const char* name;
    uint32_t begin, size;
};
constexpr Memory kFlash = {"flash", 0, kFlashSize};
constexpr uint32_t kRamBegin = 0x800000;
constexpr Memory kEeprom = {"EEPROM", 0x810000, kEepromBytes};
constexpr Memory kFuses = {"the fuses", 0x820000, 3};
constexpr Memory kLock = {"the lock bits", 0x830000, 1};
constexpr Memory kSignature = {"the signature", 0x840000, 3};
constexpr Memory kMemories[] = {kFlash, kEeprom, kFuses, kLock, kSignature};

bool holds(const Memory& memory, uint64_t address, uint64_t size) {
    return address >= memory.begin && address + size <= uint64_t{memory.begin} + memory.size;
}

std::string hex(uint32_t address) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%x", address);
    return text;
}

class ElfReader {
public:
    ElfReader(const std::string& path, const std::string& bytes, uint16_t ram_end)
        : path_(path), bytes_(bytes), ram_{"RAM", kRamBegin, ram_end + 1u} {
        header_ = at<Elf32_Ehdr>(0, "is not a whole ELF file");
        if (header_.e_machine != EM_AVR) refuse("is an ELF file, but not for an AVR");
        if (header_.e_ident[EI_CLASS] != ELFCLASS32 || header_.e_ident[EI_DATA] != ELFDATA2LSB)
            refuse("is no ELF file of 32 bits, least byte first, as an AVR's is");
        if ((header_.e_flags & kFamilyMask) != kFamilyAvr6)
            refuse("is built for another AVR than the ATmega2560");
        if (header_.e_type != ET_EXEC) refuse("is no linked program");
    }

    Image image() const {
        Image image;
        for (unsigned i = 0; i < header_.e_phnum; ++i) addSegment(image, segment(i));
        if (image.flash.empty()) refuse("holds no program");
        image.ram_static_bytes = ramBytes();
        return image;
    }

private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw std::runtime_error(path_ + ": " + why);
    }

    template <class T>
    T at(uint64_t offset, const char* otherwise) const {
        T value;
        if (offset + sizeof value > bytes_.size()) refuse(otherwise);
        std::memcpy(&value, &bytes_[offset], sizeof value);
        return value;
    }

    Elf32_Phdr segment(unsigned number) const {
        if (header_.e_phentsize != sizeof(Elf32_Phdr)) refuse("is damaged: its segments' size");
        return at<Elf32_Phdr>(uint64_t{header_.e_phoff} + number * sizeof(Elf32_Phdr),
                              "is cut short: its segments are missing");
    }

    Elf32_Shdr section(unsigned number) const {
        if (header_.e_shentsize != sizeof(Elf32_Shdr)) refuse("is damaged: its sections' size");
        return at<Elf32_Shdr>(uint64_t{header_.e_shoff} + number * sizeof(Elf32_Shdr),
                              "is cut short: its sections are missing");
    }

    // Where it is used, and where its contents are stored: .data is in both RAM and flash.
    void checkMemory(const Elf32_Phdr& part) const {
        const auto inside = [this](uint32_t address, uint32_t size) {
            return holds(ram_, address, size) ||
                   std::any_of(std::begin(kMemories), std::end(kMemories),
                               [=](const Memory& memory) { return holds(memory, address, size); });
        };
        if (part.p_paddr < kRamBegin && !holds(kFlash, part.p_paddr, part.p_filesz))
            refuse("is larger than the 256 KiB of flash");
        if (!inside(part.p_vaddr, part.p_memsz) || !inside(part.p_paddr, part.p_filesz) ||
            part.p_memsz < part.p_filesz)
            refuse("is damaged: its segment at " + hex(part.p_vaddr) +
                   " fits no memory of the chip");
        if (part.p_filesz > 0 && holds(ram_, part.p_paddr, 0))
            refuse("is damaged: RAM cannot be programmed, as its segment at " + hex(part.p_paddr) +
                   " wants");
    }

    void addSegment(Image& image, const Elf32_Phdr& part) const {
        if (part.p_type != PT_LOAD || (part.p_memsz | part.p_filesz) == 0) return;
        checkMemory(part);
        if (uint64_t{part.p_offset} + part.p_filesz > bytes_.size()) refuse("is cut short");
        if (part.p_filesz > 0 && holds(kFlash, part.p_paddr, part.p_filesz))
            image.place(part.p_paddr, bytes_.data() + part.p_offset, part.p_filesz);
    }

    std::optional<uint32_t> ramBytes() const {
        if (header_.e_shnum == 0) return std::nullopt;
        uint32_t sum = 0;
        for (unsigned i = 0; i < header_.e_shnum; ++i) {
            const Elf32_Shdr part = section(i);
            if ((part.sh_flags & SHF_ALLOC) == 0 || !holds(ram_, part.sh_addr, 0)) continue;
            if (!holds(ram_, part.sh_addr, part.sh_size))
                refuse("is damaged: its section at " + hex(part.sh_addr) + " is larger than RAM");
            sum += part.sh_size;
        }
        return sum;
    }

    const std::string& path_;
    const std::string& bytes_;
    const Memory ram_;
    Elf32_Ehdr header_;
};

}  // namespace

bool looksLikeElf(const std::string& bytes) { return bytes.compare(0, SELFMAG, ELFMAG) == 0; }

Image readElf(const std::string& path, const std::string& bytes, uint16_t ram_end) {
    return ElfReader(path, bytes, ram_end).image();
}

}  // namespace simulator
