// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/tasks.hpp"

int main() {
    firmware::start();
    for (;;) firmware::turn();
}
