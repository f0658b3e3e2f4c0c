# SPDX-License-Identifier: GPL-3.0-or-later
# The host's side: the simulator with the natively compiled firmware in it, and the tools.
# Images and programs for the chip come from the tree of avr-gcc (preset avr) beside this one.
option(TESTS "also what only the tests need" ON)
set(AVR_TREE ${CMAKE_SOURCE_DIR}/build/avr CACHE PATH "the tree of avr-gcc")
set(IMAGE_apm1 ${AVR_TREE}/apm1/firmware.elf)
set(IMAGE_apm2 ${AVR_TREE}/apm2/firmware.elf)

set(CMAKE_CXX_STANDARD 17)
# -O2 compiles in two thirds of the time of -O3; the sanitizers see as much with -O1
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -DNDEBUG")

find_package(PkgConfig REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)

set(HOST_HEADERS <algorithm> <array> <cmath> <cstdint> <cstring> <filesystem> <fstream> <functional>
    <iostream> <map> <memory> <optional> <random> <sstream> <stdexcept> <string> <vector>)
precompiled(host_headers ${PROJECT_WARNINGS} HEADERS ${HOST_HEADERS})

# ---- everything outside the board's pins
file(GLOB world_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/world.cpp
     ${CMAKE_SOURCE_DIR}/simulator/builtin_model.cpp ${CMAKE_SOURCE_DIR}/simulator/fdm/*.cpp
     ${CMAKE_SOURCE_DIR}/simulator/devices/*.cpp ${CMAKE_SOURCE_DIR}/simulator/airplane/*.cpp)
add_library(simulator_world STATIC ${world_sources})
target_compile_options(simulator_world PRIVATE ${PROJECT_WARNINGS})
target_precompile_headers(simulator_world REUSE_FROM host_headers)
target_compile_definitions(simulator_world PRIVATE
                           SIMULATOR_AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")
target_include_directories(simulator_world PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(simulator_world PUBLIC nlohmann_json::nlohmann_json)

# ---- the ground station, the report, the board of the natively compiled firmware
function(simulator_library name)
    project_sources(simulator_${name} ${CMAKE_SOURCE_DIR}/simulator/${name} ${ARGN})
    target_include_directories(simulator_${name} ${SCOPE} ${CMAKE_SOURCE_DIR}
                               ${CMAKE_SOURCE_DIR}/libraries)
endfunction()
simulator_library(ground mavlink simulator_world)
simulator_library(report simulator_ground)
include(budget_header)
target_include_directories(simulator_report PRIVATE ${CMAKE_BINARY_DIR}/generated)
simulator_library(native simulator_world core hal)
target_include_directories(simulator_native BEFORE PRIVATE ${CMAKE_SOURCE_DIR}/simulator/native)

# ---- the firmware: on the simulated board, and on the doubles of the hardware
include(firmware_sources)
add_library(firmware_native_board OBJECT ${board_sources})
set_target_properties(firmware_native_board PROPERTIES CXX_STANDARD 14)
target_compile_options(firmware_native_board PRIVATE ${PROJECT_WARNINGS})
target_include_directories(firmware_native_board BEFORE PRIVATE ${CMAKE_SOURCE_DIR}/simulator/native
                           ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_native_board PRIVATE ${all_libraries})
add_library(firmware_native INTERFACE)
target_sources(firmware_native INTERFACE $<TARGET_OBJECTS:firmware_any_board>
               $<TARGET_OBJECTS:firmware_native_board>)
target_include_directories(firmware_native INTERFACE ${CMAKE_SOURCE_DIR}/simulator/native ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_native INTERFACE ${all_libraries})

project_sources(fakes ${CMAKE_SOURCE_DIR}/host_tests/support/fakes core hal)
target_include_directories(fakes PUBLIC ${CMAKE_SOURCE_DIR}/host_tests/support
                           ${CMAKE_SOURCE_DIR}/host_tests/support/fakes)
add_library(firmware_on_fakes STATIC ${board_sources} $<TARGET_OBJECTS:firmware_any_board>)
set_target_properties(firmware_on_fakes PROPERTIES CXX_STANDARD 17)  # the doubles need it
target_compile_options(firmware_on_fakes PRIVATE ${PROJECT_WARNINGS})
target_include_directories(firmware_on_fakes BEFORE PUBLIC ${CMAKE_SOURCE_DIR}/host_tests/support/fakes
                           ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_on_fakes PUBLIC ${all_libraries} fakes)

include(tools)
if(NOT SANITIZE)
    include(simulator)
endif()
if(TESTS)
    enable_testing()
    include(testing)
    include(unit_tests)
    if(NOT SANITIZE)
        include(image_tests)
        include(flight_tests)
        include(ground_tests)
        include(fuzz)
        # begun first, the longest do not end alone
        foreach(test toolchain.flash fdm.flight.native fuzz.mission_tool.eeprom flight.native_fault_pairs)
            if(TEST ${test})
                set_property(TEST ${test} PROPERTY COST 1000)
            endif()
        endforeach()
    endif()
endif()
