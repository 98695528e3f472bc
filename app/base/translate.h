// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace toile {

/// A text in the program's language, for functions that belong to no Qt class; such texts share
/// one context.
inline QString tr(const char* text, const char* comment = nullptr, int count = -1) {
    return QCoreApplication::translate("toile", text, comment, count);
}

}  // namespace toile
