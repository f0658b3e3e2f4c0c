# SPDX-License-Identifier: GPL-3.0-or-later
# How tests are declared: what they need built, their labels, and that a result is reused while
# nothing it depends on has changed.
find_package(GTest REQUIRED)
find_program(NODE node NO_CMAKE_SYSTEM_PATH)
if(NOT NODE)
    message(STATUS "node is missing: the tests that need it are left out (toolchain/setup test)")
endif()
set(tests ${CMAKE_SOURCE_DIR}/host_tests)
set(SANITIZE_TREE ${CMAKE_SOURCE_DIR}/build/sanitize)
set(FUZZ_TREE ${CMAKE_SOURCE_DIR}/build/fuzz)

# declare_test(NAME COMMAND WORD... [NEEDS TARGET_OR_FILE...] [LABELS LABEL...] [TIMEOUT SECONDS]
#              [ENVIRONMENT A=B...] [SETUP FIXTURE] [AFTER FIXTURE...] [DATA FILE...] [REUSE]
#              [ONLY CONFIGURATION...])
# NEEDS: targets of this tree, or files of a tree beside it, that must have been built; the tool
# toolchain/test builds just these. REUSE: the result is a function of the command, NEEDS and DATA;
# toolchain/test does not run it again while these are the same. ONLY: with toolchain/test --long
# (ctest -C long), or with toolchain/test quick (ctest -C quick), and not in a plain run.
function(declare_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "REUSE" "TIMEOUT;SETUP"
                          "COMMAND;NEEDS;LABELS;ENVIRONMENT;AFTER;DATA;ONLY")
    list(GET arg_COMMAND 0 program)
    if(program STREQUAL "node")
        if(NOT NODE)
            return()
        endif()
        list(REMOVE_AT arg_COMMAND 0)
        list(PREPEND arg_COMMAND ${NODE})
    elseif(TARGET ${program})
        list(APPEND arg_NEEDS ${program})
        list(REMOVE_AT arg_COMMAND 0)
        list(PREPEND arg_COMMAND $<TARGET_FILE:${program}>)
    endif()
    set(files)
    foreach(need IN LISTS arg_NEEDS)
        if(TARGET ${need})
            list(APPEND files $<TARGET_FILE:${need}>)
        else()
            list(APPEND files ${need})
        endif()
    endforeach()
    if(arg_REUSE AND NODE)
        list(PREPEND arg_COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/test_tool/reuse.mjs
             ${CMAKE_BINARY_DIR}/results/${name} ${files} ${arg_DATA} --)
    endif()
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 600)
    endif()
    set(when)
    if(arg_ONLY)
        set(when CONFIGURATIONS ${arg_ONLY})
    endif()
    add_test(NAME ${name} COMMAND ${arg_COMMAND} ${when})
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}"
        REQUIRED_FILES "${files}" ENVIRONMENT "${arg_ENVIRONMENT}"
        FIXTURES_SETUP "${arg_SETUP}" FIXTURES_REQUIRED "${arg_AFTER}")
endfunction()

# The tests' own code runs briefly and is half of all that is compiled: what it tests is optimised,
# it is not.
set(TEST_OPTIMISATION -O0)

precompiled(test_headers ${PROJECT_WARNINGS} ${TEST_OPTIMISATION} LIBRARIES GTest::gmock
            HEADERS <gmock/gmock.h> <gtest/gtest.h> ${HOST_HEADERS})

# Data that unit tests read besides their program.
file(GLOB unit_data CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/*.md
     ${CMAKE_SOURCE_DIR}/simulator/airplanes/* ${CMAKE_SOURCE_DIR}/simulator/missions/*
     ${CMAKE_SOURCE_DIR}/firmware/state/parameters.csv ${CMAKE_SOURCE_DIR}/libraries/geo/declination_table.hpp
     ${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF ${tests}/unit/firmware/mission/images/*)

# Test programs whose sources are compiled eight at a time, in a third to half of the time: no two of
# them may define the same name, but for those that stay alone.
set(COMPILED_TOGETHER chaos_test firmware_gcs_test firmware_mission_test hal_apm1_test hal_avr_test machine_test
    report_test)
set_source_files_properties(${tests}/chip/hal_avr/eeprom_test.cpp ${tests}/chip/hal_avr/imu_interrupt_test.cpp
    ${tests}/unit/firmware/mission/fence_rally_items_test.cpp ${tests}/unit/simulator/report/report_test.cpp
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# gtest_program(NAME PATH LIBRARY...): the sources of the folder, or PATH_test.cpp alone, in one
# program, with the doubles of the hardware behind whatever the libraries leave open.
function(gtest_program name path)
    file(GLOB sources CONFIGURE_DEPENDS ${path}/*.cpp ${path}_test.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(${name} ${sources})
    target_compile_options(${name} PRIVATE ${PROJECT_WARNINGS} ${TEST_OPTIMISATION})
    target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR} ${tests}/support)
    target_precompile_headers(${name} REUSE_FROM test_headers)
    target_link_libraries(${name} PRIVATE ${ARGN} fakes GTest::gmock GTest::gtest_main)
    if(name IN_LIST COMPILED_TOGETHER)
        set_target_properties(${name} PROPERTIES UNITY_BUILD ON)
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # takes them for headers, where a fixture must not be local
            target_compile_options(${name} PRIVATE -Wno-subobject-linkage)
        endif()
    endif()
endfunction()

# Runs such a program with the sanitizers, as sanitized.NAME. Without them, by the host's compiler, it
# runs as one of the quick tests, and with --long; always with BOTH, and alone where LABELS are given.
#   gtest_run(NAME [BOTH] [NEEDS FILE...] [LABELS LABEL...])
function(gtest_run name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "BOTH" "" "NEEDS;LABELS")
    if(NOT TARGET ${name})
        return()
    endif()
    if(SANITIZE)
        add_test(NAME ${name} COMMAND ${name})
        return()
    endif()
    if(arg_LABELS)
        declare_test(${name} COMMAND ${name} NEEDS ${arg_NEEDS} DATA ${unit_data} LABELS ${arg_LABELS} REUSE)
        return()
    endif()
    declare_test(sanitized.${name} COMMAND ${SANITIZE_TREE}/${name} NEEDS ${SANITIZE_TREE}/${name}
                 DATA ${unit_data} LABELS unit sanitize REUSE)
    set(when ONLY quick long)
    if(arg_BOTH)
        set(when)
    endif()
    declare_test(${name} COMMAND ${name} DATA ${unit_data} LABELS unit quick REUSE ${when})
    # both write to the same temporary files
    set_tests_properties(${name} sanitized.${name} PROPERTIES RESOURCE_LOCK ${name})
endfunction()

# optimised(FILE...): tests, or sources beside them, that run long enough to be worth it.
function(optimised)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O2 SKIP_PRECOMPILE_HEADERS ON)
endfunction()
