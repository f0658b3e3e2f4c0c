// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/table.hpp"

#include <string.h>

#include "core/maths.hpp"

namespace parameters {

void Table::name(uint8_t index, char (&to)[kNameSize]) const {
    core::copyText(to, rows_[index].name, kNameSize);
}

float Table::value(uint8_t index) const {
    const uint8_t* field =
        static_cast<const uint8_t*>(fields_) + core::romRead(rows_[index].offset);
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
    for (uint8_t i = 0; i < count_; ++i) {
        uint8_t at = 0;
        char c = 0;
        while (at < kNameSize && (c = core::romRead(rows_[i].name[at])) == name[at] && c != 0) ++at;
        if (at == kNameSize || (c == 0 && name[at] == 0)) {
            index = i;
            return true;
        }
    }
    return false;
}

bool Table::findSlot(uint8_t slot, uint8_t& index) const {
    for (uint8_t i = 0; i < count_; ++i) {
        if (this->slot(i) != slot) continue;
        index = i;
        return true;
    }
    return false;
}

bool Table::fits(uint8_t index, float value) const {
    // NaN fails both comparisons
    return value >= core::romRead(rows_[index].lowest) &&
           value <= core::romRead(rows_[index].highest);
}

float Table::assign(uint8_t index, float value) const {
    uint8_t* field = static_cast<uint8_t*>(fields_) + core::romRead(rows_[index].offset);
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

void Table::assignInitial(uint8_t index) const {
    assign(index, core::romRead(rows_[index].initial));
}

}  // namespace parameters
