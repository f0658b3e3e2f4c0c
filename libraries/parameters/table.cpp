// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/table.hpp"

#include <string.h>

#include "core/maths.hpp"
#include "parameters/packed.hpp"

namespace parameters {
namespace {

void skipName(const uint8_t*& letter) {
    while ((core::romRead(*letter++) & kLastLetter) == 0) {
    }
}

bool isName(const char (&name)[kNameSize], const uint8_t* letter) {
    for (uint8_t i = 0; i < kNameSize; ++i) {
        const uint8_t byte = core::romRead(*letter++);
        if (static_cast<char>(byte & ~kLastLetter) != name[i]) return false;
        if ((byte & kLastLetter) != 0) return i + 1 == kNameSize || name[i + 1] == 0;
    }
    return false;
}

}  // namespace

uint8_t Table::slot(uint8_t index) const { return core::romRead(row(index).slot); }

Type Table::type(uint8_t index) const {
    return static_cast<Type>(core::romRead(row(index).field) >> kTypeShift);
}

uint8_t* Table::field(uint8_t index) const {
    return static_cast<uint8_t*>(core::romRead(fields_)) +
           (core::romRead(row(index).field) & kOffsetMask);
}

float Table::number(uint8_t place) const { return core::romRead(core::romRead(numbers_)[place]); }

float Table::initial(uint8_t index) const { return number(core::romRead(row(index).initial)); }
float Table::lowest(uint8_t index) const { return number(core::romRead(row(index).lowest)); }
float Table::highest(uint8_t index) const { return number(core::romRead(row(index).highest)); }

const uint8_t* Table::letters(uint8_t index) const {
    const uint8_t* letter =
        core::romRead(letters_) + core::romRead(core::romRead(groups_)[index / kGroup]);
    for (uint8_t names = index % kGroup; names > 0; --names) skipName(letter);
    return letter;
}

void Table::name(uint8_t index, char (&to)[kNameSize]) const {
    const uint8_t* letter = letters(index);
    uint8_t byte = 0;
    for (char& c : to) {
        if ((byte & kLastLetter) == 0) {
            byte = core::romRead(*letter++);
            c = static_cast<char>(byte & ~kLastLetter);
        } else {
            c = 0;
        }
    }
}

float Table::value(uint8_t index) const {
    const uint8_t* field = this->field(index);
    switch (type(index)) {
        case Type::int8:
            return static_cast<float>(static_cast<int8_t>(*field));
        case Type::int16: {
            int16_t value;
            memcpy(&value, field, sizeof value);
            return static_cast<float>(value);
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

bool Table::findName(const char (&name)[kNameSize], uint8_t& index) const {
    const uint8_t* letter = core::romRead(letters_);
    const uint8_t rows = count();
    for (uint8_t i = 0; i < rows; ++i) {
        if (isName(name, letter)) {
            index = i;
            return true;
        }
        skipName(letter);
    }
    return false;
}

bool Table::findSlot(uint8_t slot, uint8_t& index) const {
    const uint8_t rows = count();
    const uint8_t* at = &row(0).slot;  // a mission may seek a dozen in one pass
    for (uint8_t i = 0; i < rows; ++i, at += sizeof(PackedRow)) {
        if (core::romRead(*at) != slot) continue;
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
        const uint8_t width = type == Type::int8 ? 1 : (type == Type::int16 ? 2 : 4);
        memcpy(field, &whole, width);
    }
    return this->value(index);
}

}  // namespace parameters
