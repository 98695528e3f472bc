// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>

#include "app/settings/choices.h"

namespace toile::app {

/// What `System` comes to on a desktop of this locale: English where there is no translation.
Language resolved(Language language, const QLocale& desktop);

/// Loads the translations of Toile and of Qt's own dialogs, and makes numbers go with the language.
/// Once, after the application is made and before any window. English needs no file.
void useLanguage(Language language);
/// The one that is spoken since; English before.
Language languageInUse();

}  // namespace toile::app
