// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/table.hpp"

#include <string.h>

#include "core/maths.hpp"

namespace parameters {
namespace {

// `name` is padded with zeros, as MAVLink has it.
bool isName(const char (&name)[kNameSize], core::Unpacker letters) {
    for (uint8_t i = 0; i < kNameSize; ++i) {
        const char letter = letters.next();
        if (letter != name[i]) return false;
        if (letter == 0) return true;
    }
    return true;
}

}  // namespace

uint8_t Table::slot(uint8_t index) const { return core::romRead(row(index).slot); }

Type Table::type(uint8_t index) const {
    return static_cast<Type>(core::romRead(row(index).type_and_offset) >> kOffsetBits);
}

uint8_t* Table::field(uint8_t index) const {
    constexpr uint16_t kOffset = (1 << kOffsetBits) - 1;
    return static_cast<uint8_t*>(core::romRead(fields_)) +
           (core::romRead(row(index).type_and_offset) & kOffset);
}

float Table::number(const uint8_t& in_flash) const {
    return core::romRead(core::romRead(numbers_)[core::romRead(in_flash)]);
}

const uint8_t* Table::codes(const PackedRow& row) const {
    return core::romRead(names_) + core::romRead(row.name);
}

float Table::initial(uint8_t index) const { return number(row(index).initial); }
float Table::lowest(uint8_t index) const { return number(row(index).lowest); }
float Table::highest(uint8_t index) const { return number(row(index).highest); }

void Table::name(uint8_t index, char (&to)[kNameSize]) const {
    core::unpack({codes(row(index)), kNameSize, core::romRead(pairs_)}, to, kNameSize);
}

float Table::value(uint8_t index) const {
    const uint8_t* field = this->field(index);
    switch (type(index)) {
        case Type::int8:
            return core::real(static_cast<int8_t>(*field));
        case Type::int16: {
            int16_t value;
            memcpy(&value, field, sizeof value);
            return core::real(value);
        }
        case Type::int32: {
            int32_t value;
            memcpy(&value, field, sizeof value);
            return static_cast<float>(value);
        }
        case Type::real32:
            break;
    }
    float value;
    memcpy(&value, field, sizeof value);
    return value;
}

uint8_t Table::copyValue(uint8_t index, uint8_t* to) const {
    const uint8_t width = widthOf(type(index));
    memcpy(to, field(index), width);
    return width;
}

bool Table::findName(const char (&name)[kNameSize], uint8_t& index) const {
    const uint8_t rows = count();
    const PackedRow* at = &row(0);
    const core::CodePair* const pairs = core::romRead(pairs_);
    for (uint8_t i = 0; i < rows; ++i, ++at) {
        // spelling two hundred names would take 4 ms
        const uint8_t* const in_flash = codes(*at);
        if (core::firstLetter(core::romRead(*in_flash), pairs) != name[0]) continue;
        if (!isName(name, {in_flash, kNameSize, pairs})) continue;
        index = i;
        return true;
    }
    return false;
}

bool Table::findSlot(uint8_t slot, uint8_t& index) const {
    const uint8_t rows = count();
    const PackedRow* at = &row(0);  // a mission may seek a dozen in one pass
    for (uint8_t i = 0; i < rows; ++i, ++at) {
        if (core::romRead(at->slot) != slot) continue;
        index = i;
        return true;
    }
    return false;
}

bool Table::fits(uint8_t index, float value) const {
    // NaN fails both comparisons
    return value >= lowest(index) && value <= highest(index);
}

float Table::assign(uint8_t index, float value) const {
    uint8_t* field = this->field(index);
    const Type type = this->type(index);
    if (type == Type::real32) {
        memcpy(field, &value, sizeof value);
    } else {
        // little-endian on both sides: the low bytes are the narrower number
        const int32_t whole = core::rounded(value);
        memcpy(field, &whole, widthOf(type));
    }
    return this->value(index);
}

}  // namespace parameters
