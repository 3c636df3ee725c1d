# SPDX-License-Identifier: Apache-2.0
# Installs what the build has made into a folder, then configures, builds and runs an example from there.
cmake_minimum_required(VERSION 3.25)
function(run output)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${ARGN}\n${text}")
    endif()
    set(${output} "${text}" PARENT_SCOPE)
endfunction()

get_filename_component(name "${SOURCE}" NAME)
file(REMOVE_RECURSE "${WORK}")
# The compiler and the runtime; the report has its own install rule and is not needed here.
run(ignored "${CMAKE_COMMAND}" "-DCMAKE_INSTALL_PREFIX=${WORK}/prefix"
    -P "${BUILD}/tools/reprisec/cmake_install.cmake")
run(ignored "${CMAKE_COMMAND}" -G Ninja -S "${SOURCE}" -B "${WORK}/build" "-DCMAKE_PREFIX_PATH=${WORK}/prefix"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror ${FLAGS}" -DCMAKE_BUILD_TYPE=Release)
run(ignored "${CMAKE_COMMAND}" --build "${WORK}/build")
run(said "${WORK}/build/${name}" "${WORK}/build/${name}_pack")
message("${said}")
