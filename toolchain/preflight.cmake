# SPDX-License-Identifier: GPL-3.0-or-later
# The boards on the bench: each image in the other's chip.
function(bench_program name)
    add_executable(${name} host_tests/on_board/${name}.cpp)
    target_compile_options(${name} PRIVATE ${HOUSE_WARNINGS})
    target_link_libraries(${name} PRIVATE simulator_ground simulator_machine)
endfunction()

function(bench_test name)
    add_test(NAME preflight.${name} COMMAND ${ARGN})
    set_tests_properties(preflight.${name} PROPERTIES LABELS simavr TIMEOUT 600
                         FIXTURES_REQUIRED image_minutes)
endfunction()

bench_program(wrong_board)
bench_test(apm2_image_on_an_apm1 wrong_board ${IMAGE_ELF} apm1 ${minutes}/wrong_board_1)
bench_test(apm1_image_on_an_apm2 wrong_board ${IMAGE_APM1_ELF} apm2 ${minutes}/wrong_board_2)

bench_program(calibration)
target_link_libraries(calibration PRIVATE firmware_native simulator_native simulator_world)
bench_test(elf_calibration_1 calibration ${IMAGE_APM1_ELF} apm1 ${minutes}/calibration_1)
bench_test(elf_calibration_2 calibration ${IMAGE_ELF} apm2 ${minutes}/calibration_2)
add_test(NAME preflight.native_calibration
         COMMAND calibration native apm2 ${flights}/native_minutes/calibration)
set_tests_properties(preflight.native_calibration PROPERTIES LABELS native TIMEOUT 600)
