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
flight_test(apm1_wind simavr 5 3 60 --board apm1 --seed 2 ${windy})
