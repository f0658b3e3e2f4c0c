// SPDX-License-Identifier: GPL-3.0-or-later
// The command protocol: COMMAND_LONG, COMMAND_INT and SET_MODE. Every command is answered with
// COMMAND_ACK, one we do not know with UNSUPPORTED. https://mavlink.io/en/services/command.html
#pragma once
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool onCommand(Link& link, const mavlink::Frame& frame);  // both messages
bool onSetMode(Link& link, const mavlink::Frame& frame);
bool onAutopilotVersionRequest(Link& link, const mavlink::Frame& frame);
bool onCommandAck(Link& link, const mavlink::Frame& frame);

void commandsStart();
void commandsTick();  // 50 Hz: what takes its time

}  // namespace gcs
}  // namespace firmware
