# SPDX-License-Identifier: GPL-3.0-or-later
# The simulator: what surrounds the board, the emulated chip, and the program that flies.

# ---- everything outside the board's pins
file(GLOB world_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/world.cpp
     ${CMAKE_SOURCE_DIR}/simulator/world_file.cpp ${CMAKE_SOURCE_DIR}/simulator/builtin_model.cpp ${CMAKE_SOURCE_DIR}/simulator/fdm/*.cpp
     ${CMAKE_SOURCE_DIR}/simulator/devices/*.cpp ${CMAKE_SOURCE_DIR}/simulator/airplane/*.cpp)
add_library(simulator_world STATIC ${world_sources})
target_compile_options(simulator_world PRIVATE ${PROJECT_WARNINGS})
target_precompile_headers(simulator_world REUSE_FROM host_headers)
target_compile_definitions(simulator_world PRIVATE
                           SIMULATOR_AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")
target_include_directories(simulator_world PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(simulator_world PUBLIC nlohmann_json::nlohmann_json)

# ---- the limits of toolchain/image/budgets.json as a header, for the report of a flight.
set(budgets_json ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${budgets_json})
file(READ ${budgets_json} budgets)

# budget(VARIABLE NAME [BOARD]): the board's own budget where it has one, else everybody's
function(budget variable name)
    string(JSON value ERROR_VARIABLE missing GET "${budgets}" ${ARGN} ${name})
    if(missing)
        string(JSON value GET "${budgets}" ${name})
    endif()
    set(${variable} ${value} PARENT_SCOPE)
endfunction()

set(rows)
foreach(board IN ITEMS apm1 apm2)
    budget(processor processor_percent ${board})
    budget(interrupts interrupts_percent ${board})
    string(APPEND rows "constexpr BoardBudget k_${board} = {${processor}, ${interrupts}};\n")
endforeach()
budget(flash flash)
budget(ram ram_static_and_stack)
budget(frame frame_us)
budget(latency gyro_to_servo_us)
budget(interrupt interrupt_cycles)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/budgets.hpp CONTENT [[
// Made of toolchain/image/budgets.json by toolchain/cmake/simulator.cmake.
#pragma once
namespace budgets {
struct BoardBudget {
    double processor_percent, interrupts_percent;
};
@rows@constexpr double kFlash_bytes = @flash@, kRamAndStack_bytes = @ram@;
constexpr double kFrame_us = @frame@, kGyroToServo_us = @latency@;
constexpr double kInterrupt_us = @interrupt@ / 16.0;  // from cycles of 16 MHz
}  // namespace budgets
]] @ONLY)

# ---- the ground station, the report, the board of the natively compiled firmware
function(simulator_library name)
    project_sources(simulator_${name} ${CMAKE_SOURCE_DIR}/simulator/${name} ${ARGN})
    target_include_directories(simulator_${name} ${SCOPE} ${CMAKE_SOURCE_DIR}
                               ${CMAKE_SOURCE_DIR}/libraries)
endfunction()
simulator_library(ground mavlink simulator_world)
simulator_library(invariants mavlink simulator_ground)
include(web)
simulator_library(report simulator_ground simulator_invariants)
target_include_directories(simulator_report PRIVATE ${CMAKE_BINARY_DIR}/generated)
add_dependencies(simulator_report pages commit_of_sources)
# which commit a program was built of is in a file beside it: inside, each commit would be another
# program, and no test that has passed would count
add_custom_target(commit_of_sources COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_SOURCE_DIR} -DOUT=${CMAKE_BINARY_DIR}/commit.txt
                  -P ${CMAKE_SOURCE_DIR}/toolchain/cmake/commit.cmake VERBATIM)
target_compile_definitions(simulator_report PRIVATE COMMIT_FILE="${CMAKE_BINARY_DIR}/commit.txt")
simulator_library(live mavlink simulator_ground)
simulator_library(native simulator_world core hal)
target_include_directories(simulator_native BEFORE PRIVATE ${CMAKE_SOURCE_DIR}/simulator/native)

# ---- parameter files, for whatever flies with one
add_library(parameter_files STATIC simulator/parameter_file.cpp toolchain/param_tool/settings.cpp
            toolchain/mission_tool/wrong_input.cpp)
target_compile_options(parameter_files PRIVATE ${PROJECT_WARNINGS})
target_precompile_headers(parameter_files REUSE_FROM host_headers)
target_link_libraries(parameter_files PUBLIC simulator_ground)

if(SANITIZE)
    return()  # nothing below runs on the host alone
endif()

# ---- the emulated chip and board
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
foreach(board apm1 apm2 quick)
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

# ---- the program that flies
set(simulator_sources simulator/built_image.cpp simulator/fly.cpp simulator/fly_live.cpp simulator/fly_options.cpp
    simulator/fly_report.cpp simulator/fly_served.cpp simulator/flight_folder.cpp
    simulator/flight_provenance.cpp)
project_program(fly ${simulator_sources} LIBRARIES parameter_files firmware_native simulator_native
    simulator_live simulator_report simulator_ground simulator_machine simulator_world
    CLI11::CLI11)
target_compile_definitions(fly PRIVATE FLY_IMAGE="${IMAGE_apm2}" FLY_IMAGE_1="${IMAGE_apm1}"
    FLY_SOURCES="${CMAKE_SOURCE_DIR}" FLY_MISSION="${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints"
    FLY_OUT="${CMAKE_SOURCE_DIR}/build/flight" FLY_FLIGHTS="${CMAKE_SOURCE_DIR}/build/flights")
