# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DROOT=SOURCES -DOUT=FILE -P commit.cmake: writes "HASH DATE" of the commit that is checked out,
# with +changes behind the hash when the tree has others; nothing where there is no history. FILE is
# written only when that has changed.
find_program(GIT git)
set(text "")
if(GIT)
    execute_process(COMMAND ${GIT} -C ${ROOT} log -1 "--format=%h %cI" OUTPUT_VARIABLE head RESULT_VARIABLE failed
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
        execute_process(COMMAND ${GIT} -C ${ROOT} diff --quiet HEAD RESULT_VARIABLE changed ERROR_QUIET)
        if(changed)
            string(REPLACE " " "+changes " head ${head})
        endif()
        set(text "${head}\n")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "${text}" @ONLY)
