// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs of these tools have in common: words on the command line, a help text, and
// one clear line with exit 2 for a wrong call, exit 1 for a file that cannot be used.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "simulator/output_file.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {

struct Subcommand {
    std::string name;
    std::string what;
    std::function<void(CLI::App&)> addOptions;
    std::function<int()> run;  // gives the exit status
};

struct CommandLine {
    std::string tool;
    std::string what;
    std::string footer;
    std::vector<Subcommand> subcommands;
};

inline int runCommandLine(const CommandLine& line, const std::vector<std::string>& words,
                          std::ostream& out, std::ostream& err) {
    CLI::App app(line.what, line.tool);
    app.footer(line.footer);
    app.require_subcommand(1);
    for (const Subcommand& each : line.subcommands)
        each.addOptions(*app.add_subcommand(each.name, each.what));
    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        for (const Subcommand& each : line.subcommands)
            if (app.got_subcommand(each.name)) return each.run();
    } catch (const CLI::CallForHelp&) {
        const auto chosen = app.get_subcommands();
        out << (chosen.empty() ? app.help() : chosen[0]->help());
        return 0;
    } catch (const CLI::ParseError& error) {
        err << line.tool << ": " << error.what() << " (--help explains)\n";
    } catch (const WrongInput& error) {
        err << error.what() << '\n';
        return 1;
    } catch (const simulator::OutputError& error) {
        err << error.what() << '\n';
        return 1;
    }
    return 2;
}

}  // namespace mission_tool
