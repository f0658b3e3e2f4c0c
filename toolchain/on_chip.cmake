# SPDX-License-Identifier: GPL-3.0-or-later
# The pure libraries' tests once more, on the emulated ATmega2560.
ExternalProject_Add(on_chip_programs
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/avr-on-chip
    CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/toolchain/avr-gcc.cmake -DBOARD=apm2
               -DCMAKE_BUILD_TYPE=MinSizeRel
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target on_chip_programs
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")
add_executable(run_on_chip ${CMAKE_SOURCE_DIR}/host_tests/on_chip/run_on_chip.cpp)
target_compile_options(run_on_chip PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(run_on_chip PRIVATE simulator_machine)
add_dependencies(run_on_chip on_chip_programs)

foreach(library core geo control estimation navigation storage parameters mission scheduler mavlink
                floats std)
    add_test(NAME on_chip.${library}
             COMMAND run_on_chip ${CMAKE_BINARY_DIR}/avr-on-chip/on_chip_${library}.elf)
    set_tests_properties(on_chip.${library} PROPERTIES LABELS simavr TIMEOUT 300)
endforeach()
add_test(NAME on_chip.failing_checks_fail
         COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/on_chip/run_on_chip.test.mjs)
set_tests_properties(on_chip.failing_checks_fail PROPERTIES LABELS simavr TIMEOUT 300 ENVIRONMENT
    "RUN_ON_CHIP=$<TARGET_FILE:run_on_chip>;ON_CHIP_PROGRAMS=${CMAKE_BINARY_DIR}/avr-on-chip")
