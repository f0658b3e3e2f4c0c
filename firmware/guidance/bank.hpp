// SPDX-License-Identifier: GPL-3.0-or-later
// The bank: from an acceleration across the path to vehicle.roll_demand_rad, within what the
// parameters allow and what the wings carry at this speed.
#pragma once
#include <stdint.h>

namespace firmware {
namespace guidance {

enum class BankLimit : uint8_t { flying, level };  // LIM_ROLL_CD, LEVEL_ROLL_LIMIT

void beginBanking();                       // taking over from whoever flew
void weighBank();                          // 10 Hz: which bank the present speed carries
void learnBankTrim(float left_of_path_m);  // 20 Hz, while a path is held

void demandBank(float bank_accel_mss, BankLimit limit);

// Gravity times tan(bank), less the bank that turns nothing: what the demands so far will have
// brought about, drawn to what is measured.
float expectedBank_mss();
float bankLag_s();      // from demanded to flown bank
float turnAccel_mss();  // what planned turns are flown with
float mostBank_mss();   // gravity times tan(bank limit)
void planTurns();       // after the bank limit may have changed

}  // namespace guidance
}  // namespace firmware
