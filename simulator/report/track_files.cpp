// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/track_files.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>

namespace simulator {
namespace {

std::string number(double value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

// ISO 8601 with tenths, UTC.
std::string instant(double time_s, int64_t epoch_s) {
    const double tenths = std::round(time_s * 10);
    const auto whole = static_cast<std::time_t>(epoch_s + static_cast<int64_t>(tenths / 10));
    std::tm utc{};
    gmtime_r(&whole, &utc);
    char text[40];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &utc);
    return text + ("." + std::to_string(static_cast<int64_t>(tenths) % 10)) + "Z";
}

std::string inXml(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '&')
            out += "&amp;";
        else if (letter == '<')
            out += "&lt;";
        else if (letter == '>')
            out += "&gt;";
        else if (letter == '"')
            out += "&quot;";
        else
            out += letter;
    }
    return out;
}

std::string coordinates(double longitude_deg, double latitude_deg, double altitude_m,
                        const char* between) {
    return number(longitude_deg, 7) + between + number(latitude_deg, 7) + between +
           number(altitude_m, 1);
}

std::string coordinates(const DocumentPlace& place) {
    return coordinates(place.longitude_deg, place.latitude_deg, place.altitude_m.value_or(0), ",");
}

std::string pinName(const DocumentItem& item) {
    return inXml(std::to_string(item.index) + " " + item.name);
}

std::string pin(const std::string& name, const std::string& words, const DocumentPlace& place) {
    return "<Placemark><name>" + name + "</name><description>" + inXml(words) +
           "</description><styleUrl>#pin</styleUrl><Point><altitudeMode>absolute</altitudeMode>"
           "<coordinates>" +
           coordinates(place) + "</coordinates></Point></Placemark>\n";
}

std::string style(const char* id, const char* colour, int width) {
    return "<Style id=\"" + std::string(id) + "\"><LineStyle><color>" + colour + "</color><width>" +
           std::to_string(width) + "</width></LineStyle></Style>\n";
}

std::string plannedLine(const DocumentPlan& plan) {
    std::string places = plan.home ? coordinates(*plan.home) + "\n" : "";
    for (const DocumentItem& item : plan.items)
        if (item.place) places += coordinates(*item.place) + "\n";
    return "<Placemark><name>planned</name><styleUrl>#planned</styleUrl><LineString>"
           "<altitudeMode>absolute</altitudeMode><coordinates>\n" +
           places + "</coordinates></LineString></Placemark>\n";
}

std::string pins(const DocumentPlan& plan) {
    std::string text = plan.home ? pin("home", "home", *plan.home) : "";
    for (const DocumentItem& item : plan.items)
        if (item.place) text += pin(pinName(item), item.text, *item.place);
    for (const DocumentPlace& place : plan.rally) text += pin("rally point", "", place);
    return text;
}

std::string flownTrack(const std::vector<Sample>& samples, int64_t epoch_s) {
    std::string when, where;
    for (const Sample& s : samples) {
        when += "<when>" + instant(s.time_s, epoch_s) + "</when>\n";
        where += "<gx:coord>" +
                 coordinates(s.truth.longitude_deg, s.truth.latitude_deg, s.truth.altitude_m, " ") +
                 "</gx:coord>\n";
    }
    return "<Placemark><name>flown</name><styleUrl>#flown</styleUrl><gx:Track>"
           "<altitudeMode>absolute</altitudeMode>\n" +
           when + where + "</gx:Track></Placemark>\n";
}

std::string gpxPoint(const char* tag, const DocumentPlace& place, const std::string& inside) {
    return "<" + std::string(tag) + " lat=\"" + number(place.latitude_deg, 7) + "\" lon=\"" +
           number(place.longitude_deg, 7) + "\"><ele>" + number(place.altitude_m.value_or(0), 1) +
           "</ele>" + inside + "</" + tag + ">\n";
}

}  // namespace

std::string trackKml(const std::vector<Sample>& samples, const DocumentPlan& plan,
                     const std::string& name, int64_t epoch_s) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
           "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document><name>" +
           inXml(name) + "</name>\n" + style("flown", "ffc06a1f", 3) +
           style("planned", "ff8a8a8a", 2) +
           "<Style id=\"pin\"><IconStyle><scale>0.8</scale></IconStyle></Style>\n" +
           flownTrack(samples, epoch_s) + plannedLine(plan) + pins(plan) + "</Document></kml>\n";
}

std::string trackGpx(const std::vector<Sample>& samples, const DocumentPlan& plan,
                     const std::string& name, int64_t epoch_s) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<gpx version=\"1.1\" creator=\"apm-autopilot\" "
        "xmlns=\"http://www.topografix.com/GPX/1/1\">\n<metadata><name>" +
        inXml(name) + "</name></metadata>\n";
    for (const DocumentItem& item : plan.items)
        if (item.place)
            text +=
                gpxPoint("wpt", *item.place,
                         "<name>" + pinName(item) + "</name><desc>" + inXml(item.text) + "</desc>");
    text += "<trk><name>flown</name><trkseg>\n";
    for (const Sample& s : samples) {
        const Truth& at = s.truth;
        text += gpxPoint("trkpt", {at.latitude_deg, at.longitude_deg, at.altitude_m},
                         "<time>" + instant(s.time_s, epoch_s) + "</time>");
    }
    return text + "</trkseg></trk></gpx>\n";
}

}  // namespace simulator
