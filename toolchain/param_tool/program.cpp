// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/param_tool/program.hpp"

#include <algorithm>

#include "simulator/ground/text_file.hpp"
#include "toolchain/mission_tool/command_line.hpp"
#include "toolchain/mission_tool/load.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"
#include "toolchain/param_tool/board.hpp"
#include "toolchain/param_tool/manual.hpp"
#include "toolchain/param_tool/table.hpp"

namespace param_tool {
namespace {

using mission_tool::blankImage;
using mission_tool::encodedFor;
using mission_tool::Image;
using mission_tool::WrongInput;

constexpr char kWhat[] = "Parameters as files and as EEPROM images for the board.";
constexpr char kFooter[] =
    "FILE is a .param file of Mission Planner (NAME,VALUE) or MAVProxy (NAME VALUE), '#' beginning "
    "a\n"
    "comment, or an image: Intel hex or 4096 raw bytes. Exit status: 0 when all is well (warnings\n"
    "may be shown), 1 when a parameter or a file is wrong, 2 when the command line is.";

struct Options {
    std::string file, out, onto;
    bool skip_unknown = false, changed = false;
};

class Program {
public:
    Program(const Options& options, std::ostream& out, std::ostream& err)
        : options_(options), out_(out), err_(err) {}

    int check() {
        load(options_.file);
        if (reportFindings()) return 1;
        out_ << options_.file << ": the firmware takes it\n";
        return 0;
    }

    int compile() {
        encodedFor(options_.out, blankImage());  // a name that cannot be written to is reported first
        load(options_.file);
        if (reportFindings()) return 1;
        simulator::writeFile(options_.out, encodedFor(options_.out, image()));
        if (options_.onto.empty())
            err_ << options_.out
                 << ": a whole EEPROM: flashed, it leaves no mission on the board and sets every "
                    "other parameter to its default; --onto keeps a board's\n";
        return 0;
    }

    int decode() {
        if (!load(options_.file))
            throw WrongInput(options_.file + ": expected an image of an EEPROM");
        const std::string text = settingsOf(parameters(), options_.changed);
        if (options_.out.empty()) {
            out_ << text;
        } else {
            simulator::writeFile(options_.out, text);
        }
        return 0;
    }

    int show() {
        if (options_.file.empty()) {
            powerUp(blankImage(), "");
        } else {
            load(options_.file);
        }
        const bool wrong = reportFindings();
        out_ << tableOf(parameters(), options_.changed);
        return wrong ? 1 : 0;
    }

    int document() {
        out_ << param_tool::document();
        return 0;
    }

private:
    // The board stands as the file says; true: it was an image.
    bool load(const std::string& path) {
        const std::string contents = mission_tool::readFile(path);
        if (looksLikeImage(contents)) {
            powerUp(mission_tool::imageOf(contents, path), path);
            return true;
        }
        Image onto = blankImage();
        if (!options_.onto.empty())
            onto = mission_tool::imageOf(mission_tool::readFile(options_.onto), options_.onto);
        powerUp(onto, options_.onto);
        const std::vector<Setting> settings = parseSettings(contents, path, findings_);
        set(settings, path, {options_.skip_unknown}, findings_);
        std::stable_sort(findings_.begin(), findings_.end(),
                         [](const Finding& a, const Finding& b) { return a.line < b.line; });
        return false;
    }

    // A text of just 4096 bytes is no image.
    static bool looksLikeImage(const std::string& contents) {
        if (mission_tool::looksLikeHex(contents)) return true;
        const std::string text = simulator::decodedText(contents);
        return contents.size() == blankImage().size() &&
               !std::all_of(text.begin(), text.end(), [](unsigned char c) {
                   return (c >= 32 && c < 127) || c == '\n' || c == '\r' || c == '\t';
               });
    }

    bool reportFindings() {
        size_t errors = 0;
        for (const Finding& finding : findings_)
            if (!finding.error || ++errors <= simulator::kMaxListed) err_ << finding.text << '\n';
        if (errors > simulator::kMaxListed)
            err_ << "and " << errors - simulator::kMaxListed << " more\n";
        return errors > 0;
    }

    const Options& options_;
    std::ostream& out_;
    std::ostream& err_;
    std::vector<Finding> findings_;
};

struct Command {
    const char* name;
    const char* what;
    int (Program::*run)();
};
constexpr Command kCommands[] = {
    {"check", "checks whether the firmware takes every value of a file", &Program::check},
    {"compile", "makes an EEPROM image that the board boots with", &Program::compile},
    {"decode", "writes the parameters in an image as a .param file", &Program::decode},
    {"show", "prints a table; without FILE of the defaults", &Program::show},
    {"document", "prints docs/parameters.md", &Program::document},
};

void addOptions(CLI::App& app, const Command& command, Options& o) {
    const bool decodes = command.run == &Program::decode, shows = command.run == &Program::show;
    if (command.run == &Program::document) return;
    auto* const file = app.add_option(decodes ? "IMAGE" : "FILE", o.file, "what to read");
    if (!shows) file->required();
    if (!decodes) {
        app.add_option("--onto", o.onto,
                       "image of the board the parameters are for: its mission and what FILE does "
                       "not name stay; else a blank EEPROM");
        app.add_flag("--skip-unknown", o.skip_unknown,
                     "names this firmware does not know are reported and left out");
    }
    if (decodes || shows)
        app.add_flag("--changed", o.changed, "only what differs from its default");
    if (command.run == &Program::compile)
        app.add_option("-o,--out", o.out, "image to write: .eep or .hex (Intel hex), .bin (raw)")
            ->required();
    if (decodes) app.add_option("-o,--out", o.out, "file to write instead of the standard output");
}

}  // namespace

int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
    Options options;
    mission_tool::CommandLine line = {"param", kWhat, kFooter, {}};
    for (const Command& command : kCommands)
        line.subcommands.push_back({command.name, command.what,
                                    [&](CLI::App& app) { addOptions(app, command, options); },
                                    [&] { return (Program(options, out, err).*command.run)(); }});
    return mission_tool::runCommandLine(line, words, out, err);
}

}  // namespace param_tool
