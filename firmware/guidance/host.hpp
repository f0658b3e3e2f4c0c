// SPDX-License-Identifier: GPL-3.0-or-later
// What guidance asks of the rooms above it; app/guidance_host.cpp fills it in.
#pragma once

namespace firmware {
namespace guidance {

struct Host {
    void (*demandOfMode)();  // the mode moves vehicle.demand before it is flown, 20 Hz
};
extern const Host host;

}  // namespace guidance
}  // namespace firmware
