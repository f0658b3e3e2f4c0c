# SPDX-License-Identifier: GPL-3.0-or-later
# The firmware's link with a main() that times it; measured by host_tests/mavlink/costs.
add_executable(cost_link EXCLUDE_FROM_ALL ${firmware_but_main} ${hal_sources}
               ${CMAKE_SOURCE_DIR}/host_tests/mavlink/costs/link.cpp)
target_include_directories(cost_link PRIVATE ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/hal_avr
                           ${CMAKE_SOURCE_DIR}/hal_avr/boards/${BOARD}
                           ${CMAKE_SOURCE_DIR}/host_tests/mavlink)
target_link_libraries(cost_link PRIVATE ${all_libraries})
set_target_properties(cost_link PROPERTIES CXX_STANDARD 14 SUFFIX .elf LINK_DEPENDS "${image_checks}")
target_compile_options(cost_link PRIVATE ${HOUSE_WARNINGS})
add_dependencies(hal_programs cost_link)
