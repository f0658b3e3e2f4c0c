// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/built_image.hpp"

namespace simulator {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolders[] = {"firmware", "libraries", "hal_avr"};

bool isSource(const fs::path& path) {
    return path.extension() == ".cpp" || path.extension() == ".hpp";
}

bool anyIsNewer(const fs::path& folder, fs::file_time_type than) {
    std::error_code error;
    for (const auto& each : fs::recursive_directory_iterator(folder, error))
        if (isSource(each.path()) && each.last_write_time(error) > than) return true;
    return static_cast<bool>(error);
}

}  // namespace

std::optional<Image> imageOfSources(const fs::path& image, const fs::path& root) {
    std::error_code absent;
    const fs::file_time_type made = fs::last_write_time(image, absent);
    if (absent) return std::nullopt;
    for (const char* folder : kFolders)
        if (anyIsNewer(root / folder, made)) return std::nullopt;
    try {
        return readImage(image);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace simulator
