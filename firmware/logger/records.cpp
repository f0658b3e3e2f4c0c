// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/logger/records.hpp"

#include "core/packed_text.hpp"
#include "firmware/logger/format_pairs.hpp"

namespace firmware {
namespace logger {

namespace {

// Name, fields, units, multipliers and labels of a record, as in an FMT and an FMTU record.
struct Shape {
    RecordType type;
    uint8_t size;
    const char* text;
};

template <class Record>
constexpr Shape row(RecordType type, const char* text) {
    return {type, sizeof(Record), text};
}

// clang-format off
constexpr Shape kShapes[kFormats] = {
    row<logging::FormatRecord>(RecordType::format, "FMT BBnNZ -b--- ----- Type,Length,Name,Format,Columns"),
    row<ParameterRecord>(RecordType::parameter, "PARM QNf s-- F-- TimeUS,Name,Value"),
    row<GpsRecord>(RecordType::gps, "GPS QBBIHBcLLeCCcB s#-s-S-DUmnhn- F--C-0BGGBBBB- TimeUS,I,Status,GMS,GWk,NSats,HDop,Lat,Lng,Alt,Spd,GCrs,VZ,U"),
    row<InertialRecord>(RecordType::inertial, "IMU QBffffff s#EEEooo F-000000 TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ"),
    row<MessageRecord>(RecordType::message, "MSG QZ s- F- TimeUS,Message"),
    row<RadioInRecord>(RecordType::radio_in, "RCIN QHHHHHHHH sYYYYYYYY F-------- TimeUS,C1,C2,C3,C4,C5,C6,C7,C8"),
    row<ServoOutRecord>(RecordType::servo_out, "RCOU QHHHHHHHH sYYYYYYYY F-------- TimeUS,C1,C2,C3,C4,C5,C6,C7,C8"),
    row<BarometerRecord>(RecordType::barometer, "BARO QBffcc s#mPOn F-00BB TimeUS,I,Alt,Press,Temp,CRt"),
    row<CommandRecord>(RecordType::command, "CMD QHHHffffLLfB s-------DUm- F-------GG0- TimeUS,CTot,CNum,CId,Prm1,Prm2,Prm3,Prm4,Lat,Lng,Alt,Frame"),
    row<AttitudeRecord>(RecordType::attitude, "ATT QccccCC sddddhh FBBBBBB TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw"),
    row<BatteryRecord>(RecordType::battery, "BAT QBccf s#vAa F-BBC TimeUS,Inst,Volt,Curr,CurrTot"),
    row<CompassRecord>(RecordType::compass, "MAG QBhhhhhh s#GGGGGG F-CCCCCC TimeUS,I,MagX,MagY,MagZ,OfsX,OfsY,OfsZ"),
    row<ModeRecord>(RecordType::mode, "MODE QMB s-- F-- TimeUS,Mode,ModeNum"),
    row<ControlTuningRecord>(RecordType::control, "CTUN QccccBBccC sdddd%%%n- FBBBB00BBB TimeUS,NavRoll,Roll,NavPitch,Pitch,ThO,ThD,RdO,As,E2T"),
    row<NavigationTuningRecord>(RecordType::navigation, "NTUN QHCCffc smhhmmn F0BB00B TimeUS,Dist,TBrg,NavBrg,AltE,XT,AsE"),
    row<PerformanceRecord>(RecordType::performance, "PM QHHHHH s-Yb%- F-00A- TimeUS,NLon,MaxT,Mem,Load,LogDrop"),
    row<EventRecord>(RecordType::event, "EV QB s- F- TimeUS,Id"),
    row<ErrorRecord>(RecordType::error, "ERR QBB s-- F-- TimeUS,Subsys,ECode"),
    row<CameraRecord>(RecordType::camera, "CAM QIHLLeccC ss-DUmddh FC-GGBBBB TimeUS,GPSTime,GPSWeek,Lat,Lng,Alt,R,P,Y"),
    row<ListsRecord>(RecordType::lists, "LIST QIII s--- F--- TimeUS,Mission,Fence,Rally"),
    row<UnitRecord>(RecordType::unit, "UNIT QbZ s-- F-- TimeUS,Id,Label"),
    row<MultiplierRecord>(RecordType::multiplier, "MULT Qbd s-- F-- TimeUS,Id,Mult"),
    row<UnitsRecord>(RecordType::units, "FMTU QBNN s--- F--- TimeUS,FmtType,UnitIds,MultIds"),
    row<PlaceRecord>(RecordType::place, "POS QLLee sDUmm FGGBB TimeUS,Lat,Lng,Alt,RelHomeAlt"),
    row<PowerRecord>(RecordType::power, "POWR QC sv FB TimeUS,Vcc"),
    row<Attitude2Record>(RecordType::attitude2, "AHR2 QLLeccC sDUmddh FGGBBBB TimeUS,Lat,Lng,Alt,Roll,Pitch,Yaw"),
    row<SpeedHeightRecord>(RecordType::speed_height, "TECS Qffffffffff smnmnnno--o F0000000--0 TimeUS,h,dh,hdem,dhdem,spdem,sp,dsp,th,ph,dspdem"),
    row<LoopRecord>(RecordType::roll_loop, "PIDR Qcccccc skkdddd FBBBBBB TimeUS,Tar,Act,P,I,FF,D"),
    row<LoopRecord>(RecordType::pitch_loop, "PIDP Qcccccc skkdddd FBBBBBB TimeUS,Tar,Act,P,I,FF,D"),
    row<AirspeedRecord>(RecordType::airspeed, "ARSP QBCB s#n- F-B- TimeUS,I,Airspeed,H"),
    row<VibrationRecord>(RecordType::vibration, "VIBE QBCCCH s#ooo- F-BBB- TimeUS,IMU,VibeX,VibeY,VibeZ,Clip"),
    row<LoopRecord>(RecordType::yaw_loop, "PIDY Qcccccc skkdddd FBBBBBB TimeUS,Tar,Act,P,I,FF,D"),
};

// ArduPilot's letters; behind each what it stands for.
constexpr const char* kUnitTexts[kUnits] = {
    "- ", "# instance", "% %", "A A", "D deglatitude", "E rad/s", "G Gauss", "O degC", "P Pa", "S satellites",
    "U deglongitude", "Y PWM", "a Ah", "b B", "d deg", "h degheading", "k deg/s", "m m", "n m/s", "o m/s/s", "s s", "v V",
};
// clang-format on

struct MultiplierRow {
    char id;
    uint32_t upper, lower;  // of a double's 64 bits
};
constexpr MultiplierRow kMultiplierRows[kMultipliers] ROM = {
    {'-', 0, 0},                    // there is none
    {'0', 0x3FF00000, 0},           // 1
    {'A', 0x3FB99999, 0x9999999A},  // 0.1
    {'B', 0x3F847AE1, 0x47AE147B},  // 0.01
    {'C', 0x3F50624D, 0xD2F1A9FC},  // 0.001
    {'F', 0x3EB0C6F7, 0xA0B5ED8D},  // 1e-6
    {'G', 0x3E7AD7F2, 0x9ABCAF48},  // 1e-7
};

constexpr bool areSound() {
    for (const Shape& shape : kShapes)
        if (!logging::isSound(shape.text)) return false;
    return true;
}
static_assert(areSound(), "a row is cut off, or has not one word for each field");

constexpr bool matchTheStructs() {
    for (const Shape& shape : kShapes)
        if (logging::lengthOf(shape.text) != shape.size) return false;
    return true;
}
static_assert(matchTheStructs(), "a format and its struct are of different sizes");

constexpr bool areInOrder() {
    for (uint8_t i = 0; i < kFormats; ++i)
        if (static_cast<uint8_t>(kShapes[i].type) != logging::kFormatType + i) return false;
    return true;
}
static_assert(areInOrder(), "the rows are not in the order of RecordType");

constexpr bool explains(const logging::Letters& used, bool multipliers) {
    for (uint8_t i = 0; i < used.count; ++i) {
        bool found = false;
        if (multipliers)
            for (const MultiplierRow& row : kMultiplierRows)
                found = found || row.id == used.from[i];
        else
            for (const char* unit : kUnitTexts) found = found || *unit == used.from[i];
        if (!found) return false;
    }
    return true;
}
constexpr bool explainAll() {
    for (const Shape& shape : kShapes)
        if (!explains(logging::wordOf(shape.text, logging::kUnits), false) ||
            !explains(logging::wordOf(shape.text, logging::kMultipliers), true))
            return false;
    return true;
}
static_assert(explainAll(), "a field has a unit or a multiplier that no record explains");

// ---- as they lie in flash

constexpr uint8_t kLongest = 4 + 16 + 16 + 16 + 64 + 4;  // with the blanks between
using Codes = core::Packing<kLongest>;

using Index = core::PairIndex<core::count(kFormatPairs)>;

constexpr size_t codesOfAll() {
    const Index index(kFormatPairs);
    size_t codes = 0;
    for (const Shape& shape : kShapes) codes += Codes(shape.text, index).size;
    for (const char* unit : kUnitTexts) codes += Codes(unit, index).size;
    return codes;
}

struct PackedTexts {
    constexpr PackedTexts() {
        const Index index(kFormatPairs);
        size_t at = 0, text = 0;
        for (const Shape& shape : kShapes) add(shape.text, index, text++, at);
        for (const char* unit : kUnitTexts) add(unit, index, text++, at);
        for (size_t i = 0; i < kFormats; ++i) length[i] = kShapes[i].size;
        for (size_t i = 0; i < core::count(kFormatPairs); ++i) pair[i] = kFormatPairs[i];
    }
    constexpr void add(const char* text, const Index& pairs, size_t index, size_t& at) {
        const Codes packed(text, pairs);
        for (size_t i = 0; i < packed.size; ++i) codes[at++] = packed.codes[i];
        size[index] = static_cast<uint8_t>(packed.size);
    }

