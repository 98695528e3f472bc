// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFile>
#include <QString>
#include <filesystem>

namespace toile::app {

/// Translates a text in functions outside Qt classes. These share one context; the library's texts
/// have another.
inline QString tr(const char* text, const char* comment = nullptr, int count = -1) {
    const QString known = QCoreApplication::translate("toile::app", text, comment, count);
    return known == QString::fromUtf8(text)
               ? QCoreApplication::translate("toile", text, comment, count)
               : known;
}

/// Converts a path for display. Bytes that are not UTF-8 become question marks; here
/// `std::filesystem::path::u16string` would throw.
inline QString textOf(const std::filesystem::path& path) {
    return QFile::decodeName(QByteArray::fromStdString(path.native()));
}

inline std::filesystem::path pathOf(const QString& text) {
    return QFile::encodeName(text).toStdString();
}

}  // namespace toile::app
