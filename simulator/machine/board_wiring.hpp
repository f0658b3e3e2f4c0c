// SPDX-License-Identifier: GPL-3.0-or-later
// Which pins and peripherals of the chip a board has its parts on.
#pragma once
#include <array>
#include <optional>
#include <vector>

namespace simulator {

struct PinName {
    char port;
    int bit;
};

struct ServoWire {
    PinName pin;
    char timer;
    int compare;  // 0..2: A, B, C
};

// An ADC pin of the board that sees an analogue source of the World through another divider.
struct AnalogWire {
    int pin, source;
    double factor;
};

struct BoardWiring {
    const char* name;  // and of its program in simulator/machine/boot
    std::array<ServoWire, 8> servos;
    PinName radio;
    char radio_timer;
    PinName relay;
    std::array<PinName, 3> leds;  // A red, B yellow, C blue
    bool leds_active_low;
    PinName flash_select, flash_reset;
    std::optional<int> flash_usart;  // none: on SPI0
    int telemetry_usart;
    std::vector<AnalogWire> analog;

    // MPU-6000 and MS5611 on SPI0
    std::optional<PinName> imu_select, barometer_select, data_ready, usb_sense;
    // or ADS7844 on a USART, BMP085 on I2C and the compass rolled over
    std::optional<PinName> converter_select;
    std::optional<int> converter_usart;
    std::optional<PinName> conversion_end;  // of the BMP085
};

extern const BoardWiring kApm1Wiring, kApm2Wiring;

}  // namespace simulator
