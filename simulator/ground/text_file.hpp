// SPDX-License-Identifier: GPL-3.0-or-later
// Text files as people's editors write them: UTF-8 with or without a byte order mark, UTF-16 with
// one, lines that end in LF or CR LF.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simulator {

// As UTF-8 without a mark, lines ending in LF. What is no text comes back with its NULs.
std::string decodedText(const std::string& bytes);

// Why these bytes are no text to be read: "the file is empty", "not a text file"; else empty.
std::string whyNoText(const std::string& bytes);

// Of foreign bytes what a terminal may be shown: '?' for all that is not printable ASCII.
std::string printable(const std::string& text);

constexpr size_t kMaxListed = 50;

// The first 50, a line each, and how many more there are.
std::string listed(const std::vector<std::string>& errors);

}  // namespace simulator
