# SPDX-License-Identifier: GPL-3.0-or-later
# The firmware's sources but main.cpp: those that include the board's own header (board_sources) are
# compiled for each board, the others (firmware_sources) once.
file(GLOB_RECURSE firmware_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/firmware/*.cpp)
list(REMOVE_ITEM firmware_sources ${CMAKE_SOURCE_DIR}/firmware/app/main.cpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${firmware_sources})
set(board_sources)
foreach(source IN LISTS firmware_sources)
    file(STRINGS ${source} found LIMIT_COUNT 1 REGEX "^#include \"board\\.hpp\"")
    if(found)
        list(APPEND board_sources ${source})
    endif()
endforeach()
list(REMOVE_ITEM firmware_sources ${board_sources})

add_library(firmware_any_board OBJECT ${firmware_sources})
set_target_properties(firmware_any_board PROPERTIES CXX_STANDARD 14)
target_compile_options(firmware_any_board PRIVATE ${PROJECT_WARNINGS})
target_include_directories(firmware_any_board PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(firmware_any_board PRIVATE ${all_libraries})
