# SPDX-License-Identifier: GPL-3.0-or-later
# The parameter tool: parameters as files and EEPROM images, by the firmware's own table and store.
file(GLOB param_tool_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/param_tool/*.cpp)
list(FILTER param_tool_sources EXCLUDE REGEX /main\.cpp$)
add_library(param_tool_parts STATIC ${param_tool_sources})
target_compile_options(param_tool_parts PRIVATE ${HOUSE_WARNINGS})
target_compile_definitions(param_tool_parts PRIVATE
                           PARAMETERS_CSV="${CMAKE_SOURCE_DIR}/firmware/parameters.csv")
target_link_libraries(param_tool_parts PUBLIC mission_tool_parts PRIVATE CLI11::CLI11)

add_executable(param_tool ${CMAKE_SOURCE_DIR}/toolchain/param_tool/main.cpp)
target_compile_options(param_tool PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(param_tool PRIVATE param_tool_parts)

house_test(param_tool_test ${CMAKE_SOURCE_DIR}/host_tests/param_tool param_tool_parts)
if(TARGET param_tool_test)
    target_compile_definitions(param_tool_test PRIVATE
                               PARAMETERS_MANUAL="${CMAKE_SOURCE_DIR}/docs/parameters.md")
endif()
add_test(NAME param_tool.every_parameter_has_an_effect
         COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/param_tool/effect.test.mjs)

# an image that the tool has made, on the natively compiled board and on the emulated one
if(NOT SANITIZE)
    foreach(vehicle native elf)
        add_test(NAME param_tool.boots_a_compiled_image_${vehicle}
                 COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/param_tool/board.test.mjs)
        set_tests_properties(param_tool.boots_a_compiled_image_${vehicle} PROPERTIES TIMEOUT 600
            ENVIRONMENT "FLY=$<TARGET_FILE:fly>;FLY_BOARD=${vehicle};PARAM_TOOL=$<TARGET_FILE:param_tool>")
    endforeach()
    set_tests_properties(param_tool.boots_a_compiled_image_elf PROPERTIES LABELS simavr)
endif()
