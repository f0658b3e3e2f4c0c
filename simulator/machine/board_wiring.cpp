// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/board_wiring.hpp"

#include "simulator/devices/analog_sensors.hpp"

namespace simulator {
namespace {

BoardWiring apm2() {
    BoardWiring w{};
    w.name = "apm2";
    w.servos = {{{{'B', 6}, '1', 1},
                 {{'B', 5}, '1', 0},
                 {{'H', 5}, '4', 2},
                 {{'H', 4}, '4', 1},
                 {{'H', 3}, '4', 0},
                 {{'E', 5}, '3', 2},
                 {{'E', 4}, '3', 1},
                 {{'E', 3}, '3', 0}}};
    w.radio = {'L', 1};
    w.radio_timer = '5';
    w.relay = {'B', 7};
    w.leds = {{{'A', 5}, {'A', 4}, {'A', 3}}};
    w.leds_active_low = true;
    w.flash_select = {'A', 6};
    w.flash_reset = {'G', 0};
    w.flash_usart = 3;
    w.telemetry_usart = 2;
    for (const int pin :
         {AnalogSensors::kAirspeedPin, AnalogSensors::kCurrentPin, AnalogSensors::kVoltagePin})
        w.analog.push_back({pin, pin, 1});
    w.imu_select = PinName{'B', 0};
    w.barometer_select = PinName{'G', 1};
    w.data_ready = PinName{'E', 6};
    w.usb_sense = PinName{'A', 1};
    return w;
}

BoardWiring apm1() {
    constexpr double kOwnDivider = 3.56, kPowerModule = 10.1;
    BoardWiring w{};
    w.name = "apm1";
    w.servos = {{{{'L', 4}, '5', 1},
                 {{'L', 5}, '5', 2},
                 {{'B', 6}, '1', 1},
                 {{'B', 7}, '1', 2},
                 {{'H', 5}, '4', 2},
                 {{'H', 4}, '4', 1},
                 {{'E', 5}, '3', 2},
                 {{'E', 4}, '3', 1}}};
    w.radio = {'L', 0};
    w.radio_timer = '4';
    w.relay = {'L', 2};
    w.leds = {{{'C', 0}, {'C', 1}, {'C', 2}}};
    w.leds_active_low = false;
    w.flash_select = {'B', 0};
    w.flash_reset = {'C', 6};
    w.telemetry_usart = 3;
    w.analog.push_back({0, AnalogSensors::kVoltagePin, kPowerModule / kOwnDivider});
    w.converter_select = PinName{'C', 4};
    w.converter_usart = 2;
    w.conversion_end = PinName{'C', 7};
    return w;
}

}  // namespace

const BoardWiring kApm1Wiring = apm1(), kApm2Wiring = apm2();

}  // namespace simulator
