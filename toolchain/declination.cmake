# SPDX-License-Identifier: GPL-3.0-or-later
# The firmware's table of declinations, from the coefficients of the World Magnetic Model:
#   declination_table toolchain/declination/WMM2025.COF > libraries/geo/declination_table.hpp
add_library(declination_parts STATIC ${CMAKE_SOURCE_DIR}/toolchain/declination/model.cpp
            ${CMAKE_SOURCE_DIR}/toolchain/declination/table.cpp)
target_compile_options(declination_parts PRIVATE ${HOUSE_WARNINGS})
target_include_directories(declination_parts PUBLIC ${CMAKE_SOURCE_DIR})
add_executable(declination_table ${CMAKE_SOURCE_DIR}/toolchain/declination/main.cpp)
target_compile_options(declination_table PRIVATE ${HOUSE_WARNINGS})
target_link_libraries(declination_table PRIVATE declination_parts)

house_test(declination_test ${CMAKE_SOURCE_DIR}/host_tests/declination declination_parts geo)
target_compile_definitions(declination_test PRIVATE
    WMM_COEFFICIENTS="${CMAKE_SOURCE_DIR}/toolchain/declination/WMM2025.COF"
    DECLINATION_TABLE="${CMAKE_SOURCE_DIR}/libraries/geo/declination_table.hpp")
