// SPDX-License-Identifier: GPL-3.0-or-later
// A flight in a drawn world: draws it, flies AUTOTUNE from the defaults and what the owner knows,
// and then has the mission flown by the fly program, on what AUTOTUNE has learnt.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "simulator/drawn/draw.hpp"
#include "simulator/drawn/files.hpp"
#include "simulator/drawn/tuning.hpp"
#include "simulator/native/native_board.hpp"
#include "simulator/output_file.hpp"

namespace simulator::drawn {
namespace {

struct Options {
    uint64_t seed = 1;
    std::string out, fly = DRAWN_FLY;
    bool draw_only = false;
};

// What has been learnt goes after what was set, and so over it.
ParameterSettings tune(const DrawnWorld& drawn, const DrawnFiles& files) {
    WorldOptions world = drawn.world;
    world.airplane = files.airplane;
    WatchedBoard board(std::make_unique<NativeBoard>(world));
    Tuning tuning(board, drawn.tuning, drawn.owner);
    const std::string failure = tuning.fly();
    ParameterSettings all = drawn.owner;
    if (failure.empty())
        for (const ParameterSetting& each : tuning.found()) all.push_back(each);
    for (const Event& each : tuning.texts())
        std::cout << std::lround(each.time_s) << " s: " << each.text << "\n";
    if (!failure.empty()) throw std::runtime_error("AUTOTUNE: " + failure);
    if (!board.held()) throw std::runtime_error("AUTOTUNE: an invariant was violated");
    return all;
}

// Does not come back.
void flyMission(const Options& options, const DrawnFiles& files) {
    std::vector<std::string> words = {
        options.fly, "--native",  "--airplane", files.airplane, "--param",
        files.tuned, "--world",   files.world,  "--seed",       std::to_string(options.seed),
        "--out",     options.out, files.mission};
    std::cout << "toolchain/fly";
    for (size_t i = 1; i < words.size(); ++i) std::cout << " " << words[i];
    std::cout << std::endl;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(options.fly.c_str(), arguments.data());
    throw std::runtime_error(options.fly + ": cannot be started");
}

int run(const Options& options) {
    const DrawnWorld drawn = drawWorld(options.seed, DRAWN_MAGNETIC_MODEL);
    const DrawnFiles files(options.out);
    makeFolder(options.out);
    writeFiles(files, drawn);
    std::cout << drawn.about << std::endl;
    if (options.draw_only) return 0;
    writeParameters(files.tuned, "What its owner knows, and what AUTOTUNE has learnt.",
                    tune(drawn, files));
    flyMission(options, files);
    return 2;
}

}  // namespace
}  // namespace simulator::drawn

int main(int count, char** words) {
    simulator::drawn::Options options;
    CLI::App app("Flies AUTOTUNE and a mission with an airplane, sensors and air that are drawn.",
                 "drawn");
    app.add_option("SEED", options.seed, "the same draws the same world")->required();
    app.add_option("--out", options.out, "folder for the world's files and the report")->required();
    app.add_option("--fly", options.fly, "the fly program");
    app.add_flag("--draw-only", options.draw_only, "write the world's files, fly nothing");
    CLI11_PARSE(app, count, words);
    try {
        return simulator::finishOutput("drawn", simulator::drawn::run(options));
    } catch (const std::exception& error) {
        std::cerr << "drawn: " << error.what() << "\n";
        return 1;
    }
}
