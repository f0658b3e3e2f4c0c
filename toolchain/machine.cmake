# SPDX-License-Identifier: GPL-3.0-or-later
# The emulated chip and board, and the small AVR programs their tests run.
pkg_check_modules(LIBELF REQUIRED IMPORTED_TARGET libelf)

file(GLOB machine_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/machine/*.cpp)
add_library(simulator_machine STATIC ${machine_sources})
target_compile_options(simulator_machine PRIVATE ${HOUSE_WARNINGS})
target_include_directories(simulator_machine PUBLIC ${CMAKE_SOURCE_DIR}
                           ${CMAKE_SOURCE_DIR}/libraries)
target_link_libraries(simulator_machine PUBLIC simulator_world PkgConfig::SIMAVR
                      PRIVATE PkgConfig::LIBELF)

# What every reset of a board begins with, in place of its bootloader.
find_program(AVR_GXX avr-g++ REQUIRED)
set(boot_sections ${CMAKE_CURRENT_BINARY_DIR}/boot)
file(MAKE_DIRECTORY ${boot_sections})
foreach(board apm1 apm2)
    set(source ${CMAKE_SOURCE_DIR}/simulator/machine/boot/${board}.cpp)
    add_custom_command(OUTPUT ${boot_sections}/${board}.elf
        COMMAND ${AVR_GXX} -mmcu=atmega2560 -DF_CPU=16000000UL -std=c++14 -Os -Wall -Wextra -Werror
                -nostdlib -Wl,--section-start=.text=0x3e000 -I${CMAKE_SOURCE_DIR}
                -o ${boot_sections}/${board}.elf ${source}
        DEPENDS ${source} ${CMAKE_SOURCE_DIR}/simulator/machine/boot/boot.hpp VERBATIM)
    list(APPEND boot_programs ${boot_sections}/${board}.elf)
endforeach()
add_custom_target(boot_programs DEPENDS ${boot_programs})
add_dependencies(simulator_machine boot_programs)
target_compile_definitions(simulator_machine PUBLIC SIMULATOR_BOOT="${boot_sections}")

# chip_programs(TARGET FOLDER): every program of the folder as FOLDER's name/x.elf and x.hex in the
# build directory, built before TARGET.
find_program(AVR_OBJCOPY avr-objcopy REQUIRED)
function(chip_programs target folder)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/chip_programs)
    file(MAKE_DIRECTORY ${out})
    file(GLOB programs CONFIGURE_DEPENDS ${folder}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${folder}/*.hpp)
    foreach(program IN LISTS programs)
        get_filename_component(name ${program} NAME_WE)
        add_custom_command(OUTPUT ${out}/${name}.elf ${out}/${name}.hex
            COMMAND ${AVR_GXX} -mmcu=atmega2560 -DF_CPU=16000000UL -std=c++14 -Os -Wall -Wextra
                    -Werror -fno-exceptions -fno-threadsafe-statics -o ${out}/${name}.elf ${program}
            COMMAND ${AVR_OBJCOPY} -O ihex -R .eeprom ${out}/${name}.elf ${out}/${name}.hex
            DEPENDS ${program} ${headers} VERBATIM)
        list(APPEND elves ${out}/${name}.elf)
    endforeach()
    add_custom_target(${target}_programs DEPENDS ${elves})
    add_dependencies(${target} ${target}_programs)
    target_compile_definitions(${target} PRIVATE CHIP_PROGRAMS="${out}")
endfunction()

house_test(machine_test ${CMAKE_SOURCE_DIR}/host_tests/machine simulator_machine)
if(TARGET machine_test)
    chip_programs(machine_test ${CMAKE_SOURCE_DIR}/host_tests/machine/programs)
endif()
