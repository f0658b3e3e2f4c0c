// SPDX-License-Identifier: GPL-3.0-or-later
// Who is served: this computer's own browser, on the page's own pages. Another site that is open
// in that browser could otherwise send commands (by its Origin), or read by a name of its own that
// resolves to 127.0.0.1 (by its Host).
#pragma once
#include <optional>

#include "simulator/live/http_server.hpp"

namespace simulator::live {

// What a request is refused with; empty: it is served.
std::optional<Response> refusal(const Request& request, uint16_t port);

// {"ok": ..., "text": ...}
Response answerJson(int status, bool ok, const std::string& text);

}  // namespace simulator::live
