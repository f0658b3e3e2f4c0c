# SPDX-License-Identifier: GPL-3.0-or-later
# The image for the board named by BOARD: firmware/ on hal_avr/ on libraries/.
set(BOARD apm2 CACHE STRING "apm1 or apm2")
file(GLOB hal_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/*.cpp
     ${CMAKE_SOURCE_DIR}/hal_avr/boards/${BOARD}/*.cpp)
add_library(hal_avr STATIC ${hal_sources})
set_target_properties(hal_avr PROPERTIES CXX_STANDARD 14)
target_compile_options(hal_avr PRIVATE ${HOUSE_WARNINGS})
target_include_directories(hal_avr PUBLIC ${CMAKE_SOURCE_DIR}/hal_avr
                           ${CMAKE_SOURCE_DIR}/hal_avr/boards/${BOARD})
target_link_libraries(hal_avr PUBLIC core hal)

file(GLOB_RECURSE firmware_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/firmware/*.cpp)
add_executable(firmware ${firmware_sources} ${hal_sources})
set_target_properties(firmware PROPERTIES CXX_STANDARD 14 SUFFIX .elf)
target_compile_options(firmware PRIVATE ${HOUSE_WARNINGS})
target_include_directories(firmware PRIVATE ${CMAKE_SOURCE_DIR}
                           ${CMAKE_SOURCE_DIR}/hal_avr ${CMAKE_SOURCE_DIR}/hal_avr/boards/${BOARD})
target_link_libraries(firmware PRIVATE ${all_libraries})

find_program(NODE node REQUIRED)
add_custom_command(TARGET firmware POST_BUILD
    COMMAND ${CMAKE_OBJCOPY} -O ihex -R .eeprom $<TARGET_FILE:firmware> firmware.hex
    COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/blank_eeprom.mjs firmware.eep
    COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/task_names.mjs
            ${CMAKE_SOURCE_DIR}/firmware/tasks.cpp tasks.json
    COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/check_image.mjs $<TARGET_FILE:firmware>
            ${CMAKE_SOURCE_DIR}/toolchain/budgets.json ${BOARD}
    VERBATIM)
# what shrinks and what judges the image is part of it
file(GLOB image_checks ${CMAKE_SOURCE_DIR}/toolchain/*.mjs ${CMAKE_SOURCE_DIR}/toolchain/image/*.mjs
     ${CMAKE_SOURCE_DIR}/toolchain/budgets.json ${outliner}/*)
set_target_properties(firmware PROPERTIES LINK_DEPENDS "${image_checks}")

# ---- programs on the hardware layer alone, which host_tests/hal_avr runs on the emulated chip
file(GLOB hal_programs CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/hal_avr/programs/*.cpp)
add_custom_target(hal_programs)
foreach(program IN LISTS hal_programs)
    get_filename_component(name ${program} NAME_WE)
    add_executable(hal_${name} EXCLUDE_FROM_ALL ${program})
    set_target_properties(hal_${name} PROPERTIES CXX_STANDARD 14 SUFFIX .elf
                          LINK_DEPENDS "${image_checks}")
    target_compile_options(hal_${name} PRIVATE ${HOUSE_WARNINGS})
    target_link_libraries(hal_${name} PRIVATE hal_avr)
    add_dependencies(hal_programs hal_${name})
endforeach()
include(on_chip_programs)
include(cost_programs)
include(mavlink_cost_program)
