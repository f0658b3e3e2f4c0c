// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/json_places.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace simulator {
namespace {

constexpr int kMaxLevels = 50;        // a plan has eight
constexpr size_t kMaxEntries = 5000;  // the parser looks through a list at each of its entries
constexpr size_t kMaxKeys = 1000;     // of one object, which is searched from its beginning

// Counts what the parser has taken.
class Counting {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Counting(const char* at, size_t* taken) : at_(at), taken_(taken) {}
    reference operator*() const { return *at_; }
    Counting& operator++() {
        ++at_;
        if (taken_ != nullptr) ++*taken_;
        return *this;
    }
    Counting operator++(int) {
        const Counting before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Counting& other) const { return at_ == other.at_; }
    bool operator!=(const Counting& other) const { return at_ != other.at_; }

private:
    const char* at_;
    size_t* taken_;
};

class Lines {
public:
    explicit Lines(const std::string& text) : begins_{0} {
        for (size_t at = 0; at < text.size(); ++at)
            if (text[at] == '\n') begins_.push_back(at + 1);
    }
    TextPlace at(size_t offset) const {
        const auto behind = std::upper_bound(begins_.begin(), begins_.end(), offset);
        return {static_cast<int>(behind - begins_.begin()),
                static_cast<int>(offset - behind[-1]) + 1};
    }

private:
    std::vector<size_t> begins_;
};

struct TooMuch : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Where each object and list begins, in the order of the text.
class Watcher {
public:
    explicit Watcher(const size_t& taken) : taken_(taken) {}
    bool operator()(int depth, Json::parse_event_t event, const Json&) {
        using Event = Json::parse_event_t;
        if (depth > kMaxLevels) throw TooMuch("at most 50 levels of brackets");
        if (event == Event::object_start || event == Event::array_start) {
            const auto level = static_cast<size_t>(depth);
            begins.push_back(taken_ - 1);
            keys_.resize(level + 2);
            entries_.resize(level + 2);
            keys_.back() = entries_.back() = 0;
            if (++entries_[level] > kMaxEntries)
                throw TooMuch("at most 5000 objects or lists in a list");
        }
        if (event == Event::key && ++keys_.at(static_cast<size_t>(depth)) > kMaxKeys)
            throw TooMuch("at most 1000 keys in an object");
        return true;
    }
    std::vector<size_t> begins;

private:
    const size_t& taken_;
    std::vector<size_t> keys_, entries_;  // by the level of brackets
};

// The containers in the order of the text; the depth is limited above.
void collect(const Json& value, std::vector<const Json*>& found) {
    if (!value.is_structured()) return;
    found.push_back(&value);
    for (const Json& each : value) collect(each, found);
}

std::string wordAt(const std::string& text, size_t at) {
    if (at >= text.size()) return "the end of the file";
    const std::string word = text.substr(at, text.find_first_of(" \t\r\n,", at + 1) - at);
    std::string clean;
    for (const char c : word.substr(0, 40)) clean += c >= 32 && c < 127 ? c : '?';
    return "'" + clean + "'";
}

}  // namespace

PlacedJson::PlacedJson(const std::string& text) : root_(Json::value_t::discarded) {
    const Lines lines(text);
    size_t taken = 0;
    Watcher watcher(taken);
    const auto wrong = [&](size_t at, const std::string& what) {
        problem_ = "expected " + what;
        problem_place_ = lines.at(std::min(at, text.size()));
    };
    try {
        root_ = Json::parse(Counting(text.data(), &taken),
                            Counting(text.data() + text.size(), nullptr), std::ref(watcher));
        std::vector<const Json*> found;
        collect(root_, found);
        if (found.size() != watcher.begins.size())
            wrong(0, "each key once in an object, found one twice");
        for (size_t i = 0; problem_.empty() && i < found.size(); ++i)
            places_[found[i]] = lines.at(watcher.begins[i]);
    } catch (const Json::parse_error& error) {
        const size_t at = error.byte > 0 ? error.byte - 1 : 0;
        wrong(at, "JSON, found " + wordAt(text, at));
    } catch (const Json::exception&) {
        wrong(taken - 1, "a number that can be held, found a larger one");
    } catch (const TooMuch& error) {
        wrong(taken - 1, error.what());
    }
}

TextPlace PlacedJson::placeOf(const Json& value) const {
    const auto found = places_.find(&value);
    return found == places_.end() ? TextPlace{} : found->second;
}

}  // namespace simulator
