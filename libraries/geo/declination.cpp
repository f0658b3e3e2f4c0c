// SPDX-License-Identifier: GPL-3.0-or-later
#include "geo/declination.hpp"

#include "core/maths.hpp"
#include "geo/declination_table.hpp"

namespace geo {
namespace {

// Angles in 65536e-7 degrees: sixteen bits, 700 m.
constexpr int16_t kEdge = 10681, kHalfTurn = 27466;  // 70 and 180 degrees
constexpr uint16_t kPart = 10995;                    // 65536 * 256 / such angles in 10 degrees
constexpr uint8_t kLastRow = kDeclinationRows - 1;
constexpr int8_t kScale = 16;  // of the numbers in between

int16_t coarse(int32_t angle_e7) { return static_cast<int16_t>(angle_e7 >> 16); }
// The place in the table below or left of it, and 256ths of the way to the next.
uint16_t inTable(int16_t angle, int16_t from) {
    return static_cast<uint16_t>((uint32_t{static_cast<uint16_t>(angle + from)} * kPart) >> 16);
}

// In 5/8 / kScale degrees. The first row is near the magnetic pole and has double steps.
int16_t scaledAt(uint8_t row, uint8_t column) {
    const int16_t scaled =
        core::romRead(kDeclinations[row * kDeclinationColumns + column]) * kScale;
    return row == 0 ? 2 * scaled : scaled;
}

int16_t part(int16_t of, uint8_t f) { return static_cast<int16_t>((int32_t{of} * f) >> 8); }

// Between v[1] and v[2], f 256ths of the way: the cubic whose slope at a place is that of the line
// through its neighbours (Catmull and Rom, 1974).
int16_t between(const int16_t (&v)[4], uint8_t f) {
    const int16_t bend = static_cast<int16_t>(2 * v[0] - 5 * v[1] + 4 * v[2] - v[3]);
    const int16_t twist = static_cast<int16_t>(3 * (v[1] - v[2]) + v[3] - v[0]);
    const int16_t slope =
        static_cast<int16_t>(v[2] - v[0] + part(static_cast<int16_t>(bend + part(twist, f)), f));
    return static_cast<int16_t>(v[1] + part(slope, f) / 2);
}

constexpr int16_t kPerDegree = 153, kFromDipEquator_deg = 20;

}  // namespace

int8_t fieldPointsDown(const Position& position) {
    const int16_t latitude = coarse(position.latitude_e7);
    const uint8_t column = inTable(coarse(position.longitude_e7), kHalfTurn) >> 8;
    const int16_t level_deg = core::romRead(kDipEquator_deg[column]);
    const int16_t north_deg = static_cast<int16_t>(latitude / kPerDegree - level_deg);
    return north_deg > kFromDipEquator_deg ? 1 : north_deg < -kFromDipEquator_deg ? -1 : 0;
}

int16_t declination_cd(const Position& position) {
    const int16_t latitude = core::limit<int16_t>(coarse(position.latitude_e7), -kEdge, kEdge - 1);
    const uint16_t up = inTable(latitude, kEdge);
    const uint16_t across = inTable(coarse(position.longitude_e7), kHalfTurn);
    const uint8_t row = up >> 8, column = across >> 8;
    int16_t rows[4] = {};
    for (uint8_t i = 0; i < 4; ++i) {
        const uint8_t from = row + i - 1;
        if (from > kLastRow) continue;  // or below the first: wrapped round
        int16_t places[4];
        for (uint8_t j = 0; j < 4; ++j) {
            uint8_t at = column + j + kDeclinationColumns - 1;
            while (at >= kDeclinationColumns) at -= kDeclinationColumns;
            places[j] = scaledAt(from, at);
        }
        rows[i] = between(places, across & 0xFF);
    }
    // beyond its edges the table goes straight on
    if (row == 0) rows[0] = 2 * rows[1] - rows[2];
    if (row + 2 > kLastRow) rows[3] = 2 * rows[2] - rows[1];
    // from 5/8 / kScale degrees: times 125 / 32
    const int16_t fine = between(rows, up & 0xFF);
    return static_cast<int16_t>(4 * fine - (3 * fine >> 5));
}

}  // namespace geo
