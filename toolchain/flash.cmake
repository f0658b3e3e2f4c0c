# SPDX-License-Identifier: GPL-3.0-or-later
# toolchain/flash against a bootloader that speaks STK500v2 on a pseudo-terminal.
add_executable(bootloader_peer ${CMAKE_SOURCE_DIR}/host_tests/flash/bootloader_peer.cpp)
target_compile_options(bootloader_peer PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(bootloader_peer PRIVATE util)  # openpty
add_test(NAME toolchain.flash
         COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/flash/flash.test.mjs)
set_tests_properties(toolchain.flash PROPERTIES TIMEOUT 300
                     ENVIRONMENT BOOTLOADER_PEER=$<TARGET_FILE:bootloader_peer>)
