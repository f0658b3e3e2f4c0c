// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/plan_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/ground/json_places.hpp"
#include "simulator/ground/text_file.hpp"

namespace simulator {
namespace {

using mavlink::MavCmd;

constexpr double kAny = INFINITY, kFarAltitude_m = 100'000;
constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
constexpr uint16_t kLoiterToAlt = 31, kLandStart = 189, kTriggerDistance = 206, kJump = 177;
constexpr uint8_t kGlobal = 0, kMissionFrame = 2, kAboveHome = 3;  // MAV_FRAME
constexpr int kArduPilot = 3, kFixedWing = 1;                      // MAV_AUTOPILOT, MAV_TYPE

struct Range {
    const char* what;
    double lowest, highest;
};
constexpr Range kLatitude = {"a latitude, -90 to 90 degrees", -90, 90};
constexpr Range kLongitude = {"a longitude, -180 to 180 degrees", -180, 180};
constexpr Range kAltitude = {"an altitude in metres", -kFarAltitude_m, kFarAltitude_m};
constexpr Range kParameter = {"a number or null as parameter", -kAny, kAny};
constexpr Range kRadius = {"a radius of 0.1 to 1000000 m", 0.1, 1e6};

std::string shown(const Json& value) {
    return "'" + printable(value.dump(-1, ' ', false, Json::error_handler_t::replace)) + "'";
}

const Json kNothing;

const Json& member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? kNothing : *found;
}

class PlanReader {
public:
    PlanReader(const PlacedJson& json, const std::string& name) : json_(json), name_(name) {}

    MissionFile read() {
        const Json& root = json_.root();
        planners_ = root.is_object() && member(root, "groundStation") == "MissionPlanner";
        const bool unnamed = planners_ && member(root, "fileType").is_null();
        if (!root.is_object() || (member(root, "fileType") != "Plan" && !unnamed)) {
            fail(root, {},
                 "expected a .plan of QGroundControl (\"fileType\": \"Plan\"), found other JSON" +
                     otherKind(root));
            return std::move(mission_);
        }
        if (!version(root, {}, 1, 1)) return std::move(mission_);
        readMission(member(root, "mission"));
        readFence(member(root, "geoFence"));
        readRally(member(root, "rallyPoints"));
        return std::move(mission_);
    }

private:
    // ---- what is wrong, and where
    void fail(const Json& at, const std::string& what, const std::string& text) {
        const TextPlace place = json_.placeOf(at);
        mission_.errors.push_back({place.line, place.column,
                                   name_ + ':' + std::to_string(place.line) + ':' +
                                       std::to_string(place.column) + ": " +
                                       (what.empty() ? "" : what + ": ") + text});
    }
    void expect(const Json& at, const std::string& what, const std::string& wanted,
                const Json& found) {
        fail(at, what,
             "expected " + wanted + ", found " + (found.is_null() ? "nothing" : shown(found)));
    }
    void remark(const Json& at, const std::string& text) {
        const TextPlace place = json_.placeOf(at);
        mission_.remarks.push_back({place.line, place.column, text});
    }
    static std::string otherKind(const Json& root) {
        if (!root.is_object()) return "";
        const Json& type = member(root, "fileType");
        if (type.is_string()) return ": \"fileType\": " + shown(type);
        if (root.contains("MAV_AUTOPILOT")) return ": a mission of QGroundControl before 3.2";
        if (member(root, "type") == "FeatureCollection") return ": GeoJSON, which has no commands";
        return "";
    }

