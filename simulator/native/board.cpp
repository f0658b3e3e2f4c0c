// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.hpp"

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

void Relay::low() { NativeBoard::running().world().relay(false); }
void Relay::high() { NativeBoard::running().world().relay(true); }

}  // namespace board
