// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/legacy_points.hpp"

#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace gcs {

using namespace notify;

bool refuseLegacyPoint(Link&, const mavlink::Frame&) {
    sendStatusText(Severity::warning, STATUS_TEXT("Fence and rally: only as mission items"));
    return true;
}

}  // namespace gcs
}  // namespace firmware
