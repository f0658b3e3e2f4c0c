// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a page or an address in the user's browser.
#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace simulator {

// Where there is a display. A browser outlives the program and says nothing here.
inline void openPage(const std::string& address) {
    const char *x11 = std::getenv("DISPLAY"), *wayland = std::getenv("WAYLAND_DISPLAY");
    if ((!x11 || !*x11) && (!wayland || !*wayland)) return;
    if (fork() != 0) return;
    setsid();
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
    execlp("xdg-open", "xdg-open", address.c_str(), static_cast<char*>(nullptr));
    _exit(127);  // there is none: the address was printed
}

}  // namespace simulator
