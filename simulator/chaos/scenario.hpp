// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to an airplane in one flight of chaos, as text that a person can read and cut down:
// the air and the airplane, the mission, and a line for every event.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulator/ground/mission_file.hpp"

namespace simulator::chaos {

// The words of an event, by its first one (docs/chaos.md):
//   fault SENSOR:HOW SECONDS        restart brown_out|power_dip|watchdog|button
//   sticks ROLL PITCH THROTTLE YAW  switch US                transmitter on|off
//   usb on|off                      param LINK NAME VALUE    mode LINK NUMBER
//   command LINK NUMBER P1 .. P7    override LINK C1 .. C8   current LINK ITEM
//   count LINK ITEMS                clear LINK
//   item LINK SEQ COMMAND FRAME P1 P2 P3 P4 LATITUDE LONGITUDE ALTITUDE
//   frame LINK ID PAYLOAD           noise LINK BYTES
// LINK is usb or telemetry; PAYLOAD and BYTES are hexadecimal.
struct Event {
    double at_s = 0;
    std::vector<std::string> words;

    const std::string& kind() const { return words.front(); }
};

// What is drawn of the world besides; as in WorldOptions. A line of its name, where it is unusual.
struct Conditions {
    double tube = 1;  // 0: no airspeed sensor
    double gps_latency_s = 0.2;
    double board_warmth_c = 10, board_warmth_start_c = 10;
    double band_gap_v = 0;
    double worn_cells = 0;
    double bootloader = 0;  // of enum Bootloader
    double declination_deg = 3.67, inclination_deg = 63.54, magnetic_field_mg = 484.1;
};
struct Condition {
    const char* name;
    double Conditions::*value;
    bool of_the_place;  // goes with the mission's
};
extern const std::vector<Condition> kConditions;

struct Scenario {
    std::string airplane = "foam_trainer";
    double wind_mps = 0, wind_from_deg = 0;
    bool gusts = false;
    uint64_t seed = 1;     // of the sensors' errors
    double begins_s = 0;   // until then it stands, and nobody wants to fly it
    double seconds = 120;  // of emulated time
    Conditions conditions;
    Waypoints mission;          // item 0 is home
    Fence fence;                // on by itself, and turns the airplane back
    std::vector<Event> events;  // in order of time
};

class ScenarioError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

std::string textOf(const Scenario& scenario);
std::string textOf(const Event& event);
Scenario parseScenario(const std::string& text);  // throws ScenarioError with the line

// All there is in a scenario is survived, says docs/failsafes.md: a crash is the firmware's doing.
bool promisesToSurvive(const Scenario& scenario);

}  // namespace simulator::chaos
