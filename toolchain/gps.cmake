# SPDX-License-Identifier: GPL-3.0-or-later
# Every receiver on the GPS port: found on the boards, flown with natively, swapped in flight.
bench_program(gps_bench)
target_link_libraries(gps_bench PRIVATE firmware_native simulator_native simulator_world)
bench_test(elf_gps_1 gps_bench ${IMAGE_APM1_ELF} apm1 ${minutes}/gps_1)
bench_test(elf_gps_2 gps_bench ${IMAGE_ELF} apm2 ${minutes}/gps_2)
add_test(NAME preflight.native_gps
         COMMAND gps_bench native apm2 ${flights}/native_minutes/gps)
set_tests_properties(preflight.native_gps PROPERTIES LABELS native TIMEOUT 600)

flight_test(native_mtk16 native 5.5 3.3 60 --native --gps mtk16 --seed 1 ${windy})
flight_test(native_mtk19 native 5.5 3.3 60 --native --gps mtk19 --seed 2 ${windy})
flight_test(native_nmea native 7 3.5 70 --native --gps nmea --seed 3 ${windy})  # once a second
flight_test(native_nmea_fast native 5.5 3.3 60 --native --gps nmea --gps-baud 57600 --seed 1
            ${windy})

add_executable(gps_flight host_tests/on_board/gps_flight.cpp)
target_compile_options(gps_flight PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(gps_flight PRIVATE firmware_native simulator_native simulator_ground
                      simulator_world)
add_test(NAME flight.native_gps_swapped
         COMMAND gps_flight ${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints
                 ${flights}/native_minutes)
set_tests_properties(flight.native_gps_swapped PROPERTIES LABELS native TIMEOUT 600)
