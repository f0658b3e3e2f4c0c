# SPDX-License-Identifier: GPL-3.0-or-later
# The tools that run on the host, each a library (for its tests) and a program.
find_package(CLI11 REQUIRED)

# project_tool(NAME FOLDER LIBRARY...): NAME_parts and, of its main.cpp, NAME
function(project_tool name folder)
    project_sources(${name}_parts ${CMAKE_SOURCE_DIR}/${folder} ${ARGN})
    target_include_directories(${name}_parts PUBLIC ${CMAKE_SOURCE_DIR})
    target_link_libraries(${name}_parts PRIVATE CLI11::CLI11)
    project_program(${name} ${CMAKE_SOURCE_DIR}/${folder}/main.cpp LIBRARIES ${name}_parts)
endfunction()

# missions and parameters as files and EEPROM images, by the firmware's own tables and stores
project_tool(mission_tool toolchain/mission_tool firmware_on_fakes simulator_ground fakes)
project_tool(param_tool toolchain/param_tool mission_tool_parts)
target_compile_definitions(param_tool_parts PRIVATE
                           PARAMETERS_CSV="${CMAKE_SOURCE_DIR}/firmware/state/parameters.csv")
# flight logs from the DataFlash as tables, summaries and .bin files
project_tool(log_tool toolchain/log_tool logging simulator_report)
# many flights at once, natively
project_tool(campaign simulator/campaign simulator_report simulator_world Threads::Threads)
target_compile_definitions(campaign_parts PRIVATE CAMPAIGN_OUT="${CMAKE_SOURCE_DIR}/build/campaign"
                           CAMPAIGN_MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
target_compile_definitions(campaign PRIVATE CAMPAIGN_FLY="${CMAKE_BINARY_DIR}/fly")

# The firmware's table of declinations, from the coefficients of the World Magnetic Model:
#   declination_table toolchain/declination/WMM2025.COF > libraries/geo/declination_table.hpp
project_tool(declination_table toolchain/declination)
