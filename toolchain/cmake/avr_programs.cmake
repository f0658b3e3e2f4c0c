# SPDX-License-Identifier: GPL-3.0-or-later
# Programs for the chip that tests run on the emulated one: the hardware layer alone (hal_programs),
# whose cost is held to its limits (cost_programs), and the libraries' own tests (on_chip_programs).
set(tests ${CMAKE_SOURCE_DIR}/host_tests)

# ---- the hardware layer; of the first board what differs
add_custom_target(hal_programs)
function(hal_program board name)
    avr_program(hal_${name}_${board} ${board} ${board} hal_${name} ${tests}/chip/hal_avr/programs/${name}.cpp)
    target_link_libraries(hal_${name}_${board} PRIVATE hal_${board})
    set_target_properties(hal_${name}_${board} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(hal_programs hal_${name}_${board})
endfunction()
file(GLOB programs CONFIGURE_DEPENDS ${tests}/chip/hal_avr/programs/*.cpp)
foreach(program IN LISTS programs)
    get_filename_component(name ${program} NAME_WE)
    hal_program(apm2 ${name})
endforeach()
foreach(name pwm ppm watchdog)
    hal_program(apm1 ${name})
endforeach()

# ---- costs in cycles
add_custom_target(cost_programs)
function(cost_program name)
    avr_program(cost_${name} apm2 apm2 cost_${name} ${tests}/chip/costs/programs/${name}.cpp)
    target_link_libraries(cost_${name} PRIVATE ${ARGN})
    set_target_properties(cost_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(cost_programs cost_${name})
endfunction()
cost_program(geodesy hal_apm2 geo)
cost_program(mission firmware_parts_apm2)
cost_program(link firmware_parts_apm2)
cost_program(signing firmware_parts_apm2)

# ---- on_chip_program(LIBRARY TEST...): the library's tests, compiled like the firmware.
# GoogleTest's macros and the little of the standard library that tests use are in
# host_tests/chip/on_chip; variables and heap lie in external memory, see run_on_chip.cpp there.
set(on_chip ${tests}/chip/on_chip)
set(fakes clock eeprom memory page_flash power)
list(TRANSFORM fakes REPLACE "(.+)" "${tests}/support/fakes/\\1.cpp")
add_library(on_chip_fakes OBJECT EXCLUDE_FROM_ALL ${on_chip}/fakes/fakes.cpp ${fakes})
set_target_properties(on_chip_fakes PROPERTIES CXX_STANDARD 14)
target_compile_options(on_chip_fakes PRIVATE ${PROJECT_WARNINGS})
target_include_directories(on_chip_fakes BEFORE PRIVATE ${on_chip} ${on_chip}/std ${tests}/support)
target_link_libraries(on_chip_fakes PRIVATE core hal)
add_custom_target(on_chip_programs)

function(on_chip_program library)
    set(folder ${tests}/unit/libraries/${library})
    if(NOT TARGET ${library})  # a program that tests the harness itself
        set(folder ${on_chip}/self)
    endif()
    list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE sources)
    add_executable(on_chip_${library} EXCLUDE_FROM_ALL ${sources} ${on_chip}/harness.cpp
        $<TARGET_OBJECTS:on_chip_fakes>)
    set(left_out ${on_chip}/left_out/${library}.hpp)
    if(NOT EXISTS ${left_out})
        set(left_out ${on_chip}/left_out/none.hpp)
    endif()
    set_target_properties(on_chip_${library} PROPERTIES CXX_STANDARD 14 SUFFIX .elf
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/on_chip LINK_DEPENDS "${image_checks}")
    # a test compares int with uint16_t, which is harmless on the host
    target_compile_options(on_chip_${library} PRIVATE ${PROJECT_WARNINGS} -Wno-sign-compare)
    target_compile_definitions(on_chip_${library} PRIVATE ON_CHIP_LEFT_OUT="${left_out}")
    target_include_directories(on_chip_${library} BEFORE PRIVATE ${on_chip} ${on_chip}/std ${tests}/support)
    target_link_options(on_chip_${library} PRIVATE -Wl,--section-start=.data=0x802200
        -Wl,--defsym=__DATA_REGION_LENGTH__=0xffa0 -Wl,--defsym=__heap_end=0x80ffff
        -Wl,--defsym=__stack=0x8021ff)
    if(TARGET ${library})
        target_link_libraries(on_chip_${library} PRIVATE ${library})
    endif()
    target_link_libraries(on_chip_${library} PRIVATE core hal)
    add_dependencies(on_chip_programs on_chip_${library})
endfunction()

# new tests of a library join here; what takes too long is named in on_chip/left_out
on_chip_program(core crc_test.cpp maths_test.cpp ring_test.cpp)
on_chip_program(geo position_test.cpp)
on_chip_program(control attitude_test.cpp mixing_test.cpp speed_height_test.cpp)
on_chip_program(navigation l1_test.cpp landing_test.cpp slope_test.cpp takeoff_test.cpp)
on_chip_program(parameters store_test.cpp)
on_chip_program(mission record_test.cpp sequencer_test.cpp)
on_chip_program(storage index_store_test.cpp journal_test.cpp mission_store_test.cpp owner_test.cpp)
on_chip_program(crypto sha256_test.cpp)
on_chip_program(mavlink frame_test.cpp parser_test.cpp)
on_chip_program(estimation atan2_table_test.cpp atmosphere_test.cpp attitude_test.cpp height_test.cpp position_test.cpp
                gyro_bias_init_test.cpp wind_test.cpp)

on_chip_program(floats floats_test.cpp)
on_chip_program(std std_test.cpp)
on_chip_program(failing failing_test.cpp)
on_chip_program(stopping stopping_test.cpp)
on_chip_program(stale stale_test.cpp)
