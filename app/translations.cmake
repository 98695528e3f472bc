# SPDX-License-Identifier: GPL-3.0-or-later
# The translations of resources/translations, made into a resource of toile_app. After texts of the
# window have changed, `cmake --build BUILD --target translations` brings the .ts files up to date;
# then translate what is unfinished, with Qt Linguist or by hand.

set(translations_folder "${CMAKE_SOURCE_DIR}/resources/translations")
set(translation_files "${translations_folder}/toile_de.ts")

# Words of the core are told in the window too. Tables write TR("text"), the core worded("text") and
# translatable("text"), free functions tr("text"); all have the namespace for their context.
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/translations.sh"
"set -e
cd '${CMAKE_SOURCE_DIR}'
'$<TARGET_FILE:Qt6::lupdate>' app core -I . -extensions cpp,h \\
    -tr-function-alias QT_TR_NOOP+=TR,QT_TR_NOOP+=worded,QT_TR_NOOP+=translatable \\
    -locations none -no-obsolete -ts ${translation_files}
")
file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/update_translations.sh"
    INPUT "${CMAKE_CURRENT_BINARY_DIR}/translations.sh")
add_custom_target(translations
    COMMAND sh "${CMAKE_CURRENT_BINARY_DIR}/update_translations.sh"
    COMMENT "Collecting the window's texts for translation"
    VERBATIM)

set(compiled_translations)
set(listed_translations)
foreach(source ${translation_files})
    get_filename_component(name "${source}" NAME_WE)
    set(compiled "${CMAKE_CURRENT_BINARY_DIR}/${name}.qm")
    add_custom_command(OUTPUT "${compiled}"
        COMMAND Qt6::lrelease -silent "${source}" -qm "${compiled}"
        DEPENDS "${source}"
        VERBATIM)
    list(APPEND compiled_translations "${compiled}")
    string(APPEND listed_translations "<file alias=\"${name}.qm\">${compiled}</file>")
endforeach()

# Not by AUTORCC: that looks for the files before they are made.
file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/translations.qrc" CONTENT
    "<RCC><qresource prefix=\"/translations\">@listed_translations@</qresource></RCC>\n" @ONLY)
set(translations_source "${CMAKE_CURRENT_BINARY_DIR}/qrc_translations.cpp")
add_custom_command(OUTPUT "${translations_source}"
    COMMAND Qt6::rcc --name translations -o "${translations_source}"
        "${CMAKE_CURRENT_BINARY_DIR}/translations.qrc"
    DEPENDS ${compiled_translations} "${CMAKE_CURRENT_BINARY_DIR}/translations.qrc"
    VERBATIM)
set_source_files_properties("${translations_source}" PROPERTIES SKIP_AUTOGEN ON)
target_sources(toile_app PRIVATE "${translations_source}")
