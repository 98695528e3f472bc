# SPDX-License-Identifier: GPL-3.0-or-later
# The library for other programs: `find_package(Toile)` gives them toile::core, and <toile/toile.h>.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Toile")
target_include_directories(toile_core INTERFACE
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/toile>") # for "core/..." in our headers
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
# Installs toile.h and every header of ours that it includes, directly or not.
install(CODE "set(source \"${CMAKE_SOURCE_DIR}\")
set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/toile\")" COMPONENT dev)
install(CODE [[
    set(headers core/toile/toile.h)
    set(open ${headers})
    while(open)
        list(POP_FRONT open header)
        cmake_path(GET header PARENT_PATH folder)
        file(INSTALL "${source}/${header}" DESTINATION "${destination}/${folder}")
        file(STRINGS "${source}/${header}" included REGEX "^#include \"core/")
        list(TRANSFORM included REPLACE "^#include \"([^\"]+)\".*$" "\\1")
        list(REMOVE_ITEM included ${headers})
        list(APPEND headers ${included})
        list(APPEND open ${included})
    endwhile()
    file(WRITE "$ENV{DESTDIR}${destination}/toile.h" "#include \"core/toile/toile.h\"  // IWYU pragma: export\n")
]] COMPONENT dev)

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
