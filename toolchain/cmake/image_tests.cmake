# SPDX-License-Identifier: GPL-3.0-or-later
# Programs on the emulated chip: the emulator itself, the hardware layer, costs, and the libraries'
# own tests compiled for it.
set(budgets ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json)

# ---- the images' sizes
foreach(board apm1 apm2)
    declare_test(image.budgets_${board} COMMAND node ${CMAKE_SOURCE_DIR}/toolchain/image/check_image.mjs
                 ${IMAGE_${board}} ${budgets} ${board} NEEDS ${IMAGE_${board}} LABELS image quick REUSE)
endforeach()

# ---- the emulator, by small programs that know nothing of the firmware
set(chip_programs ${CMAKE_BINARY_DIR}/chip_programs)
file(MAKE_DIRECTORY ${chip_programs})
file(GLOB programs CONFIGURE_DEPENDS ${tests}/chip/machine/programs/*.cpp)
file(GLOB headers CONFIGURE_DEPENDS ${tests}/chip/machine/programs/*.hpp)
set(built)
foreach(program IN LISTS programs)
    get_filename_component(file ${program} NAME_WE)
    set(elf ${chip_programs}/${file}.elf)
    add_custom_command(OUTPUT ${elf} ${chip_programs}/${file}.hex
        COMMAND ${AVR_GXX} -mmcu=atmega2560 -DF_CPU=16000000UL -std=c++14 -Os -Wall -Wextra
                -fno-exceptions -fno-threadsafe-statics -o ${elf} ${program}
        COMMAND ${AVR_OBJCOPY} -O ihex -R .eeprom ${elf} ${chip_programs}/${file}.hex
        DEPENDS ${program} ${headers} VERBATIM)
    list(APPEND built ${elf})
endforeach()
add_custom_target(machine_programs DEPENDS ${built})
gtest_program(machine_test ${tests}/chip/machine simulator_machine)
add_dependencies(machine_test machine_programs)
target_compile_definitions(machine_test PRIVATE CHIP_PROGRAMS="${chip_programs}")
gtest_run(machine_test NEEDS ${built} LABELS simavr)

# ---- the hardware layer of either board
# hal_elves(BOARD RESULT NAME...): the programs of that board
function(hal_elves board result)
    list(TRANSFORM ARGN REPLACE "(.+)" "${AVR_TREE}/${board}/hal_\\1.elf" OUTPUT_VARIABLE elves)
    set(${result} ${elves} PARENT_SCOPE)
endfunction()
file(GLOB names CONFIGURE_DEPENDS RELATIVE ${tests}/chip/hal_avr/programs ${tests}/chip/hal_avr/programs/*.cpp)
list(TRANSFORM names REPLACE "\\.cpp$" "")
hal_elves(apm2 elves ${names})
gtest_program(hal_avr_test ${tests}/chip/hal_avr simulator_machine)
target_compile_definitions(hal_avr_test PRIVATE CHIP_PROGRAMS="${AVR_TREE}/apm2"
    STACK_BOUND="${NODE} ${CMAKE_SOURCE_DIR}/toolchain/image/stack_bound.mjs" CHIP_BOARD=apm2)
gtest_run(hal_avr_test NEEDS ${elves} LABELS simavr)

hal_elves(apm1 elves pwm ppm watchdog)
gtest_program(hal_apm1_test ${tests}/chip/hal_avr/boards/apm1 simulator_machine)
target_sources(hal_apm1_test PRIVATE ${tests}/chip/hal_avr/pwm_test.cpp ${tests}/chip/hal_avr/ppm_test.cpp)
target_compile_definitions(hal_apm1_test PRIVATE CHIP_PROGRAMS="${AVR_TREE}/apm1"
                           IMAGE_APM1="${IMAGE_apm1}" CHIP_BOARD=apm1)
gtest_run(hal_apm1_test NEEDS ${elves} ${IMAGE_apm1} LABELS simavr)

# ---- what geodesy, the mission engine and the ground link take of the processor
project_program(costs ${tests}/chip/costs/costs.cpp LIBRARIES simulator_machine nlohmann_json::nlohmann_json)
function(cost_test name what)
    list(TRANSFORM ARGN REPLACE "(.+)" "${AVR_TREE}/apm2/cost_\\1.elf" OUTPUT_VARIABLE elves)
    declare_test(${name} COMMAND costs ${AVR_TREE}/apm2 ${budgets} ${what} NEEDS ${elves} LABELS simavr REUSE)
endfunction()
cost_test(on_board.costs mission geodesy mission)
cost_test(mavlink.costs link link)
cost_test(signing.costs signing signing)

# ---- the libraries' tests once more, on the emulated ATmega2560
project_program(run_on_chip ${tests}/chip/on_chip/run_on_chip.cpp LIBRARIES simulator_machine)
foreach(library core geo control estimation navigation storage parameters mission crypto mavlink
                floats std)
    set(elf ${AVR_TREE}/on_chip/on_chip_${library}.elf)
    declare_test(on_chip.${library} COMMAND run_on_chip ${elf} NEEDS ${elf} LABELS simavr REUSE)
endforeach()
set(elves ${AVR_TREE}/on_chip/on_chip_failing.elf ${AVR_TREE}/on_chip/on_chip_stopping.elf
    ${AVR_TREE}/on_chip/on_chip_stale.elf)
declare_test(on_chip.failing_checks_fail COMMAND node --test ${tests}/chip/on_chip/run_on_chip.test.mjs
             NEEDS run_on_chip ${elves} LABELS simavr ENVIRONMENT RUN_ON_CHIP=$<TARGET_FILE:run_on_chip>
             ON_CHIP_PROGRAMS=${AVR_TREE}/on_chip)
