// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.hpp"

#include "simulator/devices/at45db.hpp"
#include "simulator/native/native_board.hpp"

namespace board {

using simulator::NativeBoard;

void start() {
    ImuSelect::high();
    BarometerSelect::high();
    Relay::low();
}

uint8_t SensorBus::held = 0;
uint8_t SensorBus::transfer(uint8_t mosi) { return NativeBoard::running().transfer(mosi); }
void SensorBus::slow() { NativeBoard::running().setBusFast(false); }
void SensorBus::fast() { NativeBoard::running().setBusFast(true); }
SensorBus::Lock::Lock() { NativeBoard::running().lockImu(true); }
SensorBus::Lock::~Lock() { NativeBoard::running().lockImu(false); }

void ImuSelect::low() { NativeBoard::running().select(true, true); }
void ImuSelect::high() { NativeBoard::running().select(true, false); }
void BarometerSelect::low() { NativeBoard::running().select(false, true); }
void BarometerSelect::high() { NativeBoard::running().select(false, false); }

static simulator::At45db& flash() { return NativeBoard::running().world().dataflash(); }
static uint64_t now_us() { return NativeBoard::running().time_us(); }

void FlashBus::send(const uint8_t* bytes, uint8_t size) {
    for (; size > 0; --size) NativeBoard::running().flashTransfer(*bytes++);
}
void FlashBus::receive(uint8_t* to, uint8_t size) {
    for (; size > 0; --size) *to++ = NativeBoard::running().flashTransfer(0);
}
void FlashSelect::low() { flash().select(true, now_us()); }
void FlashSelect::high() { flash().select(false, now_us()); }
void FlashReset::low() { flash().resetPin(true, now_us()); }
void FlashReset::high() { flash().resetPin(false, now_us()); }

void Relay::low() { NativeBoard::running().world().relay(false); }
void Relay::high() { NativeBoard::running().world().relay(true); }

}  // namespace board
