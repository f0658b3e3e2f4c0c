# SPDX-License-Identifier: GPL-3.0-or-later
# The running vehicle, natively compiled and as the image on the emulated chip, with programs that
# are not ours: a MAVLink client (npm node-mavlink, see toolchain/node) and an external flight model.

# vehicle_test(NAME VEHICLE FILE [NEEDS TARGET...] [ENVIRONMENT A=B...]): VEHICLE is native or elf
function(vehicle_test name vehicle file)
    cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "NEEDS;ENVIRONMENT")
    set(more LABELS native)
    set(counted ${native_minutes})
    if("${vehicle}" STREQUAL "elf")  # quoted: elf is a variable, too
        list(APPEND arg_NEEDS ${IMAGE_apm2})
        set(counted ${minutes})
        set(more LABELS simavr AFTER image_minutes)
    endif()
    declare_test(${name}.${vehicle} COMMAND node --test ${file} NEEDS fly ${arg_NEEDS} ${more}
                 DATA ${flight_data} ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json REUSE
                 ENVIRONMENT FLY=$<TARGET_FILE:fly> FLY_BOARD=${vehicle}
                 MINUTES=${counted}/${name} ${arg_ENVIRONMENT})
endfunction()

file(GLOB ground_tests CONFIGURE_DEPENDS ${tests}/interop/ground/*.test.mjs)
project_program(example_peer ${tests}/interop/fdm/example_peer.cpp LIBRARIES simulator_world)
foreach(vehicle native elf)
    foreach(file IN LISTS ground_tests)
        get_filename_component(subject ${file} NAME)
        string(REPLACE ".test.mjs" "" subject ${subject})
        vehicle_test(ground.${subject} ${vehicle} ${file})
    endforeach()
    vehicle_test(fdm.flight ${vehicle} ${tests}/interop/fdm/flight.test.mjs NEEDS example_peer
                 ENVIRONMENT PEER=$<TARGET_FILE:example_peer>)
    vehicle_test(live.page ${vehicle} ${tests}/interop/live/live.test.mjs)
    # an EEPROM image that the tool has made
    vehicle_test(param_tool.boots_a_compiled_image ${vehicle} ${tests}/scenarios/parameter_image.test.mjs
                 NEEDS param_tool ENVIRONMENT PARAM_TOOL=$<TARGET_FILE:param_tool>)
endforeach()

# toolchain/bench against the simulated board: sessions in lock step with scripted hands, and the
# program itself over TCP.
set(bench_data ${flight_data} ${tests}/support/bench_rig.mjs ${tests}/support/bench_person.mjs)
file(GLOB_RECURSE bench_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/bench_tool/*.mjs)
declare_test(bench.native COMMAND node --test ${tests}/interop/bench/native.test.mjs NEEDS fly LABELS native
             DATA ${bench_data} ${bench_sources} REUSE
             ENVIRONMENT FLY=$<TARGET_FILE:fly> FLY_BOARD=native MINUTES=${native_minutes}/bench.native)
declare_test(bench.program COMMAND node --test ${tests}/interop/bench/program.test.mjs NEEDS fly LABELS native
             DATA ${bench_data} ${bench_sources} REUSE ENVIRONMENT FLY=$<TARGET_FILE:fly>)
declare_test(bench.image COMMAND node --test ${tests}/interop/bench/image.test.mjs
             NEEDS fly ${IMAGE_apm2} ${IMAGE_apm1} LABELS simavr AFTER image_minutes
             DATA ${bench_data} ${bench_sources} REUSE
             ENVIRONMENT FLY=$<TARGET_FILE:fly> FLY_BOARD=elf MINUTES=${minutes}/bench.image
             OTHER_IMAGE=${IMAGE_apm1})
file(GLOB self_test_tool CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/toolchain/self_test_tool/*.mjs)
declare_test(bench.self_test COMMAND node --test ${tests}/interop/bench/self_test.test.mjs
             NEEDS fly ${AVR_TREE}/apm1/self_test.elf ${AVR_TREE}/apm2/self_test.elf LABELS simavr
             DATA ${bench_data} ${self_test_tool} REUSE ENVIRONMENT FLY=$<TARGET_FILE:fly>
             SELF_TEST_apm1=${AVR_TREE}/apm1/self_test.elf SELF_TEST_apm2=${AVR_TREE}/apm2/self_test.elf)
# bench_session(BOARD SUFFIX WORD...): a whole session and its form; WORD: more for declare_test()
function(bench_session board suffix)
    set(form bench_form${suffix})
    set(environment FLY=$<TARGET_FILE:fly> FLY_BOARD=elf BOARD=${board} FORM=${CMAKE_BINARY_DIR}/${form}
        IMAGE_APM1=${IMAGE_apm1} IMAGE_APM2=${IMAGE_apm2} SELF_TEST=${AVR_TREE}/${board}/self_test.elf)
    if(NOT long IN_LIST ARGN)  # their minutes are counted
        list(APPEND environment MINUTES=${minutes}/bench.session)
    endif()
    declare_test(bench.session${suffix} COMMAND node --test ${tests}/interop/bench/session.test.mjs
                 NEEDS fly ${IMAGE_apm2} ${IMAGE_apm1} ${AVR_TREE}/${board}/self_test.elf LABELS simavr
                 AFTER image_minutes SETUP ${form} TIMEOUT 1800 DATA ${bench_data} ${bench_sources} ${self_test_tool} ENVIRONMENT ${environment} ${ARGN})
    if(CHROMIUM)
        declare_test(bench.form${suffix} COMMAND node --test ${tests}/interop/bench/form.test.mjs AFTER ${form}
                     LABELS simavr ENVIRONMENT CHROMIUM=${CHROMIUM} FORM=${CMAKE_BINARY_DIR}/${form} ${ARGN})
    endif()
endfunction()
bench_session(apm2 "")
bench_session(apm1 _apm1 ONLY long)
