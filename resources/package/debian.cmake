# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages by cpack: one per component of the installation, of those that this build has.
find_program(GZIP gzip REQUIRED)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME toile)
set(CPACK_PACKAGE_VENDOR "The Toile developers")
set(CPACK_PACKAGE_CONTACT "The Toile developers <toile@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${CPACK_PACKAGE_CONTACT}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

# Says what a component's package is; its description is one line, and a paragraph.
function(toile_package component name section depends description)
    string(TOUPPER "${component}" key)
    foreach(pair "PACKAGE_NAME;${name}" "PACKAGE_SECTION;${section}" "PACKAGE_DEPENDS;${depends}")
        list(POP_FRONT pair variable)
        set(CPACK_DEBIAN_${key}_${variable} "${pair}" PARENT_SCOPE)
    endforeach()
    set(CPACK_COMPONENT_${key}_DESCRIPTION "${description}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${key}_DESCRIPTION "${description}" PARENT_SCOPE)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)

    set(folder "${CMAKE_INSTALL_DATADIR}/doc/${name}")
    install(FILES "${package_folder}/copyright" "${made_folder}/changelog.Debian.gz"
        "${made_folder}/changelog.gz" DESTINATION "${folder}" COMPONENT ${component})
    configure_file("${package_folder}/lintian-overrides" "${made_folder}/lintian/${name}" @ONLY)
    install(FILES "${made_folder}/lintian/${name}"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides" COMPONENT ${component})
endfunction()

configure_file("${package_folder}/changelog.Debian" "${made_folder}/changelog.Debian" @ONLY)
configure_file("${CMAKE_SOURCE_DIR}/CHANGELOG.md" "${made_folder}/changelog" COPYONLY)
execute_process(COMMAND "${GZIP}" -9nkf changelog.Debian changelog WORKING_DIRECTORY "${made_folder}"
    COMMAND_ERROR_IS_FATAL ANY)

set(version "${PROJECT_VERSION}-1")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # would stand above each
set(about "Toile flattens garment meshes into sewing patterns at true scale: every
boundary edge of a flat piece has exactly its 3D length, so that seams sew.")
# The BLAS by name: Debian's default is the slow reference one, and any would satisfy CHOLMOD.
toile_package(runtime toile graphics "python3 (>= 3.11), libopenblas0-pthread | libopenblas0" "sewing patterns from 3D garments
${about}
This package has the window and the command line.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "fonts-dejavu-core, qt6-translations-l10n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "qt6-wayland, snakemake")

toile_package(dev libtoile-dev libdevel
    "libeigen3-dev, libopenmesh-dev, libsuitesparse-dev, libopenblas-dev, nlohmann-json3-dev, libpugixml-dev, libpolyclipping-dev, libassimp-dev, libzip-dev, libfreetype-dev, libharfbuzz-dev, libfontconfig-dev, zlib1g-dev"
    "sewing patterns from 3D garments - library
${about}
This package has the static library, its headers and its CMake package, Toile.")

if(TARGET toile_python)
    toile_package(python python3-toile python "python3 (>= 3.11), python3 (<< 3.12), python3-numpy, libopenblas0-pthread | libopenblas0"
        "sewing patterns from 3D garments - Python module
${about}
This package has the Python module.")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
endif()
if(EXISTS "${CMAKE_SOURCE_DIR}/resources/blender")
    toile_package(blender toile-blender graphics "toile (>= ${version}), blender, python3 (>= 3.11)"
        "sewing patterns from 3D garments - Blender add-on
${about}
This package has the add-on for Blender.")
    set(CPACK_DEBIAN_BLENDER_PACKAGE_ARCHITECTURE all)
endif()
include(CPack)
