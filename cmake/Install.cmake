# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` gives a consumer: find_package(Reprise) then has Reprise::runtime, Reprise::reprisec,
# reprise_add_pack, Reprise_HLSL_DIR and Reprise_GENERATED_DIR.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(reprise_share "${CMAKE_INSTALL_DATADIR}/reprise")
set(reprise_package "${CMAKE_INSTALL_LIBDIR}/cmake/Reprise")

set_target_properties(reprise_runtime PROPERTIES EXPORT_NAME runtime)
install(TARGETS reprise_runtime reprisec EXPORT RepriseTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(EXPORT RepriseTargets NAMESPACE Reprise:: DESTINATION "${reprise_package}")

install(DIRECTORY "${PROJECT_SOURCE_DIR}/runtime/include/" "${PROJECT_SOURCE_DIR}/generated/include/"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/hlsl" DESTINATION "${reprise_share}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/generated" DESTINATION "${reprise_share}"
    PATTERN "include" EXCLUDE)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/RepriseConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/RepriseConfig.cmake"
    INSTALL_DESTINATION "${reprise_package}"
    PATH_VARS reprise_share)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/RepriseConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/RepriseConfig.cmake" "${PROJECT_BINARY_DIR}/RepriseConfigVersion.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/Reprise.cmake"
    DESTINATION "${reprise_package}")
