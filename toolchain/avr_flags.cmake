# SPDX-License-Identifier: GPL-3.0-or-later
# How the image is compiled; what each flag gained stands in docs/measurements.md.
set(AVR_OPTIMISATION -Os -flto -mrelax -mcall-prologues -mstrict-X -fira-algorithm=priority -fno-tree-dominator-opts
    -fno-tree-pre -fno-ipa-sra -fno-partial-inlining)
add_compile_options(${AVR_OPTIMISATION})
# in one piece functions are laid and inlined better; the stack bound wants to know addresses
add_link_options(${AVR_OPTIMISATION} -flto-partition=one -Wl,--emit-relocs)
# what occurs again and again in it stands once (toolchain/outline)
set(outliner ${CMAKE_SOURCE_DIR}/toolchain/outline)
add_link_options(-B${outliner})
link_libraries(m)

# Float arithmetic of our own instead of the library's, in every program for the chip.
enable_language(ASM)
file(GLOB arithmetic CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/hal_avr/arithmetic/*.S
     ${CMAKE_SOURCE_DIR}/hal_avr/*.S)
set_source_files_properties(${arithmetic} PROPERTIES COMPILE_OPTIONS "-mmcu=atmega2560;-mrelax")
add_library(arithmetic OBJECT ${arithmetic})
link_libraries($<TARGET_OBJECTS:arithmetic>)

# The lines' rings first (hal_avr/lines.S), then everything else.
add_link_options(-Wl,--section-start=.lines=0x800200 -Wl,--section-start=.data=0x800382)

# What no control loop waits for is made small, not fast; what comes by wire as well, but for each
# of its bytes.
set(libraries ${CMAKE_SOURCE_DIR}/libraries)
file(GLOB_RECURSE unhurried CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/firmware/*.cpp)
file(GLOB bytewise CONFIGURE_DEPENDS ${libraries}/mavlink/*.cpp ${CMAKE_SOURCE_DIR}/firmware/telemetry/link.cpp
     ${CMAKE_SOURCE_DIR}/firmware/telemetry/telemetry.cpp ${CMAKE_SOURCE_DIR}/firmware/telemetry/incoming.cpp)
list(FILTER unhurried EXCLUDE REGEX
     "/firmware/(main|tasks|radio|outputs|estimator|attitude_control|sensors/.*)\\.cpp$")
file(GLOB unhurried_libraries CONFIGURE_DEPENDS ${libraries}/mission/*.cpp ${libraries}/storage/*.cpp
     ${libraries}/parameters/*.cpp ${libraries}/logging/*.cpp)
set_source_files_properties(${unhurried} ${unhurried_libraries}
    ${CMAKE_SOURCE_DIR}/firmware/sensors/battery.cpp PROPERTIES COMPILE_OPTIONS
    "-fno-inline-small-functions;-fno-gcse;-fno-move-loop-invariants")
set_source_files_properties(${bytewise} PROPERTIES COMPILE_OPTIONS -fno-inline-small-functions)
