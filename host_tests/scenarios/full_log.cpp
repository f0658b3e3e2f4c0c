// SPDX-License-Identifier: GPL-3.0-or-later
// A board whose DataFlash is full of logs, whose ring has gone round: how long the image looks for
// the end, what it lists, that the next log takes the place of the oldest and no frame is late
// meanwhile. Then the same with a blank chip. Exits 0 when all is as it should be.
//   full_log FIRMWARE apm1|apm2 MINUTES_FILE
#include <algorithm>
#include <cstdio>
#include <vector>

#include "hal/page_flash.hpp"
#include "host_tests/scenarios/flight_report.hpp"
#include "host_tests/scenarios/station.hpp"
#include "logging/page.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

constexpr uint64_t kLongestSearch_us = 50'000;
constexpr uint16_t kFirstPage = hal::kFlashMissionPages;
constexpr uint16_t kPagesOfLog = 700;
constexpr uint16_t kNewestAt = 2900;  // place of the newest page in the ring, in mid-chip
// Its log's number: with all others before it, and where they have gone round at 65535.
constexpr uint16_t kNewest = 40, kNewestRound = 3;

void putPage(std::vector<uint8_t>& pages, size_t page, size_t page_size, logging::Key key) {
    uint8_t* at = &pages[page * page_size];
    logging::PageHead head{};
    head.key = key;
    head.used = static_cast<uint16_t>(page_size - sizeof head);
    for (size_t i = sizeof head; i < page_size; ++i) at[i] = static_cast<uint8_t>(7 * i + page);
    head.data_crc = core::crc16(core::kCrcStart, at + sizeof head, head.used);
    head.head_crc = logging::crcOf(head);
    std::memcpy(at, &head, sizeof head);
}

uint16_t numberOf(int log) { return static_cast<uint16_t>(log > 0 ? log : log + 65535); }

// Logs of equal length, the newest ending at kNewestAt, then round the ring to the oldest.
std::vector<uint8_t> fullChip(const At45db& chip, uint16_t newest) {
    const uint16_t ring = chip.pages() - kFirstPage;
    std::vector<uint8_t> pages(size_t{chip.pages()} * chip.pageSize(), 0xFF);
    const uint32_t room = chip.pageSize() - sizeof(logging::PageHead);
    for (uint16_t age = 0; age + 1 < ring; ++age) {  // the one to be written next is blank
        const uint16_t place = static_cast<uint16_t>((kNewestAt + ring - age) % ring);
        const uint16_t log = numberOf(newest - age / kPagesOfLog);
        const uint32_t before = (kPagesOfLog - 1 - age % kPagesOfLog) * room;
        putPage(pages, kFirstPage + place, chip.pageSize(), {log, before});
    }
    return pages;
}

class Bench {
public:
    Bench(const std::string& firmware, const BoardWiring& wiring)
        : board_(firmware, WorldOptions{}, wiring), station_(board_) {
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart != Station::kUsb) return;
            station_.link().receive(byte, at_us);
            logs_.receive(byte, at_us);
        });
        chip().on_read = [this](uint16_t page, uint64_t now_us) { wasRead(page, now_us); };
        chip().on_operation = [this](const At45db::Operation& operation) {
            if (operation.first_page >= kFirstPage) written_.push_back(operation.first_page);
        };
    }
    At45db& chip() { return board_.world().dataflash(); }

    void start() {
        station_.connect();
        board_.world().radio().sticks({1500, 1500, 1100, 1500, 1500, 1500, 1500, 1165}, true);
        station_.run_us(3'000'000);
    }
    uint64_t search_us() const { return last_read_us_ - first_read_us_; }
    uint64_t known_us() const { return last_read_us_ - board_.begun_us(); }
    bool reportedBlank() const { return reported_blank_; }

    std::vector<mavlink::LogEntry> list() {
        entries_.clear();
        mavlink::LogRequestList ask{};
        ask.end = 0xFFFF;
        ask.target_system = station_.system();
        ask.target_component = 1;
        logs_.send(ask);
        station_.waitUntil("the list's end", 10, [this] {
            return !entries_.empty() && entries_.back().id == entries_.back().last_log_num;
        });
        return entries_;
    }

    // Pages of the log written while armed.
    std::vector<uint16_t> fly(uint64_t time_us) {
        written_.clear();
        station_.arm(true);
        station_.run_us(time_us);
        station_.arm(false);
        station_.run_us(1'000'000);
        return written_;
    }
    uint32_t lateFrames() const { return board_.figures().frame_overruns.value_or(1); }
    double minutes() const { return static_cast<double>(board_.time_us()) / 60e6; }

