// SPDX-License-Identifier: GPL-3.0-or-later
// An object at a fixed address, as if its address were not known. The compiler then reaches its
// fields from a pointer register, by instructions of two bytes; at an address that it knows each
// byte of a float takes an instruction of four. It pays, by measurement, where a function that is
// inlined uses many fields of one object, within 63 bytes of its start: no instruction reaches
// farther.
#pragma once

namespace core {

template <class Object>
inline Object& based(Object& object) {
    Object* address = &object;
    asm("" : "+r"(address));
    return *address;
}

}  // namespace core
