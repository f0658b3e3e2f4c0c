# SPDX-License-Identifier: GPL-3.0-or-later
# The unit tests: one GoogleTest program a library, room or folder of sources. The tests of
# firmware/safety/fence.cpp are in host_tests/unit/firmware/safety/fence_test.cpp.

# unit_test(PATH [BOTH] LIBRARY...): the tests in host_tests/PATH or the one in PATH_test.cpp. The
# program is named after its path: core_test, fdm_test; of a room or an oracle firmware_gcs_test.
# BOTH: see gtest_run.
function(unit_test path)
    cmake_parse_arguments(PARSE_ARGV 1 arg "BOTH" "" "")
    string(REGEX REPLACE "^unit/((libraries|simulator|toolchain)/)?" "" name ${path})
    string(REPLACE "/" "_" name ${name})
    gtest_program(${name}_test ${tests}/${path} ${arg_UNPARSED_ARGUMENTS})
    set(both)
    if(arg_BOTH)
        set(both BOTH)
    endif()
    gtest_run(${name}_test ${both})
endfunction()

foreach(library IN LISTS all_libraries)
    unit_test(unit/libraries/${library} ${library})
endforeach()
# the drivers are tried on the simulator's chips, the logs lie in one
target_link_libraries(drivers_test PRIVATE simulator_world)
target_link_libraries(logging_test PRIVATE simulator_world)
# the table of declinations against the model it is made of
target_link_libraries(geo_test PRIVATE simulator_world declination_table_parts)
target_compile_definitions(geo_test PRIVATE
    WMM_COEFFICIENTS="${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF"
    DECLINATION_TABLE="${CMAKE_SOURCE_DIR}/libraries/geo/declination_table.hpp")

