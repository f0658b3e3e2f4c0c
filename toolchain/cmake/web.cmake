# SPDX-License-Identifier: GPL-3.0-or-later
# The pages of web/, each one file, and the tables that they share with the tools.
set(web ${CMAKE_SOURCE_DIR}/web)
set(pages ${CMAKE_BINARY_DIR}/web)
file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS ${web}/src/*)
add_custom_command(OUTPUT ${pages}/page.html ${pages}/campaign.html
    COMMAND node ${web}/build.mjs page campaign ${pages}
    DEPENDS ${page_sources} ${web}/build.mjs ${web}/package-lock.json VERBATIM)
add_custom_target(pages DEPENDS ${pages}/page.html ${pages}/campaign.html)

# ---- names of modes, commands, events and errors, what of a log becomes which series, and the goals
# of docs/airplanes.md
set(tables "// Made of web/src/source by toolchain/cmake/web.cmake.\n#pragma once\nnamespace tables {\n")
foreach(file IN ITEMS ${web}/src/source/names.json ${web}/src/source/log_series.json
        ${CMAKE_SOURCE_DIR}/host_tests/scenarios/figures/limits.json)
    get_filename_component(table ${file} NAME_WE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND tables "constexpr char k_${table}[] = R\"json(${text})json\";\n")
endforeach()
string(APPEND tables "}  // namespace tables\n")
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/generated/shared_tables.hpp CONTENT "${tables}")

# ---- the pages inside the tools, which thus can be moved
set_source_files_properties(${CMAKE_SOURCE_DIR}/simulator/report/page_bytes.cpp PROPERTIES
    OBJECT_DEPENDS "${pages}/page.html;${pages}/campaign.html" SKIP_PRECOMPILE_HEADERS ON
    COMPILE_DEFINITIONS "PAGE_FILE=\"${pages}/page.html\";CAMPAIGN_FILE=\"${pages}/campaign.html\"")
