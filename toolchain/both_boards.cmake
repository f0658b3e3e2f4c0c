# SPDX-License-Identifier: GPL-3.0-or-later
# What the image of either board is tried for apart from flying: how exact its pulses are while
# everything else is busy; a DataFlash that is full of logs, and a blank one.
foreach(program pulse_times full_log)
    add_executable(${program} host_tests/on_board/${program}.cpp)
    target_compile_options(${program} PRIVATE ${HOUSE_WARNINGS})
    target_link_libraries(${program} PRIVATE simulator_ground simulator_machine)
    foreach(board apm1 apm2)
        set(image ${IMAGE_ELF})
        if(board STREQUAL apm1)
            set(image ${IMAGE_APM1_ELF})
        endif()
        add_test(NAME on_board.${program}_${board}
                 COMMAND ${program} ${image} ${board} ${minutes}/${program}_${board})
        set_tests_properties(on_board.${program}_${board} PROPERTIES LABELS simavr TIMEOUT 600
                             FIXTURES_REQUIRED image_minutes)
    endforeach()
endforeach()
