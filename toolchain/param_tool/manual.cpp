// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/param_tool/manual.hpp"

#include <algorithm>
#include <sstream>

#include "toolchain/mission_tool/load.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace param_tool {
namespace {

constexpr char kHead[] = "name,unit,lowest,highest,default,meaning";
constexpr size_t kColumns = 6;

constexpr char kAbove[] = R"(# Parameters

A parameter with a name of ArduPlane has ArduPlane's unit and meaning; defaults and ranges are this
firmware's own. Every parameter in the list has an effect. This page is made from `firmware/state/parameters.csv`
by `toolchain/param document`, and a test holds it against the firmware.

## Over MAVLink

List, read by name or index, and set, as <https://mavlink.io/en/services/parameter.html> describes.
Every value travels as a float, whole numbers too (`MAV_PARAM_TYPE` 2, 4 and 6 give the type it is
stored as; the capability `PARAM_FLOAT` is set). A new value is stored before the answer is sent; the answer
is the value now in force. A value out of range, NaN or infinite is refused: the answer is the old
value, and a text says so. A name that does not exist is answered by a text alone. A new value is
sent to both links. Number and order are the same for the same image.

A list and the streams take turns, so that each has half of the link. A list that is requested again
begins anew; both links may request one at the same time.

When the power fails while a value is stored, either the old or the new value is there afterwards.

### When memory does not keep them

A check of four bytes over all values stands twice in the EEPROM, in bytes that were blank before. It is written with
every value, and looked at in every start. It finds a single bit that has changed by itself, wherever it is, and what
was there before: the value is mended, without a DataFlash, too, and "Memory fault: parameters mended" reports it. A
cell that is worn and does not hold its bit is mended at each start, and reported by "EEPROM is worn: a parameter is at
risk" when a value is stored there. When more has changed, the text is "Memory fault: check all parameters" and arming
is refused with "PreArm: parameters damaged", until the values have been looked at and `MAV_CMD_PREFLIGHT_STORAGE` with
param1 1 accepts them, or with param1 2 resets them. A flight that goes on after a restart in the air goes on.
The same happens after an earlier version of this firmware, which has no checks, has stored a value in between.

A power cut in the middle of writing a check is mended in the same way, with the same text. `storage_test` changes every
bit of parameters, journal and checks (8,768, all mended, with `STORAGE_BITS=1`; every seventh otherwise), wears out
every bit both ways (17,536, no value lost), and cuts the power in a write and again in the recovery (80,000 pairs).
The EEPROM's cells are good for 100,000 writes, and the checks are written with every value: for so many values.

## Back to the defaults

| what | how | the missions |
| --- | --- | --- |
| all parameters | `FORMAT_VERSION` set to 0, then a restart (Mission Planner: "Reset to Default") | stay |
| the same | `MAV_CMD_PREFLIGHT_STORAGE` with param1 2, then a restart (QGroundControl: "Reset all to firmware's defaults") | stay |
| the whole EEPROM | `MAV_CMD_PREFLIGHT_STORAGE` with param1 2 and param2 2, then a restart | go |

All of them on the ground, disarmed. When the power fails meanwhile, the next start continues.
An EEPROM that another firmware has written is neither read nor written: parameters have their
defaults and are not stored, until it is erased by either of the commands; arming is refused with "PreArm: EEPROM is
not ours". What marks an EEPROM as this firmware's stands twice, and is mended like a parameter.

## Declination

With `COMPASS_AUTODEC` 1 the declination comes from a table of the World Magnetic Model 2025 (NOAA
NCEI and British Geological Survey), for the middle of 2027, once there is a 3D fix. `COMPASS_DEC`
then shows the value in use; the value that was stored there counts while `COMPASS_AUTODEC` is 0. Between
60 S and 60 N the table is within a degree of the model, but for the seas within 30 degrees of the
southern magnetic pole (64 S, 135 E); up to 70 degrees within 1.2; beyond that it gives the 70th parallel's.
The model's year is the table's: `toolchain/declination` makes it from NOAA's file of coefficients.

## Files

`toolchain/param` reads and writes the `.param` files of Mission Planner (`NAME,VALUE`) and MAVProxy
(`NAME VALUE`), `#` beginning a comment:

    toolchain/param check plane.param               # would the firmware take it?
    toolchain/param show plane.param                # what it sets, and what differs from the defaults
    toolchain/param compile plane.param --onto board.eep -o new.eep   # for avrdude; the mission stays
    toolchain/param decode board.eep > plane.param

To fly with it in the simulator:

    toolchain/param compile plane.param -o plane.bin && toolchain/fly --eeprom plane.bin

## The table

| name | unit | range | default | meaning |
| --- | --- | --- | --- | --- |
)";

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream rest(line);
    for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
    return cells;
}

}  // namespace

std::vector<Explained> parseManual(const std::string& csv, const std::string& name) {
    std::vector<Explained> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    if (line != kHead)
        throw mission_tool::WrongInput(
            mission_tool::placed(name, 1, 1, mission_tool::expected(kHead, line)));
    for (int number = 2; std::getline(lines, line); ++number) {
        const std::vector<std::string> cells = split(line);
        if (cells.size() != kColumns)
            throw mission_tool::WrongInput(
                mission_tool::placed(name, number, 1, mission_tool::expected("six cells", line)));
        rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5]});
    }
    return rows;
}

const std::vector<Explained>& manual() {
    static const std::vector<Explained> rows =
        parseManual(mission_tool::readFile(PARAMETERS_CSV), PARAMETERS_CSV);
    return rows;
}

const Explained* explanationOf(const std::string& parameter) {
    const auto& rows = manual();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const Explained& r) { return r.name == parameter; });
    return row == rows.end() ? nullptr : &*row;
}

std::string document() {
    std::string text = kAbove;
    for (const Explained& row : manual())
        text += "| " + row.name + " | " + row.unit + (row.unit.empty() ? "| " : " | ") +
                row.lowest + " to " + row.highest + " | " + row.initial + " | " + row.meaning +
                " |\n";
    return text;
}

}  // namespace param_tool
