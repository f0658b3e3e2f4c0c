// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/log_series.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "shared_tables.hpp"

namespace log_tool {
namespace {

using simulator::DocumentSeries;
using simulator::FlightDocument;

constexpr size_t kMaxSamples = 5000;

struct Thinned {
    size_t time = 0;  // index into the document's times
    std::vector<const Record*> records;
};

class SeriesMaker {
public:
    SeriesMaker(FlightDocument& document, const LogFile& log) : document_(document), log_(log) {}

    void add(const nlohmann::json& row) {
        DocumentSeries series{
            row["name"], row["title"], row["unit"], row["group"], row.value("kind", ""), 0, {}};
        if (isThere(series)) return;
        const Thinned& of = thinned(row["message"]);
        const std::string field = row["field"];
        if (of.records.empty() || of.records.front()->kind->column(field) < 0) return;
        const double scale = row.value("scale", 1.0);
        for (const Record* record : of.records) series.values.push_back((*record)[field] * scale);
        const auto known = [](double value) { return std::isfinite(value); };
        if (std::none_of(series.values.begin(), series.values.end(), known)) return;
        series.time = of.time;
        document_.series.push_back(series);
    }

private:
    bool isThere(const DocumentSeries& series) const {
        return std::any_of(document_.series.begin(), document_.series.end(),
                           [&](const DocumentSeries& each) {
                               return each.name == series.name && each.kind == series.kind;
                           });
    }
    const Thinned& thinned(const std::string& message) {
        const auto known = thinned_.find(message);
        if (known != thinned_.end()) return known->second;
        std::vector<const Record*> all = log_.named(message);
        all.erase(std::remove_if(all.begin(), all.end(),
                                 [](const Record* each) { return !std::isfinite(seconds(*each)); }),
                  all.end());
        Thinned made{document_.times.size(), {}};
        const size_t every = std::max<size_t>(1, (all.size() + kMaxSamples - 1) / kMaxSamples);
        std::vector<double> times;
        for (size_t i = 0; i < all.size(); i += every) {
            made.records.push_back(all[i]);
            times.push_back(seconds(*all[i]));
        }
        if (!times.empty()) document_.times.push_back(times);
        return thinned_[message] = made;
    }

    FlightDocument& document_;
    const LogFile& log_;
    std::map<std::string, Thinned> thinned_;
};

}  // namespace

double seconds(const Record& record) { return record["TimeUS"] * 1e-6; }

void addSeries(FlightDocument& document, const LogFile& log) {
    SeriesMaker maker(document, log);
    for (const auto& row : nlohmann::json::parse(tables::k_log_series)) maker.add(row);
}

}  // namespace log_tool
