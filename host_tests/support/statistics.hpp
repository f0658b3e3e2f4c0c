// SPDX-License-Identifier: GPL-3.0-or-later
// Mean, deviation and correlation of what a model gave.
#pragma once
#include <cmath>
#include <vector>

struct Statistics {
    std::vector<double> values;

    void add(double value) { values.push_back(value); }
    double mean() const {
        double sum = 0;
        for (double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    }
    double deviation() const {
        const double middle = mean();
        double sum = 0;
        for (double value : values) sum += (value - middle) * (value - middle);
        return std::sqrt(sum / static_cast<double>(values.size()));
    }
    double rms() const {
        double sum = 0;
        for (double value : values) sum += value * value;
        return std::sqrt(sum / static_cast<double>(values.size()));
    }
};

inline double correlation(const Statistics& a, const Statistics& b) {
    double sum = 0;
    const double mean_a = a.mean(), mean_b = b.mean();
    for (size_t i = 0; i < a.values.size(); ++i)
        sum += (a.values[i] - mean_a) * (b.values[i] - mean_b);
    return sum / static_cast<double>(a.values.size()) / (a.deviation() * b.deviation());
}
