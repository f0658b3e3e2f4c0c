# SPDX-License-Identifier: GPL-3.0-or-later
# The host's side: unit tests, the simulator, and the image for the simulator to fly.
include(CTest)
include(GoogleTest)
find_package(GTest REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(SIMAVR REQUIRED IMPORTED_TARGET simavr)
set(CMAKE_CXX_STANDARD 17)

foreach(library IN LISTS all_libraries)
    house_test(${library}_test ${CMAKE_SOURCE_DIR}/host_tests/${library} ${library})
endforeach()
