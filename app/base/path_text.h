// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QString>
#include <filesystem>

namespace toile::app {

/// A path as Qt and people read it. Any name of a file has a text: what is no UTF-8 in it becomes
/// question marks, where `std::filesystem::path::u16string` would throw.
inline QString textOf(const std::filesystem::path& path) {
    return QFile::decodeName(QByteArray::fromStdString(path.native()));
}

inline std::filesystem::path pathOf(const QString& text) {
    return QFile::encodeName(text).toStdString();
}

}  // namespace toile::app