    // Mission Planner does not always write its versions.
    int lowest(int version) const { return planners_ ? 0 : version; }
    bool version(const Json& object, const std::string& what, int lowest, int highest) {
        const Json& found = member(object, "version");
        if (found.is_number_integer() && found >= lowest && found <= highest) return true;
        expect(object, what, "version " + std::to_string(highest), found);
        return false;
    }
    const Json* list(const Json& object, const std::string& what, const char* key, bool required) {
        const Json& found = member(object, key);
        if (found.is_array()) return &found;
        if (required || !found.is_null())
            expect(object, what, std::string("a list \"") + key + '"', found);
        return nullptr;
    }
    double number(const Json& at, const std::string& what, const Json& value, const Range& range) {
        const double found = value.is_number() ? value.get<double>() : kUnset;
        if (found >= range.lowest && found <= range.highest) return found;
        expect(at, what, range.what, value);
        return 0;
    }
    int whole(const Json& object, const std::string& what, const char* key, int lowest,
              int highest) {
        const Json& value = member(object, key);
        const double found = value.is_number() ? value.get<double>() : kUnset;
        if (found >= lowest && found <= highest && found == std::floor(found))
            return static_cast<int>(found);
        expect(object, what,
               std::string(key) + ", " + std::to_string(lowest) + " to " + std::to_string(highest),
               value);
        return 0;
    }
    bool flag(const Json& object, const char* key, bool otherwise) const {
        const Json& value = member(object, key);
        return value.is_boolean() ? value.get<bool>() : otherwise;
    }
    // [latitude, longitude] and, where there is one, the altitude; NaN without
    struct Coordinate {
        Place place;
        double altitude_m = kUnset;
    };
    Coordinate coordinate(const Json& at, const std::string& what, const Json& value,
                          size_t least = 2) {
        Coordinate found;
        if (!value.is_array() || value.size() < least || value.size() > 3) {
            expect(at, what,
                   least == 3 ? "[latitude, longitude, altitude]" : "[latitude, longitude]", value);
            return found;
        }
        found.place = {number(value, what, value[0], kLatitude),
                       number(value, what, value[1], kLongitude)};
        if (least == 3) found.altitude_m = number(value, what, value[2], kAltitude);
        return found;
    }

    // ---- the mission
    void readMission(const Json& mission) {
        if (!mission.is_object()) return expect(json_.root(), {}, "an object \"mission\"", mission);
        if (!version(mission, "mission", lowest(2), 2)) return;
        remarkOnVehicle(mission);
        readHome(mission);
        const Json* items = list(mission, "mission", "items", true);
        if (items == nullptr) return;
        for (const Json& item : *items) readItem(item);
        if (mission_.items.size() < 2) fail(*items, "mission", "expected at least one item");
        resolveJumps();
    }

    void remarkOnVehicle(const Json& mission) {
        const Json &firmware = member(mission, "firmwareType"),
                   &vehicle = member(mission, "vehicleType");
        if (planners_ && firmware == 0) return;
        if (firmware.is_number() && firmware != kArduPilot)
            remark(mission, "firmwareType " + shown(firmware) +
                                " is not ArduPilot's 3: its "
                                "commands are taken as ArduPilot's");
        if (vehicle.is_number() && vehicle != kFixedWing)
            remark(mission, "vehicleType " + shown(vehicle) + " is no fixed wing (1)");
    }

    void readHome(const Json& mission) {
        const Coordinate home =
            coordinate(mission, "plannedHomePosition", member(mission, "plannedHomePosition"), 3);
        WaypointItem item = itemAt(mission, MavCmd::nav_waypoint, kGlobal);
        item.current = true;
        put(item, home.place, home.altitude_m);
        mission_.items.push_back(item);
    }

    WaypointItem itemAt(const Json& at, uint16_t command, uint8_t frame) const {
        WaypointItem item;
        item.index = static_cast<int>(mission_.items.size());
        item.command = command;
        item.frame = frame;
        const TextPlace place = json_.placeOf(at);
        item.line = place.line;
        item.columns.fill(place.column);
        return item;
    }
    static void put(WaypointItem& item, const Place& place, double altitude_m) {
        item.latitude_deg = place.latitude_deg;
        item.longitude_deg = place.longitude_deg;
        item.altitude_m = altitude_m;
    }
    std::string nextItem() const { return "item " + std::to_string(mission_.items.size()); }

    void readItem(const Json& item) {
        const Json& type = item.is_object() ? member(item, "type") : kNothing;
        if (type == "SimpleItem" || (planners_ && type.is_null() && item.is_object())) {
            const Json& id = member(item, "doJumpId");
            if (id.is_number_integer() && (!planners_ || id > 0))
                jump_ids_.emplace(id.get<int64_t>(), mission_.items.size());
            readSimple(item);
        } else if (type == "ComplexItem") {
            readComplex(item);
        } else {
            expect(item, nextItem(), "\"type\": \"SimpleItem\" or \"ComplexItem\"", type);
        }
    }

