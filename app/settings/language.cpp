// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

namespace toile::app {

namespace {

QLocale::Language localeLanguage(Language language) {
    return language == Language::German ? QLocale::German : QLocale::English;
}

Language spokenNow = Language::English;

void load(const QString& name, const QString& folder) {
    auto* translator = new QTranslator(QCoreApplication::instance());
    if (translator->load(name, folder)) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;  // text stays English
    }
}

}  // namespace

Language resolved(Language language, const QLocale& desktop) {
    if (language != Language::System) {
        return language;
    }
    return desktop.language() == QLocale::German ? Language::German : Language::English;
}

void useLanguage(Language language) {
    const QLocale desktop = QLocale::system();
    const Language spoken = spokenNow = resolved(language, desktop);
    // If the user chose another language than the desktop's, numbers follow it. German sentences
    // with English decimals would be misread.
    QLocale::setDefault(language == Language::System ||
                                desktop.language() == localeLanguage(language)
                            ? desktop
                            : QLocale(localeLanguage(language)));
    if (spoken == Language::German) {
        load("qtbase_de", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
        load("toile_de", ":/translations");
    }
}

Language languageInUse() {
    return spokenNow;
}

}  // namespace toile::app
