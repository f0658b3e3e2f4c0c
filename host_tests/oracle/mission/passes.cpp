// SPDX-License-Identifier: GPL-3.0-or-later
#include "passes.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace mission_tool {
namespace {

using mission::Class;

class Passes {
public:
    Passes(const std::vector<PassItem>& items, const PassCost& cost)
        : items_(items), cost_(cost), count_(items.size()), most_steps_(2 * items.size()) {}
    virtual ~Passes() = default;

    LongPass longest() {
        for (size_t i = 1; i < count_; ++i) consider(sought(i, 0), i);
        behindConditions();
        return longest_;
    }

protected:
    // The rest of a pass in which a NAV is sought from `from` on, after so many steps.
    virtual double sought(size_t from, size_t steps) = 0;
    // Those that begin when a CONDITION has ended.
    virtual void behindConditions() = 0;

    void consider(double cost, size_t begins) {
        if (cost > longest_.cost) longest_ = {cost, begins};
    }

    bool is(size_t i, Class kind) const { return items_[i].good && items_[i].kind == kind; }
    // The next NAV at or behind a record; count_: there is none.
    size_t nav(size_t from) const {
        while (from < count_ && !is(from, Class::nav)) ++from;
        return from;
    }
    size_t plus(size_t steps, size_t more) const { return std::min(steps + more, most_steps_); }
    double records(size_t number) const { return cost_.record * static_cast<double>(number); }

    const std::vector<PassItem>& items_;
    const PassCost cost_;
    const size_t count_, most_steps_;

private:
    LongPass longest_;
};

// APM 1.0: a jump is taken once a pass; one that comes round is passed over until the next NAV.
class Passes1 : public Passes {
public:
    using Passes::Passes;

private:
    using Jumps = std::set<size_t>;

    double sought(size_t from, size_t steps) override {
        const size_t found = nav(from);
        const size_t looks = found - from + (found < count_);
        if (found == count_) return records(looks);
        return records(looks) + walked(found + 1, plus(steps, looks), {});
    }
    // With what was passed over by then. Each of them may come to further CONDITIONs.
    void behindConditions() override {
        for (size_t done = 0; done < waits_.size(); ++done) {
            const Wait wait = waits_[done];
            consider(walked(wait.first + 1, 0, wait.second), wait.first + 1);
        }
    }

    double walked(size_t at, size_t steps, Jumps blocked) {
        double cost = 0;
        Jumps taken;
        while (at < count_) {
            cost += cost_.record;
            if (is(at, Class::nav)) break;
            if (is(at, Class::condition)) {
                if (known_.insert({at, blocked}).second) waits_.push_back({at, blocked});
                break;
            }
            const bool jump = is(at, Class::jump);
            const bool goes = jump && steps < most_steps_ && blocked.count(at) == 0;
            if (!jump || steps < most_steps_) steps = plus(steps, 1);
            if (is(at, Class::action)) cost += cost_.action;
            if (goes && taken.insert(at).second) {
                at = items_[at].target;
                continue;
            }
            if (goes) blocked.insert(at);
            ++at;
        }
        return cost;
    }

    using Wait = std::pair<size_t, Jumps>;  // for a CONDITION, with what is passed over
    std::set<Wait> known_;
    std::vector<Wait> waits_;
};

// APM 2.0: a jump has the next NAV sought from its target on.
class Passes2 : public Passes {
public:
    Passes2(const std::vector<PassItem>& items, const PassCost& cost, bool trailing)
        : Passes(items, cost), trailing_(trailing) {}

private:
    static constexpr size_t kNone = 0;

    double sought(size_t from, size_t steps) override {
        const size_t found = nav(from);
        if (found < count_) {
            const size_t looks = found - from + 1;
            return records(looks) + walked(from, plus(steps, looks), kNone, found);
        }
        const size_t looks = count_ - from;
        return records(looks) + behindLast(from, plus(steps, looks));
    }

    // No NAV follows: the first jump with count left decides.
    double behindLast(size_t from, size_t steps) {
        double longest = 0;
        for (size_t i = from; i < count_; ++i) {
            if (!is(i, Class::jump)) continue;
            longest = std::max(longest, led(from, steps, i));
            if (!items_[i].counted) return longest;
        }
        return std::max(longest, trailed(from, steps));
    }

    double led(size_t from, size_t steps, size_t jump) {
        const size_t target = items_[jump].target, found = nav(target);
        const size_t looks = found - target + (found < count_);
        steps = plus(steps, looks);
        return records(looks) +
               (found < count_ ? walked(from, steps, jump, found) : trailed(from, steps));
    }

    double trailed(size_t from, size_t steps) {
        return trailing_ ? walked(from, steps, kNone, count_) : 0;
    }

    void behindConditions() override {
        for (size_t i = 1; i < count_; ++i)
            if (is(i, Class::condition)) consider(behindCondition(i + 1), i + 1);
    }

    double behindCondition(size_t from) {
        const size_t found = nav(from);
        if (found < count_) return walked(from, 0, kNone, found);
        double longest = 0;
        for (size_t i = from; i < count_; ++i) {
            if (!is(i, Class::jump)) continue;
            const size_t led_to = nav(items_[i].target);
            longest =
                std::max(longest, led_to < count_ ? walked(from, 0, i, led_to) : trailed(from, 0));
            if (!items_[i].counted) return longest;
        }
        return std::max(longest, trailed(from, 0));
    }

    // The chain from a record to `end`, by way of the jump `loop` where there is one.
    double walked(size_t at, size_t steps, size_t loop, size_t end) {
        if (loop == kNone && at >= end) return 0;
        const auto state = std::make_tuple(at, steps, loop, end);
        const auto known = known_.find(state);
        if (known != known_.end()) return known->second;
        const double cost = cost_.record + behind(at, steps, loop, end);
        known_[state] = cost;
        return cost;
    }

    double behind(size_t at, size_t steps, size_t loop, size_t end) {
        if (is(at, Class::condition)) return 0;
        if (loop != kNone && at == loop) return walked(items_[at].target, steps, kNone, end);
        if (!is(at, Class::jump))
            return (is(at, Class::action) ? cost_.action : 0) +
                   walked(at + 1, plus(steps, 1), loop, end);
        if (steps >= most_steps_) return walked(at + 1, steps, loop, end);
        const double taken = sought(items_[at].target, steps + 1);
        return items_[at].counted ? std::max(taken, walked(at + 1, steps + 1, loop, end)) : taken;
    }

    const bool trailing_;
    std::map<std::tuple<size_t, size_t, size_t, size_t>, double> known_;
};

}  // namespace

LongPass longestPass(mission::Set set, const std::vector<PassItem>& items, bool trailing,
                     const PassCost& cost) {
    if (set == mission::Set::apm1) return Passes1(items, cost).longest();
    return Passes2(items, cost, trailing).longest();
}

size_t jumpThatGoesRound(mission::Set set, const std::vector<PassItem>& items) {
    for (size_t first = 1; first < items.size(); ++first) {
        std::set<size_t> taken;
        for (size_t at = first; at < items.size();) {
            const PassItem& item = items[at];
            const bool ends =
                item.good && (item.kind == Class::nav || item.kind == Class::condition);
            if (ends) break;
            const bool goes = item.good && item.kind == Class::jump &&
                              (set == mission::Set::apm1 || !item.counted);
            if (goes && !taken.insert(at).second) return at;
            at = goes ? item.target : at + 1;
        }
    }
    return 0;
}

}  // namespace mission_tool
