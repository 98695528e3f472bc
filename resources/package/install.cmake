# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts beside the program (component runtime) so that desktops know it. The
# library's part is core/cmake/install.cmake. OPTIONAL is what a build of the program alone has not made.
include(GNUInstallDirs)

set(package_folder "${CMAKE_CURRENT_LIST_DIR}")
set(made_folder "${CMAKE_BINARY_DIR}/package_files")
set(share "${CMAKE_INSTALL_DATADIR}")
file(MAKE_DIRECTORY "${made_folder}")

# The window opens its own projects and every garment that the readers know.
string(CONCAT types "application/vnd.toile+json;model/obj;model/stl;model/gltf-binary;"
    "model/gltf+json;model/3mf;model/x-off;model/x-ply;model/x-fbx;model/vnd.collada+xml;model/vnd.usda;")
string(REGEX REPLACE "([^;]+);" "    <mediatype>\\1</mediatype>\n" mediatypes "${types}")
foreach(file toile.desktop toile.thumbnailer toile.metainfo.xml)
    configure_file("${package_folder}/${file}" "${made_folder}/${file}" @ONLY)
endforeach()

install(TARGETS toile RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT runtime)
file(GLOB samples CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/resources/samples/*.*") # and no folder
list(FILTER samples EXCLUDE REGEX "/\\.[^/]*$")
install(FILES ${samples} DESTINATION "${share}/toile/samples" COMPONENT runtime)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/docs/" DESTINATION "${share}/doc/toile"
    COMPONENT runtime PATTERN "*.sh" EXCLUDE PATTERN "*.py" EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/resources/batch/" DESTINATION "${share}/toile/batch"
    USE_SOURCE_PERMISSIONS COMPONENT runtime PATTERN __pycache__ EXCLUDE)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/resources/blender/" DESTINATION "${share}/toile/blender"
    USE_SOURCE_PERMISSIONS COMPONENT blender PATTERN __pycache__ EXCLUDE)
if(TOILE_GUI)
    install(FILES "${made_folder}/toile.desktop" DESTINATION "${share}/applications" COMPONENT runtime)
    install(FILES "${made_folder}/toile.metainfo.xml" DESTINATION "${share}/metainfo" COMPONENT runtime)
    install(FILES "${made_folder}/toile.thumbnailer" DESTINATION "${share}/thumbnailers"
        COMPONENT runtime)
    install(FILES "${package_folder}/toile.mime.xml" DESTINATION "${share}/mime/packages"
        RENAME toile.xml COMPONENT runtime)

    set(program_icon "${CMAKE_SOURCE_DIR}/resources/icons/toile.svg")
    set(project_icon "${package_folder}/application-vnd.toile+json.svg")
    install(FILES "${program_icon}" DESTINATION "${share}/icons/hicolor/scalable/apps" COMPONENT runtime)
    install(FILES "${project_icon}" DESTINATION "${share}/icons/hicolor/scalable/mimetypes"
        COMPONENT runtime)
    # For desktops that draw no SVG.
    find_program(RSVG_CONVERT rsvg-convert) # librsvg2-bin
    mark_as_advanced(RSVG_CONVERT)
    foreach(size 16 24 32 48 64 128 256)
        if(NOT RSVG_CONVERT)
            break()
        endif()
        foreach(icon "apps;${program_icon}" "mimetypes;${project_icon}")
            list(GET icon 0 context)
            list(GET icon 1 drawing)
            get_filename_component(name "${drawing}" NAME_WLE)
            set(picture "${made_folder}/icons/${size}x${size}/${context}/${name}.png")
            add_custom_command(OUTPUT "${picture}"
                COMMAND "${CMAKE_COMMAND}" -E make_directory "${made_folder}/icons/${size}x${size}/${context}"
                COMMAND "${RSVG_CONVERT}" -w ${size} -h ${size} -o "${picture}" "${drawing}"
                DEPENDS "${drawing}" VERBATIM)
            list(APPEND icon_pictures "${picture}")
        endforeach()
    endforeach()
    if(icon_pictures)
        add_custom_target(toile_icons ALL DEPENDS ${icon_pictures})
        install(DIRECTORY "${made_folder}/icons/" DESTINATION "${share}/icons/hicolor"
            COMPONENT runtime OPTIONAL)
    endif()
endif()

# What the program says of itself, as a manual page.
find_package(Python3 COMPONENTS Interpreter)
find_program(GZIP gzip)
mark_as_advanced(GZIP)
if(Python3_FOUND AND GZIP)
    add_custom_command(OUTPUT "${made_folder}/toile.1.gz"
        COMMAND "${Python3_EXECUTABLE}" "${package_folder}/manual_page.py" "$<TARGET_FILE:toile>"
            "${made_folder}/toile.1" "${CMAKE_INSTALL_FULL_DATADIR}/doc/toile"
        COMMAND "${GZIP}" -9nkf "${made_folder}/toile.1"
        DEPENDS toile "${package_folder}/manual_page.py"
        COMMENT "Writing the manual page" VERBATIM)
    add_custom_target(toile_manual ALL DEPENDS "${made_folder}/toile.1.gz")
    install(FILES "${made_folder}/toile.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1"
        COMPONENT runtime OPTIONAL)
else()
    message(STATUS "Without Python 3 and gzip there is no manual page.")
endif()

if(TOILE_DEBIAN)
    include("${package_folder}/debian.cmake")
endif()