    void readSimple(const Json& from) {
        const std::string what = nextItem();
        if (!from.is_object()) return expect(from, what, "an item", from);
        const size_t errors_before = mission_.errors.size();
        WaypointItem item =
            itemAt(from, static_cast<uint16_t>(whole(from, what, "command", 1, 65535)),
                   static_cast<uint8_t>(whole(from, what, "frame", 0, 255)));
        item.autocontinue = flag(from, "autoContinue", true);
        const Json& params = allParams(from);
        const Json& at = &params == &joined_ ? from : params;
        if (!params.is_array() || params.size() != 7) {
            expect(from, what, "a list \"params\" of seven numbers", params);
        } else {
            for (size_t i = 0; i < 4; ++i)
                item.params[i] =
                    params[i].is_null() ? kUnset : number(at, what, params[i], kParameter);
            readPlace(item, what, at, params);
        }
        item.readable = mission_.errors.size() == errors_before;
        mission_.items.push_back(item);
    }

    // Mission Planner has written four and the coordinate beside them.
    const Json& allParams(const Json& from) {
        const Json &params = member(from, "params"), &place = member(from, "coordinate");
        if (!planners_ || !params.is_array() || params.size() != 4 || !place.is_array())
            return params;
        joined_ = params;
        joined_.insert(joined_.end(), place.begin(), place.end());
        return joined_;
    }

    // null is "here" of a place, and nothing of a command that has none.
    void readPlace(WaypointItem& item, const std::string& what, const Json& at,
                   const Json& params) {
        const auto orZero = [&](size_t i, const Range& range) {
            return params[i].is_null() ? 0 : number(at, what, params[i], range);
        };
        item.latitude_deg = orZero(4, kLatitude);
        item.longitude_deg = orZero(5, kLongitude);
        item.altitude_m = item.hasPlace() || item.command == MavCmd::nav_takeoff
                              ? number(at, what, params[6], kAltitude)
                              : orZero(6, kAltitude);
    }

    void readComplex(const Json& item) {
        const Json& type = member(item, "complexItemType");
        const Json& transects = member(item, "TransectStyleComplexItem");
        const Json& stored = transects.is_object() ? member(transects, "Items") : kNothing;
        if (type == "fwLandingPattern") return readLanding(item);
        if (type != "survey" && type != "CorridorScan" && type != "StructureScan")
            return expect(item, nextItem(),
                          "a complex item of type survey, CorridorScan, StructureScan or "
                          "fwLandingPattern",
                          type);
        if (!stored.is_array() || stored.empty())
            return fail(item, nextItem(),
                        "a complex item of type " + shown(type) +
                            " in which no commands are stored (TransectStyleComplexItem.Items): "
                            "only QGroundControl can make them");
        for (const Json& each : stored) readSimple(each);
    }

    // As QGroundControl sends it: DO_LAND_START, what stops the camera, the approach, LAND.
    void readLanding(const Json& from) {
        const std::string what = nextItem() + " (fwLandingPattern)";
        if (!version(from, what, 2, 2)) return;
        const Coordinate land =
            coordinate(from, what + ", landCoordinate", member(from, "landCoordinate"), 3);
        const bool old_key = !from.contains("landingApproachCoordinate");
        const char* key = old_key ? "loiterCoordinate" : "landingApproachCoordinate";
        const Coordinate approach = coordinate(from, what + ", " + key, member(from, key), 3);
        const uint8_t frame = flag(from, "altitudesAreRelative", true) ? kAboveHome : kGlobal;
        mission_.items.push_back(itemAt(from, kLandStart, kMissionFrame));
        if (flag(from, "stopTakingPhotos", false))
            mission_.items.push_back(itemAt(from, kTriggerDistance, kMissionFrame));
        if (flag(from, "stopVideoPhotos", false))
            remark(from, what +
                             ": the command that stops a video is left out; this autopilot has "
                             "none");
        mission_.items.push_back(approachItem(from, what, frame));
        put(mission_.items.back(), approach.place, approach.altitude_m);
        mission_.items.push_back(itemAt(from, MavCmd::nav_land, frame));
        put(mission_.items.back(), land.place, land.altitude_m);
    }

