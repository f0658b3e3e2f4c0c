# SPDX-License-Identifier: GPL-3.0-or-later
# The emulated chip and board, and the program that flies.
pkg_check_modules(SIMAVR REQUIRED IMPORTED_TARGET simavr)
pkg_check_modules(LIBELF REQUIRED IMPORTED_TARGET libelf)
find_program(AVR_GXX avr-g++ REQUIRED)
find_program(AVR_OBJCOPY avr-objcopy REQUIRED)

project_sources(simulator_machine ${CMAKE_SOURCE_DIR}/simulator/machine)
target_include_directories(simulator_machine PUBLIC ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/libraries)
target_link_libraries(simulator_machine PUBLIC simulator_world PkgConfig::SIMAVR
                      PRIVATE PkgConfig::LIBELF)

# What every reset of a board begins with, in place of its bootloader.
set(boot_sections ${CMAKE_BINARY_DIR}/boot)
file(MAKE_DIRECTORY ${boot_sections})
foreach(board apm1 apm2)
    set(source ${CMAKE_SOURCE_DIR}/simulator/machine/boot/${board}.cpp)
    add_custom_command(OUTPUT ${boot_sections}/${board}.elf
        COMMAND ${AVR_GXX} -mmcu=atmega2560 -DF_CPU=16000000UL -std=c++14 -Os -Wall -Wextra
                -nostdlib -Wl,--section-start=.text=0x3e000 -I${CMAKE_SOURCE_DIR}
                -o ${boot_sections}/${board}.elf ${source}
        DEPENDS ${source} ${CMAKE_SOURCE_DIR}/simulator/machine/boot/boot.hpp VERBATIM)
    list(APPEND boot_programs ${boot_sections}/${board}.elf)
endforeach()
add_custom_target(boot_programs DEPENDS ${boot_programs})
add_dependencies(simulator_machine boot_programs)
target_compile_definitions(simulator_machine PUBLIC SIMULATOR_BOOT="${boot_sections}")

set(simulator_sources simulator/fly.cpp simulator/fly_options.cpp simulator/parameter_file.cpp
    toolchain/param_tool/settings.cpp toolchain/mission_tool/wrong_input.cpp)
project_program(fly ${simulator_sources} LIBRARIES firmware_native simulator_native
    simulator_report simulator_ground simulator_machine simulator_world CLI11::CLI11)
target_compile_definitions(fly PRIVATE FLY_IMAGE="${IMAGE_apm2}" FLY_IMAGE_1="${IMAGE_apm1}"
    FLY_MISSION="${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints"
    FLY_OUT="${CMAKE_SOURCE_DIR}/build/flight")
