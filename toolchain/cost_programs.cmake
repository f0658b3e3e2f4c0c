# SPDX-License-Identifier: GPL-3.0-or-later
# Programs whose cost the tests hold to its limits: of libraries alone, and of the firmware
add_executable(cost_geodesy EXCLUDE_FROM_ALL ${CMAKE_SOURCE_DIR}/host_tests/costs/programs/geodesy.cpp)
target_link_libraries(cost_geodesy PRIVATE hal_avr geo)
set(firmware_but_main ${firmware_sources})
list(FILTER firmware_but_main EXCLUDE REGEX /firmware/main\\.cpp$)
add_executable(cost_mission EXCLUDE_FROM_ALL ${firmware_but_main} ${hal_sources}
               ${CMAKE_SOURCE_DIR}/host_tests/costs/programs/mission.cpp)
target_include_directories(cost_mission PRIVATE ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/hal_avr
                           ${CMAKE_SOURCE_DIR}/hal_avr/boards/${BOARD})
target_link_libraries(cost_mission PRIVATE ${all_libraries})
foreach(program cost_geodesy cost_mission)
    set_target_properties(${program} PROPERTIES CXX_STANDARD 14 SUFFIX .elf LINK_DEPENDS "${image_checks}")
    target_compile_options(${program} PRIVATE ${HOUSE_WARNINGS})
    add_dependencies(hal_programs ${program})
endforeach()
