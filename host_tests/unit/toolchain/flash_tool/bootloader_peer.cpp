// SPDX-License-Identifier: GPL-3.0-or-later
// A board's bootloader on a pseudo-terminal: the STK500v2 protocol (Atmel's application note
// AVR068) as a bootloader speaks it, with the faults that are asked for. Prints the port, answers
// until its input ends, then leaves its memories as flash.bin and eeprom.bin and what it was asked
// as conversation.txt. A pseudo-terminal has no DTR: it is always just after its reset.
//   bootloader_peer FOLDER [--silent] [--signature 1e9703] [--stuck ADDRESS]
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using Bytes = std::vector<uint8_t>;

enum Command : uint8_t {
    kSignOn = 0x01,
    kGetParameter = 0x03,
    kLoadAddress = 0x06,
    kEnter = 0x10,
    kLeave = 0x11,
    kChipErase = 0x12,
    kProgramFlash = 0x13,
    kReadFlash = 0x14,
    kProgramEeprom = 0x15,
    kReadEeprom = 0x16,
    kReadFuse = 0x18,
    kReadLock = 0x1A,
    kReadSignature = 0x1B,
    kSpiMulti = 0x1D,
};
constexpr uint8_t kOk = 0x00, kFailed = 0xC0, kUnknown = 0xC9;
constexpr uint8_t kStart = 0x1B, kToken = 0x0E;
constexpr uint32_t kFlashSize = 0x40000, kBootloader = 0x3E000, kPage = 256;

struct Faults {
    bool silent = false;
    std::array<uint8_t, 3> signature = {0x1E, 0x98, 0x01};
    uint32_t stuck = UINT32_MAX;  // a byte of flash that reads 0x00 whatever was written
};

class Bootloader {
public:
    explicit Bootloader(const Faults& faults) : faults_(faults) {}

    Bytes answer(const Bytes& asked) {
        note(asked);
        switch (asked[0]) {
            case kSignOn:
                return {kSignOn, kOk, 8, 'A', 'V', 'R', 'I', 'S', 'P', '_', '2'};
            case kGetParameter:
                return {kGetParameter, kOk, 2};
            case kLoadAddress:
                return load(asked);
            case kEnter:
            case kLeave:
                return {asked[0], kOk};
            case kProgramFlash:
                return programFlash(asked);
            case kProgramEeprom:
                return programEeprom(asked);
            case kReadFlash:
            case kReadEeprom:
                return read(asked);
            case kReadFuse:
            case kReadLock:
            case kReadSignature:
                return {asked[0], kOk, instruction(&asked.at(2)), kOk};
            case kSpiMulti:
                return {kSpiMulti, kOk, 0, asked.at(4), 0, instruction(&asked.at(4)), kOk};
            default:  // also the chip erase, which bootloaders do not have
                return {asked[0], asked[0] == kChipErase ? kFailed : kUnknown};
        }
    }

    void save(const std::string& folder) const {
        const auto write = [&](const char* name, const auto& what) {
            std::ofstream file(folder + "/" + name, std::ios::binary);
            file.write(reinterpret_cast<const char*>(what.data()),
                       static_cast<std::streamsize>(what.size()));
        };
        write("flash.bin", flash_);
        write("eeprom.bin", eeprom_);
        write("conversation.txt", conversation_);
    }

private:
    // One line for a run of requests of the same kind; the addresses in between are not reported.
    void note(const Bytes& asked) {
        static const std::map<uint8_t, std::string> names = {
            {kSignOn, "sign on"},          {kEnter, "enter programming"},
            {kLeave, "leave programming"}, {kProgramFlash, "program flash"},
            {kReadFlash, "read flash"},    {kProgramEeprom, "program eeprom"},
            {kReadEeprom, "read eeprom"},  {kReadSignature, "read signature"},
            {kChipErase, "chip erase"}};
        const auto name = names.find(asked[0]);
        if (name == names.end() || last_ == asked[0]) return;
        conversation_ += name->second + "\n";
        last_ = asked[0];
    }

    Bytes load(const Bytes& asked) {
        const uint32_t words = uint32_t{asked.at(1)} << 24 | uint32_t{asked.at(2)} << 16 |
                               uint32_t{asked.at(3)} << 8 | asked.at(4);
        address_ = words & 0x7FFFFFFF;  // the top bit says: use the extended address
        return {kLoadAddress, kOk};
    }

    // Words are counted in flash, bytes in EEPROM.
    Bytes programFlash(const Bytes& asked) {
        const uint32_t size = uint32_t{asked.at(1)} << 8 | asked.at(2), begin = address_ * 2;
        if (begin % kPage != 0 || size > kPage || begin + size > kBootloader)
            return {kProgramFlash, kFailed};
        for (uint32_t i = 0; i < kPage; ++i)  // the page is erased as a whole
            flash_[begin + i] = i < size ? asked.at(10 + i) : 0xFF;
        address_ += size / 2;
        return {kProgramFlash, kOk};
    }

