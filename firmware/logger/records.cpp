// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/logger/records.hpp"

namespace firmware {
namespace logger {

namespace {

struct Shape {
    uint8_t type, size;
    const char *name, *fields, *labels;
};

template <class Record>
constexpr Shape row(RecordType type, const char* name, const char* fields, const char* labels) {
    return {static_cast<uint8_t>(type), sizeof(Record), name, fields, labels};
}

// clang-format off
constexpr Shape kShapes[] = {
    {logging::kFormatType, sizeof(logging::FormatRecord), "FMT", "BBnNZ", "Type,Length,Name,Format,Columns"},
    row<ParameterRecord>(RecordType::parameter, "PARM", "QNf", "TimeUS,Name,Value"),
    row<ModeRecord>(RecordType::mode, "MODE", "QMB", "TimeUS,Mode,ModeNum"),
    row<CommandRecord>(RecordType::command, "CMD", "QHHHffffLLfB",
        "TimeUS,CTot,CNum,CId,Prm1,Prm2,Prm3,Prm4,Lat,Lng,Alt,Frame"),
    row<MessageRecord>(RecordType::message, "MSG", "QZ", "TimeUS,Message"),
    row<AttitudeRecord>(RecordType::attitude, "ATT", "QccccCC",
        "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw"),
    row<GpsRecord>(RecordType::gps, "GPS", "QBIHBcLLefff",
        "TimeUS,Status,GMS,GWk,NSats,HDop,Lat,Lng,Alt,Spd,GCrs,VZ"),
    row<ControlTuningRecord>(RecordType::control, "CTUN", "Qcccchhfff",
        "TimeUS,NavRoll,Roll,NavPitch,Pitch,ThrOut,RdrOut,AccY,Aspd,Alt"),
    row<NavigationTuningRecord>(RecordType::navigation, "NTUN", "QHhhffffLL",
        "TimeUS,WpDist,TargBrg,NavBrg,XT,AltErr,AspdErr,GSpd,Lat,Lng"),
    row<InertialRecord>(RecordType::inertial, "IMU", "Qffffff",
        "TimeUS,GyrX,GyrY,GyrZ,AccX,AccY,AccZ"),
    row<CompassRecord>(RecordType::compass, "MAG", "Qhhhhhh",
        "TimeUS,MagX,MagY,MagZ,OfsX,OfsY,OfsZ"),
    row<BarometerRecord>(RecordType::barometer, "BARO", "Qffcf", "TimeUS,Alt,Press,Temp,CRt"),
    row<CurrentRecord>(RecordType::current, "CURR", "QhccHf",
        "TimeUS,Throttle,Volt,Curr,Vcc,CurrTot"),
    row<RadioInRecord>(RecordType::radio_in, "RCIN", "QHHHHHHHH", "TimeUS,C1,C2,C3,C4,C5,C6,C7,C8"),
    row<ServoOutRecord>(RecordType::servo_out, "RCOU", "QHHHHHHHH",
        "TimeUS,Ch1,Ch2,Ch3,Ch4,Ch5,Ch6,Ch7,Ch8"),
    row<PerformanceRecord>(RecordType::performance, "PM", "QHHHHH",
        "TimeUS,Load,NLon,MaxT,Mem,Drop"),
    row<EventRecord>(RecordType::event, "EV", "QB", "TimeUS,Id"),
    row<ErrorRecord>(RecordType::error, "ERR", "QBB", "TimeUS,Subsys,ECode"),
    row<CameraRecord>(RecordType::camera, "CAM", "QIHLLeccC",
        "TimeUS,GPSTime,GPSWeek,Lat,Lng,Alt,Roll,Pitch,Yaw"),
    row<ListsRecord>(RecordType::lists, "LIST", "QIII", "TimeUS,Mission,Fence,Rally"),
};
// clang-format on
static_assert(core::count(kShapes) == kFormats, "kFormats does not fit the table");

constexpr bool areSound() {
    for (const Shape& shape : kShapes)
        if (!logging::isSound(shape.fields, shape.labels)) return false;
    return true;
}
static_assert(areSound(), "a row has labels that are cut off, or not one for each field");

constexpr bool matchTheStructs() {
    for (const Shape& shape : kShapes)
        if (logging::format(shape.type, shape.name, shape.fields, shape.labels).length !=
            shape.size)
            return false;
    return true;
}
static_assert(matchTheStructs(), "a format and its struct are of different sizes");

constexpr logging::Format format(uint8_t i) {
    return logging::format(kShapes[i].type, kShapes[i].name, kShapes[i].fields, kShapes[i].labels);
}

}  // namespace

constexpr logging::Format kFormatTable[kFormats] ROM = {
    format(0),  format(1),  format(2),  format(3),  format(4),  format(5),  format(6),
    format(7),  format(8),  format(9),  format(10), format(11), format(12), format(13),
    format(14), format(15), format(16), format(17), format(18), format(19),
};

}  // namespace logger
}  // namespace firmware
