# SPDX-License-Identifier: GPL-3.0-or-later
# How exact the pulses of both images are while everything else is busy.
add_executable(pulse_times host_tests/on_board/pulse_times.cpp)
target_compile_options(pulse_times PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(pulse_times PRIVATE simulator_ground simulator_machine)
foreach(board apm1 apm2)
    set(image ${IMAGE_ELF})
    if(board STREQUAL apm1)
        set(image ${IMAGE_APM1_ELF})
    endif()
    add_test(NAME on_board.pulses_${board}
             COMMAND pulse_times ${image} ${board} ${minutes}/pulses_${board})
    set_tests_properties(on_board.pulses_${board} PROPERTIES LABELS simavr TIMEOUT 600
                         FIXTURES_REQUIRED image_minutes)
endforeach()
