# SPDX-License-Identifier: GPL-3.0-or-later
# How the image is compiled; what each flag gained stands in docs/measurements.md.
set(AVR_OPTIMISATION -Os -flto -mrelax -mcall-prologues)
add_compile_options(${AVR_OPTIMISATION})
add_link_options(${AVR_OPTIMISATION} -Wl,--emit-relocs)  # the stack bound wants to know addresses
link_libraries(m)
