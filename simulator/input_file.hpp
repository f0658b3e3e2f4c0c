// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of a file; empty optional when it is absent, a folder, or may not be read.
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

namespace simulator {

inline std::optional<std::string> wholeFile(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::string contents{std::istreambuf_iterator<char>(file), {}};
    if (file.bad()) return std::nullopt;
    return contents;
}

}  // namespace simulator
