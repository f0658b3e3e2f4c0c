# SPDX-License-Identifier: GPL-3.0-or-later
# libFuzzer over the parsers, over the handler of every message, and over whole conversations: a
# counted number of executions each, 100,000 unless FUZZ_RUNS says otherwise. The fuzzers are of
# the preset fuzz; without clang there are none.
find_program(CLANGXX clang++ NO_CMAKE_SYSTEM_PATH)
if(NOT CLANGXX)
    message(STATUS "clang++ is missing: the fuzzers are left out (toolchain/setup test)")
    return()
endif()

function(fuzz_test name program)
    declare_test(fuzz.${name} COMMAND node ${ARGN} NEEDS ${FUZZ_TREE}/${program} LABELS fuzz REUSE)
endfunction()
function(run_fuzzer name fuzzer)
    fuzz_test(${name} ${fuzzer}_fuzz ${tests}/fuzz/run.mjs ${FUZZ_TREE}/${fuzzer}_fuzz ${fuzzer} ${ARGN})
endfunction()

run_fuzzer(parser parser)
run_fuzzer(conversation conversation)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${CMAKE_SOURCE_DIR}/firmware/gcs/incoming.cpp)
file(STRINGS ${CMAKE_SOURCE_DIR}/firmware/gcs/incoming.cpp handled
     REGEX "to(All|Us)<mavlink::[A-Za-z]+>\\((on|refuse)")
foreach(row IN LISTS handled)
    string(REGEX REPLACE ".*<mavlink::([A-Za-z]+)>.*" "\\1" message "${row}")
    run_fuzzer(${message} handler ${message})
endforeach()
fuzz_test(gps gps_fuzz ${tests}/fuzz/gps.mjs ${FUZZ_TREE}/gps_fuzz)
# the mission tool: any bytes into each of its readers
foreach(reader waypoints plan records image eeprom)
    fuzz_test(mission_tool.${reader} mission_tool_fuzz ${tests}/fuzz/mission_tool.mjs
              ${FUZZ_TREE}/mission_tool_fuzz ${reader})
endforeach()
