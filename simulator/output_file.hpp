// SPDX-License-Identifier: GPL-3.0-or-later
// Output that is checked: what could not be written is an error of one line, never a silent loss.
#pragma once
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace simulator {

// what() is "PATH: cannot be written: REASON".
class OutputError : public std::runtime_error {
public:
    OutputError(const std::string& path, int reason)
        : std::runtime_error(path + ": cannot be written" +
                             (reason == 0 ? "" : std::string(": ") + std::strerror(reason))) {}
};

// Whatever a stream still holds is written; throws OutputError when any of it was lost.
inline void closeChecked(std::ofstream& file, const std::string& path) {
    errno = 0;
    if (!file.is_open() || !file.good() || !file.flush()) throw OutputError(path, errno);
    file.close();
    if (!file) throw OutputError(path, errno);
}

inline void openChecked(std::ofstream& file, const std::string& path, std::ios::openmode mode) {
    errno = 0;
    file.open(path, mode);
    if (!file) throw OutputError(path, errno);
}

inline void writeInPlace(const std::filesystem::path& path, const std::string& contents) {
    std::ofstream file;
    openChecked(file, path.string(), std::ios::binary);
    errno = 0;
    if (!file.write(contents.data(), static_cast<std::streamsize>(contents.size())))
        throw OutputError(path.string(), errno);
    closeChecked(file, path.string());
}

// What the file held stays when it cannot be written whole: the new contents are written beside it
// first. A device or a pipe has nothing to lose.
inline void writeFile(const std::filesystem::path& path, const std::string& contents) {
    std::error_code error;
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
        return writeInPlace(path, contents);
    const std::filesystem::path beside = path.string() + ".new";
    try {
        writeInPlace(beside, contents);
        std::filesystem::rename(beside, path);
    } catch (const std::exception&) {
        const int reason = errno;
        std::filesystem::remove(beside, error);
        throw OutputError(path.string(), reason);
    }
}

// Asked before a long run whose result goes there. Leaves the file as it is, or absent.
inline void mustBeWritable(const std::filesystem::path& path) {
    std::error_code ignored;
    const bool before = std::filesystem::exists(path, ignored);
    std::ofstream file;
    openChecked(file, path.string(), std::ios::binary | std::ios::app);
    file.close();
    if (!before) std::filesystem::remove(path, ignored);
}

// The folder with all its parents; throws OutputError when there is none afterwards.
inline void makeFolder(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (std::filesystem::is_directory(path)) return;
    throw OutputError(path.string(), error ? error.value() : ENOTDIR);
}

// The exit status of a program: `status`, or 1 when its standard output did not arrive.
inline int finishOutput(const char* tool, int status) {
    const bool failed_before = !std::cout.good() || std::ferror(stdout) != 0;
    if (!failed_before) errno = 0;  // else it says why a buffer that was full could not be written
    std::cout.flush();
    const bool whole = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (whole) return status;
    const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
    std::cerr << tool << ": the standard output cannot be written" << reason << "\n";
    return status == 0 ? 1 : status;
}

}  // namespace simulator
