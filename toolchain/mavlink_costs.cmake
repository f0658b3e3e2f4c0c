# SPDX-License-Identifier: GPL-3.0-or-later
# What the ground link takes of the processor, against its budgets.
add_executable(mavlink_costs ${CMAKE_SOURCE_DIR}/host_tests/mavlink/costs/measure.cpp)
target_compile_options(mavlink_costs PRIVATE ${HOUSE_WARNINGS})
target_include_directories(mavlink_costs PRIVATE ${CMAKE_SOURCE_DIR}/host_tests/mavlink)
target_link_libraries(mavlink_costs PRIVATE simulator_machine nlohmann_json::nlohmann_json)
add_dependencies(mavlink_costs hal_programs)
add_test(NAME mavlink.costs COMMAND mavlink_costs ${CMAKE_BINARY_DIR}/avr-hal/cost_link.elf
         ${CMAKE_SOURCE_DIR}/toolchain/budgets.json)
set_tests_properties(mavlink.costs PROPERTIES LABELS simavr)
