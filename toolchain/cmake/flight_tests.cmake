# SPDX-License-Identifier: GPL-3.0-or-later
# Whole flights as tests: the images on the emulated boards (label simavr) and the same firmware
# compiled natively (label native). Each flight of an image leaves its emulated minutes in a file;
# their sum has a limit.
set(flights ${CMAKE_BINARY_DIR}/flights)
set(minutes ${flights}/minutes)
set(native_minutes ${flights}/native_minutes)
set(missions ${CMAKE_SOURCE_DIR}/simulator/missions)
set(first_flight ${missions}/first_flight.waypoints)
set(short_flight ${tests}/scenarios/short_flight.waypoints)  # five minutes of the image instead of seven
set(there_and_back ${tests}/scenarios/there_and_back.waypoints)  # three
file(GLOB flight_data CONFIGURE_DEPENDS ${missions}/* ${CMAKE_SOURCE_DIR}/simulator/airplanes/*)

# flight_program(NAME [SOURCE...]): host_tests/scenarios/NAME.cpp, or these, with both vehicles
function(flight_program name)
    set(sources ${ARGN})
    if(NOT sources)
        set(sources ${tests}/scenarios/${name}.cpp)
    endif()
    project_program(${name} ${sources} LIBRARIES firmware_native simulator_native simulator_report
                    simulator_ground simulator_machine simulator_world nlohmann_json::nlohmann_json)
endfunction()

# native_test(NAME COMMAND...), image_test(NAME BOARD COMMAND...): BOARD is apm1, apm2 or both;
# more for declare_test() behind the command
function(native_test name)
    set(labels native)
    if(name MATCHES "native_(modes|failsafes|beyond|fault_singles|gps_swapped|calibration)")
        list(APPEND labels quick)  # half a second each, a few seconds the faults
    endif()
    declare_test(${name} COMMAND ${ARGN} DATA ${flight_data} LABELS ${labels} TIMEOUT 1800 REUSE)
endfunction()
function(image_test name board)
    set(images ${IMAGE_${board}})
    if("${board}" STREQUAL "both")
        set(images ${IMAGE_apm1} ${IMAGE_apm2})
    endif()
    declare_test(${name} COMMAND ${ARGN} NEEDS ${images} DATA ${flight_data} LABELS simavr
                 TIMEOUT 900 AFTER image_minutes REUSE)
endfunction()

# ---- the program's flights, with limits
# flight_test(NAME LABEL CROSSTRACK_M ALTITUDE_M TOUCHDOWN_M ARGUMENT...)
project_program(flight ${tests}/scenarios/flight.cpp LIBRARIES nlohmann_json::nlohmann_json)
function(flight_test name label crosstrack_m altitude_m touchdown_m)
    set(counted ${native_minutes})
    set(more NEEDS fly)
    set(labels ${label})
    if("${label}" STREQUAL "simavr")
        set(counted ${minutes})
        set(image ${IMAGE_apm2})
        if(apm1 IN_LIST ARGN)
            set(image ${IMAGE_apm1})
        endif()
        set(more NEEDS fly ${image} AFTER image_minutes)
    elseif(name MATCHES "^native_(calm|wind)")
        list(APPEND labels quick)
    endif()
    declare_test(flight.${name} COMMAND flight fly ${flights}/${name} ${counted} ${crosstrack_m}
                 ${altitude_m} ${touchdown_m} $<TARGET_FILE:fly> ${ARGN} ${more} DATA ${flight_data}
                 LABELS ${labels} SETUP ${name} TIMEOUT 900 REUSE)
endfunction()

set(windy --wind 5,320 --gusts)
flight_test(apm1_calm simavr 3 2 30 --board apm1 --seed 1)
flight_test(apm1_wind simavr 5 3 60 --board apm1 --seed 2 --usb ${windy})
foreach(seed 1 2 3)
    set(elf_chip)
    set(native_chip)
    if(seed EQUAL 1)  # and the log that stays in the DataFlash
        set(elf_chip --dataflash ${flights}/elf_wind_1/flash.bin)
        set(native_chip --dataflash ${flights}/native_wind_1/flash.bin)
    endif()
    set(wiring)
    if(seed EQUAL 2)  # one flight of three on the factory's wiring
        set(wiring --telemetry uart0)
    endif()
    set(airs wind)
    if(NOT seed EQUAL 3)  # that of the image is another airplane's, below
        list(PREPEND airs calm)
        flight_test(elf_calm_${seed} simavr 3 2 30 --seed ${seed} ${wiring})
    endif()
    flight_test(elf_wind_${seed} simavr 5 3 60 --seed ${seed} ${windy} ${wiring} ${elf_chip})
    flight_test(native_calm_${seed} native 3 2 30 --native --seed ${seed} ${wiring})
    flight_test(native_wind_${seed} native 5 3 60 --native --seed ${seed} ${windy} ${wiring} ${native_chip})
    foreach(air IN LISTS airs)
        declare_test(flight.same_events_${air}_${seed}
            COMMAND flight same ${flights}/elf_${air}_${seed}/summary.json
                    ${flights}/native_${air}_${seed}/summary.json
            AFTER elf_${air}_${seed} native_${air}_${seed} LABELS simavr)
    endforeach()
endforeach()
declare_test(log_tool.order_is_that_of_the_image COMMAND node --test ${tests}/scenarios/log_order.test.mjs NEEDS log_tool
             AFTER elf_wind_1 native_wind_1 LABELS simavr ENVIRONMENT LOG_TOOL=$<TARGET_FILE:log_tool>
             IMAGE_FLASH=${flights}/elf_wind_1/flash.bin NATIVE_FLASH=${flights}/native_wind_1/flash.bin)
flight_test(native_ublox_m9 native 5.5 3.3 60 --native --gps ublox_m9 --seed 1 ${windy})
flight_test(native_ublox_m10 native 5.5 3.3 60 --native --gps ublox_m10 --seed 2 ${windy})
flight_test(native_mtk16 native 5.5 3.3 60 --native --gps mtk16 --seed 1 ${windy})
flight_test(native_mtk19 native 5.5 3.3 60 --native --gps mtk19 --seed 2 ${windy})
flight_test(native_nmea native 7 3.5 70 --native --gps nmea --seed 3 ${windy})  # once a second
flight_test(native_nmea_fast native 5.5 3.3 60 --native --gps nmea --gps-baud 57600 --seed 1 ${windy})

# boards differ: sensors a twentieth as noisy, which repeat their readings, and three times
foreach(noise 0.05 3)
    flight_test(native_noise_${noise} native 5 3 60 --native --sensor-noise ${noise} --seed 1 ${windy})
endforeach()

# the compass of the usual GPS, chip down, with the parameters that say so
file(READ ${CMAKE_SOURCE_DIR}/simulator/airplanes/foam_trainer.param settings)
file(WRITE ${flights}/external_compass.param "${settings}COMPASS_EXTERNAL,1\nCOMPASS_ORIENT,8\n")
flight_test(native_external_compass native 5 3 60 --native --external-compass 180,0,0 --seed 1
            --param ${flights}/external_compass.param ${windy})

# a V-tail and flaperons, which are half out for the landing
file(READ ${CMAKE_SOURCE_DIR}/simulator/airplanes/foam_trainer.json airplane)
string(JSON airplane SET "${airplane}" v_tail true)
string(JSON airplane SET "${airplane}" flaperons true)
string(JSON airplane SET "${airplane}" flaps [[{"lift": 0.6, "drag": 0.04, "pitch": -0.1}]])
set(mixed ${flights}/mixed)
file(WRITE ${mixed}.json "${airplane}")
file(WRITE ${mixed}.param "${settings}VTAIL_OUTPUT,1\nMIXING_GAIN,1\nRC5_FUNCTION,24\nRC6_FUNCTION,25\n"
     "LAND_FLAP_PERCNT,50\n")
set(mixed --airplane ${mixed}.json --param ${mixed}.param)
flight_test(native_v_tail_and_flaperons native 3 2 30 --native --seed 1 ${mixed})
flight_test(elf_v_tail_and_flaperons simavr 5 3 60 ${short_flight} --seed 1 ${mixed} ${windy})

# rudder and elevator: the wing's dihedral rolls it
string(JSON airplane SET "${airplane}" v_tail false)
string(JSON airplane SET "${airplane}" flaperons false)
string(JSON airplane SET "${airplane}" roll aileron 0)
string(JSON airplane SET "${airplane}" yaw aileron 0)
string(JSON airplane SET "${airplane}" roll beta -0.16)
set(rudder_only ${flights}/rudder_only)
file(WRITE ${rudder_only}.json "${airplane}")
file(WRITE ${rudder_only}.param "${settings}RUDDER_ONLY,1\n")
set(rudder_only --airplane ${rudder_only}.json --param ${rudder_only}.param)
flight_test(native_rudder_only native 3 2 30 --native --seed 1 ${rudder_only})
flight_test(elf_rudder_only simavr 5 3 60 ${short_flight} --seed 1 ${rudder_only} ${windy})

# elevons, thrown
flight_test(elf_elevons simavr 5 3 60 ${short_flight} --airplane flying_wing --seed 1 ${windy})

# no barometer from power-on, armed all the same: the GPS's heights; the chip comes late, or never
file(READ ${CMAKE_SOURCE_DIR}/simulator/airplanes/foam_trainer.param settings)
file(WRITE ${flights}/unchecked.param "${settings}ARMING_CHECK,0\n")
foreach(until 60 2000)
    flight_test(native_no_barometer_${until} native 5 4 60 --native --seed 1
                --param ${flights}/unchecked.param --fault baro:lost@0-${until})
endforeach()

# ---- flights that a program of their own directs
flight_program(rough_flight)
image_test(flight.elf_rough apm2 rough_flight ${IMAGE_apm2} ${first_flight} ${flights}/elf_rough
           ${minutes} SETUP elf_rough)

flight_program(modes_flight)  # every mode, entered by the switch, in wind
native_test(flight.native_modes modes_flight native ${first_flight} ${flights}/native_modes 32 ${native_minutes})
image_test(flight.elf_modes apm2 modes_flight ${IMAGE_apm2} ${first_flight} ${flights}/elf_modes 15
           ${minutes} SETUP elf_modes)

flight_program(failsafe_flight)  # every transition of the failsafes, by its cause
native_test(flight.native_failsafes failsafe_flight native ${first_flight} ${flights}/native_failsafes
            ${native_minutes})
image_test(flight.elf_failsafes apm2 failsafe_flight ${IMAGE_apm2} ${first_flight}
           ${flights}/elf_failsafes ${minutes} SETUP elf_failsafes)

# commands that neither set's documents know
flight_program(beyond_flight ${tests}/scenarios/command_flights/beyond/beyond_flight.cpp)
native_test(flight.native_beyond beyond_flight ${missions}/beyond.waypoints ${native_minutes})

flight_program(fault_flight)  # sensors that fail, each in every way and every two of them
native_test(flight.native_fault_singles fault_flight native ${first_flight} singles)
native_test(flight.native_fault_pairs fault_flight native ${first_flight} pairs)
foreach(fault gps:lost baro:nonsense imu:lost)
    string(REPLACE ":" "_" name flight.elf_fault_apm2_${fault})
    image_test(${name} apm2 fault_flight apm2 ${IMAGE_apm2} ${first_flight} ${minutes} ${fault})
endforeach()
foreach(fault imu:stuck baro:lost)  # other sensors, other drivers
    string(REPLACE ":" "_" name flight.elf_fault_apm1_${fault})
    image_test(${name} apm1 fault_flight apm1 ${IMAGE_apm1} ${first_flight} ${minutes} ${fault})
endforeach()

# stalled by the pilot, every airplane
flight_program(stall_flight)
target_link_libraries(stall_flight PRIVATE parameter_files)
native_test(flight.native_stall stall_flight ${CMAKE_SOURCE_DIR}/simulator/airplanes)

flight_program(gps_flight)  # another receiver in the middle of the flight
native_test(flight.native_gps_swapped gps_flight ${first_flight} ${native_minutes})

# a compass that is turned against what is set
flight_program(mounting_flight)
foreach(yaw 90 180 270)
    native_test(flight.native_compass_turned_${yaw} mounting_flight native ${first_flight} ${yaw}
                ${flights}/native_compass_turned_${yaw} ${native_minutes})
endforeach()
image_test(flight.elf_compass_turned_90 apm2 mounting_flight ${IMAGE_apm2} ${there_and_back} 90
           ${flights}/elf_compass_turned_90 ${minutes})

# gains found in the air, on an airplane whose own are near the defaults and on one far from them
flight_program(autotune_flight)
target_link_libraries(autotune_flight PRIVATE parameter_files)
function(autotune_test airplane roll_p pitch_p)
    foreach(times 0.4 1 2.5)
        native_test(flight.native_autotune_${airplane}_${times} autotune_flight ${airplane}
                    ${first_flight} ${times} ${roll_p} ${pitch_p} ${ARGN})
    endforeach()
endfunction()
autotune_test(foam_trainer 0.57 0.67)
autotune_test(trainer_6kg 1.04 1.32)
autotune_test(flying_wing 0.58 0.92 ELEVON_OUTPUT=1 MIXING_GAIN=1 KFF_RDDRMIX=0 TKOFF_THR_MINACC=15)

# every CONDITION and DO of each set, beside the oracle
file(GLOB command_flight_sources CONFIGURE_DEPENDS ${tests}/scenarios/command_flights/*.cpp)
project_program(command_flight ${command_flight_sources} ${tests}/oracle/mission/oracle.cpp
    LIBRARIES simulator_report simulator_ground simulator_machine mission_tool_parts)
foreach(set 1 2)
    file(GLOB every_command ${missions}/every_command_${set}.*)
    image_test(flight.elf_commands_${set} apm2 command_flight ${IMAGE_apm2} ${every_command}
               ${flights}/elf_commands_${set} ${minutes} SETUP elf_commands_${set})
endforeach()

# ---- what all these flights took of the processor
set(elf_flights elf_calm_1 elf_calm_2 elf_elevons elf_wind_1 elf_wind_2 elf_wind_3 elf_rough
    elf_modes elf_failsafes elf_commands_1 elf_commands_2)
list(TRANSFORM elf_flights PREPEND ${flights}/ OUTPUT_VARIABLE elf_folders)
set(work_report node ${tests}/scenarios/work_report.mjs)
declare_test(on_board.task_budgets COMMAND ${work_report} budgets ${AVR_TREE}/apm2/tasks.json
             ${elf_folders} AFTER ${elf_flights} LABELS simavr)
declare_test(on_board.cycles COMMAND ${work_report} cycles ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json
             ${elf_folders} AFTER ${elf_flights} LABELS simavr)
declare_test(on_board.stack_bound COMMAND node ${tests}/scenarios/stack_used.mjs ${IMAGE_apm2}
             ${elf_folders} AFTER ${elf_flights} LABELS simavr)
declare_test(on_board.cycles_apm1 COMMAND ${work_report} cycles ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json
             ${flights}/apm1_calm ${flights}/apm1_wind AFTER apm1_calm apm1_wind LABELS simavr)

# ---- the boards on the bench: calibration, GPS receivers, each image in the other's chip, pulses,
# a full and a blank DataFlash, uploads and power cuts, restarts
foreach(name wrong_board pulse_times full_log upload_time power_cuts calibration gps_bench
             restart_flight register_writes)
    flight_program(${name})
endforeach()
image_test(preflight.apm2_image_on_an_apm1 apm2 wrong_board ${IMAGE_apm2} apm1 ${minutes}/wrong_board_1)
image_test(preflight.apm1_image_on_an_apm2 apm1 wrong_board ${IMAGE_apm1} apm2 ${minutes}/wrong_board_2)
# what the images write to the chip's registers, against the document
declare_test(on_board.registers COMMAND node ${CMAKE_SOURCE_DIR}/toolchain/image/registers.mjs
             $<TARGET_FILE:register_writes> ${IMAGE_apm2} ${IMAGE_apm1} --check
             NEEDS register_writes ${IMAGE_apm1} ${IMAGE_apm2} LABELS simavr)
image_test(storing.upload_time apm2 upload_time ${IMAGE_apm2} ${minutes}/upload_time)
image_test(storing.power_cuts apm2 power_cuts ${IMAGE_apm2} ${minutes}/power_cuts)
foreach(board apm1 apm2)
    image_test(preflight.elf_calibration_${board} ${board} calibration ${IMAGE_${board}} ${board}
               ${minutes}/calibration_${board})
    image_test(preflight.elf_gps_${board} ${board} gps_bench ${IMAGE_${board}} ${board}
               ${minutes}/gps_${board})
    foreach(name pulse_times full_log)
        image_test(on_board.${name}_${board} ${board} ${name} ${IMAGE_${board}} ${board}
                   ${minutes}/${name}_${board})
    endforeach()
    image_test(restart.${board} ${board} restart_flight ${IMAGE_${board}} ${board} ${first_flight}
               ${minutes}/restart_${board})
endforeach()
native_test(preflight.native_calibration calibration native apm2 ${native_minutes}/calibration)
native_test(preflight.native_gps gps_bench native apm2 ${native_minutes}/gps)

# ---- how exactly they fly, as a table held to its goals; and on gains that AUTOTUNE found
set(figures ${tests}/scenarios/figures)
set(table node ${figures}/table.mjs ${figures}/limits.json $<TARGET_FILE:fly> ${missions}/box_600.waypoints)
declare_test(figures.table COMMAND ${table} ${CMAKE_BINARY_DIR}/figures NEEDS fly DATA ${flight_data}
             LABELS native TIMEOUT 900 REUSE)
foreach(name windy no_airspeed)
    declare_test(figures.${name} COMMAND node ${figures}/table.mjs ${figures}/${name}.json $<TARGET_FILE:fly>
                 ${missions}/box_600.waypoints ${CMAKE_BINARY_DIR}/figures/${name} NEEDS fly DATA ${flight_data}
                 LABELS native TIMEOUT 900 REUSE)
endforeach()
set(landings node ${figures}/landings.mjs ${figures}/limits.json $<TARGET_FILE:fly> ${missions}/box_600.waypoints)
declare_test(figures.landings COMMAND ${landings} ${CMAKE_BINARY_DIR}/figures/landings NEEDS fly DATA ${flight_data}
             LABELS native TIMEOUT 900 REUSE)
set(tuned)
set(tuned_files)
foreach(airplane trainer_6kg flying_wing)
    set(parameters ${CMAKE_BINARY_DIR}/figures/${airplane}.param)
    list(APPEND tuned ${airplane}=${parameters})
    list(APPEND tuned_files ${parameters})
    declare_test(figures.tune_${airplane} COMMAND autotune_flight ${airplane} ${first_flight} to
                 ${CMAKE_SOURCE_DIR}/simulator/airplanes/${airplane}.param ${parameters}
                 DATA ${flight_data} LABELS native SETUP tuned REUSE)
endforeach()
declare_test(figures.tuned COMMAND ${table} ${CMAKE_BINARY_DIR}/figures/tuned ${tuned} NEEDS fly
             DATA ${flight_data} ${tuned_files} LABELS native TIMEOUT 900 AFTER tuned REUSE)
declare_test(figures.tuned_landings COMMAND ${landings} ${CMAKE_BINARY_DIR}/figures/tuned_landings ${tuned} NEEDS fly
             DATA ${flight_data} ${tuned_files} LABELS native TIMEOUT 900 AFTER tuned REUSE)

# ---- three airplanes, two missions, calm and wind: who crashes or gets lost fails
declare_test(campaign.slice COMMAND campaign --seeds 2 --out ${flights}/campaign NEEDS fly
             DATA ${flight_data} LABELS native REUSE)
declare_test(campaign.drawn COMMAND node ${figures}/drawn.mjs ${figures}/drawn.json $<TARGET_FILE:campaign>
             ${flights}/drawn NEEDS campaign drawn fly DATA ${flight_data}
             ${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF LABELS native REUSE)
declare_test(campaign.replay_on_the_image COMMAND node --test ${tests}/scenarios/campaign_replay.test.mjs
             NEEDS fly ${IMAGE_apm2} DATA ${flight_data} LABELS simavr AFTER image_minutes REUSE
             ENVIRONMENT FLY=$<TARGET_FILE:fly> MINUTES=${minutes}/campaign)

# ---- whatever happens, the invariants hold
declare_test(chaos COMMAND chaos --flights 100 --seed 1 --out ${flights}/chaos DATA ${flight_data}
             ${CMAKE_SOURCE_DIR}/firmware/state/parameters.csv LABELS native REUSE)
# what chaos found: stalls by sensors that failed and by a pilot's stick, ailerons that swung, loops
# that wound up on the ground, a motor armed again there, one that was not in the air
file(GLOB found CONFIGURE_DEPENDS ${tests}/scenarios/stalls/*.scenario
     ${tests}/scenarios/swings/*.scenario ${tests}/scenarios/on_the_ground/*.scenario
     ${tests}/scenarios/restarts/*.scenario)
foreach(scenario IN LISTS found)
    get_filename_component(name ${scenario} NAME_WE)
    declare_test(chaos.${name} COMMAND chaos --replay ${scenario} DATA ${flight_data} ${scenario}
                 LABELS native REUSE)
endforeach()

# ---- the tools' images and logs, flown
declare_test(flight.dead_reckoning COMMAND node --test ${tests}/scenarios/dead_reckoning.test.mjs NEEDS fly
             LABELS native REUSE DATA ${flight_data} ENVIRONMENT FLY=$<TARGET_FILE:fly>)
declare_test(flight.least_ground_speed COMMAND node --test ${tests}/scenarios/ground_speed.test.mjs NEEDS fly
             LABELS native REUSE DATA ${flight_data} ENVIRONMENT FLY=$<TARGET_FILE:fly>)
declare_test(mission_tool.rehearses COMMAND node --test ${tests}/scenarios/mission_rehearsal.test.mjs
             NEEDS fly mission_tool LABELS native REUSE DATA ${flight_data} ENVIRONMENT
             MISSION_TOOL=$<TARGET_FILE:mission_tool>)
declare_test(mission_tool.flies_a_compiled_image COMMAND node --test ${tests}/scenarios/mission_image.test.mjs
             NEEDS fly mission_tool LABELS native REUSE DATA ${flight_data} ENVIRONMENT
             FLY=$<TARGET_FILE:fly> FLY_BOARD=native MISSION_TOOL=$<TARGET_FILE:mission_tool>)
declare_test(log_tool.flight_log_agrees_with_the_simulator COMMAND node --test ${tests}/scenarios/flight_log.test.mjs
             NEEDS fly log_tool mission_tool LABELS native REUSE DATA ${flight_data}
             ENVIRONMENT FLY=$<TARGET_FILE:fly> LOG_TOOL=$<TARGET_FILE:log_tool>
                         MISSION_TOOL=$<TARGET_FILE:mission_tool>)

declare_test(flight.minutes_begin COMMAND ${CMAKE_COMMAND} -E rm -rf ${minutes} SETUP image_minutes
             LABELS simavr)
add_test(NAME flight.minutes_of_the_image COMMAND flight minutes ${minutes})
set_tests_properties(flight.minutes_of_the_image PROPERTIES FIXTURES_CLEANUP image_minutes LABELS simavr
                     REQUIRED_FILES $<TARGET_FILE:flight>)
