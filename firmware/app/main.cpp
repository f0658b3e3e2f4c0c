// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/app/tasks.hpp"

int main() {
    firmware::app::setup();
    for (;;) firmware::app::loop();
}