    uint8_t length[kFormats] = {};         // of a record
    uint8_t size[kFormats + kUnits] = {};  // in codes
    uint8_t codes[codesOfAll()] = {};
    core::CodePair pair[core::count(kFormatPairs)] = {};
};
constexpr PackedTexts packed ROM;
static_assert(core::pairsDeep(kFormatPairs) <= core::kPairsDeep, "an Unpacker has no room");

core::Unpacker unpacked(uint8_t index) {
    const uint8_t* codes = packed.codes;
    for (uint8_t i = 0; i < index; ++i) codes += core::romRead(packed.size[i]);
    return {codes, core::romRead(packed.size[index]), packed.pair};
}

// The next word, zeros behind it. None is longer than what it is spelt into.
void spellWord(core::Unpacker& from, char* to, uint8_t size) {
    uint8_t count = 0;
    for (char letter; (letter = from.next()) != 0 && letter != ' '; ++count) to[count] = letter;
    while (count < size) to[count++] = 0;
}

template <size_t kSize>
void spellWord(core::Unpacker& from, char (&to)[kSize]) {
    spellWord(from, to, kSize);
}

}  // namespace

void spellFormat(uint8_t index, logging::Format& to) {
    to.type = static_cast<uint8_t>(logging::kFormatType + index);
    to.length = core::romRead(packed.length[index]);
    core::Unpacker text = unpacked(index);
    spellWord(text, to.name);
    spellWord(text, to.fields);
    spellWord(text, to.labels);  // the units and ...
    spellWord(text, to.labels);  // ... the multipliers are none of its
    spellWord(text, to.labels);
}

void spellUnits(uint8_t index, UnitsRecord& to) {
    to.of_type = static_cast<uint8_t>(logging::kFormatType + index);
    core::Unpacker text = unpacked(index);
    spellWord(text, to.units);  // the name and ...
    spellWord(text, to.units);  // ... the fields are none of its
    spellWord(text, to.units);
    spellWord(text, to.multipliers);
}

void spellUnit(uint8_t index, UnitRecord& to) {
    core::Unpacker text = unpacked(static_cast<uint8_t>(kFormats + index));
    spellWord(text, &to.id, 1);
    spellWord(text, to.label);
}

void spellMultiplier(uint8_t index, MultiplierRecord& to) {
    const MultiplierRow row = core::romRead(kMultiplierRows[index]);
    to.id = row.id;
    to.value_lower = row.lower;
    to.value_upper = row.upper;
}

uint8_t lengthOfRecord(uint8_t type) {
    const uint8_t index = static_cast<uint8_t>(type - logging::kFormatType);
    return index < kFormats ? core::romRead(packed.length[index]) : 0;
}

}  // namespace logger
}  // namespace firmware
