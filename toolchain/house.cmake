# SPDX-License-Identifier: GPL-3.0-or-later
# house_library(NAME DEPENDENCY...): a folder of libraries/ as a target, and, on the host, its
# tests in host_tests/NAME as NAME_test. The firmware's compiler takes C++14 and no more, so the
# libraries are held to it on the host too.
set(HOUSE_WARNINGS -Wall -Wextra -Wshadow -Wundef -Wlogical-op -Wcast-qual -Wvla -Werror)

function(house_target name folder)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    if(sources)
        add_library(${name} STATIC ${sources})
        target_compile_options(${name} PRIVATE ${HOUSE_WARNINGS})
        set(scope PUBLIC)
    else()
        add_library(${name} INTERFACE)
        set(scope INTERFACE)
    endif()
    target_link_libraries(${name} ${scope} ${ARGN})
    set(HOUSE_SCOPE ${scope} PARENT_SCOPE)
endfunction()

function(house_library name)
    house_target(${name} ${CMAKE_SOURCE_DIR}/libraries/${name} ${ARGN})
    target_include_directories(${name} ${HOUSE_SCOPE} ${CMAKE_SOURCE_DIR}/libraries)
    if(HOUSE_SCOPE STREQUAL PUBLIC)
        set_target_properties(${name} PROPERTIES CXX_STANDARD 14)
    endif()
endfunction()

# house_test(NAME FOLDER LIBRARY...): every *_test.cpp of the folder in one GoogleTest program,
# with the doubles of the hardware behind whatever the libraries leave open.
function(house_test name folder)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*_test.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(${name} ${sources})
    # the tests' own code runs briefly: what it tests is optimised, it compiles in two thirds
    target_compile_options(${name} PRIVATE ${HOUSE_WARNINGS} -O1)
    target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/host_tests)
    set_target_properties(${name} PROPERTIES CXX_STANDARD 17)
    target_link_libraries(${name} PRIVATE ${ARGN} fakes GTest::gmock GTest::gtest_main)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_PREFIX "${HOUSE_TEST_PREFIX}")
endfunction()
