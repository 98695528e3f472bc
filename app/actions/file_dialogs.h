// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace toile {

/// Asking for files. Replaceable, so that tests answer without a dialog on the screen.
struct FileDialogs {
    /// Files to open as one garment; empty where the person thought better of it.
    std::function<QStringList(QWidget* parent, const QString& folder)> open;
    /// A seams file to read; empty where the person thought better of it.
    std::function<QString(QWidget* parent, const QString& folder)> openSeams;
    /// File to write; empty where the person thought better of it. The suggestion is a full path
    /// whose ending is the format's.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)> save;

    /// The desktop's own dialogs.
    static FileDialogs native();
};

/// Endings of mesh files that can be opened, lower case with the dot.
QStringList openableSuffixes();
bool isOpenable(const QString& path);

}  // namespace toile
