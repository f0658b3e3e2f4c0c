# SPDX-License-Identifier: GPL-3.0-or-later
# The images of both boards, build/avr/apm1 and build/avr/apm2: firmware/ on hal_avr/ on
# libraries/. What does not know the board is compiled once.
find_program(NODE node REQUIRED)
set(boards apm1 apm2)

function(avr_objects name)
    add_library(${name} OBJECT ${ARGN})
    set_target_properties(${name} PROPERTIES CXX_STANDARD 14)
    target_compile_options(${name} PRIVATE ${PROJECT_WARNINGS})
endfunction()

# every program for the chip is linked again when a check of it changes
file(GLOB image_checks CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/image/*
     ${CMAKE_SOURCE_DIR}/toolchain/schedule/task_rows.mjs)

# avr_program(NAME BOARD FOLDER FILE SOURCE...): build/avr/FOLDER/FILE.elf
function(avr_program name board folder file)
    add_executable(${name} ${ARGN})
    set_target_properties(${name} PROPERTIES CXX_STANDARD 14 OUTPUT_NAME ${file} SUFFIX .elf
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${folder} LINK_DEPENDS "${image_checks}")
    target_compile_options(${name} PRIVATE ${PROJECT_WARNINGS})
    target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/hal_avr
                               ${CMAKE_SOURCE_DIR}/hal_avr/boards/${board})
endfunction()

foreach(board IN LISTS boards)
    file(GLOB hal_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/*.cpp
         ${CMAKE_SOURCE_DIR}/hal_avr/boards/${board}/*.cpp)
    set(headers ${CMAKE_SOURCE_DIR}/hal_avr ${CMAKE_SOURCE_DIR}/hal_avr/boards/${board})
    avr_objects(hal_objects_${board} ${hal_sources})
    target_include_directories(hal_objects_${board} PRIVATE ${headers})
    target_link_libraries(hal_objects_${board} PRIVATE core hal)
    # as a library, for programs that need a part of it
    add_library(hal_${board} STATIC $<TARGET_OBJECTS:hal_objects_${board}>)
    target_include_directories(hal_${board} PUBLIC ${headers})
    target_link_libraries(hal_${board} PUBLIC core hal)

    avr_objects(firmware_on_${board} ${board_sources})
    target_include_directories(firmware_on_${board} PRIVATE ${CMAKE_SOURCE_DIR} ${headers})
    target_link_libraries(firmware_on_${board} PRIVATE ${all_libraries})

    # everything but main()
    add_library(firmware_parts_${board} INTERFACE)
    target_sources(firmware_parts_${board} INTERFACE $<TARGET_OBJECTS:firmware_any_board>
        $<TARGET_OBJECTS:firmware_on_${board}> $<TARGET_OBJECTS:hal_objects_${board}>)
    target_link_libraries(firmware_parts_${board} INTERFACE ${all_libraries})

    # the board's self-test, a program of its own (toolchain/self_test)
    file(GLOB self_test_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/self_test/*.cpp)
    avr_program(self_test_${board} ${board} ${board} self_test ${self_test_sources})
    target_link_libraries(self_test_${board} PRIVATE hal_${board} ${all_libraries})
    add_custom_command(TARGET self_test_${board} POST_BUILD VERBATIM
        COMMAND ${CMAKE_OBJCOPY} -O ihex -R .eeprom $<TARGET_FILE:self_test_${board}>
                ${CMAKE_BINARY_DIR}/${board}/self_test.hex)

    # linked twice: the first image says which function calls which, and the linker's script made of it
    # places them so that most calls are short
    avr_objects(firmware_main_${board} ${CMAKE_SOURCE_DIR}/firmware/app/main.cpp)
    target_include_directories(firmware_main_${board} PRIVATE ${CMAKE_SOURCE_DIR} ${headers})
    target_link_libraries(firmware_main_${board} PRIVATE ${all_libraries})
    set(folder ${CMAKE_BINARY_DIR}/${board})
    set(script ${folder}/placed.ld)
    foreach(name firmware_unplaced firmware)
        avr_program(${name}_${board} ${board} ${board} ${name} $<TARGET_OBJECTS:firmware_main_${board}>)
        target_link_libraries(${name}_${board} PRIVATE firmware_parts_${board})
    endforeach()
    set_target_properties(firmware_unplaced_${board} PROPERTIES EXCLUDE_FROM_ALL ON)
    target_link_options(firmware_unplaced_${board} PRIVATE -Wl,-Map=${folder}/firmware_unplaced.map)
    add_custom_command(OUTPUT ${script}
        COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/image/link_script.mjs
                $<TARGET_FILE:firmware_unplaced_${board}> ${folder}/firmware_unplaced.map ${script}
        DEPENDS firmware_unplaced_${board} ${image_checks} VERBATIM)
    add_custom_target(firmware_script_${board} DEPENDS ${script})
    add_dependencies(firmware_${board} firmware_script_${board})
    target_link_options(firmware_${board} PRIVATE -T ${script})
    set_property(TARGET firmware_${board} APPEND PROPERTY LINK_DEPENDS ${script})
    add_custom_command(TARGET firmware_${board} POST_BUILD
        COMMAND ${CMAKE_OBJCOPY} -O ihex -R .eeprom $<TARGET_FILE:firmware_${board}> ${folder}/firmware.hex
        COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/image/blank_eeprom.mjs ${folder}/firmware.eep
        COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/schedule/task_rows.mjs
                ${CMAKE_SOURCE_DIR}/firmware/app/tasks.cpp ${folder}/tasks.json
        COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/image/check_image.mjs
                $<TARGET_FILE:firmware_${board}> ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json ${board}
        VERBATIM)
endforeach()