private:
    void wasRead(uint16_t page, uint64_t now_us) {
        if (page < kFirstPage || now_us > 2'000'000) return;
        if (first_read_us_ == 0) first_read_us_ = now_us;
        last_read_us_ = now_us;
    }

    AvrBoard board_;
    Station station_;
    Link logs_{board_, Station::kUsb, [this](const mavlink::Frame& frame, uint64_t) {
                   if (const auto entry = as<mavlink::LogEntry>(frame)) entries_.push_back(*entry);
                   if (const auto text = as<mavlink::Statustext>(frame))
                       reported_blank_ |= std::strncmp(text->text, "No logs", 8) == 0;
               }};
    std::vector<mavlink::LogEntry> entries_;
    std::vector<uint16_t> written_;
    bool reported_blank_ = false;
    uint64_t first_read_us_ = 0, last_read_us_ = 0;
};

bool all_well = true;

void expect(bool as_expected, const char* what, double value, const char* unit) {
    std::printf("  %s %s: %.4g %s\n", as_expected ? "ok    " : "FAILED", what, value, unit);
    all_well = all_well && as_expected;
}

bool inSequence(const std::vector<uint16_t>& pages, uint16_t first) {
    for (size_t i = 0; i < pages.size(); ++i)
        if (pages[i] != first + i) return false;
    return true;
}

double tryFull(const std::string& firmware, const BoardWiring& wiring, uint16_t newest) {
    std::printf("a full chip, its newest log number %d\n", newest);
    Bench bench(firmware, wiring);
    const uint16_t ring = bench.chip().pages() - kFirstPage;
    bench.chip().setImage(fullChip(bench.chip(), newest));
    bench.start();
    expect(bench.search_us() <= kLongestSearch_us, "looked for the end of the logs",
           static_cast<double>(bench.search_us()) / 1000, "ms");
    expect(bench.known_us() <= 300'000, "had found it after the program began in",
           static_cast<double>(bench.known_us()) / 1000, "ms");
    expect(!bench.reportedBlank(), "nobody calls it blank", bench.reportedBlank(), "");
    const int logs = (ring - 2) / kPagesOfLog + 1;
    const auto before = bench.list();
    expect(static_cast<int>(before.size()) == logs, "lists as many logs as there are",
           static_cast<double>(before.size()), "logs");
    expect(before.back().id == newest, "the newest is", before.back().id, "");
    expect(before.front().id == numberOf(newest - logs + 1), "the oldest is", before.front().id,
           "");
    expect(before.front().num_logs == logs, "says that there are", before.front().num_logs, "logs");
    const auto pages = bench.fly(8'000'000);
    expect(pages.size() > 10 && inSequence(pages, kFirstPage + kNewestAt + 1),
           "wrote on behind the newest page", static_cast<double>(pages.size()), "pages");
    const auto after = bench.list();
    expect(after.back().id == newest + 1 && after.back().size > 10'000, "the new log has",
           after.back().size, "bytes");
    expect(after.front().size < before.front().size, "the oldest gave way to it, by",
           static_cast<double>(before.front().size) - after.front().size, "bytes");
    expect(bench.lateFrames() == 0, "frames late", bench.lateFrames(), "");
    return bench.minutes();
}

double tryBlank(const std::string& firmware, const BoardWiring& wiring) {
    std::printf("a blank chip\n");
    Bench bench(firmware, wiring);
    bench.start();
    expect(bench.known_us() <= 300'000, "had seen that after the program began in",
           static_cast<double>(bench.known_us()) / 1000, "ms");
    expect(bench.reportedBlank(), "the ground was notified", bench.reportedBlank(), "");
    const auto none = bench.list();
    expect(none.size() == 1 && none[0].num_logs == 0, "lists no logs", none[0].num_logs, "logs");
    const auto pages = bench.fly(4'000'000);
    expect(pages.size() > 5 && inSequence(pages, kFirstPage), "wrote at the ring's beginning",
           static_cast<double>(pages.size()), "pages");
    const auto one = bench.list();
    expect(one.size() == 1 && one[0].id == 1, "lists the first log", one[0].id, "");
    expect(bench.lateFrames() == 0, "frames late", bench.lateFrames(), "");
    return bench.minutes();
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("expected FIRMWARE apm1|apm2 MINUTES_FILE");
    const BoardWiring& wiring = std::string(argv[2]) == "apm1" ? kApm1Wiring : kApm2Wiring;
    writeMinutes(argv[3], tryFull(argv[1], wiring, kNewest) +
                              tryFull(argv[1], wiring, kNewestRound) + tryBlank(argv[1], wiring));
    return all_well ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "full_log: %s\n", error.what());
    return 1;
}
