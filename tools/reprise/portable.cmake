# SPDX-License-Identifier: Apache-2.0
# Gathers one folder that runs on any machine with a Vulkan loader and driver:
# cmake -DPROGRAM=... -DSOURCE=... -DOUT=... -DSTRIP=... -DEMBREE=... -P portable.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${OUT}")
file(MAKE_DIRECTORY "${OUT}/bin" "${OUT}/lib" "${OUT}/share/reprise/scenes")

# glibc and the Vulkan loader belong to the machine: the one to its kernel, the other to its driver.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${PROGRAM}" LIBRARIES "${EMBREE}"
    RESOLVED_DEPENDENCIES_VAR libraries
    UNRESOLVED_DEPENDENCIES_VAR missing
    PRE_EXCLUDE_REGEXES "^linux-vdso" "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv)\\.so" "^libvulkan\\.so"
    POST_EXCLUDE_REGEXES "/ld-linux")
if(missing)
    message(FATAL_ERROR "Libraries that the program needs were not found: ${missing}")
endif()

file(COPY "${PROGRAM}" DESTINATION "${OUT}/bin")
foreach(library ${libraries})
    # One plain file under the name that the loader asks for: links do not survive every way of copying.
    get_filename_component(name "${library}" NAME)
    file(COPY_FILE "${library}" "${OUT}/lib/${name}")
endforeach()
file(GLOB binaries "${OUT}/bin/*" "${OUT}/lib/*.so*")
foreach(binary ${binaries})
    execute_process(COMMAND "${STRIP}" --strip-unneeded "${binary}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# Packed, for it is 44 MB: the program unpacks it into memory when it casts rays.
file(REAL_PATH "${EMBREE}" embree)
file(ARCHIVE_CREATE OUTPUT "${OUT}/lib/libembree3.so.3.gz" PATHS "${embree}"
    FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)

file(COPY "${SOURCE}/hlsl" DESTINATION "${OUT}/share/reprise")
file(COPY "${SOURCE}/generated" DESTINATION "${OUT}/share/reprise"
    FILES_MATCHING PATTERN "*.spv" PATTERN "*.json" PATTERN "include" EXCLUDE)
file(GLOB scene_shaders "${SOURCE}/tools/scenes/*.hlsl" "${SOURCE}/tools/scenes/*.hlsli")
file(COPY ${scene_shaders} DESTINATION "${OUT}/share/reprise/scenes")
file(COPY "${SOURCE}/LICENSE" DESTINATION "${OUT}")

# The terms of what others made, as Debian keeps them: of the packages that own the shared libraries, and of
# those whose headers and static libraries are in the program.
file(STRINGS "${SOURCE}/cmake/packages.txt" packages REGEX "-dev$|^spirv-tools$")
foreach(library ${libraries} "${EMBREE}")
    file(REAL_PATH "${library}" real)
    string(REGEX MATCH "[^/]+/[^/]+$" place "${real}") # x86_64-linux-gnu/libz.so.1.2.13
    execute_process(COMMAND dpkg-query -S "*/${place}" OUTPUT_VARIABLE owner ERROR_QUIET)
    if(NOT owner MATCHES "^([^:,\n]+)")
        message(FATAL_ERROR "No package owns ${real}, so its terms are unknown; the folder is made on Debian.")
    endif()
    list(APPEND packages "${CMAKE_MATCH_1}")
endforeach()
foreach(package ${packages})
    file(MAKE_DIRECTORY "${OUT}/share/doc/${package}")
    file(COPY_FILE "/usr/share/doc/${package}/copyright" "${OUT}/share/doc/${package}/copyright")
endforeach()

file(GLOB_RECURSE files "${OUT}/*")
set(bytes 0)
foreach(file ${files})
    file(SIZE "${file}" size)
    math(EXPR bytes "${bytes} + ${size}")
endforeach()
math(EXPR mebibytes "${bytes} / 1048576")
message(STATUS "${OUT}: ${mebibytes} MiB")
if(bytes GREATER 60000000)
    message(FATAL_ERROR "The portable folder has ${bytes} bytes; it must stay below 60 MB")
endif()