    Bytes programEeprom(const Bytes& asked) {
        const uint32_t size = uint32_t{asked.at(1)} << 8 | asked.at(2);
        if (address_ + size > eeprom_.size()) return {kProgramEeprom, kFailed};
        for (uint32_t i = 0; i < size; ++i) eeprom_[address_++] = asked.at(10 + i);
        return {kProgramEeprom, kOk};
    }

    Bytes read(const Bytes& asked) {
        const bool flash = asked[0] == kReadFlash;
        const Bytes& memory = flash ? flash_ : eeprom_;
        const uint32_t size = uint32_t{asked.at(1)} << 8 | asked.at(2);
        const uint32_t begin = flash ? address_ * 2 : address_;
        if (begin + size > memory.size()) return {asked[0], kFailed};
        Bytes reply = {asked[0], kOk};
        for (uint32_t i = 0; i < size; ++i)
            reply.push_back(flash && begin + i == faults_.stuck ? 0 : memory[begin + i]);
        reply.push_back(kOk);
        address_ += flash ? size / 2 : size;
        return reply;
    }

    // The serial programming instructions that a bootloader answers for the chip: data sheet,
    // section "Serial Programming Instruction set".
    uint8_t instruction(const uint8_t* bytes) const {
        const bool second = bytes[1] == 0x08;
        if (bytes[0] == 0x30) return faults_.signature.at(bytes[2] % 3);
        if (bytes[0] == 0x50) return second ? 0xFD : 0xFF;  // extended, low fuse
        if (bytes[0] == 0x58) return second ? 0xD8 : 0xCF;  // high fuse, lock bits
        return 0;
    }

    Faults faults_;
    // an older firmware, and its parameters
    Bytes flash_ = Bytes(kFlashSize, 0x5A), eeprom_ = Bytes(4096, 0xA5);
    uint32_t address_ = 0;
    uint8_t last_ = 0;
    std::string conversation_;
};

// Message framing: start, sequence number, size, token, body, exclusive or of all.
class Wire {
public:
    // The body of a message when this byte completes a right one.
    const Bytes* take(uint8_t byte) {
        message_.push_back(byte);
        if (message_[0] != kStart || (message_.size() == 5 && byte != kToken)) message_.clear();
        if (message_.size() < 6) return nullptr;
        const size_t size = size_t{message_[2]} << 8 | message_[3];
        if (message_.size() < size + 6) return nullptr;
        uint8_t sum = 0;
        for (uint8_t each : message_) sum ^= each;
        sequence_ = message_[1];
        body_.assign(message_.begin() + 5, message_.end() - 1);
        message_.clear();
        return sum == 0 && !body_.empty() ? &body_ : nullptr;
    }

    Bytes wrap(const Bytes& body) const {
        Bytes all;
        for (size_t each : {size_t{kStart}, size_t{sequence_}, body.size() >> 8, body.size() & 255,
                            size_t{kToken}})
            all.push_back(static_cast<uint8_t>(each));
        for (uint8_t each : body) all.push_back(each);
        uint8_t sum = 0;
        for (uint8_t each : all) sum ^= each;
        all.push_back(sum);
        return all;
    }

private:
    Bytes message_, body_;
    uint8_t sequence_ = 0;
};

int openTerminal() {
    int ours, theirs;
    char name[100];
    termios raw{};
    cfmakeraw(&raw);
    if (openpty(&ours, &theirs, name, &raw, nullptr) != 0) throw std::runtime_error("no terminal");
    close(theirs);  // else it would look as if this program held the port
    printf("%s\n", name);
    fflush(stdout);
    return ours;
}

void serve(int terminal, const Faults& faults, Bootloader& bootloader) {
    Wire wire;
    pollfd inputs[] = {{STDIN_FILENO, POLLIN, 0}, {terminal, POLLIN, 0}};
    for (;;) {
        poll(inputs, 2, -1);
        if (inputs[0].revents != 0) return;
        uint8_t bytes[512];
        const ssize_t count = read(terminal, bytes, sizeof bytes);
        if (count <= 0)  // nobody has opened the port
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        for (ssize_t i = 0; i < count && !faults.silent; ++i) {
            const Bytes* asked = wire.take(bytes[i]);
            if (asked == nullptr) continue;
            const Bytes reply = wire.wrap(bootloader.answer(*asked));
            if (write(terminal, reply.data(), reply.size()) < 0) return;
        }
    }
}

Faults readFaults(int count, char** words) {
    Faults faults;
    for (int i = 2; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--silent") {
            faults.silent = true;
            continue;
        }
        const unsigned long value = std::strtoul(words[++i], nullptr, 16);
        if (word == "--stuck") faults.stuck = static_cast<uint32_t>(value);
        if (word == "--signature")
            for (int byte = 0; byte < 3; ++byte)
                faults.signature.at(byte) = static_cast<uint8_t>(value >> (16 - 8 * byte));
    }
    return faults;
}

}  // namespace

int main(int count, char** words) {
    const Faults faults = readFaults(count, words);
    Bootloader bootloader(faults);
    serve(openTerminal(), faults, bootloader);
    bootloader.save(words[1]);
}
