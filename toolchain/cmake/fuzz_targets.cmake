# SPDX-License-Identifier: GPL-3.0-or-later
# The fuzzers, by clang for its libFuzzer: the flight program on the doubles of the hardware, with
# the sanitizers (preset fuzz).
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")
add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
include_directories(${CMAKE_SOURCE_DIR}/host_tests/support/fakes ${CMAKE_SOURCE_DIR}
                    ${CMAKE_SOURCE_DIR}/libraries ${CMAKE_SOURCE_DIR}/host_tests/support)

file(GLOB_RECURSE fuzzed_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/libraries/*.cpp
     ${CMAKE_SOURCE_DIR}/firmware/*.cpp)
list(REMOVE_ITEM fuzzed_sources ${CMAKE_SOURCE_DIR}/firmware/app/main.cpp)
add_library(fuzzed STATIC ${fuzzed_sources})
file(GLOB fakes_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/support/fakes/*.cpp)
list(FILTER fakes_sources EXCLUDE REGEX _test\\.cpp$)
# behind what the firmware has itself
add_library(fuzz_fakes STATIC ${fakes_sources})
target_link_libraries(fuzzed PUBLIC fuzz_fakes)

# fuzzer(NAME SOURCE...)
function(fuzzer name)
    add_executable(${name}_fuzz ${ARGN})
    target_link_libraries(${name}_fuzz PRIVATE fuzzed)
    target_link_options(${name}_fuzz PRIVATE -fsanitize=fuzzer,address,undefined)
endfunction()
foreach(name parser handler conversation gps)
    fuzzer(${name} ${CMAKE_SOURCE_DIR}/host_tests/fuzz/${name}_fuzz.cpp)
endforeach()

# the readers of the mission tool, without its command line and the airplane
file(GLOB tool_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/mission_tool/*.cpp)
list(FILTER tool_sources EXCLUDE REGEX "/(main|program|airplane|power|page|drawing|rehearse|estimate|fence_check|flight_[ft][a-z]*)\\.cpp$")
set(ground ${CMAKE_SOURCE_DIR}/simulator/ground)
fuzzer(mission_tool ${CMAKE_SOURCE_DIR}/host_tests/fuzz/mission_tool_fuzz.cpp ${tool_sources}
       ${ground}/waypoints.cpp ${ground}/mission_file.cpp ${ground}/plan_file.cpp ${ground}/json_places.cpp
       ${ground}/text_file.cpp)
