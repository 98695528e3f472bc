// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QString>
#include <filesystem>

namespace toile::app {

/// A path as Qt and people read it. Any name of a file has a text: what is no UTF-8 in it becomes
/// question marks, where `std::filesystem::path::u16string` would throw.
inline QString textOf(const std::filesystem::path& path) {
#ifdef _WIN32
    return QString::fromStdWString(path.native());
#else
    return QFile::decodeName(QByteArray::fromStdString(path.native()));
#endif
}

inline std::filesystem::path pathOf(const QString& text) {
#ifdef _WIN32
    return text.toStdWString();
#else
    return QFile::encodeName(text).toStdString();
#endif
}

}  // namespace toile::app
