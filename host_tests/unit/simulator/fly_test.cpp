// SPDX-License-Identifier: GPL-3.0-or-later
// The fly program as a user meets it.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program_run.hpp"

using program_run::contents;
using program_run::Outcome;
using program_run::Wrong;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

Outcome fly(const std::string& arguments) { return program_run::run(FLY_PROGRAM, arguments); }

fs::path folder(const std::string& name) {
    const fs::path path = fs::temp_directory_path() / ("fly_test_" + std::to_string(getpid()));
    fs::create_directories(path);
    return path / name;
}

class WrongCommandLine : public testing::TestWithParam<Wrong> {};

}  // namespace

TEST_P(WrongCommandLine, is_answered_by_one_line_and_exit_status_2) {
    const Outcome run = fly(GetParam().arguments);

    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongCommandLine,
    testing::Values(
        Wrong{"--no-such-option", "--no-such-option"}, Wrong{"--board apm9", "--board"},
        Wrong{"--wind 5", "SPEED,FROM_DEGREES"}, Wrong{"--wind 5,400", "SPEED,FROM_DEGREES"},
        Wrong{"--wind -1,0", "SPEED,FROM_DEGREES"}, Wrong{"--wind x,y", "--wind"},
        Wrong{"--seed many", "--seed"}, Wrong{"--seed -1", "--seed"},
        Wrong{"--seed 18446744073709551616", "--seed"}, Wrong{"--time-limit nan", "--time-limit"},
        Wrong{"--listen 65536 --serve", "65535"}, Wrong{"--gusts=2", "gusts"},
        Wrong{"--out --native", "--out"}, Wrong{"--native --eeprom /tmp", "is no file"},
        Wrong{"--native --eeprom /no/such/folder/e.bin", "cannot be written"},
        Wrong{"--listen 5000", "--serve"}, Wrong{"--lock-step --out x", "--out"},
        Wrong{"--serve --time-limit 9", "--time-limit"}, Wrong{"--bench", "--bench"},
        Wrong{"--serve --bench --fdm json:9002", "--fdm"},
        Wrong{"--lock-step some.waypoints", "--lock-step"}, Wrong{"--time-limit 0", "--time-limit"},
        Wrong{"--telemetry uart7", "--telemetry"}, Wrong{"--listen 70000 --serve", "--listen"},
        Wrong{"--gdb 0", "--gdb"}, Wrong{"--native --gdb 1234", "--native"},
        Wrong{"--native --vcd /tmp/x.vcd", "--native"}, Wrong{"--native --board apm1", "--native"},
        Wrong{"--board apm1 --telemetry uart0", "--telemetry"},
        Wrong{"--native --airplane no_such", "no_such.json: no such airplane"},
        Wrong{"--native --airplane /etc/passwd", "/etc/passwd"},
        Wrong{"--native --param /no/such.param", "/no/such.param: cannot be read"},
        Wrong{"--native --world /no/such.json", "/no/such.json: cannot be read"},
        Wrong{"--native --world /tmp", "/tmp: cannot be read"},
        Wrong{"--native --world /etc/passwd", "/etc/passwd: expected JSON"},
        Wrong{"--native --world " AIRPLANES "/foam_trainer.json", "does not know 'mass_kg'"},
        Wrong{"--world x.json --wind 5,1", "--world has the wind: no --wind"},
        Wrong{"--fdm 9002", "json:PORT"}, Wrong{"--fdm json:", "json:PORT"},
        Wrong{"--fdm json:0", "json:PORT"}, Wrong{"--fdm json:65535", "json:PORT"},
        Wrong{"--fdm json:9002x", "json:PORT"}, Wrong{"--fdm json:9002 --wind 5,1", "own air"},
        Wrong{"--fdm json:9002 --gusts", "own air"}, Wrong{"--fdm-wait 3", "--fdm"},
        Wrong{"--fdm json:9002 --fdm-wait 0", "--fdm-wait"},
        Wrong{"--native --fdm json:no.such.host.invalid:9002", "no.such.host.invalid"},
        Wrong{"--native --firmware x.elf", "--native"}, Wrong{"--serve some.waypoints", "--serve"},
        Wrong{"/no/such/mission.waypoints", "/no/such/mission.waypoints"},
        Wrong{"--firmware /no/such.elf", "/no/such.elf"},
        Wrong{"--firmware /etc/passwd", "/etc/passwd"},
        Wrong{"--native --out /proc/nowhere", "/proc/nowhere"},
        Wrong{"--native --out /dev/null", "--out /dev/null"},
        Wrong{"--profile /no/such/p.json", "--profile /no/such/p.json: cannot be written"},
        Wrong{"--profile /tmp", "--profile /tmp: cannot be written: Is a directory"},
        Wrong{"--vcd /no/such/x.vcd", "/no/such/x.vcd: cannot be written"},
        Wrong{"--vcd /dev/full", "/dev/full: cannot be written: No space left"},
        Wrong{"--wind 31,270", "0 to 30 m/s and 0 to 360 degrees"},
        Wrong{"--native --airplane /tmp", "/tmp: is a folder"},
        Wrong{"--native --param /tmp", "/tmp: cannot be read"},
        Wrong{"/tmp", "/tmp: cannot be read"}, Wrong{"--firmware /tmp", "/tmp: cannot be opened"},
        Wrong{"--native --eeprom /etc/passwd", "4096 bytes"},
        Wrong{"--native --dataflash /etc/passwd", "8192 or 4096 pages"},
        Wrong{"--native --dataflash /no/such/folder/d.bin", "--dataflash"},
        Wrong{"--native --bootloader looping", "--bootloader"}, Wrong{"--bootloader none", "slow"},
        Wrong{"--fault supply:sag@5", "PART:HOW"}, Wrong{"--gps-latency 20", "400"},
        Wrong{"--band-gap 1.3", "1.2"}, Wrong{"--no-dataflash --dataflash d.bin", "--no-dataflash"},
        Wrong{"--serve --watch", "--watch"}, Wrong{"--watch --usb", "--usb"},
        Wrong{"--http 5000", "--serve or --watch"}, Wrong{"--no-http", "--serve or --watch"},
        Wrong{"--watch --http 1 --no-http", "exclude"}, Wrong{"--serve --http 65536", "--http"},
        Wrong{"--lock-step --http 0", "--lock-step"}, Wrong{"--end-with-client", "--serve"},
        Wrong{"--lock-step --end-with-client", "--serve"}, Wrong{"--flightgear 5500", "HOST:PORT"},
        Wrong{"--flightgear host:0", "HOST:PORT"},
        Wrong{"--native --flightgear no.such.host.invalid:5500", "no.such.host.invalid"},
        Wrong{"--lock-step --flightgear x:1", "--flightgear"},
        Wrong{"--native --serve --out /dev/null", "--out /dev/null"},
        Wrong{"--stored 1,2", "--stored needs --eeprom"},
        Wrong{"--eeprom e.bin --stored 1,,2", "ITEM,ITEM"},
        Wrong{"--eeprom e.bin --stored 0", "ITEM,ITEM"},
        Wrong{"--serve --eeprom e.bin --stored 1", "--stored"}, Wrong{"a b", "b"}));

