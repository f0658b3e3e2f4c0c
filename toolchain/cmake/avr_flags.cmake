# SPDX-License-Identifier: GPL-3.0-or-later
# How the image is compiled; docs/measurements.md has the table of what was tried. -g costs the chip
# nothing: debug information stays in the ELF file. -mstrict-X: the register X, which has no offsets, is
# not stepped to and fro for fields of a struct.
set(AVR_OPTIMISATION -Os -flto -mrelax -mcall-prologues -mstrict-X -g)
add_compile_options(${AVR_OPTIMISATION})
# toolchain/image/stack_bound.mjs sees by its relocation that a word is a function's address
add_link_options(${AVR_OPTIMISATION} -Wl,--emit-relocs)

# What runs in every frame and at every interrupt is made quick: these folders, not those in them.
set(every_frame_folders firmware/app firmware/sensors firmware/estimator firmware/control
    firmware/actuators hal_avr hal_avr/boards/*)
list(TRANSFORM every_frame_folders PREPEND ${CMAKE_SOURCE_DIR}/)
list(TRANSFORM every_frame_folders APPEND /*.cpp)
file(GLOB every_frame CONFIGURE_DEPENDS ${every_frame_folders})
# Of the ground link only what every byte and every message passes: replies to requests are seldom.
foreach(source incoming link streams telemetry flight_messages)
    list(APPEND every_frame ${CMAKE_SOURCE_DIR}/firmware/gcs/${source}.cpp)
endforeach()
# And of the libraries what is worked out 25 to 100 times a second, as far as flash allows.
foreach(source estimation/height estimation/position control/axis)
    list(APPEND every_frame ${CMAKE_SOURCE_DIR}/libraries/${source}.cpp)
endforeach()
set_source_files_properties(${every_frame} PROPERTIES COMPILE_OPTIONS -O2)

link_libraries(m)

# Float arithmetic of our own instead of the library's, in every program for the chip.
enable_language(ASM)
file(GLOB arithmetic CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/arithmetic/*.S)
set_source_files_properties(${arithmetic} PROPERTIES COMPILE_OPTIONS "-mmcu=atmega2560;-mrelax")
add_library(arithmetic OBJECT ${arithmetic})
link_libraries($<TARGET_OBJECTS:arithmetic>)
