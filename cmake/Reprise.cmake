# SPDX-License-Identifier: Apache-2.0
# reprise_add_pack(TARGET SCENE needs.toml [TARGETS spirv glsl450 glsles json] [DIRECTORY dir]
#                  [DEFINES NDC_AND_UV_SHARE_Y=1 ...])
#
# Compiles the modules that the plan of a scene can ask for, and no others, into DIRECTORY (by default TARGET
# in the current binary directory): PASS/VARIANT.STAGE.spv and so on, as spirvFromDirectory reads them.
# needs.toml has the fields of SceneNeeds under [needs], those of Settings under [settings] and those of
# CacheSettings under [settings.cache]; see reprise/plan.hpp. TARGETS is what must exist; spirv by default. A
# target that cannot be expressed stops the build with the reason; but compute modules with quad operations,
# which GLSL has not, are made as SPIR-V and JSON alone: those without are beside them. DEFINES sets platform
# switches of the table, 0 otherwise. The target's property REPRISE_PACK_DIRECTORY holds the directory.
#
# With an installed Reprise each module has a command of its own, so that touching one header compiles again
# only what includes it. Inside Reprise's own build the compiler does not exist yet when CMake runs: there one
# command with one depfile compiles the scene's modules.
include_guard(GLOBAL)

function(reprise_add_pack target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "SCENE;DIRECTORY" "TARGETS;DEFINES")
    if(NOT arg_SCENE)
        message(FATAL_ERROR "reprise_add_pack(${target}): name a needs.toml after SCENE.")
    endif()
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "reprise_add_pack(${target}): ${arg_UNPARSED_ARGUMENTS} is not understood.")
    endif()
    if(NOT arg_TARGETS)
        set(arg_TARGETS spirv)
    endif()
    if(NOT arg_DIRECTORY)
        set(arg_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${target}")
    endif()
    get_filename_component(scene "${arg_SCENE}" ABSOLUTE)
    if(NOT EXISTS "${scene}")
        message(FATAL_ERROR "reprise_add_pack(${target}): there is no ${scene}.")
    endif()
    set(pack "${Reprise_HLSL_DIR}/pack.toml")
    set(defines ${arg_DEFINES})
    list(TRANSFORM defines PREPEND "--define;")
    if(TARGET Reprise::reprisec)
        _reprise_command_per_module("${target}" "${scene}" "${arg_DIRECTORY}" "${arg_TARGETS}" outputs)
    else()
        _reprise_one_command("${target}" "${scene}" "${arg_DIRECTORY}" "${arg_TARGETS}" outputs)
    endif()
    add_custom_target(${target} ALL DEPENDS ${outputs})
    set_target_properties(${target} PROPERTIES REPRISE_PACK_DIRECTORY "${arg_DIRECTORY}")
endfunction()

# Asks the compiler for the list now, and again whenever the scene or the table changes.
function(_reprise_command_per_module target scene directory targets outputs)
    get_target_property(program Reprise::reprisec IMPORTED_LOCATION)
    if(NOT program)
        get_target_property(program Reprise::reprisec LOCATION)
    endif()
    execute_process(
        COMMAND "${program}" --pack "${pack}" --needs "${scene}" --targets ${targets} --list-outputs
        OUTPUT_VARIABLE listed ERROR_VARIABLE complaint RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "reprise_add_pack(${target}): ${complaint}")
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${scene}" "${pack}")
    string(REGEX MATCHALL "[^\n]+" lines "${listed}")
    set(modules)
    foreach(line IN LISTS lines)
        string(REPLACE " " ";" words "${line}")
        list(GET words 0 variant)
        list(GET words 1 stage)
        list(GET words 2 path)
        list(GET words 3 kind)
        list(APPEND modules "${variant} ${stage}")
        list(APPEND "files_of_${variant}_${stage}" "${directory}/${path}")
        list(APPEND "kinds_of_${variant}_${stage}" "${kind}")
    endforeach()
    list(REMOVE_DUPLICATES modules)
    set(all)
    foreach(module IN LISTS modules)
        string(REPLACE " " ";" words "${module}")
        list(GET words 0 variant)
        list(GET words 1 stage)
        set(files "${files_of_${variant}_${stage}}")
        list(GET files 0 first)
        add_custom_command(
            OUTPUT ${files}
            COMMAND Reprise::reprisec --pack "${pack}" --out "${directory}" --variant "${variant}"
                    --stage "${stage}" --targets ${kinds_of_${variant}_${stage}} ${defines} --jobs 1
                    --depfile "${first}.d"
            DEPENDS Reprise::reprisec
            DEPFILE "${first}.d"
            COMMENT "Compiling ${variant} (${stage})"
            VERBATIM)
        list(APPEND all ${files})
    endforeach()
    set(${outputs} "${all}" PARENT_SCOPE)
endfunction()

function(_reprise_one_command target scene directory targets outputs)
    set(stamp "${directory}/pack.stamp")
    add_custom_command(
        OUTPUT "${stamp}"
        COMMAND reprisec --pack "${pack}" --out "${directory}" --needs "${scene}" --targets ${targets}
                ${defines} --depfile "${stamp}.d" --stamp "${stamp}"
        DEPENDS reprisec "${scene}"
        DEPFILE "${stamp}.d"
        COMMENT "Compiling the modules of ${target}"
        VERBATIM)
    set(${outputs} "${stamp}" PARENT_SCOPE)
endfunction()

# Inside the project; the package's config sets it for everyone else.
if(NOT DEFINED Reprise_HLSL_DIR)
    get_filename_component(Reprise_HLSL_DIR "${CMAKE_CURRENT_LIST_DIR}/../hlsl" ABSOLUTE)
endif()
