# SPDX-License-Identifier: GPL-3.0-or-later
# libFuzzer over the parsers, over the handler of every message, and over whole conversations: the
# fuzzers in the tree of the preset fuzz, and in the host's tree the tests that run them.

if(FUZZ)
    # The fuzzers, by clang for its libFuzzer: the flight program on the doubles of the hardware, with
    # the sanitizers (preset fuzz).
    set(CMAKE_CXX_STANDARD 17)
    set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
                        -fsanitize-coverage-ignorelist=${CMAKE_SOURCE_DIR}/host_tests/fuzz/unobserved.txt)
    include_directories(${CMAKE_SOURCE_DIR}/host_tests/support/fakes ${CMAKE_SOURCE_DIR}
                        ${CMAKE_SOURCE_DIR}/libraries ${CMAKE_SOURCE_DIR}/host_tests/support)

    file(GLOB_RECURSE fuzzed_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/libraries/*.cpp
         ${CMAKE_SOURCE_DIR}/firmware/*.cpp)
    list(REMOVE_ITEM fuzzed_sources ${CMAKE_SOURCE_DIR}/firmware/app/main.cpp)
    add_library(fuzzed STATIC ${fuzzed_sources})
    file(GLOB fakes_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/support/fakes/*.cpp)
    list(FILTER fakes_sources EXCLUDE REGEX _test\\.cpp$)
    # behind what the firmware has itself; how a double goes is nothing to steer by
    add_library(fuzz_fakes STATIC ${fakes_sources})
    target_compile_options(fuzz_fakes PRIVATE -O2 -fno-sanitize=fuzzer-no-link)
    target_link_libraries(fuzzed PUBLIC fuzz_fakes)

    # fuzzer(NAME SOURCE...)
    function(fuzzer name)
        add_executable(${name}_fuzz ${ARGN})
        target_link_libraries(${name}_fuzz PRIVATE fuzzed)
        target_link_options(${name}_fuzz PRIVATE -fsanitize=fuzzer,address,undefined)
    endfunction()
    foreach(name parser handler conversation signing gps)
        fuzzer(${name} ${CMAKE_SOURCE_DIR}/host_tests/fuzz/${name}_fuzz.cpp)
    endforeach()

    # the readers of the mission tool, without its command line and the airplane
    file(GLOB tool_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/mission_tool/*.cpp)
    list(FILTER tool_sources EXCLUDE REGEX "/(main|program|airplane|power|page|drawing|rehearse|estimate|turns|fence_check|flight_[ft][a-z]*)\\.cpp$")
    set(ground ${CMAKE_SOURCE_DIR}/simulator/ground)
    fuzzer(mission_tool ${CMAKE_SOURCE_DIR}/host_tests/fuzz/mission_tool_fuzz.cpp ${tool_sources}
           ${ground}/waypoints.cpp ${ground}/mission_file.cpp ${ground}/points_file.cpp ${ground}/plan_file.cpp
           ${ground}/json_places.cpp ${ground}/text_file.cpp)
    return()
endif()

# A counted number of executions each, 100,000 (files of the mission tool 30,000) unless FUZZ_RUNS
# says otherwise; without clang there are none.
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
run_fuzzer(signing signing)
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
