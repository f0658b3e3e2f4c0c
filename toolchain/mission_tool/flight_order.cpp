// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/flight_order.hpp"

#include <algorithm>
#include <map>

#include "firmware/mission/command_table.hpp"
#include "firmware/state/parameters.hpp"
#include "mission/sequencer.hpp"
#include "toolchain/mission_tool/board.hpp"

namespace mission_tool {
namespace {

using mission::Class;
using mission::Event;
using mission::Progress;
using mission::Record;

constexpr uint8_t kLoiterUnlimited = 0x11;
constexpr size_t kMaxVisits = 5000;
constexpr int kMaxPolls = 2'000'000;  // each takes one record

class Flight;
Flight* flown;  // what the engine's plain functions speak to

// The firmware's table, in which all that would move an airplane only says so.
struct Rows {
    std::vector<mission::Row> rows;
    std::vector<mission::Target> targets;
    mission::Table table;
};
const Rows& rows();

class Flight {
public:
    explicit Flight(const Document& document)
        : document_(document), engine_(rows().table, kHost, memory_) {
        flown = this;
        engine_.boot(document.set, 1, false, 0);
    }

    FlightOrder run() {
        engine_.enter(false);
        for (int i = 0; i < kMaxPolls && !over_; ++i) {
            jump_target_ = 0;
            engine_.poll(firmware::state::parameters.mission_trailing != 0);
            // one of the 2.0 set that is taken abandons what is flown
            if (jump_target_ != 0 && engine_.next() == jump_target_ &&
                document_.set == mission::Set::apm2)
                flying_ = false;
            finish_nav_ = finish_condition_ = false;
            if (!over_ && !engine_.midPass()) goOn();
        }
        if (!over_) order_.end = FlightOrder::End::longer;
        return order_;
    }

    // ---- what the engine asks and says
    core::Status read(uint8_t index, uint8_t* to) const {
        mission::pack(document_.set, document_.entries[index].record, to);
        return core::Status::ok;
    }
    uint8_t count() const { return static_cast<uint8_t>(document_.entries.size()); }
    void begin(bool from_here) { from_here_ = from_here; }
    Progress navDone() const { return finish_nav_ ? Progress::done : Progress::running; }
    Progress conditionDone() const {
        return finish_condition_ ? Progress::done : Progress::running;
    }
    // Asked also of one that the engine only looks at, and does not come to.
    void jumps(const Record& record, uint8_t target) {
        const uint8_t at = engine_.next();
        if (at >= count() || !same(record, document_.entries[at].record)) return;
        jump_target_ = target;
        accompany(at);
    }
    void event(Event event, uint8_t index) {
        switch (event) {
            case Event::started:
                start(index);
                break;
            case Event::reached:
                flying_ = false;
                break;
            case Event::hold:
                order_.visits.push_back({0, false, {}});
                flying_ = true;
                break;
            case Event::runs:
            case Event::waits:
                accompany(index);
                break;
            case Event::complete:
            case Event::landed:
                order_.end = event == Event::landed ? FlightOrder::End::landed
                                                    : FlightOrder::End::complete;
                over_ = true;
                break;
            default:
                break;
        }
    }

private:
    static const mission::Host kHost;

    bool same(const Record& a, const Record& b) const {
        uint8_t bytes[2][mission::kRecordSize];
        mission::pack(document_.set, a, bytes[0]);
        mission::pack(document_.set, b, bytes[1]);
        return std::equal(bytes[0], bytes[0] + sizeof bytes[0], bytes[1]);
    }

    void accompany(size_t index) {
        auto& to = flying_ ? order_.visits.back().beside : pending_;
        if (to.size() < kMaxVisits) to.push_back(index);
    }

    void start(size_t nav) {
        const auto [seen, fresh] = seen_.emplace(stateNow(), order_.visits.size());
        if (!fresh || order_.visits.size() >= kMaxVisits) {
            order_.end = fresh ? FlightOrder::End::longer : FlightOrder::End::repeats;
            order_.again = seen->second;
            over_ = true;
            return;
        }
        order_.visits.push_back({nav, from_here_, pending_});
        pending_.clear();
        waited_.clear();
        flying_ = true;
    }

    // Two starts with the same of all this have the same future.
    std::string stateNow() const {
        std::string state(1, static_cast<char>(memory_.nav));
        state += static_cast<char>(engine_.next());
        state.append(reinterpret_cast<const char*>(&memory_.counters), sizeof memory_.counters);
        state.append(reinterpret_cast<const char*>(&memory_.jumps), sizeof memory_.jumps);
        return state;
    }

