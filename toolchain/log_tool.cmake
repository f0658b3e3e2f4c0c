# SPDX-License-Identifier: GPL-3.0-or-later
# The log tool: flight logs from the DataFlash as tables, summaries and .bin files.
file(GLOB log_tool_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/log_tool/*.cpp)
list(FILTER log_tool_sources EXCLUDE REGEX /main\.cpp$)
add_library(log_tool_parts STATIC ${log_tool_sources})
target_compile_options(log_tool_parts PRIVATE ${HOUSE_WARNINGS})
target_include_directories(log_tool_parts PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(log_tool_parts PUBLIC logging simulator_report PRIVATE CLI11::CLI11)

add_executable(log_tool ${CMAKE_SOURCE_DIR}/toolchain/log_tool/main.cpp)
target_compile_options(log_tool PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(log_tool PRIVATE log_tool_parts)

house_test(log_tool_test ${CMAKE_SOURCE_DIR}/host_tests/log_tool log_tool_parts)

# a flight of the natively compiled firmware, its log held against the simulator's truth
if(NOT SANITIZE)
    add_test(NAME log_tool.flight_log_tells_the_truth
             COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/log_tool/truth.test.mjs)
    set_tests_properties(log_tool.flight_log_tells_the_truth PROPERTIES TIMEOUT 600 ENVIRONMENT
        "FLY=$<TARGET_FILE:fly>;LOG_TOOL=$<TARGET_FILE:log_tool>")
endif()
