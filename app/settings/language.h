// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>

#include "app/settings/choices.h"

namespace toile::app {

/// Replaces `System` by the language of this locale, or English without a translation.
Language resolved(Language language, const QLocale& desktop);

/// Loads the translations of Toile and of Qt's own dialogs, and sets the number format. Call it
/// once, after the application is created and before any window. English needs no file.
void useLanguage(Language language);
/// The language set by useLanguage(); English before that.
Language languageInUse();

}  // namespace toile::app
