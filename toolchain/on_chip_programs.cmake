# SPDX-License-Identifier: GPL-3.0-or-later
# on_chip_program(LIBRARY TEST...): the library's tests as a program for the chip, compiled like
# the firmware. GoogleTest's words and the little of the standard library that tests use are in
# host_tests/on_chip; variables and heap lie in external memory, see run_on_chip.cpp there.
set(on_chip ${CMAKE_SOURCE_DIR}/host_tests/on_chip)
set(fakes ${CMAKE_SOURCE_DIR}/host_tests/fakes)
add_custom_target(on_chip_programs)

function(on_chip_program library)
    set(folder ${CMAKE_SOURCE_DIR}/host_tests/${library})
    if(NOT TARGET ${library})  # a program that tries the tests' own tools
        set(folder ${on_chip}/self)
    endif()
    list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE tests)
    add_executable(on_chip_${library} EXCLUDE_FROM_ALL ${tests} ${on_chip}/harness.cpp
        ${on_chip}/fakes/fakes.cpp ${fakes}/clock.cpp ${fakes}/eeprom.cpp ${fakes}/memory.cpp
        ${fakes}/page_flash.cpp ${fakes}/power.cpp)
    set(left_out ${on_chip}/left_out/${library}.hpp)
    if(NOT EXISTS ${left_out})
        set(left_out ${on_chip}/left_out/none.hpp)
    endif()
    set_target_properties(on_chip_${library} PROPERTIES CXX_STANDARD 14 SUFFIX .elf LINK_DEPENDS "${image_checks}")
    # a test compares what it likes: int with uint16_t is harmless on the host
    target_compile_options(on_chip_${library} PRIVATE ${HOUSE_WARNINGS} -Wno-sign-compare)
    target_compile_definitions(on_chip_${library} PRIVATE ON_CHIP_LEFT_OUT="${left_out}")
    target_include_directories(on_chip_${library} BEFORE PRIVATE ${on_chip} ${on_chip}/std
                               ${CMAKE_SOURCE_DIR}/host_tests ${folder})
    target_link_options(on_chip_${library} PRIVATE -Wl,--section-start=.data=0x802200 -Wl,--defsym=__DATA_REGION_LENGTH__=0xffa0
                        -Wl,--defsym=__heap_end=0x80ffff -Wl,--defsym=__stack=0x8021ff)
    if(TARGET ${library})
        target_link_libraries(on_chip_${library} PRIVATE ${library})
    endif()
    target_link_libraries(on_chip_${library} PRIVATE core hal)
    add_dependencies(on_chip_programs on_chip_${library})
endfunction()

# new tests of a library join here; what takes too long is named in on_chip/left_out
on_chip_program(core crc_test.cpp ring_test.cpp)
on_chip_program(geo edges_test.cpp)
on_chip_program(control attitude_test.cpp mixing_test.cpp speed_height_test.cpp)
on_chip_program(navigation l1_test.cpp vertical_test.cpp)
on_chip_program(scheduler scheduler_test.cpp)
on_chip_program(parameters store_test.cpp)
on_chip_program(mission record_test.cpp sequencer_test.cpp)
on_chip_program(storage index_and_owner_test.cpp journal_test.cpp mission_store_test.cpp)
on_chip_program(mavlink frame_test.cpp parser_test.cpp)
on_chip_program(estimation attitude_test.cpp height_test.cpp position_test.cpp wind_test.cpp)

on_chip_program(floats floats_test.cpp)
on_chip_program(std std_test.cpp)
on_chip_program(failing failing_test.cpp)
on_chip_program(stopping stopping_test.cpp)
on_chip_program(stale stale_test.cpp)