TEST(Help, names_every_option) {
    const Outcome run = fly("--help");

    EXPECT_EQ(run.status, 0);
    for (const char* option :
         {"MISSION",        "--board",       "--native",          "--airplane",     "--fdm",
          "--fdm-wait",     "--param",       "--firmware",        "--eeprom",       "--dataflash",
          "--no-dataflash", "--wind",        "--gusts",           "--seed",         "--time-limit",
          "--out",          "--serve",       "--telemetry",       "--lock-step",    "--listen",
          "--vcd",          "--gdb",         "--fault",           "--band-gap",     "--bootloader",
          "--gps-cold",     "--gps-latency", "--worn-eeprom",     "--board-warmth", "--watch",
          "--http",         "--no-http",     "--end-with-client", "--flightgear",   "--stored"}) {
        EXPECT_THAT(run.output, HasSubstr(option));
    }
}

TEST(WrongMission, is_shown_with_line_and_column) {
    const fs::path path = folder("bad.waypoints");
    std::ofstream(path)
        << "QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 488 1\n1 0 3 16 0 0 0 0 here 8 9 1\n";

    const Outcome run = fly(path.string());

    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.output, HasSubstr("bad.waypoints:3:18: expected a latitude"));
}

TEST(TimeLimit, ends_the_flight_with_its_reason) {
    const Outcome run = fly("--native --time-limit 30 --out " + folder("limit").string());

    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.output, HasSubstr("not completed: time limit reached"));
    EXPECT_THAT(contents(folder("limit") / "report.html"), HasSubstr("time limit reached"));
}

