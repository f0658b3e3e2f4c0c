# SPDX-License-Identifier: GPL-3.0-or-later
# Eight digits of the commit that last changed what the image is made of, for AUTOPILOT_VERSION. Other commits leave the
# image as it is. Of sources without a history, as in a tarball, it is empty. One file is compiled with it; CMake runs
# again when another commit is checked out.
find_program(GIT git)
set(commit "")
if(GIT)
    execute_process(COMMAND ${GIT} -C ${CMAKE_SOURCE_DIR} log -1 --abbrev=8 --format=%h -- firmware libraries hal_avr
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${CMAKE_SOURCE_DIR} rev-parse --git-path logs/HEAD
                    OUTPUT_VARIABLE moved OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    get_filename_component(moved "${moved}" ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
    if(commit AND EXISTS ${moved} AND NOT IS_DIRECTORY ${moved})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${moved})
    endif()
    string(SUBSTRING "${commit}" 0 8 commit)
endif()
set_property(SOURCE ${CMAKE_SOURCE_DIR}/firmware/gcs/status_messages.cpp APPEND PROPERTY
             COMPILE_DEFINITIONS "FIRMWARE_COMMIT=\"${commit}\"")
