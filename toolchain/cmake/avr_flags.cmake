# SPDX-License-Identifier: GPL-3.0-or-later
# How the image is compiled; docs/measurements.md has the table of what was tried. -g costs the chip
# nothing: debug information stays in the ELF file. -mstrict-X: the register X, which has no offsets, is
# not stepped to and fro for fields of a struct. The others after it: what is kept in registers over
# more of a function, because it is used there again, costs more moves and places in the stack frame
# than it saves. What is inlined before link time stays in all who use it, so little is; 14 instructions
# are the compiler's own limit.
set(AVR_OPTIMISATION -Os -flto -mrelax -mcall-prologues -mstrict-X -fira-algorithm=priority -fno-gcse
    -fno-tree-pre -fno-signed-zeros -fno-tree-ch -fno-tree-dominator-opts -fno-tree-loop-ivcanon -fno-tree-loop-im
    -fno-move-loop-invariants --param early-inlining-insns=3 -fno-ipa-sra -fira-region=all -g)
add_compile_options(${AVR_OPTIMISATION})
# toolchain/image/stack_bound.mjs sees by its relocation that a word is a function's address
add_link_options(${AVR_OPTIMISATION} -flto-partition=one -Wl,--emit-relocs)

# What runs at interrupts is made quick, and of what runs in a frame those files where that gains most
# for its flash, by measurement: docs/measurements.md.
file(GLOB quick CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/*.cpp
     ${CMAKE_SOURCE_DIR}/hal_avr/boards/*/*.cpp)
set(quick_in_firmware actuators/flaps actuators/outputs app/dataflash app/main app/tasks
    gcs/link logger/log safety/restart sensors/barometer
    sensors/compass sensors/inertial)
set(quick_in_libraries control/axis drivers/hmc5883l drivers/ms5611_compensation geo/position)
foreach(folder firmware libraries)
    foreach(source IN LISTS quick_in_${folder})
        set(path ${CMAKE_SOURCE_DIR}/${folder}/${source}.cpp)
        if(NOT EXISTS ${path})
            message(FATAL_ERROR "${path} is no file: name those to be made quick as they are named now")
        endif()
        list(APPEND quick ${path})
    endforeach()
endforeach()
set_source_files_properties(${quick} PROPERTIES COMPILE_OPTIONS "-O2;-fgcse;-ftree-dominator-opts;--param;early-inlining-insns=10")

# What runs seldom is made small: docs/measurements.md.
set(small)
foreach(folder firmware/gcs firmware/logger firmware/mission firmware/modes firmware/notify firmware/safety
        libraries/logging libraries/mission libraries/parameters libraries/storage)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
    list(APPEND small ${sources})
endforeach()
list(REMOVE_ITEM small ${quick})
set_source_files_properties(${small} PROPERTIES COMPILE_OPTIONS "-fno-inline-small-functions;-fno-guess-branch-probability")

link_libraries(m)

# Float arithmetic of our own instead of the library's, in every program for the chip.
enable_language(ASM)
file(GLOB arithmetic CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/arithmetic/*.S)
set_source_files_properties(${arithmetic} PROPERTIES COMPILE_OPTIONS "-mmcu=atmega2560;-mrelax")
add_library(arithmetic OBJECT ${arithmetic})
link_libraries($<TARGET_OBJECTS:arithmetic>)
