// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/file_dialogs.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <algorithm>

#include "core/io/soup.h"

namespace toile {

FileDialogs FileDialogs::native() {
    FileDialogs dialogs;
    dialogs.open = [](QWidget* parent, const QString& folder) {
        QString patterns;
        for (const QString& suffix : openableSuffixes()) {
            patterns += (patterns.isEmpty() ? "*" : " *") + suffix;
        }
        return QFileDialog::getOpenFileNames(
            parent, QCoreApplication::translate("FileDialogs", "Open a garment"), folder,
            QCoreApplication::translate("FileDialogs", "3D garments (%1);;All files (*)")
                .arg(patterns));
    };
    dialogs.openSeams = [](QWidget* parent, const QString& folder) {
        return QFileDialog::getOpenFileName(
            parent, QCoreApplication::translate("FileDialogs", "Read cuts and ease"), folder,
            QCoreApplication::translate("FileDialogs", "Seams files (*.json);;All files (*)"));
    };
    dialogs.save = [](QWidget* parent, const QString& suggestion, const QString& filter) {
        return QFileDialog::getSaveFileName(
            parent, QCoreApplication::translate("FileDialogs", "Export the pattern"), suggestion,
            filter);
    };
    return dialogs;
}

QStringList openableSuffixes() {
    QStringList suffixes;
    for (const std::string& ending : readableEndings()) {
        suffixes << QString::fromStdString(ending);
    }
    return suffixes;
}

bool isOpenable(const QString& path) {
    const QStringList suffixes = openableSuffixes();
    return std::any_of(suffixes.begin(), suffixes.end(), [&path](const QString& suffix) {
        return path.endsWith(suffix, Qt::CaseInsensitive);
    });
}

}  // namespace toile