    WaypointItem approachItem(const Json& from, const std::string& what, uint8_t frame) {
        if (!flag(from, "useLoiterToAlt", true)) return itemAt(from, MavCmd::nav_waypoint, frame);
        WaypointItem item = itemAt(from, kLoiterToAlt, frame);
        const double radius_m =
            number(from, what + ", loiterRadius", member(from, "loiterRadius"), kRadius);
        item.params = {1, flag(from, "loiterClockwise", true) ? radius_m : -radius_m, 0, 1};
        return item;
    }

    // A jump names its target by doJumpId, which only items that are not complex have.
    void resolveJumps() {
        for (WaypointItem& item : mission_.items) {
            if (item.command != kJump || !item.readable) continue;
            const double wanted = item.params[0];
            const bool is_id = wanted == std::floor(wanted) && std::abs(wanted) < 1e9;
            if (planners_ && jump_ids_.empty()) continue;  // by the item's number
            const auto found =
                is_id ? jump_ids_.find(static_cast<int64_t>(wanted)) : jump_ids_.end();
            if (found != jump_ids_.end()) {
                item.params[0] = static_cast<double>(found->second);
                continue;
            }
            item.readable = false;
            char id[32];
            std::snprintf(id, sizeof id, "%g", wanted);
            const std::string place =
                std::to_string(item.line) + ':' + std::to_string(item.columns[0]);
            mission_.errors.push_back(
                {item.line, item.columns[0],
                 name_ + ':' + place + ": item " + std::to_string(item.index) +
                     ": no item has the doJumpId " + id + " that this jump goes to"});
        }
    }

    // ---- fence and rally points
    void readFence(const Json& fence) {
        if (fence.is_null()) return;
        if (!fence.is_object()) return expect(json_.root(), {}, "an object \"geoFence\"", fence);
        if (!version(fence, "geoFence", lowest(1), 2)) return;
        if (member(fence, "version") == 1 || member(fence, "polygon").is_array()) {
            readPolygon(fence, true);
        } else {
            if (const Json* polygons = list(fence, "geoFence", "polygons", false))
                for (const Json& each : *polygons)
                    readPolygon(each, each.is_object() && flag(each, "inclusion", true));
            if (const Json* circles = list(fence, "geoFence", "circles", false))
                for (const Json& each : *circles) readCircle(each);
        }
        const Json& way_back = member(fence, "breachReturn");
        if (!way_back.is_null())
            mission_.fence.way_back = coordinate(fence, "geoFence, breachReturn", way_back).place;
    }

    void readPolygon(const Json& from, bool inclusion) {
        const std::string what = "geoFence, polygon";
        if (!from.is_object()) return expect(from, what, "an object", from);
        const bool flat = member(from, "version") == 1 && !from.contains("inclusion");
        const Json* corners = list(from, what, "polygon", !flat);
        if (corners == nullptr || (flat && corners->empty())) return;
        if (corners->size() < 3)
            return fail(
                *corners, what,
                "expected at least three corners, found " + std::to_string(corners->size()));
        FenceArea area;
        area.inclusion = inclusion;
        for (const Json& corner : *corners)
            area.rim.push_back(coordinate(*corners, what, corner).place);
        mission_.fence.areas.push_back(area);
    }

    void readCircle(const Json& from) {
        const std::string what = "geoFence, circle";
        const Json& circle = from.is_object() ? member(from, "circle") : kNothing;
        if (!circle.is_object()) return expect(from, what, "an object \"circle\"", circle);
        FenceArea area;
        area.inclusion = flag(from, "inclusion", true);
        area.rim.push_back(coordinate(circle, what + ", center", member(circle, "center")).place);
        area.radius_m = number(circle, what, member(circle, "radius"), kRadius);
        if (area.isCircle()) mission_.fence.areas.push_back(area);
    }

    void readRally(const Json& rally) {
        if (rally.is_null()) return;
        if (!rally.is_object()) return expect(json_.root(), {}, "an object \"rallyPoints\"", rally);
        if (!version(rally, "rallyPoints", lowest(1), 2)) return;
        const Json* points = list(rally, "rallyPoints", "points", false);
        if (points == nullptr) return;
        for (const Json& each : *points) {
            const Coordinate found = coordinate(*points, "rallyPoints", each, 3);
            mission_.rally.push_back({found.place, found.altitude_m});
        }
    }

