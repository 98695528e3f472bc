// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFile>
#include <QString>
#include <filesystem>

namespace toile::app {

/// A text in the program's language, for functions that belong to no Qt class; such texts share
/// one context, and those that the library gives have another.
inline QString tr(const char* text, const char* comment = nullptr, int count = -1) {
    const QString known = QCoreApplication::translate("toile::app", text, comment, count);
    return known == QString::fromUtf8(text)
               ? QCoreApplication::translate("toile", text, comment, count)
               : known;
}

/// A path as Qt and people read it. Any name of a file has a text: what is no UTF-8 in it becomes
/// question marks, where `std::filesystem::path::u16string` would throw.
inline QString textOf(const std::filesystem::path& path) {
    return QFile::decodeName(QByteArray::fromStdString(path.native()));
}

inline std::filesystem::path pathOf(const QString& text) {
    return QFile::encodeName(text).toStdString();
}

}  // namespace toile::app
