// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/parameters.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace simulator {
namespace {

using Json = nlohmann::json;

struct Field {
    const char* key;
    double* to;
};

// clang-format off
std::vector<Field> fields(AirplaneParameters& p) {
    return {
        {"/mass_kg", &p.mass_kg},
        {"/inertia_kgm2/xx", &p.inertia_kgm2.xx}, {"/inertia_kgm2/yy", &p.inertia_kgm2.yy},
        {"/inertia_kgm2/zz", &p.inertia_kgm2.zz}, {"/inertia_kgm2/xz", &p.inertia_kgm2.xz},
        {"/wing/area_m2", &p.area_m2}, {"/wing/span_m", &p.span_m}, {"/wing/chord_m", &p.chord_m},

        {"/lift/at_zero", &p.lift.at_zero}, {"/lift/alpha", &p.lift.alpha},
        {"/lift/pitch_rate", &p.lift.pitch_rate}, {"/lift/elevator", &p.lift.elevator},
        {"/lift/stall_alpha_rad", &p.lift.stall_alpha_rad},
        {"/lift/stall_sharpness", &p.lift.stall_sharpness},
        {"/drag/parasite", &p.drag.parasite}, {"/drag/induced", &p.drag.induced},
        {"/drag/beta2", &p.drag.beta2}, {"/drag/plate", &p.drag.plate},
        {"/side/beta", &p.side.beta}, {"/side/roll_rate", &p.side.roll_rate},
        {"/side/yaw_rate", &p.side.yaw_rate}, {"/side/rudder", &p.side.rudder},

        {"/roll/at_zero", &p.roll.at_zero}, {"/roll/beta", &p.roll.beta},
        {"/roll/roll_rate", &p.roll.roll_rate}, {"/roll/yaw_rate", &p.roll.yaw_rate},
        {"/roll/aileron", &p.roll.aileron}, {"/roll/rudder", &p.roll.rudder},
        {"/roll/stall_loss", &p.roll.stall_loss},
        {"/pitch/at_zero", &p.pitch.at_zero}, {"/pitch/alpha", &p.pitch.alpha},
        {"/pitch/pitch_rate", &p.pitch.pitch_rate}, {"/pitch/elevator", &p.pitch.elevator},
        {"/pitch/stall", &p.pitch.stall},
        {"/yaw/beta", &p.yaw.beta}, {"/yaw/roll_rate", &p.yaw.roll_rate},
        {"/yaw/yaw_rate", &p.yaw.yaw_rate}, {"/yaw/aileron", &p.yaw.aileron},
        {"/yaw/rudder", &p.yaw.rudder},

        {"/controls/aileron_deg", &p.controls.aileron_deg},
        {"/controls/elevator_deg", &p.controls.elevator_deg},
        {"/controls/rudder_deg", &p.controls.rudder_deg},
        {"/controls/nose_wheel_deg", &p.controls.nose_wheel_deg},
        {"/controls/rate_per_s", &p.controls.rate_per_s}, {"/controls/lag_s", &p.controls.lag_s},

        {"/propeller/diameter_m", &p.propeller.diameter_m},
        {"/propeller/inertia_kgm2", &p.propeller.inertia_kgm2},
        {"/propeller/thrust/0", &p.propeller.thrust0},
        {"/propeller/thrust/1", &p.propeller.thrust1},
        {"/propeller/thrust/2", &p.propeller.thrust2},
        {"/propeller/torque/0", &p.propeller.torque0},
        {"/propeller/torque/1", &p.propeller.torque1},
        {"/propeller/torque/2", &p.propeller.torque2},
        {"/propeller/slipstream", &p.propeller.slipstream},
        {"/motor/volts_per_rads", &p.motor.volts_per_rads},
        {"/motor/resistance_ohm", &p.motor.resistance_ohm}, {"/motor/idle_a", &p.motor.idle_a},
        {"/motor/throttle_exponent", &p.motor.throttle_exponent}, {"/motor/lag_s", &p.motor.lag_s},
        {"/battery/cells", &p.battery.cells}, {"/battery/capacity_mah", &p.battery.capacity_mah},
        {"/battery/resistance_ohm", &p.battery.resistance_ohm},
        {"/battery/avionics_a", &p.battery.avionics_a},
        {"/battery/full_v", &p.battery.full_v}, {"/battery/knee_v", &p.battery.knee_v},
        {"/battery/empty_v", &p.battery.empty_v}, {"/battery/knee_charge", &p.battery.knee_charge},

        {"/grip/stiffness_nm", &p.grip.stiffness_nm}, {"/grip/damping_nsm", &p.grip.damping_nsm},
    };
}
// clang-format on

Vec3 vectorOf(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

void readExtras(Json& json, AirplaneParameters& out) {
    for (const auto& [key, to] : {std::pair{"elevons", &out.elevons},
                                  {"v_tail", &out.v_tail},
                                  {"flaperons", &out.flaperons}}) {
        *to = json.value(key, false);
        json.erase(key);
    }
    if (out.elevons && (out.v_tail || out.flaperons))
        throw std::runtime_error("/elevons goes with neither /v_tail nor /flaperons");
    if (json.contains("flaps"))
        out.flaps = {json["flaps"].at("lift").get<double>(), json["flaps"].at("drag").get<double>(),
                     json["flaps"].at("pitch").get<double>()};
    json.erase("flaps");
    if (json.contains("imu_place_m")) out.imu_place_m = vectorOf(json["imu_place_m"]);
    json.erase("imu_place_m");
    if (!json.contains("linkage")) return;
    out.linkage = {json["linkage"].at("deadband").get<double>(),
                   json["linkage"].at("curve").get<double>()};
    json.erase("linkage");
}

void readLaunch(Json& json, AirplaneParameters& out) {
    if (!json.contains("launch")) return;
    const Json launch = json["launch"];
    json.erase("launch");
    out.launch = {launch.at("speed_mps").get<double>(), launch.at("acceleration_mss").get<double>(),
                  launch.at("pitch_deg").get<double>(), launch.at("height_m").get<double>()};
    if (out.launch.speed_mps <= 0 || out.launch.acceleration_mss <= 0)
        throw std::runtime_error("/launch needs a speed and an acceleration above 0");
}

Contact contact(const Json& from) {
    Contact to;
    to.name = from.at("name").get<std::string>();
    to.place_m = vectorOf(from.at("place_m"));
    to.wheel = from.value("wheel", false);
    to.steered = from.value("steered", false);
    to.stiffness_nm = from.at("stiffness_nm").get<double>();
    to.damping_nsm = from.at("damping_nsm").get<double>();
    to.sliding = from.at("sliding").get<double>();
    to.rolling = from.value("rolling", to.sliding);
    to.breaks_at_mps = from.at("breaks_at_mps").get<double>();
    return to;
}

AirplaneParameters parse(Json json) {
    AirplaneParameters out;
    for (const Json& one : json.at("contacts")) out.contacts.push_back(contact(one));
    json.erase("contacts");
    json.erase("about");
    readExtras(json, out);
    readLaunch(json, out);
    Json flat = json.flatten();
    for (const Field& field : fields(out)) {
        if (!flat.contains(field.key)) throw std::runtime_error(std::string("lacks ") + field.key);
        *field.to = flat[field.key].get<double>();
        flat.erase(field.key);
    }
    if (!flat.empty()) throw std::runtime_error("does not know " + flat.begin().key());
    return out;
}

Json jsonOf(const Vec3& vector) { return {vector.x, vector.y, vector.z}; }

Json jsonOf(const Contact& from) {
    return {{"name", from.name},
            {"place_m", jsonOf(from.place_m)},
            {"wheel", from.wheel},
            {"steered", from.steered},
            {"stiffness_nm", from.stiffness_nm},
            {"damping_nsm", from.damping_nsm},
            {"rolling", from.rolling},
            {"sliding", from.sliding},
            {"breaks_at_mps", from.breaks_at_mps}};
}

}  // namespace

std::string airplaneText(AirplaneParameters airplane, const std::string& about) {
    Json flat = Json::object();
    for (const Field& field : fields(airplane)) flat[field.key] = *field.to;
    Json json = flat.unflatten();
    json["about"] = about;
    json["contacts"] = Json::array();
    for (const Contact& each : airplane.contacts) json["contacts"].push_back(jsonOf(each));
    json["elevons"] = airplane.elevons;
    json["v_tail"] = airplane.v_tail;
    json["flaperons"] = airplane.flaperons;
    json["flaps"] = {{"lift", airplane.flaps.lift},
                     {"drag", airplane.flaps.drag},
                     {"pitch", airplane.flaps.pitch}};
    json["imu_place_m"] = jsonOf(airplane.imu_place_m);
    json["linkage"] = {{"deadband", airplane.linkage.deadband}, {"curve", airplane.linkage.curve}};
    if (const auto& launch = airplane.launch; launch.speed_mps > 0)
        json["launch"] = {{"speed_mps", launch.speed_mps},
                          {"acceleration_mss", launch.acceleration_mss},
                          {"pitch_deg", launch.pitch_deg},
                          {"height_m", launch.height_m}};
    return json.dump(4) + "\n";
}

std::string airplanePath(const std::string& name) {
    const bool path =
        name.find('/') != std::string::npos || name.find(".json") != std::string::npos;
    return path ? name : std::string(SIMULATOR_AIRPLANES) + "/" + name + ".json";
}

AirplaneParameters loadAirplane(const std::string& name) {
    const std::string path = airplanePath(name);
    if (std::filesystem::is_directory(path))
        throw AirplaneError(path + ": is a folder; expected the .json file of an airplane");
    std::ifstream file(path);
    if (!file) throw AirplaneError(path + ": no such airplane");
    try {
        return parse(Json::parse(file));
    } catch (const std::exception& error) {
        throw AirplaneError(path + ": " + error.what());
    }
}

}  // namespace simulator