    const PlacedJson& json_;
    const std::string& name_;
    MissionFile mission_;
    std::map<int64_t, size_t> jump_ids_;
    bool planners_ = false;  // Mission Planner's
    Json joined_;
};

// ---- writing

Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json pair(const Place& place) { return {place.latitude_deg, place.longitude_deg}; }

Json itemAsJson(const WaypointItem& item, size_t index) {
    nlohmann::ordered_json json;
    if (item.hasPlace() || item.command == MavCmd::nav_takeoff) {
        json["AMSLAltAboveTerrain"] = nullptr;
        json["Altitude"] = numberOrNull(item.altitude_m);
        json["AltitudeMode"] = item.relative() ? 1 : 2;
    }
    json["autoContinue"] = item.autocontinue;
    json["command"] = item.command;
    json["doJumpId"] = index;
    json["frame"] = item.frame;
    Json params = Json::array();
    for (const double param : item.params) params.push_back(numberOrNull(param));
    for (const double part : {item.latitude_deg, item.longitude_deg, item.altitude_m})
        params.push_back(numberOrNull(part));
    json["params"] = params;
    json["type"] = "SimpleItem";
    return json;
}

Json fenceAsJson(const Fence& fence) {
    Json json;
    if (fence.way_back) json["breachReturn"] = pair(*fence.way_back);
    json["circles"] = Json::array();
    json["polygons"] = Json::array();
    for (const FenceArea& area : fence.areas) {
        Json each;
        if (area.isCircle()) {
            each["circle"] = {{"center", pair(area.rim[0])}, {"radius", area.radius_m}};
            each["inclusion"] = area.inclusion;
            each["version"] = 1;
            json["circles"].push_back(each);
            continue;
        }
        each["inclusion"] = area.inclusion;
        each["polygon"] = Json::array();
        for (const Place& corner : area.rim) each["polygon"].push_back(pair(corner));
        each["version"] = 1;
        json["polygons"].push_back(each);
    }
    json["version"] = 2;
    return json;
}

Json missionAsJson(const Waypoints& items, double cruise_mps) {
    constexpr int kRelativeMode = 1, kHover_mps = 5;
    Json json;
    json["cruiseSpeed"] = cruise_mps;
    json["firmwareType"] = kArduPilot;
    json["globalPlanAltitudeMode"] = kRelativeMode;
    json["hoverSpeed"] = kHover_mps;
    json["items"] = Json::array();
    for (size_t i = 1; i < items.size(); ++i) json["items"].push_back(itemAsJson(items[i], i));
    json["plannedHomePosition"] = {items[0].latitude_deg, items[0].longitude_deg,
                                   items[0].altitude_m};
    json["vehicleType"] = kFixedWing;
    json["version"] = 2;
    return json;
}

}  // namespace

bool looksLikeJson(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string::npos && (text[first] == '{' || text[first] == '[');
}

MissionFile readPlan(const std::string& text, const std::string& name) {
    const PlacedJson json(text);
    if (json.problem().empty()) return PlanReader(json, name).read();
    const TextPlace at = json.problemPlace();
    MissionFile mission;
    mission.errors.push_back({at.line, at.column,
                              name + ':' + std::to_string(at.line) + ':' +
                                  std::to_string(at.column) + ": " + json.problem()});
    return mission;
}

std::string planOf(const MissionFile& mission, double cruise_mps) {
    Json json;
    json["fileType"] = "Plan";
    json["geoFence"] = fenceAsJson(mission.fence);
    json["groundStation"] = "toolchain/mission";
    json["mission"] = missionAsJson(mission.items, cruise_mps);
    json["rallyPoints"] = {{"points", Json::array()}, {"version", 2}};
    for (const RallyPlace& each : mission.rally)
        json["rallyPoints"]["points"].push_back(
            {each.place.latitude_deg, each.place.longitude_deg, each.height_m});
    json["version"] = 1;
    return json.dump(4) + "\n";
}

}  // namespace simulator
