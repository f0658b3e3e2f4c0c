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
precompiled(text_headers ${PROJECT_WARNINGS} ${TEXT_OPTIMISATION} HEADERS <nlohmann/json.hpp> ${HOST_HEADERS})
use_precompiled_text(text_headers)

include(simulator)

# ---- the firmware: on the simulated board, and on the doubles of the hardware
add_library(firmware_native_board OBJECT ${board_sources})
set_target_properties(firmware_native_board PROPERTIES CXX_STANDARD 14)
target_compile_options(firmware_native_board PRIVATE ${PROJECT_WARNINGS})
target_include_directories(firmware_native_board BEFORE PRIVATE ${CMAKE_SOURCE_DIR}/simulator/native
                           ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_native_board PRIVATE ${all_libraries})
# between two marks, so that its variables can be put back to what they were at the start
add_library(firmware_begins OBJECT ${CMAKE_SOURCE_DIR}/simulator/native/marks/begin.cpp)
add_library(firmware_ends OBJECT ${CMAKE_SOURCE_DIR}/simulator/native/marks/end.cpp)
add_library(firmware_native INTERFACE)
target_sources(firmware_native INTERFACE $<TARGET_OBJECTS:firmware_begins>
               $<TARGET_OBJECTS:firmware_any_board> $<TARGET_OBJECTS:firmware_native_board>
               $<TARGET_OBJECTS:firmware_ends>)
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

# ---- the tools that run on the host, each a library (for its tests) and a program
# project_tool(NAME FOLDER LIBRARY...): NAME_parts and, of its main.cpp, NAME
function(project_tool name folder)
    project_sources(${name}_parts ${CMAKE_SOURCE_DIR}/${folder} ${ARGN})
    target_include_directories(${name}_parts PUBLIC ${CMAKE_SOURCE_DIR})
    target_link_libraries(${name}_parts PRIVATE CLI11::CLI11)
    project_program(${name} ${CMAKE_SOURCE_DIR}/${folder}/main.cpp LIBRARIES ${name}_parts)
endfunction()

# missions and parameters as files and EEPROM images, by the firmware's own tables and stores
project_tool(mission_tool toolchain/mission_tool parameter_files firmware_on_fakes simulator_ground fakes)
target_compile_definitions(mission_tool_parts PRIVATE MISSION_FLY="${CMAKE_BINARY_DIR}/fly"
                           MISSION_OUT="${CMAKE_SOURCE_DIR}/build/rehearsal")
project_tool(param_tool toolchain/param_tool mission_tool_parts)
target_compile_definitions(param_tool_parts PRIVATE
                           PARAMETERS_CSV="${CMAKE_SOURCE_DIR}/firmware/state/parameters.csv")
# flight logs from the DataFlash as tables, summaries and .bin files
project_tool(log_tool toolchain/log_tool logging simulator_report)
target_include_directories(log_tool_parts PRIVATE ${CMAKE_BINARY_DIR}/generated)
# flights in worlds that are drawn: airplane, sensors, air, place
if(NOT SANITIZE)
    set(drawn ${CMAKE_SOURCE_DIR}/simulator/drawn)
    add_library(drawn_parts STATIC ${drawn}/estimate.cpp ${drawn}/draw.cpp ${drawn}/field.cpp ${drawn}/files.cpp)
    target_compile_options(drawn_parts PRIVATE ${PROJECT_WARNINGS})
    target_precompile_headers(drawn_parts REUSE_FROM host_headers)
    target_link_libraries(drawn_parts PUBLIC mavlink simulator_world declination_table_parts)
    project_program(drawn ${drawn}/main.cpp ${drawn}/tuning.cpp
                    LIBRARIES drawn_parts firmware_native simulator_native simulator_invariants
                    simulator_ground simulator_world CLI11::CLI11)
    target_compile_definitions(drawn PRIVATE DRAWN_FLY="${CMAKE_BINARY_DIR}/fly"
                               DRAWN_MAGNETIC_MODEL="${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF")
endif()

# many flights at once, natively
project_tool(campaign simulator/campaign simulator_report simulator_world Threads::Threads)
target_compile_definitions(campaign_parts PRIVATE CAMPAIGN_OUT="${CMAKE_SOURCE_DIR}/build/campaign"
                           CAMPAIGN_MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
target_compile_definitions(campaign PRIVATE CAMPAIGN_FLY="${CMAKE_BINARY_DIR}/fly"
                           CAMPAIGN_DRAWN="${CMAKE_BINARY_DIR}/drawn")

# random scenarios against the invariants, natively or on the emulated board
if(NOT SANITIZE)
    set(chaos ${CMAKE_SOURCE_DIR}/simulator/chaos)
    # what flies nothing
    add_library(chaos_parts STATIC ${chaos}/scenario.cpp ${chaos}/generator.cpp ${chaos}/shrink.cpp
                ${chaos}/totals.cpp ${chaos}/document.cpp)
    target_compile_options(chaos_parts PRIVATE ${PROJECT_WARNINGS})
    target_precompile_headers(chaos_parts REUSE_FROM host_headers)
    target_link_libraries(chaos_parts PUBLIC mavlink simulator_report simulator_invariants simulator_world
                          declination_table_parts)
    target_compile_definitions(chaos_parts PRIVATE
        CHAOS_MAGNETIC_MODEL="${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF")
    project_program(chaos ${chaos}/main.cpp ${chaos}/options.cpp ${chaos}/station.cpp
                    ${chaos}/drill.cpp ${chaos}/flight.cpp ${chaos}/flight_process.cpp
                    LIBRARIES chaos_parts parameter_files firmware_native simulator_native simulator_invariants simulator_ground
                    simulator_machine simulator_world CLI11::CLI11)
    target_compile_definitions(chaos PRIVATE CHAOS_OUT="${CMAKE_SOURCE_DIR}/build/chaos"
                               CHAOS_IMAGE="${IMAGE_apm2}"
                               CHAOS_PARAMETERS="${CMAKE_SOURCE_DIR}/firmware/state/parameters.csv")
endif()

# The firmware's table of declinations, from the coefficients of the World Magnetic Model:
#   declination_table toolchain/declination/WMM2025.COF > libraries/geo/declination_table.hpp
project_tool(declination_table toolchain/declination)

# ---- the tests
if(TESTS)
    enable_testing()
    include(testing)
    include(unit_tests)
    if(NOT SANITIZE)
        include(image_tests)
        include(flight_tests)
        include(interop_tests)
        include(fuzz)
        # begun first, the longest do not end alone
        foreach(test toolchain.flash fdm.flight.native fuzz.mission_tool.eeprom flight.native_fault_pairs)
            if(TEST ${test})
                set_property(TEST ${test} PROPERTY COST 1000)
            endif()
        endforeach()
    endif()
endif()
