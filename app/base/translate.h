// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace toile::app {

/// A text in the program's language, for functions that belong to no Qt class; such texts share
/// one context, and those that the library gives have another.
inline QString tr(const char* text, const char* comment = nullptr, int count = -1) {
    const QString known = QCoreApplication::translate("toile::app", text, comment, count);
    return known == QString::fromUtf8(text)
               ? QCoreApplication::translate("toile", text, comment, count)
               : known;
}

}  // namespace toile::app
