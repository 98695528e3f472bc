// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/file_dialogs.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QPrinterInfo>
#include <QPushButton>
#include <QUrl>
#include <algorithm>

#include "core/io/soup.h"
#include "core/project/project_file.h"

namespace toile::app {
namespace {

QStringList meshSuffixes() {
    QStringList suffixes;
    for (const std::string& ending : readableEndings()) {
        suffixes << QString::fromStdString(ending);
    }
    return suffixes;
}

/// "*.obj *.ply"
QString patternsOf(const QStringList& suffixes) {
    QString patterns;
    for (const QString& suffix : suffixes) {
        patterns += (patterns.isEmpty() ? "*" : " *") + suffix;
    }
    return patterns;
}

SaveAnswer askInABox(QWidget* parent, const QString& name) {
    QMessageBox box(parent);
    box.setObjectName("askToSave");
    box.setIcon(QMessageBox::Question);
    const bool isProject = name.endsWith(QString::fromUtf8(kProjectEnding), Qt::CaseInsensitive);
    box.setText((isProject ? FileDialogs::tr("Save the changes to the project %1?")
                           : FileDialogs::tr("Save the pattern made from %1 as a project?"))
                    .arg(name));
    box.setInformativeText(
        isProject
            ? FileDialogs::tr("Your changes since the last save are lost if you do not save them.")
            : FileDialogs::tr(
                  "Your work is lost if you do not save it. The garment's file is never changed."));
    box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
        case QMessageBox::Save:
            return SaveAnswer::Save;
        case QMessageBox::Discard:
            return SaveAnswer::Discard;
        default:
            return SaveAnswer::Cancel;
    }
}

OverwriteAnswer askAboutOthers(QWidget* parent, const QString& name) {
    QMessageBox box(parent);
    box.setObjectName("askToOverwrite");
    box.setIcon(QMessageBox::Warning);
    box.setText(FileDialogs::tr("Another program has changed %1 since you opened it. Save anyway?")
                    .arg(name));
    box.setInformativeText(FileDialogs::tr("If you save, the other program's changes are lost."));
    const QPushButton* anyway =
        box.addButton(FileDialogs::tr("Save anyway"), QMessageBox::DestructiveRole);
    QPushButton* as = box.addButton(FileDialogs::tr("Save as…"), QMessageBox::AcceptRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(as);
    box.exec();
    return box.clickedButton() == anyway ? OverwriteAnswer::SaveAnyway
           : box.clickedButton() == as   ? OverwriteAnswer::SaveAs
                                         : OverwriteAnswer::Cancel;
}

bool askToReplace(QWidget* parent, const QString& path) {
    return QMessageBox::question(parent, FileDialogs::tr("Replace the file?"),
                                 FileDialogs::tr("The file %1 already exists. Replace it?")
                                     .arg(QFileInfo(path).fileName())) == QMessageBox::Yes;
}

/// Asks for a file to write and appends the suggestion's extension. The user has confirmed to
/// overwrite the returned path if it exists.
QString askForTarget(QWidget* parent, const QString& title, const QString& suggestion,
                     const QString& filter) {
    const QString suffix = QFileInfo(suggestion).suffix();
    QFileDialog dialog(parent, title, QFileInfo(suggestion).absolutePath(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(suggestion);
    while (dialog.exec() == QDialog::Accepted) {
        QString path = dialog.selectedFiles().constFirst();
        if (path.endsWith('.' + suffix, Qt::CaseInsensitive)) {
            return path;
        }
        // Qt's default suffix is not appended to a name like "dress.v2", which has a suffix.
        path += '.' + suffix;
        if (!QFileInfo::exists(path) || askToReplace(parent, path)) {
            return path;
        }
        dialog.selectFile(path);
    }
    return {};
}

bool askForPrinter(QWidget* parent, QPrinter& printer, int pages) {
    QPrintDialog dialog(&printer, parent);
    dialog.setOption(QPrintDialog::PrintPageRange);
    dialog.setMinMax(1, pages);
    return dialog.exec() == QDialog::Accepted;
}

}  // namespace

FileDialogs FileDialogs::native() {
    FileDialogs dialogs;
    dialogs.open = [](QWidget* parent, const QString& folder) {
        return QFileDialog::getOpenFileNames(
            parent, FileDialogs::tr("Open a garment"), folder,
            FileDialogs::tr("Garments and projects (%1);;All files (*)")
                .arg(patternsOf(openableSuffixes())));
    };
    dialogs.openSeams = [](QWidget* parent, const QString& folder) {
        return QFileDialog::getOpenFileName(parent, FileDialogs::tr("Load cuts and ease"), folder,
                                            FileDialogs::tr("Seams files (*.json);;All files (*)"));
    };
    dialogs.openHides = [](QWidget* parent, const QString& folder) {
        return QFileDialog::getOpenFileNames(
            parent, FileDialogs::tr("Open hides"), folder,
            FileDialogs::tr("Drawings (%1);;All files (*)").arg("*.dxf *.svg"));
    };
    dialogs.openBody = [](QWidget* parent, const QString& folder) {
        return QFileDialog::getOpenFileName(
            parent, FileDialogs::tr("Open a body"), folder,
            FileDialogs::tr("Meshes (%1);;All files (*)").arg(patternsOf(meshSuffixes())));
    };
    dialogs.openPattern = [](QWidget* parent, const QString& folder) {
        return QFileDialog::getOpenFileName(
            parent, FileDialogs::tr("Open a reference pattern"), folder,
            FileDialogs::tr("Patterns (%1);;All files (*)").arg("*.dxf *.svg *specification.json"));
    };
    dialogs.save = [](QWidget* parent, const QString& suggestion, const QString& filter) {
        return askForTarget(parent, FileDialogs::tr("Export the pattern"), suggestion, filter);
    };
    dialogs.saveReport = [](QWidget* parent, const QString& suggestion, const QString& filter) {
        return askForTarget(parent, FileDialogs::tr("Save the report"), suggestion, filter);
    };
    dialogs.mayReplace = askToReplace;
    dialogs.showFolder = [](const QString& folder) {
        QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
    };
    dialogs.saveProject = [](QWidget* parent, const QString& suggestion) {
        return askForTarget(parent, FileDialogs::tr("Save the project"), suggestion,
                            FileDialogs::tr("Toile projects (*.toile)"));
    };
    dialogs.findMesh = [](QWidget* parent, const QString& folder, const QString& name) {
        return QFileDialog::getOpenFileName(
            parent, FileDialogs::tr("Where is %1?").arg(name), folder,
            FileDialogs::tr("3D garments (%1);;All files (*)").arg(patternsOf(meshSuffixes())));
    };
    dialogs.askToSave = askInABox;
    dialogs.askToOverwrite = askAboutOthers;
    dialogs.hasPrinter = [] { return !QPrinterInfo::availablePrinterNames().isEmpty(); };
    dialogs.choosePrinter = askForPrinter;
    return dialogs;
}

QStringList openableSuffixes() {
    return meshSuffixes() << QString::fromUtf8(kProjectEnding);
}

bool isOpenable(const QString& path) {
    const QStringList suffixes = openableSuffixes();
    return std::any_of(suffixes.begin(), suffixes.end(), [&path](const QString& suffix) {
        return path.endsWith(suffix, Qt::CaseInsensitive);
    });
}

}  // namespace toile::app
