# SPDX-License-Identifier: GPL-3.0-or-later
# The running vehicle, natively compiled and as the image on the emulated chip, met by an
# independent MAVLink client (npm node-mavlink, see toolchain/node).
file(GLOB ground_tests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/ground/*.test.mjs)
foreach(file IN LISTS ground_tests)
    get_filename_component(subject ${file} NAME)
    string(REPLACE ".test.mjs" "" subject ${subject})
    foreach(vehicle native elf)
        set(name ground.${subject}.${vehicle})
        add_test(NAME ${name} COMMAND ${NODE} --test ${file})
        set_tests_properties(${name} PROPERTIES TIMEOUT 600
                             ENVIRONMENT "FLY=$<TARGET_FILE:fly>;FLY_BOARD=${vehicle}")
    endforeach()
    set_property(TEST ground.${subject}.elf APPEND PROPERTY ENVIRONMENT
                 "MINUTES=${CMAKE_BINARY_DIR}/flights/minutes/ground_${subject}")
    set_tests_properties(ground.${subject}.elf PROPERTIES LABELS simavr
                         FIXTURES_REQUIRED image_minutes)
endforeach()
