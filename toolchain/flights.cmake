# SPDX-License-Identifier: GPL-3.0-or-later
# Whole flights as tests: the image on the emulated board and the same firmware natively, in calm
# air and in wind with gusts, three seeds each, with limits.
add_executable(flight host_tests/on_board/flight.cpp)
target_compile_options(flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(flight PRIVATE nlohmann_json::nlohmann_json)

set(flights ${CMAKE_BINARY_DIR}/flights)
set(minutes ${CMAKE_BINARY_DIR}/flights/minutes)

# flight_test(NAME LABEL CROSSTRACK_M ALTITUDE_M TOUCHDOWN_M ARGUMENT...)
function(flight_test name label crosstrack_m altitude_m touchdown_m)
    set(counted ${flights}/native_minutes)
    if(label STREQUAL simavr)
        set(counted ${minutes})
    endif()
    add_test(NAME flight.${name}
             COMMAND flight fly ${flights}/${name} ${counted} ${crosstrack_m} ${altitude_m}
                     ${touchdown_m} $<TARGET_FILE:fly> ${ARGN})
    set_tests_properties(flight.${name} PROPERTIES LABELS ${label} TIMEOUT 900
                         FIXTURES_SETUP ${name})
    if(label STREQUAL simavr)
        set_tests_properties(flight.${name} PROPERTIES FIXTURES_REQUIRED image_minutes)
    endif()
endfunction()

set(windy --wind 5,320 --gusts)
include(first_board)
foreach(seed 1 2 3)
    set(wiring)
    if(seed EQUAL 2)  # one flight of three on the factory's wiring
        set(wiring --telemetry uart0)
    endif()
    flight_test(elf_calm_${seed} simavr 3 2 30 --seed ${seed} ${wiring})
    flight_test(elf_wind_${seed} simavr 5 3 60 --seed ${seed} ${windy} ${wiring})
    flight_test(native_calm_${seed} native 3 2 30 --native --seed ${seed} ${wiring})
    flight_test(native_wind_${seed} native 5 3 60 --native --seed ${seed} ${windy} ${wiring})
    foreach(air calm wind)
        add_test(NAME flight.same_events_${air}_${seed}
                 COMMAND flight same ${flights}/elf_${air}_${seed}/summary.json
                         ${flights}/native_${air}_${seed}/summary.json)
        set_tests_properties(flight.same_events_${air}_${seed} PROPERTIES LABELS simavr
                             FIXTURES_REQUIRED "elf_${air}_${seed};native_${air}_${seed}")
    endforeach()
endforeach()

# what a quiet mission never shows
add_executable(rough_flight host_tests/on_board/rough_flight.cpp)
target_compile_options(rough_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(rough_flight PRIVATE simulator_report simulator_ground simulator_machine)
add_test(NAME flight.elf_rough
         COMMAND rough_flight ${IMAGE_ELF} ${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints
                 ${flights}/elf_rough ${minutes})
set_tests_properties(flight.elf_rough PROPERTIES LABELS simavr TIMEOUT 900
                     FIXTURES_SETUP elf_rough FIXTURES_REQUIRED image_minutes)

# every mode, entered by the switch, in wind
add_executable(modes_flight host_tests/on_board/modes_flight.cpp)
target_compile_options(modes_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(modes_flight PRIVATE firmware_native simulator_native simulator_report
                      simulator_ground simulator_machine simulator_world)
set(first_flight ${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints)
add_test(NAME flight.native_modes COMMAND modes_flight native ${first_flight}
         ${flights}/native_modes 32 ${flights}/native_minutes)
add_test(NAME flight.elf_modes COMMAND modes_flight ${IMAGE_ELF} ${first_flight}
         ${flights}/elf_modes 15 ${minutes})
set_tests_properties(flight.native_modes PROPERTIES LABELS native TIMEOUT 900)
set_tests_properties(flight.elf_modes PROPERTIES LABELS simavr TIMEOUT 900
                     FIXTURES_SETUP elf_modes FIXTURES_REQUIRED image_minutes)

# every transition of the failsafes, by its cause
add_executable(failsafe_flight host_tests/on_board/failsafe_flight.cpp)
target_compile_options(failsafe_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(failsafe_flight PRIVATE firmware_native simulator_native simulator_report
                      simulator_ground simulator_machine simulator_world)
add_test(NAME flight.native_failsafes COMMAND failsafe_flight native ${first_flight}
         ${flights}/native_failsafes ${flights}/native_minutes)
add_test(NAME flight.elf_failsafes COMMAND failsafe_flight ${IMAGE_ELF} ${first_flight}
         ${flights}/elf_failsafes ${minutes})
set_tests_properties(flight.native_failsafes PROPERTIES LABELS native TIMEOUT 900)
set_tests_properties(flight.elf_failsafes PROPERTIES LABELS simavr TIMEOUT 900
                     FIXTURES_SETUP elf_failsafes FIXTURES_REQUIRED image_minutes)

# what stands beyond the sets' documents
add_executable(beyond_flight host_tests/command_flights/beyond/beyond_flight.cpp)
target_compile_options(beyond_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(beyond_flight PRIVATE firmware_native simulator_native simulator_ground
                      simulator_world)
add_test(NAME flight.native_beyond
         COMMAND beyond_flight ${CMAKE_SOURCE_DIR}/simulator/missions/beyond.waypoints
                 ${flights}/native_minutes)
set_tests_properties(flight.native_beyond PROPERTIES LABELS native TIMEOUT 300)

# sensors that fail, each in every way and every two of them; a sample on the image
add_executable(fault_flight host_tests/on_board/fault_flight.cpp)
target_compile_options(fault_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(fault_flight PRIVATE firmware_native simulator_native simulator_ground
                      simulator_machine simulator_world)
foreach(what singles pairs)
    add_test(NAME flight.native_fault_${what} COMMAND fault_flight native ${first_flight} ${what})
    set_tests_properties(flight.native_fault_${what} PROPERTIES LABELS native TIMEOUT 1800)
endforeach()
function(elf_fault board image fault)
    string(REPLACE ":" "_" name flight.elf_fault_${board}_${fault})
    add_test(NAME ${name} COMMAND fault_flight ${board} ${image} ${first_flight} ${minutes} ${fault})
    set_tests_properties(${name} PROPERTIES LABELS simavr TIMEOUT 900
                         FIXTURES_REQUIRED image_minutes)
endfunction()
foreach(fault gps:lost baro:nonsense imu:lost)
    elf_fault(apm2 ${IMAGE_ELF} ${fault})
endforeach()
foreach(fault imu:stuck baro:lost)  # other sensors, other drivers
    elf_fault(apm1 ${IMAGE_APM1_ELF} ${fault})
endforeach()

# gains learnt in the air, on an airplane whose own are near the defaults and on one far from them
add_executable(autotune_flight host_tests/on_board/autotune_flight.cpp
               simulator/parameter_file.cpp toolchain/param_tool/settings.cpp
               toolchain/mission_tool/wrong_input.cpp)
target_compile_options(autotune_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(autotune_flight PRIVATE firmware_native simulator_native simulator_ground
                      simulator_world)
function(autotune_test airplane roll_p pitch_p)
    foreach(times 0.4 1 2.5)
        set(name flight.native_autotune_${airplane}_${times})
        add_test(NAME ${name} COMMAND autotune_flight ${airplane} ${first_flight} ${times} ${roll_p}
                 ${pitch_p} ${ARGN})
        set_tests_properties(${name} PROPERTIES LABELS native)
    endforeach()
endfunction()
autotune_test(foam_trainer 0.57 0.67)
autotune_test(trainer_6kg 1.04 1.32)
autotune_test(flying_wing 0.46 0.72 ELEVON_OUTPUT=1 MIXING_GAIN=1 KFF_RDDRMIX=0 TKOFF_THR_MINACC=15)

# every CONDITION and DO of each set, beside the oracle
file(GLOB command_flight_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host_tests/command_flights/*.cpp)
add_executable(command_flight ${command_flight_sources}
               ${CMAKE_SOURCE_DIR}/host_tests/mission_oracle/oracle.cpp)
target_compile_options(command_flight PRIVATE ${HOUSE_WARNINGS})
target_include_directories(command_flight PRIVATE ${CMAKE_SOURCE_DIR}/host_tests)
target_link_libraries(command_flight PRIVATE simulator_report simulator_ground simulator_machine
                      mission_tool_parts)
foreach(set 1 2)
    file(GLOB every_command ${CMAKE_SOURCE_DIR}/simulator/missions/every_command_${set}.*)
    add_test(NAME flight.elf_commands_${set}
             COMMAND command_flight ${IMAGE_ELF} ${every_command} ${flights}/elf_commands_${set}
                     ${minutes})
    set_tests_properties(flight.elf_commands_${set} PROPERTIES LABELS simavr TIMEOUT 900
                         FIXTURES_SETUP elf_commands_${set} FIXTURES_REQUIRED image_minutes)
endforeach()

# what all these flights of the image took of the processor
set(elf_flights elf_calm_1 elf_calm_2 elf_calm_3 elf_wind_1 elf_wind_2 elf_wind_3 elf_rough
    elf_modes elf_failsafes elf_commands_1 elf_commands_2)
list(TRANSFORM elf_flights PREPEND ${flights}/ OUTPUT_VARIABLE elf_folders)
set(work_report ${NODE} ${CMAKE_SOURCE_DIR}/host_tests/on_board/work_report.mjs)
set(image_folder ${CMAKE_BINARY_DIR}/avr-apm2)
add_test(NAME on_board.task_budgets
         COMMAND ${work_report} budgets ${image_folder}/tasks.json ${elf_folders})
add_test(NAME on_board.cycles
         COMMAND ${work_report} cycles ${CMAKE_SOURCE_DIR}/toolchain/budgets.json ${elf_folders})
add_test(NAME on_board.stack_bound
         COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/host_tests/on_board/stack_used.mjs ${IMAGE_ELF}
                 ${elf_folders})
add_test(NAME on_board.cycles_apm1
         COMMAND ${work_report} cycles ${CMAKE_SOURCE_DIR}/toolchain/budgets.json ${flights}/apm1_calm
                 ${flights}/apm1_wind)
set_tests_properties(on_board.cycles_apm1 PROPERTIES LABELS simavr
                     FIXTURES_REQUIRED "apm1_calm;apm1_wind")
set_tests_properties(on_board.task_budgets on_board.cycles on_board.stack_bound PROPERTIES LABELS simavr
                     FIXTURES_REQUIRED "${elf_flights}")

add_test(NAME flight.minutes_begin COMMAND ${CMAKE_COMMAND} -E rm -rf ${minutes})
set_tests_properties(flight.minutes_begin PROPERTIES FIXTURES_SETUP image_minutes LABELS simavr)
add_test(NAME flight.minutes_of_the_image COMMAND flight minutes ${minutes})
set_tests_properties(flight.minutes_of_the_image PROPERTIES FIXTURES_CLEANUP image_minutes
                     LABELS simavr)

house_test(on_board_test ${CMAKE_SOURCE_DIR}/host_tests/on_board)
if(TARGET on_board_test)
    add_dependencies(on_board_test fly)
    target_compile_definitions(on_board_test PRIVATE FLY_PROGRAM="$<TARGET_FILE:fly>")
endif()
