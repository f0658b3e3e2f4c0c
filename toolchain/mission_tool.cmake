# SPDX-License-Identifier: GPL-3.0-or-later
# The mission tool: missions as files and EEPROM images, by the firmware's own store and upload.
find_package(CLI11 REQUIRED)
file(GLOB mission_tool_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/mission_tool/*.cpp)
list(FILTER mission_tool_sources EXCLUDE REGEX /main\.cpp$)
add_library(mission_tool_parts STATIC ${mission_tool_sources})
target_compile_options(mission_tool_parts PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(mission_tool_parts PUBLIC firmware_on_fakes simulator_ground fakes
                      PRIVATE CLI11::CLI11)

add_executable(mission_tool ${CMAKE_SOURCE_DIR}/toolchain/mission_tool/main.cpp)
target_compile_options(mission_tool PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(mission_tool PRIVATE mission_tool_parts)

house_test(mission_tool_test ${CMAKE_SOURCE_DIR}/host_tests/mission_tool mission_tool_parts)

# an image that the tool has made, flown by the natively compiled firmware
if(NOT SANITIZE)
    add_test(NAME mission_tool.flies_a_compiled_image
             COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/mission_tool/flight.test.mjs)
    set_tests_properties(mission_tool.flies_a_compiled_image PROPERTIES TIMEOUT 600 ENVIRONMENT
        "FLY=$<TARGET_FILE:fly>;FLY_BOARD=native;MISSION_TOOL=$<TARGET_FILE:mission_tool>")
endif()