TEST(Seed, makes_the_same_flight_again_bit_by_bit) {
    const std::string flight = "--native --gusts --wind 4,300 --time-limit 60 --out ";
    fly(flight + folder("a").string() + " --seed 7");
    fly(flight + folder("b").string() + " --seed 7");
    fly(flight + folder("c").string() + " --seed 8");

    const std::string a = contents(folder("a") / "flight.csv");
    EXPECT_GT(a.size(), 10'000u);
    EXPECT_EQ(a, contents(folder("b") / "flight.csv"));
    EXPECT_NE(a, contents(folder("c") / "flight.csv"));
}

TEST(Provenance, of_a_native_flight_has_the_size_of_the_image_of_the_same_sources) {
    const auto firmwareOf = [](const std::string& board, const char* name) {
        fly(board + " --time-limit 1 --out " + folder(name).string());
        const auto summary = nlohmann::json::parse(contents(folder(name) / "summary.json"));
        return summary["provenance"]["firmware"];
    };
    const auto native = firmwareOf("--native", "pn"), image = firmwareOf("--board apm2", "pi");

    EXPECT_GT(image["flash_bytes"], 100'000);
    EXPECT_EQ(native["flash_bytes"], image["flash_bytes"]);
    EXPECT_EQ(native["ram_bytes"], image["ram_bytes"]);
}

TEST(Dataflash, keeps_its_pages_over_power_off) {
    const fs::path image = folder("dataflash.bin");
    std::string pages(8192 * 528, '\xff');
    pages.replace(1000 * 528, 5, "pages");
    std::ofstream(image, std::ios::binary) << pages;
    const Outcome run = fly("--native --time-limit 2 --out " + folder("d").string() +
                            " --dataflash " + image.string());

    EXPECT_EQ(run.status, 1) << run.output;  // the time limit
    EXPECT_EQ(contents(image).size(), pages.size());
    EXPECT_EQ(contents(image).substr(1000 * 528, 6), "pages\xff");
}

class EitherBoard : public testing::TestWithParam<const char*> {};

TEST_P(EitherBoard, finds_its_dataflash_or_says_that_there_is_none) {
    const auto texts = [](const std::string& options, const char* name) {
        const fs::path out = folder(name);
        fs::remove_all(out);
        fly(std::string(GetParam()) + options + " --time-limit 5 --out " + out.string());
        return contents(out / "summary.json");
    };

    EXPECT_THAT(texts(" --no-dataflash", "without"), HasSubstr("DataFlash: none found"));
    EXPECT_THAT(texts("", "with"), testing::Not(HasSubstr("DataFlash")));
}

INSTANTIATE_TEST_SUITE_P(All, EitherBoard,
                         testing::Values("--native", "--board apm1", "--board apm2"));

TEST(Eeprom, keeps_what_the_autopilot_stored) {
    const fs::path image = folder("eeprom.bin");
    const std::string flight =
        "--native --time-limit 10 --out " + folder("e").string() + " --eeprom " + image.string();
    fly(flight);
    const std::string first = contents(image);
    fly(flight);

    EXPECT_EQ(first.size(), 4096u);
    EXPECT_NE(first, std::string(4096, '\xff'));  // the mission is in it
    EXPECT_EQ(contents(image).size(), 4096u);
}

TEST(WrongParameters, are_reported_line_by_line_and_without_control_characters) {
    const fs::path path = folder("bad.param");
    std::ofstream(path) << "WP_RADIUS,x\nTHR_MAX,\x1b[2J\n";

    const Outcome run = fly("--native --param " + path.string());

    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.output, HasSubstr("bad.param:1:11: expected a finite decimal number"));
    EXPECT_THAT(run.output, HasSubstr("bad.param:2:9: expected a finite decimal number"));
    EXPECT_EQ(run.output.find('\x1b'), run.output.npos);
}

TEST(Output, is_tried_before_the_flight) {
    const fs::path out = folder("taken");
    fs::create_directories(out / "flight.csv");

    const Outcome run = fly("--native --time-limit 5 --out " + out.string());

    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("flight.csv: cannot be written: Is a directory"));
}

TEST(Output, that_is_lost_after_the_flight_costs_neither_verdict_nor_the_other_files) {
    const fs::path out = folder("full");
    fs::create_directories(out);
    fs::create_symlink("/dev/full", out / "summary.json");

    const Outcome run = fly("--native --time-limit 5 --out " + out.string());

    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.output, HasSubstr("not completed: time limit reached"));
    EXPECT_THAT(run.output, HasSubstr("fly: " + (out / "summary.json").string() +
                                      ": cannot be written: No space left on device\n"));
    EXPECT_THAT(run.output, testing::Not(HasSubstr("  report")));
    EXPECT_THAT(contents(out / "report.html"), HasSubstr("time limit reached"));
}

TEST(Output, to_a_full_disk_is_an_error) {
    const Outcome run = program_run::runOnFullDisk(FLY_PROGRAM, "--help");

    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.output, HasSubstr("fly: the standard output cannot be written: No space"));
}

TEST(Profile, names_the_program_it_was_made_of) {
    const fs::path profile = folder("profile.json");
    const Outcome run =
        fly("--time-limit 1 --out " + folder("p").string() + " --profile " + profile.string());

    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(contents(profile), HasSubstr("avr/apm2/firmware.elf\",\"sha256\":\""));
}

TEST(NoDataflash, says_what_must_go_along_with_it) {
    const fs::path param = folder("no_log.param");
    std::ofstream(param) << "LOG_BITMASK,0\n";
    const std::string flight =
        "--native --no-dataflash --time-limit 2 --out " + folder("nolog").string();

    EXPECT_THAT(fly(flight).output, HasSubstr("--no-dataflash: the firmware does not arm without"));
    EXPECT_THAT(fly(flight).output, HasSubstr("LOG_BITMASK,0"));
    EXPECT_THAT(fly(flight + " --param " + param.string()).output,
                testing::Not(HasSubstr("does not arm")));
}

TEST(NoDataflash, flies_with_that) {
    const fs::path param = folder("no_log.param");
    std::ofstream(param) << "LOG_BITMASK,0\n";
    const Outcome run = fly("--native --no-dataflash --out " + folder("nolog").string() +
                            " --param " + param.string());

    EXPECT_EQ(run.status, 0) << run.output;
}
