# SPDX-License-Identifier: Apache-2.0
# Installs the build into a folder and uses it from there as a consumer would.
function(run output)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${ARGN}\n${text}")
    endif()
    set(${output} "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run(ignored "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
file(COPY "${WORK}/prefix/share/reprise/hlsl" DESTINATION "${WORK}")
run(ignored "${CMAKE_COMMAND}" -G Ninja -S "${SOURCE}" -B "${WORK}/build"
    "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DHLSL=${WORK}/hlsl" -DCMAKE_BUILD_TYPE=Debug)
run(first "${CMAKE_COMMAND}" --build "${WORK}/build")
run(ignored "${WORK}/build/consumer" "${WORK}/build/scene_pack")

if(EXISTS "${WORK}/build/scene_pack/object_velocity")
    message(FATAL_ERROR "The pack of a scene without moving objects has object_velocity.")
endif()
file(GLOB shared "${WORK}/build/quad_pack/temporal_aa/*quad_sharing-on.comp.spv")
file(GLOB texts "${WORK}/build/quad_pack/temporal_aa/*.glsl")
if(NOT shared OR NOT texts)
    message(FATAL_ERROR "The pack of the defaults lacks the module with quad operations, or the GLSL without.")
endif()
run(second "${CMAKE_COMMAND}" --build "${WORK}/build")
if(NOT second MATCHES "no work to do")
    message(FATAL_ERROR "A second build is not idle:\n${second}")
endif()

# Only temporal_aa includes this header.
file(TOUCH "${WORK}/hlsl/reprise/history_constraint.hlsli")
run(third "${CMAKE_COMMAND}" --build "${WORK}/build")
if(NOT third MATCHES "Compiling temporal_aa" OR third MATCHES "Compiling camera_velocity")
    message(FATAL_ERROR "Touching one header compiled something else than what includes it:\n${third}")
endif()
