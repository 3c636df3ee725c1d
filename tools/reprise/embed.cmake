# SPDX-License-Identifier: Apache-2.0
# Writes OUT, a C++ header with each of the page's files as a constant: cmake -DOUT=... -DIN=... -P embed.cmake
set(text "// Made from page/ by embed.cmake.\n#pragma once\n\n#include <string_view>\n\nnamespace report {\n\n")
foreach(pair "pageTemplate|page.html" "pageStyle|page.css" "pageCharts|charts.js" "pageScript|page.js")
    string(REPLACE "|" ";" pair "${pair}")
    list(GET pair 0 name)
    list(GET pair 1 file)
    file(READ "${IN}/${file}" content)
    string(APPEND text "inline constexpr std::string_view ${name} = R\"~~~(${content})~~~\";\n\n")
endforeach()
string(APPEND text "} // namespace report\n")
file(WRITE "${OUT}" "${text}")
