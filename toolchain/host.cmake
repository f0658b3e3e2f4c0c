# SPDX-License-Identifier: GPL-3.0-or-later
# The host's side: unit tests, the simulator, and the image for the simulator to fly.
include(CTest)
include(GoogleTest)
find_package(GTest REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(SIMAVR REQUIRED IMPORTED_TARGET simavr)
set(CMAKE_CXX_STANDARD 17)

# With SANITIZE only what runs on the host alone is built, and twice as carefully.
option(SANITIZE "build with the address and undefined-behaviour sanitizers" OFF)
if(SANITIZE)
    # -O1: half of the time to compile, and the sanitizers see as much
    set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all)
    add_link_options(-fsanitize=address,undefined)
endif()

# ---- the rules of the house
find_program(NODE node REQUIRED)
add_test(NAME house.include_rules COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/check_house.mjs)
file(GLOB tool_tests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/toolchain/*.test.mjs)
add_test(NAME toolchain.image_tools COMMAND ${NODE} --test ${tool_tests})
add_test(NAME house.formatting COMMAND ${CMAKE_SOURCE_DIR}/toolchain/check_format)

# ---- doubles of the hardware for the unit tests
file(GLOB fakes_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/fakes/*.cpp)
list(FILTER fakes_sources EXCLUDE REGEX _test\.cpp$)
add_library(fakes STATIC ${fakes_sources})
target_compile_options(fakes PRIVATE ${HOUSE_WARNINGS})
target_include_directories(fakes PUBLIC ${CMAKE_SOURCE_DIR}/host_tests
                           ${CMAKE_SOURCE_DIR}/host_tests/fakes)
target_link_libraries(fakes PUBLIC core hal)
house_test(fakes_test ${CMAKE_SOURCE_DIR}/host_tests/fakes)

foreach(library IN LISTS all_libraries)
    house_test(${library}_test ${CMAKE_SOURCE_DIR}/host_tests/${library} ${library})
endforeach()
# the mission engine against an independent reading of its rules
house_test(mission_oracle_test ${CMAKE_SOURCE_DIR}/host_tests/mission_oracle mission)
target_sources(mission_oracle_test PRIVATE ${CMAKE_SOURCE_DIR}/host_tests/mission_oracle/oracle.cpp
               ${CMAKE_SOURCE_DIR}/host_tests/mission_oracle/rig.cpp
               ${CMAKE_SOURCE_DIR}/host_tests/mission_oracle/trial.cpp
               ${CMAKE_SOURCE_DIR}/host_tests/mission_oracle/random_trial.cpp)
if(TARGET geo_test)  # measured against the geodesics of an independent library
    find_library(GEOGRAPHICLIB NAMES GeographicLib Geographic REQUIRED)
    target_link_libraries(geo_test PRIVATE ${GEOGRAPHICLIB})
endif()

# ---- MAVLink against an independent implementation (npm node-mavlink, see toolchain/node)
add_executable(mavlink_repeat ${CMAKE_SOURCE_DIR}/host_tests/mavlink/repeat.cpp)
target_compile_options(mavlink_repeat PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(mavlink_repeat PRIVATE mavlink)
add_test(NAME mavlink.definitions
         COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/mavlink/definitions.test.mjs)
add_test(NAME mavlink.vectors
         COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/mavlink/vectors.test.mjs)
set_tests_properties(mavlink.vectors PROPERTIES ENVIRONMENT
                     MAVLINK_REPEAT=$<TARGET_FILE:mavlink_repeat>)

# ---- everything outside the board's pins
find_package(nlohmann_json REQUIRED)
file(GLOB world_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/world.cpp
     ${CMAKE_SOURCE_DIR}/simulator/own_airplane.cpp ${CMAKE_SOURCE_DIR}/simulator/fdm/*.cpp
     ${CMAKE_SOURCE_DIR}/simulator/devices/*.cpp ${CMAKE_SOURCE_DIR}/simulator/airplane/*.cpp)
add_library(simulator_world STATIC ${world_sources})
target_compile_options(simulator_world PRIVATE ${HOUSE_WARNINGS})
target_compile_definitions(simulator_world PRIVATE
                           SIMULATOR_AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")
target_include_directories(simulator_world PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(simulator_world PUBLIC nlohmann_json::nlohmann_json)
foreach(room devices airplane)
    house_test(${room}_test ${CMAKE_SOURCE_DIR}/host_tests/${room} simulator_world)
endforeach()
if(TARGET drivers_test)  # the drivers are tried on the simulator's chips
    target_link_libraries(drivers_test PRIVATE simulator_world)
endif()
if(TARGET logging_test)  # the logs lie in the simulator's chip
    target_sources(logging_test PRIVATE ${CMAKE_SOURCE_DIR}/host_tests/logging/chip.cpp)
    target_link_libraries(logging_test PRIVATE simulator_world)
endif()
if(TARGET airplane_test)
    target_compile_definitions(airplane_test PRIVATE
                               AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")
endif()

# ---- the natively compiled firmware, the ground station, the report, the program that flies
function(simulator_library name)
    house_target(simulator_${name} ${CMAKE_SOURCE_DIR}/simulator/${name} ${ARGN})
    target_include_directories(simulator_${name} ${HOUSE_SCOPE} ${CMAKE_SOURCE_DIR}
                               ${CMAKE_SOURCE_DIR}/libraries)
endfunction()
simulator_library(ground mavlink simulator_world)
simulator_library(report simulator_ground)

file(GLOB_RECURSE native_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/firmware/*.cpp)
list(FILTER native_sources EXCLUDE REGEX /firmware/main\.cpp$)
add_library(firmware_native OBJECT ${native_sources})
set_target_properties(firmware_native PROPERTIES CXX_STANDARD 14)
target_compile_options(firmware_native PRIVATE ${HOUSE_WARNINGS})
target_include_directories(firmware_native BEFORE PUBLIC ${CMAKE_SOURCE_DIR}/simulator/native
                           ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_native PUBLIC ${all_libraries})
# the same sources on the doubles, for the unit tests of firmware/
add_library(firmware_on_fakes STATIC ${native_sources})
set_target_properties(firmware_on_fakes PROPERTIES CXX_STANDARD 17)  # the doubles want it
target_compile_options(firmware_on_fakes PRIVATE ${HOUSE_WARNINGS})
target_include_directories(firmware_on_fakes BEFORE PUBLIC ${CMAKE_SOURCE_DIR}/host_tests/fakes
                           ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_on_fakes PUBLIC ${all_libraries} fakes)
foreach(room firmware firmware_mission telemetry)
    house_test(${room}_test ${CMAKE_SOURCE_DIR}/host_tests/${room} firmware_on_fakes)
endforeach()
if(TARGET firmware_test)
    target_compile_definitions(firmware_test PRIVATE FAILSAFE_MANUAL="${CMAKE_SOURCE_DIR}/docs/failsafes.md")
endif()
# telemetry's own double of the vehicle stands before what the library has of it
target_sources(telemetry_test PRIVATE ${CMAKE_SOURCE_DIR}/host_tests/telemetry/vehicle_double.cpp)

simulator_library(native simulator_world core hal)
target_include_directories(simulator_native BEFORE PRIVATE ${CMAKE_SOURCE_DIR}/simulator/native)

house_test(simulator_test ${CMAKE_SOURCE_DIR}/host_tests/simulator simulator_report
           simulator_ground simulator_native simulator_world)

include(mission_tool)
include(param_tool)
include(log_tool)
include(declination)

if(SANITIZE)
    return()
endif()

# ---- the image, by the cross compiler: always asked, rebuilds only what changed
include(ExternalProject)
set(IMAGE_ELF ${CMAKE_BINARY_DIR}/avr-apm2/firmware.elf)
ExternalProject_Add(image
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/avr-apm2
    CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/toolchain/avr-gcc.cmake -DBOARD=apm2
               -DCMAKE_BUILD_TYPE=MinSizeRel
    BUILD_ALWAYS ON
    BUILD_BYPRODUCTS ${IMAGE_ELF}
    INSTALL_COMMAND "")
add_test(NAME image.budgets
         COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/check_image.mjs ${IMAGE_ELF})

include(machine)
include(on_chip)

find_package(CLI11 REQUIRED)
add_executable(fly simulator/fly.cpp simulator/fly_options.cpp simulator/parameter_file.cpp
               toolchain/param_tool/settings.cpp toolchain/mission_tool/wrong_input.cpp)
target_compile_options(fly PRIVATE ${HOUSE_WARNINGS})
target_compile_definitions(fly PRIVATE FLY_IMAGE="${IMAGE_ELF}"
    FLY_MISSION="${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints"
    FLY_OUT="${CMAKE_SOURCE_DIR}/build/flight")
target_link_libraries(fly PRIVATE firmware_native simulator_native simulator_report
                      simulator_ground simulator_machine simulator_world CLI11::CLI11)

# ---- the hardware layer, by small programs of its own on the emulated chip
ExternalProject_Add(hal_programs
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/avr-hal
    CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/toolchain/avr-gcc.cmake -DBOARD=apm2
               -DCMAKE_BUILD_TYPE=MinSizeRel
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target hal_programs
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")
house_test(hal_avr_test ${CMAKE_SOURCE_DIR}/host_tests/hal_avr simulator_machine)
add_dependencies(hal_avr_test hal_programs)
target_compile_definitions(hal_avr_test PRIVATE CHIP_PROGRAMS="${CMAKE_BINARY_DIR}/avr-hal"
    STACK_BOUND="${NODE} ${CMAKE_SOURCE_DIR}/toolchain/stack_bound.mjs" CHIP_BOARD=apm2)
# ---- what geodesy and the mission engine take on the chip
add_executable(costs ${CMAKE_SOURCE_DIR}/host_tests/costs/costs.cpp)
target_compile_options(costs PRIVATE ${HOUSE_WARNINGS})
target_include_directories(costs PRIVATE ${CMAKE_SOURCE_DIR}/host_tests)
target_link_libraries(costs PRIVATE simulator_machine nlohmann_json::nlohmann_json)
add_dependencies(costs hal_programs)
add_test(NAME on_board.costs
         COMMAND costs ${CMAKE_BINARY_DIR}/avr-hal ${CMAKE_SOURCE_DIR}/toolchain/budgets.json)
set_tests_properties(on_board.costs PROPERTIES LABELS simavr)

# ---- the same tests again with the sanitizers watching
ExternalProject_Add(sanitized
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/sanitized
    CMAKE_ARGS -DSANITIZE=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")
add_test(NAME sanitizers
         COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${CMAKE_BINARY_DIR}/sanitized --output-on-failure)
set_tests_properties(sanitizers PROPERTIES TIMEOUT 1200)

include(mavlink_costs)
include(fuzz)
include(flash)
include(ground)
include(flights)
include(campaign)
include(fdm)
include(storing)
include(restart)
include(both_boards)
include(preflight)
include(gps)
