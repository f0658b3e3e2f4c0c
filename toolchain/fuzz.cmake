# SPDX-License-Identifier: GPL-3.0-or-later
# libFuzzer over the parser, over the handler of every message, and over whole conversations: a
# million executions each, counted.
find_program(CLANGXX clang++ REQUIRED)
ExternalProject_Add(fuzzers
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/fuzz
    CMAKE_ARGS -DFUZZ=ON -DCMAKE_CXX_COMPILER=${CLANGXX} -DCMAKE_BUILD_TYPE=RelWithDebInfo
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")

function(fuzz_test name)
    list(GET ARGN 0 target)
    add_test(NAME fuzz.${name}
             COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/host_tests/fuzz/run.mjs
                     ${CMAKE_BINARY_DIR}/fuzz/${target}_fuzz ${ARGN})
    set_tests_properties(fuzz.${name} PROPERTIES TIMEOUT 600 LABELS fuzz)
endfunction()

fuzz_test(parser parser)
fuzz_test(conversation conversation)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${CMAKE_SOURCE_DIR}/firmware/telemetry/incoming.cpp)
file(STRINGS ${CMAKE_SOURCE_DIR}/firmware/telemetry/incoming.cpp handled
     REGEX "to(All|Us)<mavlink::[A-Za-z]+>\\(on")
foreach(row IN LISTS handled)
    string(REGEX REPLACE ".*<mavlink::([A-Za-z]+)>.*" "\\1" message "${row}")
    fuzz_test(${message} handler ${message})
endforeach()

add_test(NAME fuzz.gps COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/host_tests/fuzz/gps.mjs
         ${CMAKE_BINARY_DIR}/fuzz/gps_fuzz)
set_tests_properties(fuzz.gps PROPERTIES TIMEOUT 600 LABELS fuzz)

# the mission tool: any bytes into each of its readers
foreach(reader waypoints records image eeprom)
    add_test(NAME fuzz.mission_tool.${reader}
             COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/host_tests/mission_tool/fuzz.mjs
                     ${CMAKE_BINARY_DIR}/fuzz/mission_tool_fuzz ${reader})
    set_tests_properties(fuzz.mission_tool.${reader} PROPERTIES TIMEOUT 600 LABELS fuzz)
endforeach()
