// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "simulator/input_file.hpp"
#include "simulator/output_file.hpp"
#include "simulator/report/page.hpp"
#include "toolchain/log_tool/image.hpp"
#include "toolchain/log_tool/log_document.hpp"

namespace log_tool {
namespace {

constexpr char kWhat[] = "Flight logs: from the board's DataFlash or as downloaded.";
constexpr char kFooter[] =
    "FILE is a .bin log, or an image of the DataFlash (what fly --dataflash writes). Of an image\n"
    "the newest log is taken, or the one of --log. Exit status: 0 when all is well, 1 when there\n"
    "is no such log, 2 when the command line or a file is wrong.";

class NoLog : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};
class WrongInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Options {
    std::string file, out;
    int log = 0;  // 0: the newest
};

Bytes readFile(const std::string& path) {
    const auto contents = simulator::wholeFile(path);
    if (!contents) throw WrongInput(path + ": cannot be read");
    if (contents->empty()) throw WrongInput(path + ": the file is empty");
    return Bytes(contents->begin(), contents->end());
}

bool isFormat(const Bytes& bytes, size_t at) {
    return at + 89 <= bytes.size() && bytes[at] == 0xA3 && bytes[at + 1] == 0x95 &&
           bytes[at + 2] == 128;
}

// A log without its beginning borrows the formats of one that has it.
Bytes readable(const StoredLog& log, const std::vector<StoredLog>& all) {
    Bytes bytes;
    const auto whole =
        std::find_if(all.begin(), all.end(), [](const StoredLog& each) { return each.lost == 0; });
    if (log.lost > 0 && whole != all.end())
        for (size_t at = 0; isFormat(whole->bytes, at); at += 89)
            bytes.insert(bytes.end(), &whole->bytes[at], &whole->bytes[at] + 89);
    bytes.insert(bytes.end(), log.bytes.begin(), log.bytes.end());
    return bytes;
}

Bytes load(const Options& options) {
    const Bytes contents = readFile(options.file);
    if (!isImage(contents.size())) {
        if (!isFormat(contents, 0))
            throw WrongInput(options.file + ": neither a log nor an image of a DataFlash");
        if (options.log != 0) throw WrongInput("--log: " + options.file + " is one log");
        return contents;
    }
    const std::vector<StoredLog> logs = logsIn(contents);
    if (logs.empty()) throw NoLog(options.file + ": holds no log");
    if (options.log == 0) return readable(logs.back(), logs);
    for (const StoredLog& log : logs)
        if (log.number == options.log) return readable(log, logs);
    throw NoLog(options.file + ": holds no log " + std::to_string(options.log));
}

// A log on its own has lost its number.
void listOne(const Bytes& bytes, std::ostream& out) {
    const LogFile log(bytes);
    out << "one log  " << bytes.size() << " bytes, " << log.records().size() << " records";
    if (log.skippedBytes() > 0) out << "; " << log.skippedBytes() << " bytes are no record";
    out << '\n';
}

void list(const Options& options, std::ostream& out) {
    const Bytes contents = readFile(options.file);
    if (!isImage(contents.size())) return listOne(load(options), out);
    const std::vector<StoredLog> logs = logsIn(contents);
    if (logs.empty()) out << "no logs\n";
    for (const StoredLog& log : logs) {
        out << "log " << log.number << "  " << log.bytes.size() << " bytes in " << log.pages
            << " pages";
        if (log.lost > 0) out << "; its first " << log.lost << " bytes are overwritten";
        if (log.damaged > 0) out << "; " << log.damaged << " pages are damaged";
        out << '\n';
    }
}

void reportSummary(const Options& options, std::ostream& out) {
    out << summary(LogFile(load(options)));
}

void extract(const Options& options, std::ostream&) {
    const Bytes bytes = load(options);
    simulator::writeFile(options.out, std::string(bytes.begin(), bytes.end()));
}

void writeCsv(const Options& options, std::ostream& out) {
    const LogFile log(load(options));
    simulator::makeFolder(options.out);
    for (const auto& [type, kind] : log.kinds()) {
        if (kind.name == "FMT" || log.named(kind.name).empty()) continue;
        const std::filesystem::path path =
            std::filesystem::path(options.out) / (kind.name + ".csv");
        simulator::writeFile(path, csv(log, kind));
        out << path.string() << '\n';
    }
}

void writeReport(const Options& options, std::ostream&) {
    const std::string name = std::filesystem::path(options.file).filename().string();
    simulator::writeFile(options.out, flightPage(documentOf(LogFile(load(options)), name)));
}

struct Command {
    const char *name, *what;
    const char* out;  // what -o names; nullptr: it has none
    void (*run)(const Options& options, std::ostream& out);
};
constexpr Command kCommands[] = {
    {"list", "lists the logs of an image, or how long a log is", nullptr, list},
    {"summary", "summarises a log", nullptr, reportSummary},
    {"csv", "writes one table for each kind of record", "the folder they go into", writeCsv},
    {"report", "draws the page that a simulated flight gets", "the .html file", writeReport},
    {"extract", "writes a log as the .bin that other programs read", "the file", extract},
};

}  // namespace

int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
    CLI::App app(kWhat, "log");
    app.footer(kFooter);
    app.require_subcommand(1);
    Options options;
    for (const Command& command : kCommands) {
        CLI::App& sub = *app.add_subcommand(command.name, command.what);
        sub.footer(kFooter);
        sub.add_option("FILE", options.file, "what to read")->required();
        sub.add_option("--log", options.log, "number of the log in an image")
            ->check(CLI::Range(1, 65535));
        if (command.out != nullptr)
            sub.add_option("-o,--out", options.out, command.out)->required();
    }
    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ParseError& error) {
        return app.exit(error, out, err) == 0 ? 0 : 2;
    }
    try {
        for (const Command& command : kCommands)
            if (app.got_subcommand(command.name)) command.run(options, out);
        return 0;
    } catch (const NoLog& error) {
        err << "log: " << error.what() << '\n';
        return 1;
    } catch (const std::exception& error) {
        err << "log: " << error.what() << '\n';
        return 2;
    }
}

}  // namespace log_tool