    // Between two passes: what is under way comes to its end.
    void goOn() {
        if (engine_.ended()) {
            over_ = true;
        } else if (engine_.conditionRuns() &&
                   std::count(waited_.begin(), waited_.end(), memory_.condition) < 2) {
            waited_.push_back(memory_.condition);  // twice: a jump leads back to it
            finish_condition_ = true;
        } else if (memory_.nav_record.id == kLoiterUnlimited) {
            order_.end = FlightOrder::End::circles;
            over_ = true;
        } else {
            finish_nav_ = true;
        }
    }

    const Document& document_;
    mission::Memory memory_ = {};
    mission::Sequencer engine_;
    FlightOrder order_;
    std::vector<size_t> pending_;  // of the NAV that is loaded and not yet started
    std::vector<uint8_t> waited_;  // CONDITIONs ended beside this NAV
    std::map<std::string, size_t> seen_;
    uint8_t jump_target_ = 0;
    bool from_here_ = true, flying_ = false, over_ = false;
    bool finish_nav_ = false, finish_condition_ = false;
};

const mission::Host Flight::kHost = {
    [](uint8_t index, uint8_t* to) { return flown->read(index, to); },
    [] { return flown->count(); },
    [](Event event, uint8_t index) { flown->event(event, index); },
    [](Record&) {},
    [] { return true; },  // one record a poll
};

mission::Jump jumpOf(const Record& record) {
    const uint8_t row = rows().table.find(mission::Set::apm2, record.id);
    const uint8_t row1 = rows().table.find(mission::Set::apm1, record.id);
    const bool is2 = row != mission::kNoRow && rows().targets[row] != nullptr;
    const mission::Jump jump = rows().targets[is2 ? row : row1](record);
    flown->jumps(record, jump.target);
    return jump;
}

Rows makeRows() {
    using firmware::mission::kCommandTable;
    Rows made;
    for (uint8_t i = 0; i < kCommandTable.count; ++i) {
        mission::Row row = core::romRead(kCommandTable.rows[i]);
        made.targets.push_back(row.target);
        row.act = [](const Record&) {};
        row.begin = [](const Record&, mission::LegStart entry) { flown->begin(entry.from_here); };
        row.check = row.kind == Class::nav ? [](const Record&) { return flown->navDone(); }
                                           : [](const Record&) { return flown->conditionDone(); };
        if (row.kind == Class::jump) row.target = jumpOf;
        made.rows.push_back(row);
    }
    made.table = {nullptr, kCommandTable.count};
    return made;
}

const Rows& rows() {
    static const Rows kRows = [] {
        static Rows made = makeRows();
        made.table.rows = made.rows.data();
        return made;
    }();
    return kRows;
}

}  // namespace

FlightOrder flightOrder(const Document& document) {
    const auto& entries = document.entries;
    const bool good = std::all_of(entries.begin() + 1, entries.end(),
                                  [](const Entry& entry) { return entry.good(); });
    const bool has_nav = std::any_of(entries.begin() + 1, entries.end(),
                                     [](const Entry& entry) { return entry.is(Class::nav); });
    if (!good || !has_nav || entries.size() > kMaxItems) return {};
    return Flight(document).run();
}

std::vector<std::vector<size_t>> flownBeside(const Document& document, const FlightOrder& order) {
    std::vector<std::vector<size_t>> navs(document.entries.size());
    for (const Visit& visit : order.visits) {
        const auto add = [&](size_t item) {
            auto& of = navs[item];
            if (std::find(of.begin(), of.end(), visit.nav) == of.end()) of.push_back(visit.nav);
        };
        if (visit.nav != 0) add(visit.nav);
        for (const size_t item : visit.beside) add(item);
    }
    return navs;
}

std::string endOf(const FlightOrder& order) {
    switch (order.end) {
        case FlightOrder::End::landed:
            return "ends landed";
        case FlightOrder::End::circles:
            return "circles at item " + std::to_string(order.visits.back().nav) + " for ever";
        case FlightOrder::End::repeats:
            return "goes on from item " + std::to_string(order.visits[order.again].nav) +
                   " again, for ever";
        case FlightOrder::End::longer:
            return "goes on beyond what was looked at";
        case FlightOrder::End::complete:
            break;
    }
    return "ends in RTL";
}

}  // namespace mission_tool
