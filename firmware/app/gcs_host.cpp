// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/host.hpp"

#include "firmware/app/tasks.hpp"

namespace firmware {
namespace gcs {

const Host host = {app::taskCount, app::taskFigures};

}  // namespace gcs
}  // namespace firmware
