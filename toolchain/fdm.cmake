# SPDX-License-Identifier: GPL-3.0-or-later
# A flight model in another program: the protocol, and flights with the example of such a program.
house_test(fdm_test ${CMAKE_SOURCE_DIR}/host_tests/fdm simulator_world)
add_executable(example_peer ${CMAKE_SOURCE_DIR}/host_tests/fdm/example_peer.cpp)
target_compile_options(example_peer PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(example_peer PRIVATE simulator_world)

foreach(vehicle native elf)
    add_test(NAME fdm.flight_${vehicle}
             COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/fdm/flight.test.mjs)
    set_tests_properties(fdm.flight_${vehicle} PROPERTIES TIMEOUT 600 ENVIRONMENT
        "FLY=$<TARGET_FILE:fly>;FLY_BOARD=${vehicle};PEER=$<TARGET_FILE:example_peer>;MINUTES=${CMAKE_BINARY_DIR}/flights/minutes/fdm")
endforeach()
set_tests_properties(fdm.flight_elf PROPERTIES LABELS simavr FIXTURES_REQUIRED image_minutes)
