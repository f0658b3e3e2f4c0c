// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes into the GPS driver, in chunks of any size. Whatever they were: a fix it vouches for is
// a place on earth and a speed an airplane flies, and good messages behind them are heard, all but
// those the bytes before laid claim to.
#include <stdlib.h>

#include "drivers/gps.hpp"
#include "fakes/fakes.hpp"

namespace {

constexpr uint8_t kUbx[] = {0xB5, 0x62, 0x05, 0x01, 0x02, 0x00, 0x06, 0x01, 0x0F, 0x38};

void require(bool holds) {
    if (!holds) abort();
}

void check(const drivers::GpsFix& fix) {
    if (fix.type <= drivers::GpsFixType::none) return;
    require(fix.latitude_e7 >= -900000000 && fix.latitude_e7 <= 900000000);
    require(fix.longitude_e7 >= -1800000000 && fix.longitude_e7 <= 1800000000);
    require(fix.speed_cms <= 30000 && fix.course_cd < 36000);
    require(abs(fix.north_cms) <= 30000 && abs(fix.east_cms) <= 30000 &&
            abs(fix.down_cms) <= 30000);
    require(fix.age_ms <= 1000);
}

struct Driver {
    drivers::Gps gps;
    uint32_t now_ms = 0;

    void step() {
        if (gps.step(now_ms += 10)) check(gps.fix());
    }
    void take(const uint8_t* bytes, size_t size) {
        for (size_t i = 0; i < size; ++i) fakes::serial(hal::Port::gps).in.push_back(bytes[i]);
        while (!fakes::serial(hal::Port::gps).in.empty()) step();
    }
};

}  // namespace

// The first byte: the type the receiver is said to be, and how the rest is cut into steps.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    if (size == 0) return 0;
    fakes::resetSerial();
    Driver driver;
    driver.gps.start(drivers::gps_any + (bytes[0] & 7) % 5);
    const size_t chunk = 1 + (bytes[0] >> 3);
    for (int i = 0; i < 16; ++i) driver.step();  // past the greeting
    for (size_t at = 1; at < size; at += chunk)
        driver.take(bytes + at, size - at < chunk ? size - at : chunk);

    drivers::GpsFraming framing;
    const auto hear = [&framing](const uint8_t* from, size_t count) {
        int heard = 0;
        for (size_t i = 0; i < count; ++i)
            for (auto what = framing.put(from[i]); what != drivers::GpsProtocol::none;
                 what = framing.next())
                ++heard;
        return heard;
    };
    hear(bytes, size);
    int heard = 0;
    constexpr int kLost = drivers::GpsFraming::kLongest / sizeof kUbx + 1, kWanted = 10;
    for (int i = 0; i < kLost + kWanted; ++i) heard += hear(kUbx, sizeof kUbx);
    require(heard >= kWanted);  // a frame of the longest kind may have been begun before
    return 0;
}
