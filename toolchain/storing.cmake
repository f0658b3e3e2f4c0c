# SPDX-License-Identifier: GPL-3.0-or-later
# How the image keeps missions: in what time, and through power cuts.
# storing_test(NAME): host_tests/on_board/NAME.cpp on the image, which writes its emulated minutes.
function(storing_test name)
    add_executable(${name} host_tests/on_board/${name}.cpp)
    target_compile_options(${name} PRIVATE ${HOUSE_WARNINGS})
    target_link_libraries(${name} PRIVATE simulator_ground simulator_machine)
    add_test(NAME storing.${name} COMMAND ${name} ${IMAGE_ELF} ${minutes}/${name})
    set_tests_properties(storing.${name} PROPERTIES LABELS simavr TIMEOUT 600
                         FIXTURES_REQUIRED image_minutes)
endfunction()

storing_test(upload_time)
storing_test(power_cuts)
