# SPDX-License-Identifier: GPL-3.0-or-later
# The image for the first board, APM 1, and its flight on the emulated board.
set(IMAGE_APM1_ELF ${CMAKE_BINARY_DIR}/avr-apm1/firmware.elf)
ExternalProject_Add(image_apm1
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/avr-apm1
    CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/toolchain/avr-gcc.cmake -DBOARD=apm1
               -DCMAKE_BUILD_TYPE=MinSizeRel
    BUILD_ALWAYS ON
    BUILD_BYPRODUCTS ${IMAGE_APM1_ELF}
    INSTALL_COMMAND "")
target_compile_definitions(fly PRIVATE FLY_IMAGE_1="${IMAGE_APM1_ELF}")
add_test(NAME image.budgets_apm1
         COMMAND ${NODE} ${CMAKE_SOURCE_DIR}/toolchain/check_image.mjs ${IMAGE_APM1_ELF}
                 ${CMAKE_SOURCE_DIR}/toolchain/budgets.json apm1)

flight_test(apm1_calm simavr 3 2 30 --board apm1 --seed 1)
flight_test(apm1_wind simavr 5 3 60 --board apm1 --seed 2 --usb ${windy})

# ---- its hardware layer, by the programs that also try the APM 2's
ExternalProject_Add(hal_programs_apm1
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${CMAKE_BINARY_DIR}/avr-hal-apm1
    CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/toolchain/avr-gcc.cmake -DBOARD=apm1
               -DCMAKE_BUILD_TYPE=MinSizeRel
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target hal_pwm hal_ppm hal_watchdog
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")
set(HOUSE_TEST_PREFIX apm1.)
house_test(hal_apm1_test ${CMAKE_SOURCE_DIR}/host_tests/hal_apm1 simulator_machine)
unset(HOUSE_TEST_PREFIX)
target_sources(hal_apm1_test PRIVATE ${CMAKE_SOURCE_DIR}/host_tests/hal_avr/pwm_test.cpp
                                     ${CMAKE_SOURCE_DIR}/host_tests/hal_avr/ppm_test.cpp)
add_dependencies(hal_apm1_test hal_programs_apm1 image_apm1)
target_compile_definitions(hal_apm1_test PRIVATE CHIP_PROGRAMS="${CMAKE_BINARY_DIR}/avr-hal-apm1"
                           IMAGE_APM1="${IMAGE_APM1_ELF}" CHIP_BOARD=apm1)
