# SPDX-License-Identifier: GPL-3.0-or-later
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
