# SPDX-License-Identifier: GPL-3.0-or-later
# How this project declares its libraries, programs and tests.

# Warnings are errors with the compilers of Debian 12, which every change is built with; another
# compiler may warn of more, and still builds.
set(PROJECT_WARNINGS -Wall -Wextra -Wshadow -Wundef -Wcast-qual -Wvla)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    list(APPEND PROJECT_WARNINGS -Wlogical-op)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 6 OR (CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12 AND
       CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13))
        list(APPEND PROJECT_WARNINGS -Werror)
    endif()
endif()

# project_sources(NAME FOLDER LIBRARY...): the folder's *.cpp but for tests and main as a library;
# one of headers alone when there are none. Sets SCOPE for further properties.
function(project_sources name folder)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "(_test|/main)\\.cpp$")
    set(scope INTERFACE)
    if(sources)
        add_library(${name} STATIC ${sources})
        target_compile_options(${name} PRIVATE ${PROJECT_WARNINGS})
        if(TARGET host_headers)
            target_precompile_headers(${name} REUSE_FROM host_headers)
        endif()
        set(scope PUBLIC)
    else()
        add_library(${name} INTERFACE)
    endif()
    target_link_libraries(${name} ${scope} ${ARGN})
    set(SCOPE ${scope} PARENT_SCOPE)
endfunction()

# project_library(NAME DEPENDENCY...): a folder of libraries/. The firmware's compiler takes C++14
# and no more, so the libraries are held to it on the host too.
function(project_library name)
    project_sources(${name} ${CMAKE_SOURCE_DIR}/libraries/${name} ${ARGN})
    target_include_directories(${name} ${SCOPE} ${CMAKE_SOURCE_DIR}/libraries)
    if(SCOPE STREQUAL PUBLIC)
        set_target_properties(${name} PROPERTIES CXX_STANDARD 14)
    endif()
endfunction()

# project_program(NAME SOURCE... LIBRARIES LIBRARY...)
function(project_program name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" LIBRARIES)
    add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
    target_compile_options(${name} PRIVATE ${PROJECT_WARNINGS})
    if(TARGET host_headers)
        target_precompile_headers(${name} REUSE_FROM host_headers)
    endif()
    target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
endfunction()

# precompiled(NAME OPTION... HEADERS HEADER... [LIBRARIES LIBRARY...]): headers that many sources
# include, compiled once. A target uses them by target_precompile_headers(... REUSE_FROM NAME), with
# the same options.
function(precompiled name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LIBRARIES")
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${name}.cpp CONTENT "// ${name}\n")
    add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/${name}.cpp)
    set_target_properties(${name} PROPERTIES CXX_STANDARD 17)
    target_compile_options(${name} PRIVATE ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# Header-only libraries for text (CLI11, JSON) take most of the time in which their users compile,
# and next to none when these run: their users are not optimised, which halves it. Those of JSON also
# have it precompiled, on the host (use_precompiled_text).
set(TEXT_OPTIMISATION -O0)
file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/*.cpp
     ${CMAKE_SOURCE_DIR}/toolchain/*.cpp ${CMAKE_SOURCE_DIR}/host_tests/*.cpp)
list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")  # these share precompiled headers
set(json_users)
foreach(source IN LISTS sources)
    file(STRINGS ${source} found LIMIT_COUNT 1 REGEX
         "^#include (<CLI/CLI.hpp>|<nlohmann/json.hpp>|\"(toolchain/mission_tool/command_line|simulator/ground/json_places).hpp\")")
    if(found)
        set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS ${TEXT_OPTIMISATION} SKIP_PRECOMPILE_HEADERS ON)
    endif()
    if(found MATCHES "json")
        list(APPEND json_users ${source})
    endif()
endforeach()

# use_precompiled_text(NAME): the users of JSON take the headers of precompiled(NAME), although their
# targets have others: for single sources there is only the compiler's own option.
function(use_precompiled_text name)
    set(header ${CMAKE_BINARY_DIR}/CMakeFiles/${name}.dir/cmake_pch.hxx)
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
        set(made ${header}.pch)
        set(option -Xclang -include-pch -Xclang ${made})
    else()
        set(made ${header}.gch)
        set(option -Winvalid-pch -include ${header})
    endif()
    set_source_files_properties(${json_users} PROPERTIES OBJECT_DEPENDS ${made}
        COMPILE_OPTIONS "${TEXT_OPTIMISATION};${option}")
endfunction()
