# SPDX-License-Identifier: GPL-3.0-or-later
# Many flights at once, natively: the program, its tests, and a slice of a campaign as a test.
file(GLOB campaign_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/campaign/*.cpp)
list(FILTER campaign_sources EXCLUDE REGEX /main\.cpp$)
add_library(campaign_parts STATIC ${campaign_sources})
target_compile_options(campaign_parts PRIVATE ${HOUSE_WARNINGS})
target_compile_definitions(campaign_parts PRIVATE CAMPAIGN_OUT="${CMAKE_SOURCE_DIR}/build/campaign"
                           CAMPAIGN_MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
target_link_libraries(campaign_parts PUBLIC simulator_report simulator_world PRIVATE CLI11::CLI11)

add_executable(campaign ${CMAKE_SOURCE_DIR}/simulator/campaign/main.cpp)
target_compile_options(campaign PRIVATE ${HOUSE_WARNINGS})
target_compile_definitions(campaign PRIVATE CAMPAIGN_FLY="$<TARGET_FILE:fly>")
find_package(Threads REQUIRED)
target_link_libraries(campaign PRIVATE campaign_parts Threads::Threads)
add_dependencies(campaign fly)

house_test(campaign_test ${CMAKE_SOURCE_DIR}/host_tests/campaign campaign_parts)
if(TARGET campaign_test)
    add_dependencies(campaign_test campaign)
    target_compile_definitions(campaign_test PRIVATE CAMPAIGN_PROGRAM="$<TARGET_FILE:campaign>"
        MISSIONS="${CMAKE_SOURCE_DIR}/simulator/missions")
endif()

# three airplanes, two missions, calm and wind: whoever crashes, gets lost or breaks a frame fails
add_test(NAME campaign.slice COMMAND campaign --seeds 2 --out ${CMAKE_BINARY_DIR}/flights/campaign)
set_tests_properties(campaign.slice PROPERTIES LABELS native TIMEOUT 600)
add_test(NAME campaign.replay_on_the_image
         COMMAND ${NODE} --test ${CMAKE_SOURCE_DIR}/host_tests/campaign/replay.test.mjs)
set_tests_properties(campaign.replay_on_the_image PROPERTIES LABELS simavr TIMEOUT 600
    FIXTURES_REQUIRED image_minutes
    ENVIRONMENT "FLY=$<TARGET_FILE:fly>;MINUTES=${CMAKE_BINARY_DIR}/flights/minutes/campaign")

# how exactly they fly, as a table, held to its goals or to what is reached
set(figures ${CMAKE_SOURCE_DIR}/host_tests/figures)
add_test(NAME figures.table
         COMMAND ${NODE} ${figures}/table.mjs ${figures}/limits.json $<TARGET_FILE:fly>
                 ${CMAKE_SOURCE_DIR}/simulator/missions/box_600.waypoints
                 ${CMAKE_BINARY_DIR}/figures)
set_tests_properties(figures.table PROPERTIES LABELS native TIMEOUT 900)

# on gains that AUTOTUNE has found, begun with the defaults
set(tuned)
foreach(airplane trainer_6kg flying_wing)
    set(parameters ${CMAKE_BINARY_DIR}/figures/${airplane}.param)
    list(APPEND tuned ${airplane}=${parameters})
    add_test(NAME figures.tune_${airplane}
             COMMAND autotune_flight ${airplane}
                     ${CMAKE_SOURCE_DIR}/simulator/missions/first_flight.waypoints to
                     ${CMAKE_SOURCE_DIR}/simulator/airplanes/${airplane}.param ${parameters})
    set_tests_properties(figures.tune_${airplane} PROPERTIES LABELS native FIXTURES_SETUP tuned)
endforeach()
add_test(NAME figures.tuned
         COMMAND ${NODE} ${figures}/table.mjs ${figures}/limits.json $<TARGET_FILE:fly>
                 ${CMAKE_SOURCE_DIR}/simulator/missions/box_600.waypoints
                 ${CMAKE_BINARY_DIR}/figures/tuned ${tuned})
set_tests_properties(figures.tuned PROPERTIES LABELS native TIMEOUT 900 FIXTURES_REQUIRED tuned)

file(GLOB airplane_parameters CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/simulator/airplanes/*.param)
foreach(file IN LISTS airplane_parameters)
    get_filename_component(airplane ${file} NAME_WE)
    add_test(NAME airplanes.param.${airplane} COMMAND param_tool check ${file})
endforeach()
