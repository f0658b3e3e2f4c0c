# SPDX-License-Identifier: GPL-3.0-or-later
# How the image is compiled; what each flag gained stands in docs/measurements.md.
set(AVR_OPTIMISATION -Os -flto -mrelax -mcall-prologues -mstrict-X -fno-gcse
    -fno-move-loop-invariants)
add_compile_options(${AVR_OPTIMISATION})
# in one piece functions are laid and inlined better; the stack bound wants to know addresses
add_link_options(${AVR_OPTIMISATION} -flto-partition=one -Wl,--emit-relocs)
link_libraries(m)

# Float arithmetic of our own instead of the library's, in every program for the chip.
enable_language(ASM)
file(GLOB arithmetic CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/arithmetic/*.S)
set_source_files_properties(${arithmetic} PROPERTIES COMPILE_OPTIONS "-mmcu=atmega2560;-mrelax")
add_library(arithmetic OBJECT ${arithmetic})
link_libraries($<TARGET_OBJECTS:arithmetic>)

# What no control loop waits for is made small, not fast.
set(firmware ${CMAKE_SOURCE_DIR}/firmware)
set(libraries ${CMAKE_SOURCE_DIR}/libraries)
file(GLOB unhurried CONFIGURE_DEPENDS ${firmware}/telemetry/*.cpp ${firmware}/mission/*.cpp
     ${firmware}/modes/*.cpp ${firmware}/modes.cpp ${firmware}/arming.cpp ${firmware}/home.cpp
     ${firmware}/lights.cpp ${firmware}/failsafe.cpp ${firmware}/parameters.cpp
     ${firmware}/sensors/battery.cpp ${libraries}/mission/*.cpp ${libraries}/storage/*.cpp
     ${libraries}/parameters/*.cpp ${libraries}/mavlink/*.cpp)
set_source_files_properties(${unhurried} PROPERTIES COMPILE_OPTIONS -fno-inline-small-functions)
