# SPDX-License-Identifier: GPL-3.0-or-later
# The unit tests, one GoogleTest program a folder.

# unit_test(FOLDER LIBRARY...): host_tests/FOLDER as FOLDER_test
function(unit_test folder)
    gtest_program(${folder}_test ${tests}/${folder} ${ARGN})
    gtest_run(${folder}_test)
endfunction()

unit_test(fakes)
foreach(library IN ITEMS core geo control estimation navigation storage parameters mission scheduler
                         mavlink drivers logging)
    unit_test(${library} ${library})
endforeach()
# measured against the geodesics of an independent library
find_library(GEOGRAPHICLIB NAMES GeographicLib Geographic REQUIRED)
target_link_libraries(geo_test PRIVATE ${GEOGRAPHICLIB})
# the drivers are tried on the simulator's chips, the logs lie in one
target_link_libraries(drivers_test PRIVATE simulator_world)
target_sources(logging_test PRIVATE ${tests}/logging/chip.cpp)
target_link_libraries(logging_test PRIVATE simulator_world)
# the mission engine against an independent reading of its rules
unit_test(mission_oracle mission)
set(oracle oracle.cpp rig.cpp trial.cpp random_trial.cpp)
list(TRANSFORM oracle PREPEND ${tests}/mission_oracle/)
target_sources(mission_oracle_test PRIVATE ${oracle})
optimised(${oracle} ${tests}/estimation/attitude_test.cpp ${tests}/estimation/position_test.cpp
          ${tests}/firmware_mission/manual_test.cpp ${tests}/firmware_mission/rows_test.cpp)

unit_test(devices simulator_world)
unit_test(airplane simulator_world)
target_compile_definitions(airplane_test PRIVATE AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")
unit_test(simulator simulator_report simulator_ground simulator_native simulator_world)

unit_test(firmware firmware_on_fakes)
target_compile_definitions(firmware_test PRIVATE FAILSAFE_MANUAL="${CMAKE_SOURCE_DIR}/docs/failsafes.md")
unit_test(firmware_mission firmware_on_fakes)
unit_test(telemetry firmware_on_fakes)
# telemetry's own double of the vehicle stands before what the library has of it
target_sources(telemetry_test PRIVATE ${tests}/telemetry/vehicle_double.cpp)
unit_test(restart firmware_on_fakes)

unit_test(mission_tool mission_tool_parts)
unit_test(param_tool param_tool_parts)
target_compile_definitions(param_tool_test PRIVATE PARAMETERS_MANUAL="${CMAKE_SOURCE_DIR}/docs/parameters.md")
unit_test(log_tool log_tool_parts)
unit_test(declination declination_table_parts geo)
target_compile_definitions(declination_test PRIVATE
    WMM_COEFFICIENTS="${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF"
    DECLINATION_TABLE="${CMAKE_SOURCE_DIR}/libraries/geo/declination_table.hpp")

if(SANITIZE)
    return()
endif()

# ---- programs that run the tools as a user does
gtest_program(campaign_test ${tests}/campaign campaign_parts)
target_compile_definitions(campaign_test PRIVATE CAMPAIGN_PROGRAM="$<TARGET_FILE:campaign>"
    MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
gtest_run(campaign_test NEEDS campaign fly LABELS unit quick)
gtest_program(fdm_test ${tests}/fdm simulator_world)
gtest_run(fdm_test LABELS unit quick)
gtest_program(on_board_test ${tests}/on_board)
target_compile_definitions(on_board_test PRIVATE FLY_PROGRAM="$<TARGET_FILE:fly>")
gtest_run(on_board_test NEEDS fly ${IMAGE_apm2} ${IMAGE_apm1} LABELS unit)

# ---- the layers
# Every header of the firmware compiles alone, and all of them together: no two clash.
file(GLOB firmware_headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/firmware/*/*.hpp)
set(header_sources)
set(all_headers "int main() {}\n")
foreach(header IN LISTS firmware_headers)
    string(MAKE_C_IDENTIFIER ${header} name)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/headers/${name}.cpp CONTENT "#include \"${header}\"\n")
    list(APPEND header_sources ${CMAKE_BINARY_DIR}/headers/${name}.cpp)
    string(PREPEND all_headers "#include \"${header}\"\n")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/headers/all.cpp CONTENT "${all_headers}")
add_executable(firmware_headers ${CMAKE_BINARY_DIR}/headers/all.cpp ${header_sources})
target_compile_options(firmware_headers PRIVATE ${PROJECT_WARNINGS} -O0)
target_link_libraries(firmware_headers PRIVATE firmware_on_fakes)
declare_test(layering.headers COMMAND firmware_headers LABELS quick)
declare_test(layering COMMAND node ${CMAKE_SOURCE_DIR}/toolchain/check_layering.mjs LABELS quick)
find_program(CLANG_FORMAT clang-format NO_CMAKE_SYSTEM_PATH)
if(CLANG_FORMAT)
    declare_test(formatting COMMAND ${CMAKE_SOURCE_DIR}/toolchain/check_format LABELS quick)
endif()
file(GLOB tool_tests CONFIGURE_DEPENDS ${tests}/toolchain/*.test.mjs)
file(GLOB documents CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/*.md ${CMAKE_SOURCE_DIR}/docs/*
     ${CMAKE_SOURCE_DIR}/CMake* ${CMAKE_SOURCE_DIR}/toolchain/cmake/*.cmake)
list(TRANSFORM firmware_headers PREPEND ${CMAKE_SOURCE_DIR}/ OUTPUT_VARIABLE task_headers)
declare_test(toolchain.scripts COMMAND node --test ${tool_tests} DATA ${documents}
             ${CMAKE_SOURCE_DIR}/firmware/safety/arming.cpp ${CMAKE_SOURCE_DIR}/firmware/app/tasks.cpp ${task_headers}
             ${CMAKE_SOURCE_DIR}/libraries/scheduler/scheduler.hpp LABELS quick REUSE)
declare_test(toolchain.help COMMAND node ${tests}/help/help.mjs ${CMAKE_BINARY_DIR}
             NEEDS fly campaign mission_tool param_tool log_tool LABELS unit quick)
declare_test(param_tool.every_parameter_has_an_effect
             COMMAND node --test ${tests}/param_tool/effect.test.mjs LABELS quick)
file(GLOB airplane_parameters CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/airplanes/*.param)
foreach(file IN LISTS airplane_parameters)
    get_filename_component(airplane ${file} NAME_WE)
    declare_test(airplanes.param.${airplane} COMMAND param_tool check ${file} LABELS quick)
endforeach()

# ---- MAVLink against an independent implementation (npm node-mavlink, see toolchain/node)
project_program(mavlink_repeat ${tests}/mavlink/repeat.cpp LIBRARIES mavlink)
declare_test(mavlink.definitions COMMAND node --test ${tests}/mavlink/definitions.test.mjs LABELS interop)
declare_test(mavlink.vectors COMMAND node --test ${tests}/mavlink/vectors.test.mjs NEEDS mavlink_repeat
             ENVIRONMENT MAVLINK_REPEAT=$<TARGET_FILE:mavlink_repeat> LABELS interop)

# ---- toolchain/flash against a bootloader that speaks STK500v2 on a pseudo-terminal
project_program(bootloader_peer ${tests}/flash/bootloader_peer.cpp LIBRARIES util)  # openpty
declare_test(toolchain.flash COMMAND node --test ${tests}/flash/flash.test.mjs NEEDS bootloader_peer
             ENVIRONMENT BOOTLOADER_PEER=$<TARGET_FILE:bootloader_peer>
             LABELS interop)
