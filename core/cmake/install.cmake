# SPDX-License-Identifier: GPL-3.0-or-later
# The library for other programs: `find_package(Toile)` gives them toile::core. Their sources include
# "core/pipeline/pipeline.h" as ours do.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Toile")
target_include_directories(toile_core INTERFACE
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/toile>")
set_target_properties(toile_core PROPERTIES EXPORT_NAME core)

# Libraries that are found as files go out by their names: they lie elsewhere on another machine.
get_target_property(needed toile_core INTERFACE_LINK_LIBRARIES)
set(as_file "^.*/lib([^/>]+)\\.(so|a)>*$")
set(named ${needed})
list(FILTER named INCLUDE REGEX "${as_file}")
list(TRANSFORM named REPLACE "${as_file}" "\\1") # for ToileConfig, which looks whether they are there
list(REMOVE_ITEM named pthread) # part of the C library, or found as Threads
list(TRANSFORM needed REPLACE "^/.*/lib([^/]+)\\.(so|a)$" "$<BUILD_INTERFACE:\\0>;$<INSTALL_INTERFACE:\\1>")
set_target_properties(toile_core PROPERTIES INTERFACE_LINK_LIBRARIES "${needed}")

install(TARGETS toile_core EXPORT ToileTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
install(EXPORT ToileTargets NAMESPACE toile:: DESTINATION "${package}" COMPONENT dev)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/core" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/toile"
    COMPONENT dev FILES_MATCHING PATTERN "*.h" PATTERN cmake EXCLUDE)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/ToileConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/ToileConfig.cmake" INSTALL_DESTINATION "${package}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/ToileConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/ToileConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/ToileConfigVersion.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindHarfBuzz.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindUMFPACK.cmake"
    DESTINATION "${package}" COMPONENT dev)
