// SPDX-License-Identifier: GPL-3.0-or-later
// Where the files of a flight go: into a folder that was asked for, or into a new one of its own,
// FLIGHTS/12-MISSION, beside which index.html lists the flights and a link names the newest.
#pragma once
#include <filesystem>
#include <string>

namespace simulator {

// What the index says of a flight.
struct FlightEntry {
    std::string date, airplane, mission, board, result;
    bool good = false;
};

class FlightFolder {
public:
    // One that was asked for. Both throw OutputError.
    explicit FlightFolder(const std::filesystem::path& asked);
    // A new one; it is removed again when nothing came into it.
    FlightFolder(const std::filesystem::path& flights, const std::filesystem::path& newest,
                 const std::string& mission);
    ~FlightFolder();
    FlightFolder(const FlightFolder&) = delete;
    FlightFolder& operator=(const FlightFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // Of a folder of its own, when its files are written: the index, and the link. Throws
    // OutputError.
    void enter(const FlightEntry& entry) const;

private:
    void link() const;

    std::filesystem::path path_, flights_, newest_;
};

// The page of all folders in `flights` that hold an entry, the newest first.
std::string indexPage(const std::filesystem::path& flights);

}  // namespace simulator