file(GLOB rooms CONFIGURE_DEPENDS RELATIVE ${tests} ${tests}/unit/firmware/*)
foreach(room IN LISTS rooms)
    unit_test(${room} firmware_on_fakes)
    get_filename_component(name ${room} NAME)
    target_sources(firmware_${name}_test PRIVATE ${tests}/support/fresh_start.cpp)
endforeach()
target_link_libraries(firmware_mission_test PRIVATE simulator_world)  # for its DataFlash
target_link_libraries(firmware_sensors_test PRIVATE simulator_world)  # for its barometer
target_compile_definitions(firmware_safety_test PRIVATE FAILSAFE_MANUAL="${CMAKE_SOURCE_DIR}/docs/failsafes.md")
target_compile_definitions(firmware_modes_test PRIVATE FAILSAFE_MANUAL="${CMAKE_SOURCE_DIR}/docs/failsafes.md")

foreach(part IN ITEMS airplane builtin_model devices world world_file output_file ground native report invariants live flight_folder)
    unit_test(unit/simulator/${part} simulator_live simulator_report simulator_ground simulator_native simulator_world)
endforeach()
target_sources(flight_folder_test PRIVATE ${CMAKE_SOURCE_DIR}/simulator/flight_folder.cpp)
target_compile_definitions(live_test PRIVATE FAILSAFE_MANUAL="${CMAKE_SOURCE_DIR}/docs/failsafes.md")
target_compile_definitions(airplane_test PRIVATE AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")

unit_test(unit/toolchain/mission_tool mission_tool_parts)
target_compile_definitions(mission_tool_test PRIVATE MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
unit_test(unit/toolchain/log_tool log_tool_parts)
unit_test(unit/toolchain/param_tool param_tool_parts)
target_compile_definitions(param_tool_test PRIVATE PARAMETERS_MANUAL="${CMAKE_SOURCE_DIR}/docs/parameters.md")
unit_test(support/fakes)

# ---- against implementations that are not the project's own, or written a second time
unit_test(oracle/mission BOTH mission)  # the random missions
target_compile_definitions(oracle_mission_test PRIVATE
    ORACLE_PASSES=$<IF:$<BOOL:${SANITIZE}>,1000000,3000000>)
unit_test(oracle/airplane simulator_world)
find_library(GEOGRAPHICLIB NAMES GeographicLib Geographic REQUIRED)
unit_test(oracle/geo geo ${GEOGRAPHICLIB})
unit_test(oracle/fence firmware_on_fakes ${GEOGRAPHICLIB})
target_sources(oracle_fence_test PRIVATE ${tests}/support/fresh_start.cpp)

set(long oracle/mission/oracle.cpp oracle/mission/rig.cpp oracle/mission/trial.cpp oracle/mission/random_trial.cpp
    unit/libraries/estimation/attitude_test.cpp unit/libraries/estimation/position_test.cpp
    unit/firmware/mission/manual_test.cpp unit/firmware/mission/command_table_test.cpp
    unit/simulator/devices/ublox_gps_test.cpp)
list(TRANSFORM long PREPEND ${tests}/)
optimised(${long})

if(SANITIZE)
    return()
endif()

# ---- programs that run the tools as a user does
gtest_program(campaign_test ${tests}/unit/simulator/campaign campaign_parts)
target_compile_definitions(campaign_test PRIVATE CAMPAIGN_PROGRAM="$<TARGET_FILE:campaign>"
    MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
gtest_run(campaign_test NEEDS campaign drawn fly LABELS unit quick)
gtest_program(drawn_test ${tests}/unit/simulator/drawn drawn_parts simulator_ground)
target_compile_definitions(drawn_test PRIVATE
    MAGNETIC_MODEL="${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF")
gtest_run(drawn_test LABELS unit quick)
gtest_program(chaos_test ${tests}/unit/simulator/chaos chaos_parts)
target_compile_definitions(chaos_test PRIVATE PARAMETERS="${CMAKE_SOURCE_DIR}/firmware/state/parameters.csv")
gtest_run(chaos_test LABELS unit quick)
gtest_program(fdm_test ${tests}/unit/simulator/fdm simulator_world)
gtest_run(fdm_test LABELS unit quick)
gtest_program(fly_test ${tests}/unit/simulator/fly)
target_compile_definitions(fly_test PRIVATE FLY_PROGRAM="$<TARGET_FILE:fly>"
    AIRPLANES="${CMAKE_SOURCE_DIR}/simulator/airplanes")
gtest_run(fly_test NEEDS fly ${IMAGE_apm2} ${IMAGE_apm1} LABELS unit)

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
declare_test(layering COMMAND node ${CMAKE_SOURCE_DIR}/toolchain/check/layering.mjs LABELS quick)
declare_test(file_states COMMAND node ${CMAKE_SOURCE_DIR}/toolchain/check/file_states.mjs LABELS quick)
declare_test(lengths COMMAND node ${CMAKE_SOURCE_DIR}/toolchain/check/lengths.mjs LABELS quick)
declare_test(linting COMMAND ${CMAKE_SOURCE_DIR}/toolchain/check_scripts LABELS quick)
find_program(CLANG_FORMAT clang-format NO_CMAKE_SYSTEM_PATH)
if(CLANG_FORMAT)
    declare_test(formatting COMMAND ${CMAKE_SOURCE_DIR}/toolchain/check_format LABELS quick)
endif()
file(GLOB_RECURSE tool_tests CONFIGURE_DEPENDS ${tests}/unit/*.test.mjs)
list(FILTER tool_tests EXCLUDE REGEX "/(flash_tool|firmware)/")  # tests of their own, below
file(GLOB documents CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/*.md ${CMAKE_SOURCE_DIR}/docs/*
     ${CMAKE_SOURCE_DIR}/CMake* ${CMAKE_SOURCE_DIR}/toolchain/cmake/*.cmake)
list(TRANSFORM firmware_headers PREPEND ${CMAKE_SOURCE_DIR}/ OUTPUT_VARIABLE task_headers)
# these read the whole tree: their result depends on every file and is not reused
set(tree_tests ${tool_tests})
list(FILTER tree_tests INCLUDE REGEX "/(architecture|documents|words)\\.test\\.mjs$")
list(REMOVE_ITEM tool_tests ${tree_tests})
# which the bugs of toolchain/known_bugs are put back into
set(known_bugs actuators/outputs estimator/estimator guidance/launch modes/mode_requests modes/mode_switch
    safety/restart sensors/radio)
list(TRANSFORM known_bugs REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/firmware/\\1.cpp")
declare_test(toolchain.documents COMMAND node --test ${tree_tests} LABELS quick)
declare_test(toolchain.scripts COMMAND node --test ${tool_tests} DATA ${documents}
             ${CMAKE_SOURCE_DIR}/firmware/safety/arming.cpp ${CMAKE_SOURCE_DIR}/firmware/app/tasks.cpp ${task_headers}
             ${CMAKE_SOURCE_DIR}/libraries/scheduler/scheduler.hpp ${known_bugs}
             ${CMAKE_SOURCE_DIR}/simulator/invariants/watch.cpp LABELS quick REUSE)
declare_test(toolchain.help COMMAND node ${tests}/unit/toolchain/help/help.mjs ${CMAKE_BINARY_DIR}
             NEEDS fly campaign chaos mission_tool param_tool log_tool LABELS unit quick)
declare_test(param_tool.every_parameter_has_an_effect
             COMMAND node --test ${tests}/unit/firmware/state/parameters.test.mjs LABELS quick)
file(GLOB airplane_parameters CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/airplanes/*.param)
foreach(file IN LISTS airplane_parameters)
    get_filename_component(airplane ${file} NAME_WE)
    declare_test(airplanes.param.${airplane} COMMAND param_tool check ${file} LABELS quick)
endforeach()

# ---- the pages, in a browser where there is one
set(page_programs FLY=$<TARGET_FILE:fly> LOG_TOOL=$<TARGET_FILE:log_tool> CAMPAIGN=$<TARGET_FILE:campaign>
    CHAOS=$<TARGET_FILE:chaos>)
file(GLOB page_tests CONFIGURE_DEPENDS ${tests}/web/*.mjs ${tests}/support/*.mjs)
set(page_data ${page_tests} ${page_sources} ${CMAKE_SOURCE_DIR}/docs/failsafes.md
    ${CMAKE_SOURCE_DIR}/simulator/ground/telemetry.cpp)
declare_test(web.log_document COMMAND node --test ${tests}/web/log_document.test.mjs NEEDS fly log_tool
             DATA ${page_data} ENVIRONMENT ${page_programs} LABELS unit quick REUSE)
declare_test(web.drawn_document COMMAND node --test ${tests}/web/drawn_document.test.mjs
             DATA ${page_data} LABELS unit quick REUSE)
find_program(CHROMIUM chromium NO_CMAKE_SYSTEM_PATH)
if(CHROMIUM)
    foreach(name page touch served campaign drawn chaos)
        declare_test(web.${name} COMMAND node --test ${tests}/web/${name}.test.mjs NEEDS fly log_tool campaign drawn chaos
                     ENVIRONMENT ${page_programs} CHROMIUM=${CHROMIUM} PAGES=${pages} SHOTS=${pages}/shots
                     DATA ${page_data} ${pages}/page.html ${pages}/campaign.html LABELS unit quick REUSE)
    endforeach()
else()
    message(STATUS "chromium is missing: the pages are not tried in a browser (toolchain/setup test)")
endif()

# ---- MAVLink against an independent implementation (npm node-mavlink, see toolchain/node)
project_program(mavlink_repeat ${tests}/interop/mavlink/repeat.cpp LIBRARIES mavlink)
declare_test(mavlink.definitions COMMAND node --test ${tests}/interop/mavlink/definitions.test.mjs LABELS interop)
declare_test(mavlink.vectors COMMAND node --test ${tests}/interop/mavlink/vectors.test.mjs NEEDS mavlink_repeat
             ENVIRONMENT MAVLINK_REPEAT=$<TARGET_FILE:mavlink_repeat> LABELS interop)

# ---- toolchain/flash against a bootloader that speaks STK500v2 on a pseudo-terminal
project_program(bootloader_peer ${tests}/unit/toolchain/flash_tool/bootloader_peer.cpp LIBRARIES util)  # openpty
declare_test(toolchain.flash COMMAND node --test ${tests}/unit/toolchain/flash_tool/flash.test.mjs NEEDS bootloader_peer
             ENVIRONMENT BOOTLOADER_PEER=$<TARGET_FILE:bootloader_peer>
             LABELS interop)
