# SPDX-License-Identifier: GPL-3.0-or-later
# Restarts: what is kept over one, and the images of both boards through them.
house_test(restart_test ${CMAKE_SOURCE_DIR}/host_tests/restart firmware_on_fakes)

add_executable(restart_flight host_tests/restart/restart_flight.cpp)
target_compile_options(restart_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(restart_flight PRIVATE simulator_ground simulator_machine)
foreach(board apm1 apm2)
    add_test(NAME restart.${board}
             COMMAND restart_flight ${CMAKE_BINARY_DIR}/avr-${board}/firmware.elf ${board}
                     ${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints
                     ${minutes}/restart_${board})
    set_tests_properties(restart.${board} PROPERTIES LABELS simavr TIMEOUT 900
                         FIXTURES_REQUIRED image_minutes)
endforeach()
